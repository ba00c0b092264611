"""Equilibrium states. No motion has to lead to them, so they stand beside the order of states: what they say of places
and what equilibrium demands (free speeds and their rates vanish) are solved on their own.
"""

from __future__ import annotations

from collections.abc import Mapping
from decimal import Decimal
from typing import Any

import sympy as sp

from planar_cli.equation.exact import PI, Valuation
from planar_cli.errors import Diagnostic, NoSolution
from planar_cli.problem.expression import Equilibrium, Statement
from planar_cli.problem.scene import State
from planar_cli.records import record
from planar_cli.solve.between.chain import Branch, Chain
from planar_cli.solve.regimes.equations import Equation, drawn_equations, loop_equations, stated_equations
from planar_cli.solve.regimes.regime_sequence import RegimeSequence
from planar_cli.solve.regimes.timeline import Demand, Stop

TINY = Decimal("1e-15")
SAME = Decimal("1e-12")
Raw = Mapping[str, list[tuple[Statement, tuple[Any, ...]]]]


@record
class Equilibria:
    """The equilibrium states of a problem: their equations, and the one way in which these hold."""

    states: tuple[State, ...]
    demands: Mapping[str, tuple[Demand, ...]]
    equations: tuple[Equation, ...]
    branch: Branch


def is_equilibrium(state: State) -> bool:
    """Does a state stand beside the order of states?"""
    return any(isinstance(r, Equilibrium) for r in state.relations)


def solve_equilibria(course: RegimeSequence, raw: Raw) -> Equilibria:
    """Solve all equilibrium states. NoSolution: there is none, or several places fit."""
    states = tuple(state for state, _ in course.modes.equilibria)
    demands: dict[str, tuple[Demand, ...]] = {}
    equations: list[Equation] = []
    drawn: list[Equation] = []
    for state in states:
        reader, stop = course.readers[state.name], course.stops[state.name]
        demands[state.name] = tuple(reader.demands(stop, raw[state.name]))
        equations += stated_equations(demands[state.name])
        equations += loop_equations(reader.regime, course.first, stop)
        if state.name == course.problem.states[0].name:
            drawn += drawn_equations(reader.regime, stop)
    if not states:
        return Equilibria((), {}, (), Branch({}, {}, (), ()))
    whole = _branches(course, states, demands, [*equations, *drawn])
    mark, names = states[0].mark, ", ".join(s.name for s in states)
    if not whole and drawn and _branches(course, states, demands, equations):
        first = course.problem.states[0]
        text = f"{first.name}: the forces do not balance as drawn, and the first state is drawn"
        hint = "write the points that may move with `coordinates`, or let a state that is as drawn come before it"
        raise NoSolution([Diagnostic(first.mark, "PL630", text, hint)])
    if not whole:
        hint = "check the relations of the state, and whether the forces can balance at all"
        raise NoSolution([Diagnostic(mark, "PL630", f"{names}: no position of equilibrium is found", hint)])
    if len(whole) > 1:
        places = "; ".join(_place(b, [course.stops[s.name] for s in states]) for b in whole[:6])
        hint = "say which is meant: give the coordinate, or an inequality"
        raise NoSolution([Diagnostic(mark, "PL630", f"{names}: several positions of equilibrium: {places}", hint)])
    return Equilibria(states, demands, (*equations, *drawn), whole[0])


def _branches(
    course: RegimeSequence,
    states: tuple[State, ...],
    demands: Mapping[str, tuple[Demand, ...]],
    equations: list[Equation],
) -> list[Branch]:
    """All positions in which the equations hold, one of each."""
    base = course.given()
    stops = [course.stops[s.name] for s in states]
    letters = [v for stop in stops for v in stop.letters.values()]
    units = course.ledger.units
    angles = {v: None for v in letters if units[v].angle and units[v].text in ("rad", "deg", "rev")}
    parameters = set(base.values)
    symbolic = any(e.residual.free_symbols & parameters for e in equations)
    wanted = [d for ds in demands.values() for d in ds if d.kind == "inequality"]

    def possible(values: dict[sp.Symbol, Decimal]) -> bool:
        number = base.extended(values)
        return all(_holds(d, number) for d in wanted)

    unknowns = frozenset([*letters, *course.sought()])
    natural = course.natural(unknowns)
    chain = Chain(unknowns, {}, dict.fromkeys(angles), base, symbolic, possible, natural=natural)
    found = [b for b in chain.branches(equations) if not b.left]
    if not symbolic:
        found = [b for b in found if _assumed(course, states, base.extended(b.values))]
    return _distinct(found, set(angles), natural)


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
    """One of each position; an angle may differ by turns, and the smallest is taken."""
    found: list[Branch] = []
    for b in sorted(branches, key=lambda b: sum(abs(b.values[a]) for a in angles if a in b.values)):
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


def _place(branch: Branch, stops: list[Stop]) -> str:
    """The places of one branch in words."""
    found = []
    others = {own for stop in stops for own in stop.letters.values()}
    for stop in stops:
        for letter, own in stop.letters.items():
            value = branch.values.get(own)
            if value:
                formula = branch.formulas.get(own)
                told = formula is not None and not formula.free_symbols & others
                found.append(f"{letter.name} = {formula if told else round(value, 6)}")
    return ", ".join(found) or "everything as drawn"
