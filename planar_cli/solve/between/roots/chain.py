"""The equations of a motion solved in numbers, one small block after the other, along every branch of roots.

A block is one equation in one unknown, or two or three equations in as many unknowns that eliminate to one. Roots of
times are looked for in order from the state before.
"""

from __future__ import annotations

import itertools
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import field, replace
from decimal import Decimal

import sympy as sp

from planar_cli.calculus.first import roots
from planar_cli.calculus.polish import polish
from planar_cli.equation.algebra.common_factors import together
from planar_cli.equation.algebra.plain import letters
from planar_cli.equation.values.exact import Unvalued, Valuation
from planar_cli.equation.values.scales import slack_of
from planar_cli.errors import NoValue, Undecided
from planar_cli.records import record
from planar_cli.solve.between.roots.flat_roots import better_told
from planar_cli.solve.between.roots.integrals_that_hold import taken_out
from planar_cli.solve.between.roots.linked import independent, linked_blocks
from planar_cli.solve.between.roots.root_beside import root_beside
from planar_cli.solve.instant.branches import holds_between, vanishes
from planar_cli.solve.instant.elimination import Pending, alone, combined, eliminate, in_factors
from planar_cli.solve.instant.roots import Root, real_roots, turning
from planar_cli.solve.regimes.equations import Equation
from planar_cli.solve.regimes.regime import number_function

LARGEST = 3
MOST_ROOTS = 6
MOST_BRANCHES = 200
AGREES = Decimal("1e-18")
LATER = Decimal("1e-20")
NOTHING = Decimal("1e-45")
"""What the last of sixty digits leave of a zero, in parts of an ordinary size."""
LEFT, NEVER, SMALL = Decimal("1e-20"), Decimal("1e-12"), Decimal("1e-3")
"""Parts of an ordinary size: where all that stands in an equation is smaller, where a time is none, and below which
values of followed letters are compared with it.
"""
NEAR = Decimal("1e-6")
"""Values of a followed motion agree with exact ones up to this part."""


@record
class Line:
    """unknown = formula = value."""

    unknown: sp.Symbol
    formula: sp.Expr | None
    value: Decimal
    equations: tuple[Equation, ...]
    roots: tuple[Root, ...] = ()
    """All that were found for it."""
    taken: int = 0
    """Which of them this branch takes."""


@record
class Step:
    """One block: its equations, the unknowns that were eliminated and the one that was left, line by line."""

    equations: tuple[Equation, ...]
    unknowns: tuple[sp.Symbol, ...]
    lines: tuple[Line, ...]


@record
class Branch:
    """One way through all blocks."""

    values: dict[sp.Symbol, Decimal]
    formulas: dict[sp.Symbol, sp.Expr]
    steps: tuple[Step, ...]
    left: tuple[Equation, ...]


