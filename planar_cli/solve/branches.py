"""A plan with unknowns that enter nonlinearly, carried out: every root of every such equation is a branch."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from decimal import Decimal

import sympy as sp

from planar_cli.equation.exact import Valuation
from planar_cli.equation.form import Nonlinear, linear_form
from planar_cli.equation.plain import tidy
from planar_cli.errors import Undecided
from planar_cli.solve.algebra import Algebra, Line, SolvedBlock
from planar_cli.solve.plan import Block
from planar_cli.solve.roots import Root, real_roots
from planar_cli.solve.write import Written


@dataclass(frozen=True, slots=True)
class Choice:
    """One equation in one unknown with all its real roots, and the one that this branch takes."""

    symbol: sp.Symbol
    equation: sp.Expr
    roots: tuple[Root, ...]
    taken: int
    number: int


@dataclass(frozen=True, slots=True)
class Branch:
    """One way through the plan."""

    algebra: Algebra
    blocks: tuple[SolvedBlock, ...]
    choices: tuple[Choice, ...]


class Brancher:
    """Walks the blocks of a plan. `angles`: unknowns that are angles."""

    def __init__(self, unknowns: tuple[sp.Symbol, ...], angles: frozenset[sp.Symbol], symbolic: bool) -> None:
        self.unknowns, self.angles, self.symbolic = unknowns, angles, symbolic

    def run(self, algebra: Algebra, work: list[tuple[Block, tuple[Written, ...]]]) -> Iterator[Branch]:
        """All branches, depth first."""
        if not work:
            yield Branch(algebra, (), ())
            return
        (block, written), rest = work[0], work[1:]
        for after, solved, choices in self._block(algebra, block, written):
            for branch in self.run(after, rest):
                yield Branch(branch.algebra, (solved, *branch.blocks), (*choices, *branch.choices))

    def _block(
        self, algebra: Algebra, block: Block, written: tuple[Written, ...]
    ) -> Iterator[tuple[Algebra, SolvedBlock, tuple[Choice, ...]]]:
        order = tuple(self.unknowns[j] for j in block.unknowns)
        residuals = [self._opened(algebra.in_unknowns(w, order), algebra, order) for w in written]
        if self._linear(residuals, order):
            after = copied(algebra)
            yield after, after.solve(block, written, self.unknowns), ()
            return
        letters = tuple(self.unknowns[j] for j in block.letters) or order
        yield from self._nonlinear(algebra, residuals, written, order, letters)

    @staticmethod
    def _opened(residual: sp.Expr, algebra: Algebra, order: tuple[sp.Symbol, ...]) -> sp.Expr:
        """Named intermediates that hold an unknown of the block are put in."""
        definitions = algebra.value.definitions
        for _ in range(20):
            inside = {
                s: definitions[s]
                for s in residual.free_symbols
                if s in definitions and holds(definitions, s, set(order))
            }
            if not inside:
                return residual
            residual = residual.xreplace(inside)
        return residual

    @staticmethod
    def _linear(residuals: list[sp.Expr], order: tuple[sp.Symbol, ...]) -> bool:
        try:
            forms = [linear_form(r, set(order)) for r in residuals]
        except Nonlinear:
            return False
        return all(any(x in f.terms for f in forms) for x in order)

    def _nonlinear(
        self,
        algebra: Algebra,
        residuals: list[sp.Expr],
        written: tuple[Written, ...],
        order: tuple[sp.Symbol, ...],
        letters: tuple[sp.Symbol, ...],
    ) -> Iterator[tuple[Algebra, SolvedBlock, tuple[Choice, ...]]]:
        """Express the linear unknowns one at a time, until one equation in one unknown is left; then go back."""
        lines: list[Line] = []
        pool = list(zip(residuals, written, strict=True))
        left = list(order)
        while len(pool) > 1:
            step = self._eliminate(pool, left, letters)
            if step is None:
                raise Undecided(
                    "the equations "
                    + ", ".join(f"({w.number})" for w in written)
                    + " are nonlinear in several unknowns at once"
                )
            index, x, formula = step
            _, equation = pool.pop(index)
            pool = [(tidy(r.xreplace({x: formula})), w) for r, w in pool]
            lines.append(
                Line(
                    x, formula, None, (equation.number,), tuple(s for s in left if s in formula.free_symbols and s != x)
                )
            )
            left.remove(x)
        residual, equation = pool[0]
        x = left[0]
        if vanishes(residual, x, algebra.value):
            return
        roots = real_roots(residual, x, algebra.value, self.symbolic, x in self.angles)
        for taken, root in enumerate(roots):
            after = copied(algebra)
            found = self._back(after, x, root, lines, equation.number)
            choice = Choice(x, residual, tuple(roots), taken, equation.number)
            yield after, SolvedBlock(written, order, (x,) if len(order) > 1 else (), (*lines, *found)), (choice,)

    def _eliminate(
        self, pool: list[tuple[sp.Expr, Written]], left: list[sp.Symbol], letters: tuple[sp.Symbol, ...]
    ) -> tuple[int, sp.Symbol, sp.Expr] | None:
        """An equation that is linear in one unknown, which it gives; unknowns that are not letters first."""
        for x in sorted(left, key=lambda s: s in letters):
            for index, (residual, _) in enumerate(pool):
                if x not in residual.free_symbols:
                    continue
                try:
                    form = linear_form(residual, {x})
                except Nonlinear:
                    continue
                if form.terms.get(x, sp.S.Zero) != 0:
                    return index, x, tidy(-form.constant / form.terms[x])
        return None

    def _back(self, algebra: Algebra, x: sp.Symbol, root: Root, lines: list[Line], number: int) -> list[Line]:
        exact = root.expression if root.expression is not None else sp.Rational(str(root.value))
        algebra.value = algebra.value.extended({x: root.value})
        algebra.formulas[x] = exact
        found = [Line(x, exact, root.value, (number,))]
        for line in reversed(lines):
            value = algebra.value(line.formula)
            algebra.value = algebra.value.extended({line.symbol: value})
            algebra.formulas[line.symbol] = line.formula
            found.append(Line(line.symbol, line.formula, value, line.equations))
        return found


def vanishes(residual: sp.Expr, x: sp.Symbol, value: Valuation) -> bool:
    """Does an equation hold for every value of its unknown? Then it follows from the others and says nothing of it."""
    tried = (value.extended({x: Decimal(n)}) for n in ("0.73205", "1.31607", "0.27915"))
    try:
        return all(v.is_zero(residual) for v in tried)
    except (ArithmeticError, LookupError):
        return False


def holds(definitions: Mapping[sp.Symbol, sp.Expr], symbol: sp.Symbol, unknowns: set[sp.Symbol]) -> bool:
    """Does a named intermediate rest on one of the unknowns?"""
    expr = definitions.get(symbol)
    if expr is None:
        return False
    return any(s in unknowns or holds(definitions, s, unknowns) for s in expr.free_symbols)


def copied(algebra: Algebra) -> Algebra:
    """The same state, to be extended on its own."""
    twin = Algebra(
        Valuation(dict(algebra.value.values), algebra.value.definitions),
        algebra.explicit,
        algebra.symbolic,
        algebra.unknowns,
    )
    twin.formulas = dict(algebra.formulas)
    return twin
