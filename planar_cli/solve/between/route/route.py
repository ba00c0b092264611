"""The cheapest way through the equations of a motion to what is asked, and that way worked out in symbols.

An unknown follows from one equation in which all others are known, or from two or three equations together; the
cheapest derivation of every unknown is taken. All values are known beforehand, so that only equations
count that really fix their unknown there, and of several roots the one that happens is taken.
"""

from __future__ import annotations

import itertools
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import replace
from decimal import Decimal

import sympy as sp

from planar_cli.equation.algebra.plain import by_name, derivative, letters, longer, simplified
from planar_cli.equation.values.exact import Valuation
from planar_cli.errors import Undecided
from planar_cli.solve.between.roots.chain import Step
from planar_cli.solve.between.roots.closed import closed_roots
from planar_cli.solve.between.roots.extremes import with_aims
from planar_cli.solve.between.roots.linked import independent
from planar_cli.solve.between.roots.one_by_one import one_by_one, without_factors
from planar_cli.solve.between.roots.quarters import at_quarters, is_harmonic
from planar_cli.solve.between.roots.substitution import linear_step, same_as
from planar_cli.solve.between.route.angles_between import by_angles, by_the_angle_between
from planar_cli.solve.between.route.at_hand import at_hand
from planar_cli.solve.between.route.by_given import beginnings, by_given, by_its_name, with_constants
from planar_cli.solve.between.route.by_numbers import ByNumbers
from planar_cli.solve.between.route.by_squares import by_squares
from planar_cli.solve.between.route.by_targets import by_targets
from planar_cli.solve.between.route.cheapest import cheapest
from planar_cli.solve.between.route.inside_integrals import inside_integrals, outside_integrals
from planar_cli.solve.between.trace.derivation import (
    Derivation,
    DerivedStep,
    Edge,
    Route,
    at_right_angles,
    each_once,
    levels,
)
from planar_cli.solve.between.trace.trace import Result
from planar_cli.solve.multibody.linear import determinant, solve
from planar_cli.solve.regimes.costs import HIDDEN
from planar_cli.solve.regimes.equations import DATA, Equation

MANY = 4
"""Of so many unknowns together letters that are another's leave the equations."""
LONG_POOL = 30
"""A longer remainder is not put in a plainer form where numbers stand behind it."""
WHOLE = 8
"""So many unknowns at most are told as found together."""
TOGETHER = 0.8
"""What solving equations together costs beside them."""