@record
class Chain:
    """The search for all roots of the equations between states."""

    unknowns: frozenset[sp.Symbol]
    """In the order of their states."""
    times: dict[sp.Symbol, sp.Symbol | None]
    """Unknowns that are times, each with the time before it; None: the first."""
    angles: dict[sp.Symbol, sp.Symbol | None]
    """Unknowns that are angles, each with the one from which its turns are counted."""
    value: Valuation
    symbolic: bool
    accept: Callable[[dict[sp.Symbol, Decimal]], bool] = lambda values: True
    truth: Mapping[sp.Symbol, float] = field(default_factory=dict)
    """Values to twelve digits where the motion was followed; then only the roots next to them are taken."""
    tends: Mapping[sp.Symbol, float] = field(default_factory=dict)
    """Values far along the way to states that are only approached; the root next to them is the limit."""
    agrees: Decimal = AGREES
    """To so many digits equations hold with what is known."""
    natural: Mapping[sp.Symbol, Decimal] = field(default_factory=dict)
    """An ordinary size of each unknown, beside which what is left of a zero is nothing."""

    def branches(self, equations: Sequence[Equation]) -> Iterator[Branch]:
        """All branches, those with earlier times first where the order tells."""
        start = {s: v for s, v in self.value.values.items() if s in self.unknowns}
        yield from itertools.islice(self._advance(dict(start), {}, (), tuple(equations)), MOST_BRANCHES)

    # --- search ------------------------------------------------------------------------------------------------------

    def _open(self, equation: Equation, values: dict[sp.Symbol, Decimal]) -> frozenset[sp.Symbol]:
        return (letters(equation.residual) & self.unknowns).difference(values)

    def _advance(
        self,
        values: dict[sp.Symbol, Decimal],
        formulas: dict[sp.Symbol, sp.Expr],
        steps: tuple[Step, ...],
        left: tuple[Equation, ...],
    ) -> Iterator[Branch]:
        if not self.truth and not self.accept(values):
            return
        here = self.value.extended(values)
        rest: list[tuple[Equation, frozenset[sp.Symbol]]] = []
        for e in left:
            unknowns = self._open(e, values)
            if unknowns:
                rest.append((e, unknowns))
            elif e.kind != "t(q)" and not self._holds(e, here):
                return
        if not rest:
            yield Branch(values, formulas, steps, ())
            return
        tried = False
        flat: list[tuple[tuple[Equation, ...], tuple[sp.Symbol, ...]]] = []
        for block, sought in itertools.chain(self._blocks(rest), self._linked(rest), flat):
            try:
                found = list(self._solve(block, sought, values, formulas))
            except Undecided:
                continue
            if self.truth and not found:
                continue
            if len(block) == 1 and found and (block, sought) not in flat:
                here = self.value.extended(found[0][0])
                if better_told(block[0], sought[0], rest, here, self.natural):
                    # It comes again at the end, should no other equation be solved.
                    flat.append((block, sought))
                    continue
            tried = True
            others = tuple(e for e in left if e not in block)
            for after, forms, step in found:
                yield from self._advance(after, forms, (*steps, step), others)
            break
        if not tried:
            yield Branch(values, formulas, steps, tuple(e for e, _ in rest))

    def _holds(self, equation: Equation, value: Valuation) -> bool:
        try:
            agrees = self._closes(equation.residual, value, self.agrees)
            return agrees and (equation.trend is None or value(equation.trend) >= -AGREES)
        except NoValue:
            return False
        except Unvalued:
            return True

    def _blocks(
        self, rest: list[tuple[Equation, frozenset[sp.Symbol]]]
    ) -> Iterator[tuple[tuple[Equation, ...], tuple[sp.Symbol, ...]]]:
        """Blocks that could be solved now, the smallest and plainest first."""
        for size in range(1, LARGEST + 1):
            found = []
            small = [(e, u) for e, u in rest if len(u) <= size]
            if len(small) > 40 and size > 2:
                small = sorted(small, key=lambda x: x[0].cost)[:40]
            for group in itertools.combinations(small, size):
                union = frozenset().union(*(u for _, u in group))
                if len(union) != size:
                    continue
                members = tuple(e for e, _ in group)
                if not independent(members):
                    continue
                cost = sum(e.cost for e in members)
                found.append((cost, self._order(union), members, union))
            found.sort(key=lambda x: (x[0], x[1]))
            for _, _, members, union in found:
                yield members, tuple(sorted(union, key=lambda s: s.name))

    def _linked(
        self, rest: list[tuple[Equation, frozenset[sp.Symbol]]]
    ) -> Iterator[tuple[tuple[Equation, ...], tuple[sp.Symbol, ...]]]:
        """Larger blocks, where unknowns that enter linearly are expressed first."""
        plain = [e for e, _ in rest if not e.residual.has(sp.Integral)]
        unknowns = frozenset().union(*(u for _, u in rest))
        return linked_blocks(plain, unknowns, tuple(self.times))

    def _order(self, union: frozenset[sp.Symbol]) -> int:
        """States are solved in their order where there is a choice."""
        names = list(self.times)
        return max((names.index(s) for s in union if s in self.times), default=0)

    # --- one block ---------------------------------------------------------------------------------------------------

    def _solve(
        self,
        block: tuple[Equation, ...],
        unknowns: tuple[sp.Symbol, ...],
        values: dict[sp.Symbol, Decimal],
        formulas: dict[sp.Symbol, sp.Expr],
    ) -> Iterator[tuple[dict[sp.Symbol, Decimal], dict[sp.Symbol, sp.Expr], Step]]:
        """Eliminate unknowns until one equation holds one alone; all its roots, and so on with the others."""
        pool = [Pending(e.residual, ()) for e in block]
        for found in self._unfold(pool, list(unknowns), values):
            after, forms, lines = dict(values), dict(formulas), []
            for told in found:
                nothing = NOTHING * self.natural.get(told.unknown, Decimal(1))
                line = replace(told, value=Decimal(0)) if abs(told.value) < nothing else told
                after[line.unknown] = line.value
                if line.formula is not None:
                    forms[line.unknown] = line.formula
                lines.append(replace(line, equations=block))
            yield after, forms, Step(block, unknowns, tuple(lines))

    def _unfold(
        self, pool: list[Pending], left: list[sp.Symbol], values: dict[sp.Symbol, Decimal]
    ) -> Iterator[list[Line]]:
        """All ways to solve these equations for the unknowns left."""
        here = self.value.extended(values)
        if not left:
            if all(self._closed(p.residual, here) for p in pool):
                yield []
            return
        if factored := in_factors(pool, frozenset(left)):
            for one in factored:
                yield from self._unfold(one, left, values)
            return
        index = alone(pool, left)
        if index is not None:
            yield from self._rooted(pool, index, left, values)
            return
        if any(not set(p.residual.free_symbols) & set(left) and not self._closed(p.residual, here) for p in pool):
            return
        step = eliminate(pool, left, tuple(self.times), here, tuple(self.times)) if len(pool) > 1 else None
        if step is None:
            more = combined(pool, left, here, self.symbolic)
            if more is None:
                raise Undecided("equations of the motion are nonlinear in several unknowns at once")
            yield from self._unfold(more, left, values)
            return
        x, formula = step.line.symbol, step.line.formula
        for found in self._unfold(step.pool, [s for s in left if s != x], values):
            try:
                number = self.value.extended({**values, **{line.unknown: line.value for line in found}})(formula)
            except NoValue:
                continue
            if self._may_be(number, x) and (x not in self.truth or self._near(number, x)):
                yield [*found, Line(x, formula, number, ())]

    def _closed(self, residual: sp.Expr, here: Valuation) -> bool:
        """Does a residual with known values vanish?"""
        return here.known(residual) is not None and self._closes(residual, here, AGREES)

    def _closes(self, residual: sp.Expr, here: Valuation, agrees: Decimal) -> bool:
        """The same; where all that it is made of nearly vanishes, beside what that ordinarily is."""
        number = abs(here(residual))
        if number <= agrees * here.size(residual):
            return True
        return number <= agrees * LEFT * slack_of(residual, [*self.unknowns], self.natural, here)

    def _rooted(
        self, pool: list[Pending], index: int, left: list[sp.Symbol], values: dict[sp.Symbol, Decimal]
    ) -> Iterator[list[Line]]:
        """Every root of the one equation that holds a single unknown, and the rest with it."""
        residual = taken_out(pool[index].residual)
        x = next(s for s in left if s in residual.free_symbols)
        here = self.value.extended(values)
        if vanishes(residual, x, here):
            raise Undecided("these equations say the same")
        every = [r for r in self._roots(residual, x, here) if self._may_be(r.value, x)]
        if holds_between(residual, x, [r.value for r in every], here):
            raise Undecided("these equations say the same over some distance")
        others = [p for i, p in enumerate(pool) if i != index]
        nearest = min((abs(float(r.value) - self.tends[x]) for r in every), default=0.0) if x in self.tends else 0.0
        for taken, root in enumerate(every):
            if x in self.truth and not self._near(root.value, x):
                continue
            if x in self.tends and abs(float(root.value) - self.tends[x]) > nearest:
                continue
            line = Line(x, root.expression, root.value, (), tuple(every), taken)
            for found in self._unfold(others, [s for s in left if s != x], {**values, x: root.value}):
                yield [line, *found]

    def _roots(self, residual: sp.Expr, x: sp.Symbol, here: Valuation) -> list[Root]:
        """All real roots; a time only after the state before it, an angle with its turns."""
        known = x in self.truth and not residual.is_polynomial(x)
        if known and not self.symbolic and (near := self._followed_to(residual, x, here)) is not None:
            return near
        if x in self.times:
            return self._times(residual, x, here)
        try:
            found = real_roots(residual, x, here, self.symbolic, False)
        except Undecided:
            if known and (near := self._followed_to(residual, x, here)) is not None:
                return near
            found = real_roots(residual, x, here, False, False)
        if x in self.angles:
            found = self._turned(found, residual, x, here)
        return found

    def _followed_to(self, residual: sp.Expr, x: sp.Symbol, here: Valuation) -> list[Root] | None:
        at = Decimal(repr(self.truth[x]))
        return root_beside(residual, x, here, at, max(abs(at), SMALL * self.natural[x]))

    def _may_be(self, number: Decimal, x: sp.Symbol) -> bool:
        """A distance is not negative; a coefficient that the data make negative is left to what tells that."""
        return not x.is_nonnegative or bool(x.is_positive) or number >= -NOTHING * self.natural.get(x, Decimal(1))

    def _near(self, number: Decimal, x: sp.Symbol) -> bool:
        """Is a value the one that the motion which was followed shows?"""
        truth = Decimal(repr(self.truth[x]))
        return abs(number - truth) <= NEAR * max(abs(truth), SMALL * self.natural[x])

    def _times(self, residual: sp.Expr, x: sp.Symbol, here: Valuation) -> list[Root]:
        before = self.times[x]
        known = before is not None and before in here.values
        after = here(before) if before is not None and known else None
        closed = _closed_roots(residual, x, here, self.symbolic)
        if closed is None:
            start = float(after) if after is not None else 0.0
            closed = self._searched(residual, x, here, start)
        if after is None:
            return closed
        size = max(abs(after), NEVER * self.natural[x])
        return [r for r in closed if r.value > after + LATER * size or before is None]

    def _searched(self, residual: sp.Expr, x: sp.Symbol, here: Valuation, start: float) -> list[Root]:
        """The next roots of a time, or the one next to the truth."""
        g = number_function([residual], [x], here)
        until = None
        if x in self.truth:
            until = self.truth[x] + 1e-6 * max(abs(self.truth[x] - start), 1e-9 * float(self.natural[x]))
            start = min(start, self.truth[x])
        found = itertools.islice(roots(lambda t: g(t)[0], start, until), MOST_ROOTS if until is None else 200)
        closed = []
        for r in found:
            try:
                closed.append(Root(None, _polished(residual, x, here, r.low, r.high)))
            except NoValue:
                continue
        return closed

    def _turned(self, roots: list[Root], residual: sp.Expr, x: sp.Symbol, here: Valuation) -> list[Root]:
        """Roots of a trigonometric equation in all the turns about the state before."""
        if not residual.has(sp.sin, sp.cos, sp.tan):
            return roots
        near = self.angles[x]
        center = here(near) if near is not None and near in here.values else Decimal(0)
        center = Decimal(repr(self.truth[x])) if x in self.truth else center
        found: dict[str, Root] = {}
        turn = _turn(residual, x)
        whole = here(turn)
        for root in roots:
            turns = int((center - root.value) / whole)
            for k in range(turns - 2, turns + 3):
                value = root.value + whole * k
                if abs(value - center) <= whole + Decimal("0.01"):
                    expr = root.expression + turn * k if root.expression is not None else None
                    found[str(round(value, 25))] = Root(expr, value)
        return sorted(found.values(), key=lambda r: abs(r.value - center))


def _turn(residual: sp.Expr, x: sp.Symbol) -> sp.Expr:
    """After how much of x a trigonometric equation comes again: a whole turn of the one angle in which x stands."""
    paces = {*turning(residual, x).values()}
    return 2 * sp.pi / sp.Abs(paces.pop()) if len(paces) == 1 else 2 * sp.pi


def _closed_roots(residual: sp.Expr, x: sp.Symbol, here: Valuation, symbolic: bool) -> list[Root] | None:
    """Roots in closed form, or of a polynomial; None where they must be looked for."""
    numerator = sp.fraction(together(residual))[0]
    inside = {s: here(s) for s in numerator.free_symbols if s != x and s in here.values}
    if not numerator.is_polynomial(x):
        flat = numerator.xreplace({s: sp.Rational(str(v)) for s, v in inside.items()})
        if not flat.is_polynomial(x):
            return None
    try:
        return real_roots(residual, x, here, symbolic, False)
    except Undecided:
        return real_roots(residual, x, here, False, False)


def _polished(residual: sp.Expr, x: sp.Symbol, here: Valuation, low: float, high: float) -> Decimal:
    return polish(lambda t: here.extended({x: t})(residual), Decimal(low), Decimal(high))
