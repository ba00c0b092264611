"""A plan with unknowns that enter nonlinearly, carried out: every root of every such equation is a branch."""

from __future__ import annotations

import itertools
from collections.abc import Callable, Iterator, Sequence
from dataclasses import replace
from decimal import Decimal

import sympy as sp

from planar_cli.equation.algebra.form import Nonlinear, linear_form
from planar_cli.equation.values.exact import Valuation
from planar_cli.errors import NoValue, Undecided
from planar_cli.records import record
from planar_cli.solve.instant.algebra import Algebra, Line, SolvedBlock
from planar_cli.solve.instant.elimination import Pending, alone, closes, combined, eliminate
from planar_cli.solve.instant.plan import Block
from planar_cli.solve.instant.roots import Root, real_roots
from planar_cli.solve.instant.several_roots import roots_together
from planar_cli.solve.instant.written import Written


@record
class Choice:
    """One equation in one unknown with all its real roots, and the one that this branch takes."""

    symbol: sp.Symbol
    equation: sp.Expr
    roots: tuple[Root, ...]
    taken: int
    number: int
    together: bool = False
    """Was the root looked for with those of other unknowns?"""


@record
class Branch:
    """One way through the plan."""

    algebra: Algebra
    blocks: tuple[SolvedBlock, ...]
    choices: tuple[Choice, ...]


class Brancher:
    """Walks the blocks of a plan. `angles`: unknowns that are angles; `natural`: an ordinary size of each."""

    def __init__(
        self,
        unknowns: tuple[sp.Symbol, ...],
        angles: frozenset[sp.Symbol],
        symbolic: bool,
        natural: Callable[[sp.Symbol], Decimal],
    ) -> None:
        self.unknowns, self.angles, self.symbolic, self.natural = unknowns, angles, symbolic, natural
        self.repeated: set[int] = set()
        """The numbers of equations that came out as following from others of their block."""

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
        residuals = [algebra.in_unknowns(w, order) for w in written]
        if self._linear(residuals, order):
            after = copied(algebra)
            yield after, after.solve(block, written, self.unknowns), ()
            return
        letters = tuple(self.unknowns[j] for j in block.letters) or order
        yield from self._nonlinear(algebra, residuals, written, order, letters)

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
        """Express unknowns one at a time, until equations in one unknown are left, all of whose roots are followed."""
        pool = [Pending(r, (w.number,)) for r, w in zip(residuals, written, strict=True)]
        for after, lines, choices in self._reduced(copied(algebra), pool, order, letters, ()):
            shown = tuple(dict.fromkeys(c.symbol for c in choices)) if len(order) > 1 else ()
            yield after, SolvedBlock(written, order, shown, lines), choices

    def _reduced(
        self,
        algebra: Algebra,
        pool: list[Pending],
        left: tuple[sp.Symbol, ...],
        letters: tuple[sp.Symbol, ...],
        lines: tuple[Line, ...],
    ) -> Iterator[tuple[Algebra, tuple[Line, ...], tuple[Choice, ...]]]:
        """One step, and what follows from it; `lines`: unknowns expressed so far, by unknowns that are still left."""
        if not left:
            after = copied(algebra)
            try:
                back = self._back(after, lines)
            except NoValue:
                return
            if all(closes(p.residual, after.value) for p in pool):
                yield after, (*lines, *back), ()
            return
        told = [p for p in pool if any(s in p.residual.free_symbols for s in left)]
        if len(told) < len(left):
            self.repeated |= {max(p.numbers) for p in pool if p not in told and algebra.value.vanishes(p.residual)}
            return
        pool = told
        own = alone(pool, left)
        step = eliminate(pool, left, letters, algebra.value) if len(pool) > 1 else None
        if step is not None:
            line = replace(step.line, letters=tuple(s for s in left if s in step.line.formula.free_symbols))
            rest = tuple(s for s in left if s != line.symbol)
            yield from self._reduced(algebra, step.pool, rest, letters, (*lines, line))
        elif own is not None:
            yield from self._rooted(algebra, pool, own, left, letters, lines)
        else:
            smaller = combined(pool, left, algebra.value)
            if smaller is None:
                yield from self._together(algebra, pool, left, letters, lines)
            else:
                yield from self._reduced(algebra, smaller, left, letters, lines)

    def _together(
        self,
        algebra: Algebra,
        pool: list[Pending],
        left: tuple[sp.Symbol, ...],
        letters: tuple[sp.Symbol, ...],
        lines: tuple[Line, ...],
    ) -> Iterator[tuple[Algebra, tuple[Line, ...], tuple[Choice, ...]]]:
        """All roots that are found of equations of which none tells an unknown by the others."""
        numbers = tuple(dict.fromkeys(n for p in pool for n in p.numbers))
        told = f"the equations {', '.join(f'({n})' for n in numbers)} are nonlinear in several unknowns at once"
        if any(self.symbolic and _rests_on_letters(p.residual, algebra) for p in pool):
            raise Undecided(f"{told}, and hold letters; with numbers for these their roots can be looked for")
        found = roots_together([p.residual for p in pool], left, algebra.value, self.natural, self.angles)
        if not found:
            raise Undecided(f"{told}, and no root is found")
        for taken, root in enumerate(found):
            after = copied(algebra)
            after.value = after.value.extended(root)
            exact = {x: sp.Rational(str(v)) for x, v in root.items()}
            after.formulas |= exact
            own = tuple(Line(x, exact[x], root[x], numbers) for x in left)
            choices = tuple(
                Choice(x, p.residual, tuple(Root(None, r[x]) for r in found), taken, numbers[0], True)
                for x, p in zip(left, pool, strict=False)
            )
            for back, shown, others in self._reduced(after, [], (), letters, (*lines, *own)):
                yield back, shown, (*choices, *others)

    def _rooted(
        self,
        algebra: Algebra,
        pool: list[Pending],
        own: int,
        left: tuple[sp.Symbol, ...],
        letters: tuple[sp.Symbol, ...],
        lines: tuple[Line, ...],
    ) -> Iterator[tuple[Algebra, tuple[Line, ...], tuple[Choice, ...]]]:
        """All roots of an equation in one unknown."""
        pending = pool[own]
        x = next(s for s in left if s in pending.residual.free_symbols)
        rest = [p for i, p in enumerate(pool) if i != own]
        if vanishes(pending.residual, x, algebra.value):
            self.repeated.add(max(pending.numbers))
            return
        symbolic = self.symbolic and _rests_on_letters(pending.residual, algebra)
        roots = real_roots(pending.residual, x, algebra.value, symbolic, x in self.angles)
        for taken, root in enumerate(roots):
            after = copied(algebra)
            exact = root.expression if root.expression is not None else sp.Rational(str(root.value))
            after.value = after.value.extended({x: root.value})
            after.formulas[x] = exact
            line = Line(x, exact, root.value, pending.numbers)
            choice = Choice(x, pending.residual, tuple(roots), taken, pending.numbers[0])
            others = tuple(s for s in left if s != x)
            for found, told, choices in self._reduced(after, rest, others, letters, (*lines, line)):
                yield found, told, (choice, *choices)

    @staticmethod
    def _back(algebra: Algebra, lines: tuple[Line, ...]) -> list[Line]:
        """The unknowns that were expressed by others, the last one first, in numbers."""
        found = []
        for line in reversed(lines):
            if line.value is None:
                value = algebra.value(line.formula)
                if value and algebra.value.is_zero(line.formula):
                    value = Decimal(0)
                algebra.value = algebra.value.extended({line.symbol: value})
                algebra.formulas[line.symbol] = line.formula
                found.append(Line(line.symbol, line.formula, value, line.equations))
        return found