class Router:
    """Plans over the equations of one motion. `value`: numbers of everything; `unknowns`: letters of states and sought
    constants; `blocks`: those in which numbers were found; `followed`: what only a step method tells; `natural`: an
    ordinary size of each unknown; `kinetics`: states up to which an acceleration is asked or needed.
    """

    def __init__(
        self,
        equations: Sequence[Equation],
        unknowns: frozenset[sp.Symbol],
        value: Valuation,
        symbolic: bool,
        blocks: Sequence[Step] = (),
        followed: ByNumbers | None = None,
        natural: Mapping[sp.Symbol, Decimal] | None = None,
        kinetics: frozenset[str] = frozenset(),
    ) -> None:
        self.unknowns, self.value, self.symbolic, self.blocks = unknowns, value, symbolic, blocks
        self.followed, self.natural, self.kinetics = followed, natural or {}, kinetics
        self.plain = self._plain(equations)
        self._residuals: dict[sp.Expr, sp.Expr] = {}
        equations = [without_factors(e, value) for e in with_aims(equations)]
        equations = by_given([by_the_angle_between(e, unknowns, value) for e in equations], unknowns, self.plain)
        self.equations = [e for e in equations if self._inside(e) and self._true(e)]
        self._zeros: dict[sp.Symbol, sp.Expr] = {}
        self._same: dict[sp.Symbol, sp.Expr] = {}
        self._level: dict[sp.Symbol, sp.Expr] = {}

    def residual(self, equation: Equation) -> sp.Expr:
        """With zeros and names of the file put in."""
        if not self.plain:
            return equation.residual
        if (found := self._residuals.get(equation.residual)) is None:
            found = self._residuals[equation.residual] = equation.residual.xreplace(self.plain)
        return found

    def _true(self, equation: Equation) -> bool:
        """Does a time by the place hold? Only as long as the motion does not turn round."""
        if equation.kind != "t(q)":
            return True
        value = self.value.roughly()
        number = value.known(equation.residual)
        return number is not None and abs(number) <= Decimal("1e-9") * value.size(equation.residual)

    def _inside(self, equation: Equation) -> frozenset[sp.Symbol]:
        return letters(self.residual(equation)) & self.unknowns

    def _plain(self, equations: Sequence[Equation]) -> dict[sp.Symbol, sp.Expr]:
        """Data that need no line: zeros, names of the file or their opposites, starting times; and what stays so."""
        found, changed = dict[sp.Symbol, sp.Expr](), True
        begins = beginnings(equations)
        while changed:
            changed = False
            for e in equations:
                if e.kind not in (*DATA, "v(t)", "link", "q(t)"):
                    continue
                residual = e.residual.xreplace(found)
                inside = by_its_name(e, residual, letters(residual) & self.unknowns, begins)
                if len(inside) != 1 or inside & found.keys():
                    continue
                (x,) = inside
                rate = derivative(residual, x)
                if x in letters(rate) or rate == 0:
                    continue
                datum = simplified(-residual.subs(x, 0) / rate)
                if datum == 0 or ((datum.is_Symbol or (-datum).is_Symbol) and e.kind in DATA and not e.told):
                    found[x] = datum
                    found = {k: v.xreplace({x: datum}) for k, v in found.items()}
                    changed = True
        return found

    # --- plan --------------------------------------------------------------------------------------------------------

    def route(self, targets: Iterable[sp.Symbol]) -> Route:
        """The way to all targets that can be derived."""
        targets = with_constants(targets, self.plain, self.unknowns)
        best = cheapest(edges := self._edges())
        for more in (self._rings, self._large, self._of_integrals):
            if any(t not in best and t not in self.plain for t in targets):
                edges += more()
                best = cheapest(edges)
        for target in targets:
            if target not in best and target not in self.plain:
                whole = self._whole(target, best)
                if whole is not None:
                    edges.append(whole)
                    best = cheapest(edges)
        if self.followed is not None and any(t not in best and t not in self.plain for t in targets):
            best = {**cheapest(self.followed.edges(edges)), **best}
        if (cheaper := at_hand(best, edges, targets, self.plain, self.value, self.kinetics)) is not None:
            best = {**best, **cheapest(edges := cheaper)}
        best = by_targets(best, edges, targets, self.plain)
        order: list[Derivation] = []
        # What only numbers tell, and nothing else rests on, comes last.
        for target in sorted(targets, key=lambda t: t in best and best[t].equations[0].kind == "followed"):
            self._collect(target, best, order)
        formulas, steps = dict[sp.Symbol, sp.Expr](self.plain), list[DerivedStep]()
        derivations = one_by_one(each_once(order), self._inside, self._regular)
        for derivation in derivations:
            used = frozenset(targets).union(*(d.needs for d in derivations if d is not derivation))
            step = self._work(derivation, used)
            if step is None:
                continue
            steps.append(step)
            told = [] if derivation.equations[0].kind == "followed" else step.results
            self._zeros |= {r.unknown: r.formula for r in told if r.formula == 0}
            self._same |= same_as(told, formulas)
            self._level |= levels([*self._level.items(), *((r.unknown, r.formula) for r in told)])
            formulas |= {r.unknown: r.formula for r in told if r.formula is not None}
        return Route(tuple(steps), formulas, self.plain)

    def _collect(self, target: sp.Symbol, best: dict[sp.Symbol, Derivation], order: list[Derivation]) -> None:
        derivation = best.get(target)
        if derivation is None or derivation in order:
            return
        for need in sorted(derivation.needs, key=lambda s: s.name):
            self._collect(need, best, order)
        if derivation not in order:
            order.append(derivation)

    def _edges(self) -> list[Edge]:
        """Every unknown from one equation, every two from two."""
        found: list[Edge] = []
        small: list[tuple[Equation, frozenset[sp.Symbol]]] = []
        for e in self.equations:
            inside = self._inside(e)
            small.append((e, inside))
            for x in by_name(inside):
                hidden = self._hidden(e, x)
                if hidden is not None:
                    found.append(((e,), (x,), inside - {x}, e.cost + 0.05 * len(inside) + hidden))
        for (e, a), (f, b) in itertools.combinations(small, 2):
            shared = a & b
            if e.kind in DATA and f.kind in DATA and len(shared) < 2:
                continue
            for pair in itertools.combinations(sorted(shared, key=lambda s: s.name), 2):
                if self._regular((e, f), pair):
                    hidden = sum(self._hidden(g, x) or 0.0 for g in (e, f) for x in pair) / 2
                    cost = e.cost + f.cost + TOGETHER + hidden + 0.05 * len(a | b)
                    found.append(((e, f), pair, (a | b) - set(pair), cost))
        return found

    def _rings(self) -> list[Edge]:
        """Three unknowns from three equations, each of which shares one with each of the others."""
        found: list[Edge] = []
        inside = [(e, self._inside(e)) for e in self.equations if not e.residual.has(sp.Integral)]
        for (e, a), (f, b), (g, c) in itertools.combinations(inside, 3):
            if not (a & b and b & c and c & a):
                continue
            threes = {tuple(by_name(set(t))) for t in itertools.product(a & b, b & c, c & a) if len(set(t)) == 3}
            for unknowns in sorted(threes, key=lambda three: [s.name for s in three]):
                if self._regular((e, f, g), unknowns):
                    cost = e.cost + f.cost + g.cost + 2 * TOGETHER + 0.05 * len(a | b | c)
                    found.append(((e, f, g), unknowns, (a | b | c) - {*unknowns}, cost))
        return found

    def _of_integrals(self) -> list[Edge]:
        """What stands inside an integral over a way."""
        return inside_integrals(self.equations, self._inside, self.residual, self.value)

    def _large(self) -> list[Edge]:
        """The larger blocks in which the numbers were found."""
        found: list[Edge] = []
        for step in self.blocks:
            unknowns = tuple(x for x in step.unknowns if x not in self.plain)
            equations = tuple(without_factors(e, self.value) for e in step.equations if self._inside(e))
            if len(equations) == len(unknowns) > 1:
                inside = frozenset().union(*(self._inside(e) for e in equations))
                cost = sum(e.cost for e in equations) + TOGETHER * len(equations)
                found.append((equations, unknowns, inside - set(unknowns), cost))
        return found

    def _whole(self, target: sp.Symbol, best: dict[sp.Symbol, Derivation]) -> Edge | None:
        """All equations that fix a target together, found by adding those with the fewest further unknowns."""
        equations: list[Equation] = []
        unknowns = {target}
        usable = [e for e in self.equations if not e.residual.has(sp.Integral) and e.kind not in ("v(q)", "q(v)")]
        while len(unknowns) <= WHOLE:
            further: list[tuple[int, float, int, Equation, set[sp.Symbol]]] = []
            for e in usable:
                fresh = {s for s in self._inside(e) if s not in best} - unknowns
                if e not in equations and self._inside(e) & unknowns:
                    further.append((len(fresh), e.cost, len(further), e, fresh))
            for _, _, _, e, fresh in sorted(further, key=lambda f: f[:3]):
                if self._adds([*equations, e], unknowns | fresh):
                    equations.append(e)
                    unknowns |= fresh
                    break
            else:
                return None
            if len(equations) == len(unknowns):
                needs = frozenset().union(*(self._inside(e) for e in equations)) - unknowns
                cost = sum(e.cost for e in equations) + TOGETHER * len(equations)
                return tuple(equations), tuple(sorted(unknowns, key=lambda s: s.name)), needs, cost
        return None

    def _adds(self, equations: list[Equation], unknowns: set[sp.Symbol]) -> bool:
        """Are these equations independent in these unknowns?"""
        columns = sorted(unknowns, key=lambda s: s.name)
        rows = self._slopes(equations, columns)
        if rows is None:
            return False
        solved = solve([[*row, Decimal(0)] for row in rows], len(columns))
        return len(solved.null) == len(columns) - len(equations)

    def _slopes(self, equations: Iterable[Equation], unknowns: Sequence[sp.Symbol]) -> list[list[Decimal]] | None:
        """How much each equation changes with each unknown; None: that has no value, or none that is finite."""
        rows = [[self.value.known(derivative(self.residual(e), x)) for x in unknowns] for e in equations]
        found = [[c for c in row if c is not None and c.is_finite()] for row in rows]
        return found if all(len(row) == len(unknowns) for row in found) else None

    def _hidden(self, equation: Equation, x: sp.Symbol) -> float | None:
        """What it costs to solve for x: nothing where it enters plainly. None: the equation does not fix x here."""
        residual = self.residual(equation)
        rate = derivative(residual, x)
        if self.value.known(rate) is None:
            return None
        if self.value.is_zero(rate):
            return None if x not in letters(rate) else self._double(rate, x)
        if residual.has(sp.Integral):
            return HIDDEN if equation.kind != "t(q)" or x in outside_integrals(residual) else None
        if x not in letters(rate):
            return 0.0
        return 0.3 if residual.is_polynomial(x) else HIDDEN * (2 if equation.kind == "t(q)" else 1)

    def _double(self, rate: sp.Expr, x: sp.Symbol) -> float | None:
        """A double root, as at a turning point, still fixes x if the equation is quadratic there."""
        bend = derivative(rate, x)
        return None if self.value.known(bend) is None or self.value.is_zero(bend) else HIDDEN

    def _regular(self, equations: tuple[Equation, ...], unknowns: tuple[sp.Symbol, ...]) -> bool:
        """Do as many equations fix these unknowns?"""
        if any(e.residual.has(sp.Integral) for e in equations) or not independent(equations):
            return False
        if (rows := self._slopes(equations, unknowns)) is None:
            return False
        scaled = [[c / (max(abs(v) for v in row) or Decimal(1)) for c in row] for row in rows]
        return abs(determinant(scaled)) > Decimal("1e-18")

    # --- work --------------------------------------------------------------------------------------------------------

    def _work(self, derivation: Derivation, used: frozenset[sp.Symbol]) -> DerivedStep | None:
        """Solve in symbols; of several roots the one with the known value. `used`: what is asked, or others need."""
        pool = [
            self._in_place(e, self._without_zeros(self.residual(e), derivation.unknowns)) for e in derivation.equations
        ]
        left = list(derivation.unknowns)
        back: list[tuple[sp.Symbol, sp.Expr]] = []
        most, by_time = (60, None) if self.symbolic else (LONG_POOL, used)
        while len(pool) > 1 and (step := linear_step(pool, left, self.value, most, by_time)) is not None:
            index, x, formula = step
            pool.pop(index)
            put = [r.xreplace({x: formula}) for r in pool]
            pool = [r if longer(r, LONG_POOL) and not self.symbolic else simplified(r) for r in put]
            back.append((x, formula))
            left.remove(x)
        results: list[Result] = []
        if len(pool) == 1:
            results.append(self._by_phase(derivation, pool[0]) or self._single(pool[0], left[0]))
            results += [Result(x, formula, self.value(x)) for x, formula in reversed(back)]
        else:
            results = by_squares(pool, left, self.value, self._single) or by_angles(
                pool, left, self.value, self._single
            )
            results = results or [Result(x, None, self.value(x)) for x in derivation.unknowns]
        datum = len(derivation.equations) == 1 and derivation.equations[0].kind in DATA and not derivation.needs
        return DerivedStep(derivation, tuple(results), datum and not _is_high(derivation))

    def _without_zeros(self, residual: sp.Expr, unknowns: Sequence[sp.Symbol]) -> sp.Expr:
        """An equation without letters that were found to be zero, where it still tells its unknowns."""
        if residual.has(sp.Integral):
            return residual
        found = residual.xreplace(self._zeros if len(unknowns) < MANY else {**self._zeros, **self._same})
        lost = (residual.free_symbols - found.free_symbols) & set(unknowns)
        return residual if lost or found.has(sp.nan, sp.zoo) else found

    def _in_place(self, e: Equation, residual: sp.Expr) -> sp.Expr:
        """An equation of a blow with the right angles of the place where it happens."""
        return at_right_angles(residual, self._level) if e.kind == "blow" else residual

    def _by_phase(self, derivation: Derivation, residual: sp.Expr) -> Result | None:
        """The one unknown of a simple harmonic motion a quarter or half a period after its beginning."""
        (e, *more), (x, *others) = derivation.equations, derivation.unknowns
        told = None if more or others or not is_harmonic(e) else at_quarters(residual, x, self.value)
        return None if told is None else replace(self._single(told[0], x), formula=told[1])

    def _single(self, residual: sp.Expr, x: sp.Symbol) -> Result:
        truth = self.value(x)
        try:
            roots = closed_roots(residual, x, self.value, truth, self.symbolic)
        except Undecided:
            roots = []
        near = Decimal("1e-11") * max(abs(truth), Decimal("1e-6") * self.natural.get(x, Decimal(1)))
        taken = next((r for r in roots if abs(r.value - truth) <= near), None)
        formula = None if taken is None else taken.expression
        return Result(x, formula, truth, tuple(roots))


def _is_high(derivation: Derivation) -> bool:
    """Is it of more than a square? Then it is not what the file says of its unknown, but follows from that."""
    residual, x = derivation.equations[0].residual, derivation.unknowns[0]
    return bool(residual.is_polynomial(x)) and sp.degree(residual, x) > 2
