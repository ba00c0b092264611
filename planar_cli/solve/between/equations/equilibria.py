"""Equilibrium states. No motion has to lead to them, so they stand beside the order of states: what they say of places
and what equilibrium demands (free speeds and their rates vanish) are solved on their own.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import replace
from decimal import Decimal
from types import MappingProxyType
from typing import Any

import sympy as sp

from planar_cli.equation.algebra.plain import by_name, derivative, simplified
from planar_cli.equation.values.exact import PI, Valuation
from planar_cli.errors import Diagnostic, NoSolution, undecided_at
from planar_cli.problem.implied.not_negative import not_negative
from planar_cli.problem.language.expression import Statement
from planar_cli.problem.scene.order_of_states import as_listed
from planar_cli.problem.scene.scene import State
from planar_cli.records import record
from planar_cli.solve.between.roots.chain import Branch, Chain
from planar_cli.solve.between.roots.extremes import stationary
from planar_cli.solve.diagnosis.words import listed
from planar_cli.solve.instant.several_roots import roots_together
from planar_cli.solve.regimes.equations import Equation, drawn_equations, loop_equations, stated_equations
from planar_cli.solve.regimes.regime_sequence import RegimeSequence
from planar_cli.solve.regimes.timeline import Demand, Stop

TINY = Decimal("1e-15")
SAME = Decimal("1e-12")
ASIDE = Decimal("1e-4")
"""By this part of an ordinary size a constant is changed, to see whether what is largest becomes less."""
Raw = Mapping[str, list[tuple[Statement, tuple[Any, ...]]]]


@record
class Equilibria:
    """The equilibrium states of a problem: their equations, and the one way in which these hold."""

    states: tuple[State, ...]
    demands: Mapping[str, tuple[Demand, ...]]
    equations: tuple[Equation, ...]
    branch: Branch


def solve_equilibria(course: RegimeSequence, raw: Raw, start: Mapping[str, Iterable[Demand]]) -> Equilibria:
    """Solve all equilibrium states. `start`: what the first state says, by its name. NoSolution: there is none, or
    several places fit.
    """
    states = tuple(state for state, _ in course.modes.equilibria)
    demands: dict[str, tuple[Demand, ...]] = {}
    equations: list[Equation] = []
    drawn: list[Equation] = []
    for state in states:
        reader, stop = course.readers[state.name], course.stops[state.name]
        demands[state.name] = tuple(reader.demands(stop, raw[state.name]))
        equations += stated_equations(demands[state.name])
        equations += loop_equations(reader.regime, course.first, stop)
        if state.name == as_listed(course.problem.states)[0].name:
            drawn += drawn_equations(reader.regime, stop)
    if not states:
        return Equilibria((), {}, (), Branch({}, {}, (), ()))
    if not drawn:
        equations = _from_start(course, equations, start.get(course.first.name, ()))
    _demand_placed(course, states, [*equations, *drawn])
    equations += _stationary(course, states, demands, [*equations, *drawn])
    whole = _branches(course, states, demands, [*equations, *drawn])
    mark, names = states[0].mark, ", ".join(s.name for s in states)
    if not whole and drawn and _branches(course, states, demands, equations):
        first = as_listed(course.problem.states)[0]
        text = f"{first.name}: the forces do not balance as drawn, and the first state is drawn"
        hint = "write the points that may move with `coordinates`, or let a state that is as drawn come before it"
        raise NoSolution([Diagnostic(first.mark, "PL630", text, hint)])
    if not whole:
        _demand_letter_by_letter(course, states, demands, [*equations, *drawn])
        hint = "check the relations of the state, and whether the forces can balance at all"
        raise NoSolution([Diagnostic(mark, "PL630", f"{names}: no position of equilibrium is found", hint)])
    whole = _tops(course, states, demands, [*equations, *drawn], whole)
    if not whole:
        extreme = next(d for ds in demands.values() for d in ds if d.kind == "extreme")
        hint = "ask for the other extreme, or state the limit itself up to which it may grow"
        text = f"{extreme.state}: `{extreme.text}` nowhere: it does not become less on both sides"
        raise NoSolution([Diagnostic(extreme.mark, "PL630", text, hint)])
    if len(whole) > 1:
        stops = [course.stops[s.name] for s in states]
        places = "; ".join(_place(b, whole, stops, course.sought()) for b in whole[:6])
        hint = "say which is meant: give the coordinate, or an inequality"
        raise NoSolution([Diagnostic(mark, "PL630", f"{names}: several positions of equilibrium: {places}", hint)])
    return Equilibria(states, demands, (*equations, *drawn), whole[0])


def _demand_placed(course: RegimeSequence, states: tuple[State, ...], equations: list[Equation]) -> None:
    """NoSolution: where a guide lies depends on the place of a free particle, which nothing tells."""
    scene = course.readers[states[0].name].regime.general.instant.scene
    own = {c.symbol for s in states for c in course.readers[s.name].regime.coordinates}
    loose = {x for e in equations for x in e.residual.free_symbols & scene.open_places} - own
    if loose:
        bodies = listed(name for name, b in scene.bodies.items() if loose & {b.center.x, b.center.y})
        text = f"{states[0].name}: {bodies} is free, and nothing tells where its guide lies"
        hint = "draw it there, `particle: [x, y]`, or write what is known of its place in the state"
        raise NoSolution([Diagnostic(states[0].mark, "PL623", text, hint)])


def _from_start(course: RegimeSequence, equations: list[Equation], said: Iterable[Demand]) -> list[Equation]:
    """The equations with the places of the first state put in, from which what rolls counts its way. NoSolution: that
    state does not tell them one by one.
    """
    first = course.first
    own = {*first.letters.values()} - {
        v for s, _ in course.modes.equilibria for v in course.stops[s.name].letters.values()
    }
    needed = {s for e in equations for s in e.residual.free_symbols & own}
    regime = course.readers[first.name].regime
    told: dict[sp.Symbol, sp.Expr] = {}
    for e in (*stated_equations(said), *drawn_equations(regime, first)) if needed else ():
        inside = e.residual.free_symbols & own
        symbol = next(iter(inside)) if len(inside) == 1 else None
        slope = derivative(e.residual, symbol) if symbol in needed else sp.S.Zero
        if symbol is not None and slope != 0 and not slope.has(symbol):
            told.setdefault(symbol, simplified(symbol - e.residual / slope))
    if needed - told.keys():
        states = ", ".join(s.name for s, _ in course.modes.equilibria)
        text = f"{states}: where the equilibrium lies depends on the place in state {first.name}, which is not told"
        hint = f"write the equilibrium before state {first.name}, or the place itself there"
        raise NoSolution([Diagnostic(first.mark, "PL630", text, hint)])
    return [replace(e, residual=e.residual.xreplace(told)) for e in equations]


def _stationary(
    course: RegimeSequence,
    states: tuple[State, ...],
    demands: Mapping[str, tuple[Demand, ...]],
    equations: list[Equation],
) -> list[Equation]:
    """What is largest or smallest in an equilibrium is so for a constant that is sought."""
    found: list[Equation] = []
    unknowns, sought = _unknowns(course, states), frozenset(course.sought())
    for state in states:
        for d in (d for d in demands[state.name] if d.kind == "extreme"):
            if not sought:
                text = f"{state.name}: `{d.text}`, and nothing is sought on which it could depend"
                raise NoSolution([Diagnostic(d.mark, "PL623", text, "declare the constant under `unknowns`")])
            like = Equation(sp.S.Zero, "extreme", d.text, state.name, mark=d.mark)
            objective = course.stops[state.name].at(d.residual)
            found += stationary(equations, objective, unknowns, sought, like, sought)
    return found


def _tops(
    course: RegimeSequence,
    states: tuple[State, ...],
    demands: Mapping[str, tuple[Demand, ...]],
    equations: list[Equation],
    whole: list[Branch],
) -> list[Branch]:
    """The positions in which what is to be largest (smallest) is more (less) than beside them; what cannot be told may
    be.
    """
    extremes = [(course.stops[s.name], d) for s in states for d in demands[s.name] if d.kind == "extreme"]
    related = [e for e in equations if e.kind != "extreme"]
    natural = course.natural(course.sought())
    base = course.given()

    def beside(branch: Branch, constant: sp.Symbol, way: int) -> Branch | None:
        at = branch.values[constant] + way * ASIDE * natural[constant]
        near = _branches(course, states, demands, related, {constant: at})
        return min(near, key=lambda b: _distance(b, branch), default=None)

    def is_top(branch: Branch) -> bool:
        here = base.extended(branch.values)
        for constant, way in ((c, w) for c in course.sought() if c in branch.values for w in (-1, 1)):
            other = beside(branch, constant, way)
            if other is None:
                continue
            for stop, d in extremes:
                top, less = here.known(stop.at(d.residual)), base.extended(other.values).known(stop.at(d.residual))
                if top is None or (less is not None and (less - top) * d.extreme > 0):
                    return False
        return True

    return [b for b in whole if is_top(b)] if extremes else whole


def _distance(one: Branch, other: Branch) -> Decimal:
    return sum((abs(v - other.values[s]) for s, v in one.values.items() if s in other.values), Decimal(0))


def _unknowns(course: RegimeSequence, states: tuple[State, ...]) -> frozenset[sp.Symbol]:
    """All letters of these states, and the constants that are sought."""
    return frozenset([*(v for s in states for v in course.stops[s.name].letters.values()), *course.sought()])


def _chain(
    course: RegimeSequence,
    states: tuple[State, ...],
    demands: Mapping[str, tuple[Demand, ...]],
    equations: list[Equation],
    fixed: Mapping[sp.Symbol, Decimal],
) -> Chain:
    """The search of all positions in which the equations hold."""
    base = course.given().extended(dict(fixed))
    wanted = [d for ds in demands.values() for d in ds if d.kind == "inequality"]

    def possible(values: dict[sp.Symbol, Decimal]) -> bool:
        number = base.extended(values)
        return all(_holds(d, number) for d in wanted)

    unknowns = _unknowns(course, states).difference(fixed)
    angles = dict.fromkeys(_angles(course, states))
    symbolic = any(e.residual.free_symbols & set(base.values) for e in equations)
    return Chain(unknowns, {}, angles, base, symbolic, possible, natural=course.natural(unknowns))


def _angles(course: RegimeSequence, states: tuple[State, ...]) -> dict[sp.Symbol, None]:
    """The letters that are angles, in order."""
    units, stops = course.ledger.units, [course.stops[s.name] for s in states]
    letters = [v for stop in stops for v in stop.letters.values()]
    return {v: None for v in letters if units[v].angle and units[v].text in ("rad", "deg", "rev")}


def _demand_letter_by_letter(
    course: RegimeSequence,
    states: tuple[State, ...],
    demands: Mapping[str, tuple[Demand, ...]],
    equations: list[Equation],
) -> None:
    """Undecided: the equations do not give one letter after the other."""
    found = list(_chain(course, states, demands, equations, {}).branches(equations))
    if found and all(b.left for b in found):
        _demand_enough(course, states, found[0])
        text = "the equations of equilibrium are nonlinear in several unknowns at once"
        raise undecided_at(states[0].mark, f"{text}; a coordinate less may help, where symmetry tells one")


def _demand_enough(course: RegimeSequence, states: tuple[State, ...], branch: Branch) -> None:
    """NoSolution: fewer relations are left than constants that are sought, so that no equilibrium tells them."""
    told = {s: simplified(sp.sympify(str(v))) for s, v in branch.values.items()}
    left = [e for e in branch.left if simplified(e.residual.xreplace(told)) != 0]
    unknowns = by_name({s for e in left for s in e.residual.free_symbols & {*course.sought()}} - told.keys())
    stated = list(dict.fromkeys(e.words for e in left))
    if len(left) >= len(unknowns) or len(left) != len(stated):
        return
    names = listed(s.name for s in unknowns)
    text = f"{states[0].name}: {names} are open: {listed(f'`{t}`' for t in stated)} is all that is said of them there"
    hint = "an equilibrium is solved before any motion: say more of it, such as its `decrement` or `damping_ratio`"
    raise NoSolution([Diagnostic(states[0].mark, "PL623", text, hint)])


def _branches(
    course: RegimeSequence,
    states: tuple[State, ...],
    demands: Mapping[str, tuple[Demand, ...]],
    equations: list[Equation],
    fixed: Mapping[sp.Symbol, Decimal] = MappingProxyType({}),
) -> list[Branch]:
    """All positions in which the equations hold, one of each. `fixed`: sought constants that have these values."""
    chain = _chain(course, states, demands, equations, fixed)
    base, symbolic, natural = chain.value, chain.symbolic, chain.natural
    sizes = [s for s in course.sought() if s.name in not_negative(course.problem)]
    angles = frozenset(_angles(course, states))
    found = [whole for b in chain.branches(equations) for whole in _with_the_rest(chain, b, angles)]
    found = [b for b in found if not any(s in b.formulas and b.formulas[s].is_negative for s in sizes)]
    proper = [b for b in found if all(b.values.get(s, Decimal(0)) >= 0 for s in sizes)]
    # With letters the signs are those of their draws: they only tell one root from another.
    found = proper or (found if course.problem.symbols else [])
    if not symbolic:
        found = [b for b in found if _assumed(course, states, base.extended(b.values))]
    found = [replace(b, values={**b.values, **fixed}) for b in found]
    return _distinct(found, set(angles), natural)


def _with_the_rest(chain: Chain, branch: Branch, angles: frozenset[sp.Symbol]) -> Iterator[Branch]:
    """A branch with the letters that no equation tells alone: their roots are looked for together, in numbers."""
    if not branch.left:
        yield branch
        return
    residuals = [e.residual for e in branch.left]
    unknowns = by_name({s for e in residuals for s in e.free_symbols & chain.unknowns}.difference(branch.values))
    if chain.symbolic or not unknowns:
        return
    here = chain.value.extended(branch.values)
    for root in roots_together(residuals, unknowns, here, lambda s: chain.natural[s], angles):
        if chain.accept({**branch.values, **root}):
            yield replace(branch, values={**branch.values, **root}, left=())


def _assumed(course: RegimeSequence, states: tuple[State, ...], number: Valuation) -> bool:
    """Do the modes hold in which it balances, as that ropes pull and contacts press, and is everything on the side for
    which the formulas are?
    """
    for state in states:
        regime = course.readers[state.name].regime
        kept = [w.expr for w in regime.watches]
        kept += [way * place for way, place in regime.general.instant.scene.sided.values()]
        for expr in (e.xreplace(course.stops[state.name].letters) for e in kept):
            value = number.known(expr)
            if value is not None and value < -SAME * number.size(expr):
                return False
    return True


def _holds(demand: Demand, number: Valuation) -> bool:
    v = number.known(demand.residual)
    if v is None:
        return True
    slack = TINY * number.size(demand.residual)
    return v >= -slack and (not demand.sign or v > slack)


def _distinct(branches: list[Branch], angles: set[sp.Symbol], natural: Mapping[sp.Symbol, Decimal]) -> list[Branch]:
    """One of each position; an angle may differ by turns, and the smallest is taken, π rather than -π."""

    def turned(branch: Branch) -> tuple[Decimal, int]:
        own = [v for a, v in branch.values.items() if a in angles]
        return round(sum(map(abs, own), Decimal(0)), 12), sum(v < 0 for v in own)

    found: list[Branch] = []
    for b in sorted(branches, key=turned):
        if not any(_same(b, other, angles, natural) for other in found):
            found.append(b)
    return found


def _same(one: Branch, other: Branch, angles: set[sp.Symbol], natural: Mapping[sp.Symbol, Decimal]) -> bool:
    for s, v in one.values.items():
        away = v - other.values.get(s, v)
        if s in angles:
            away -= 2 * PI * (away / (2 * PI)).to_integral_value()
        if abs(away) > SAME * max(abs(v), natural.get(s, Decimal(0))):
            return False
    return True


def _place(branch: Branch, all_of_them: list[Branch], stops: list[Stop], sought: Iterable[sp.Symbol]) -> str:
    """The places of one branch in words, as far as they are not as drawn in every one, and what is sought."""
    found = [f"{s.name} = {branch.values[s]:.6g}" for s in sought if s in branch.values]
    others = {own for stop in stops for own in stop.letters.values()}
    for stop in stops:
        for letter, own in stop.letters.items():
            value = branch.values.get(own)
            if value is not None and any(b.values.get(own) for b in all_of_them):
                formula = branch.formulas.get(own)
                told = formula is not None and not formula.free_symbols & others
                found.append(f"{letter.name} = {formula if told else round(value, 6)}")
    return ", ".join(found) or "everything as drawn"