def _rests_on_letters(residual: sp.Expr, algebra: Algebra) -> bool:
    """Is there a letter without a number in an equation, or in what it takes from lines before it?"""
    known = {**algebra.value.definitions, **algebra.explicit, **algebra.formulas}
    waiting, seen = set(residual.free_symbols), set[sp.Symbol]()
    while waiting:
        symbol = waiting.pop()
        seen.add(symbol)
        waiting |= sp.sympify(known.get(symbol, sp.S.Zero)).free_symbols - seen
    return not seen.isdisjoint(algebra.value.drawn)


def vanishes(residual: sp.Expr, x: sp.Symbol, value: Valuation) -> bool:
    """Does an equation hold for every value of its unknown? Then it follows from the others and says nothing of it."""
    tried = (value.extended({x: Decimal(n)}) for n in ("0.73205", "1.31607", "0.27915"))
    return all(v.vanishes(residual) for v in tried)


def holds_between(residual: sp.Expr, x: sp.Symbol, roots: Sequence[Decimal], value: Valuation) -> bool:
    """Does it hold all the way from one root to the next, as an absolute value may make it do on one side of a place?
    Then these are no roots, but places at which it was looked for some.
    """
    for low, high in itertools.pairwise(sorted(roots)):
        tried = (value.extended({x: low + (high - low) * Decimal(n)}) for n in ("0.27915", "0.73205"))
        if low != high and all(v.vanishes(residual) for v in tried):
            return True
    return False


def copied(algebra: Algebra) -> Algebra:
    """The same state, to be extended on its own."""
    twin = Algebra(algebra.value.extended({}), algebra.explicit, algebra.symbolic, algebra.unknowns)
    twin.formulas = dict(algebra.formulas)
    return twin
