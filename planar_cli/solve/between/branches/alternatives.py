"""Several motions that fit, where something is to be largest (or smallest) over a constant that is sought.

Each is the largest of those near it: a throw up a slope, and one down its other side. The file must say which is meant;
a place that is positive in one and negative in the other tells them apart.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from decimal import Decimal

import sympy as sp

from planar_cli.equation.values.exact import PI, Unvalued
from planar_cli.equation.values.ledger import display
from planar_cli.errors import Diagnostic, NoSolution, NoValue
from planar_cli.problem.scene.scene import State
from planar_cli.solve.between.branches.solved_motion import SolvedMotion
from planar_cli.solve.between.equations.motion_equations import MotionEquations
from planar_cli.solve.between.roots.chain import Branch
from planar_cli.solve.diagnosis.choosing import IN_GENERAL, hint_between
from planar_cli.solve.diagnosis.words import in_unit
from planar_cli.solve.regimes.regime_sequence import RegimeSequence
from planar_cli.solve.regimes.timeline import Demand
from planar_cli.solve.roads import is_curve
from planar_cli.solve.within_a_turn import within_a_turn

SAME = Decimal("1e-12")
ASIDE = Decimal("1e-4")
"""By this part of an ordinary size a constant is changed, to see whether what is largest becomes less."""


def chosen_extreme(course: MotionEquations) -> tuple[State, Demand] | None:
    """What is to be largest or smallest over a constant that is sought; None: nothing is."""
    # What has a bend is so in time.
    timed = {e.stop for e in course.equations if e.kind == "extreme" and e.trend is not None}
    for state in (s for s in course.states if s.name not in timed):
        for d in course.demands[state.name]:
            if d.kind == "extreme" and course.is_set(state) and course.sought():
                return state, d
    return None


def one_of(course: MotionEquations, fits: list[SolvedMotion], again: list[SolvedMotion]) -> SolvedMotion:
    """The motion that is meant; one with negative constants only where there are no others. `again`: those that pass
    such a state before. NoSolution: the file must choose.
    """
    if not fits:
        return replace(again[0], checks=_left_out(course, again[1:], "fit as well"))
    fits = _at_the_top(course, fits)
    usual = [f for f in fits if all(f.branch.values.get(s, 0) >= 0 for s in course.sought())]
    fits = usual or fits
    for constant in course.sought():
        told = [f for f in fits if constant in f.branch.values]
        if len(told) == len(fits):
            fits = within_a_turn(course.problem, constant.name, fits, [float(f.branch.values[constant]) for f in fits])
    if len(fits) > 1 and _answered_alike(fits):
        return replace(fits[0], checks=_left_out(course, fits[1:], "fit as well, with the same answers"))
    _demand_one(course, [f.branch for f in fits])
    return replace(fits[0], checks=_left_out(course, again, "pass such a state before, and are left out"))


def _answered_alike(fits: list[SolvedMotion]) -> bool:
    """Is everything that is asked the same in all of them?"""
    for find in fits[0].finds:
        if not find.raw or is_curve(find.find.found.what):
            return False
        for part in find.parts():
            numbers = [f.value.known(part) for f in fits]
            told = [n for n in numbers if n is not None]
            if len(told) < len(numbers) or max(told) - min(told) > SAME * max(fits[0].value.size(part), SAME):
                return False
    return bool(fits[0].finds)


def _at_the_top(course: MotionEquations, fits: list[SolvedMotion]) -> list[SolvedMotion]:
    """Of motions in which something is stationary those in which it is largest (smallest). NoSolution: it is in none of
    them, or several fit that are no smaller (larger) than all near them.
    """
    found = chosen_extreme(course)
    if found is None:
        return fits
    state, demand = found
    tops = [f for f in fits if _is_top(course, f.branch, state, demand)]
    if not tops:
        other = "smallest" if demand.extreme > 0 else "largest"
        text = f"state {state.name}: `{demand.text}` nowhere: where its derivative is zero it is {other}, or neither"
        hint = f"ask where it is {other}, or state the limit itself"
        raise NoSolution([Diagnostic(demand.mark, "PL638", text, hint)])
    distinct: list[Branch] = []
    for branch in (f.branch for f in tops):
        if not any(_same(course, branch, b) or _same_places(course, branch, b) for b in distinct):
            distinct.append(branch)
    if len(distinct) < 2:
        return tops
    listed = "; ".join(_words(course, b) for b in distinct)
    told = "" if course.problem.symbols else f": {listed}"
    text = f"state {state.name}: `{demand.text}` in several ways{told}"
    raise NoSolution([Diagnostic(demand.mark, "PL635", text, _hint(course, distinct, state))])


def _demand_one(course: MotionEquations, branches: Sequence[Branch]) -> None:
    """NoSolution: the motion passes all states with several numbers of the constants that are sought."""
    if not course.sought() or chosen_extreme(course) is not None:
        return
    distinct: list[Branch] = []
    for branch in branches:
        own = replace(branch, values={s: branch.values[s] for s in course.sought() if s in branch.values})
        if own.values and not any(_same(course, own, b) for b in distinct):
            distinct.append(own)
    if len(distinct) > 1:
        # Numbers that were drawn for the letters of the file are no values.
        names = " and ".join(s.name for s in course.sought())
        in_letters = f"{names} may have {len(distinct)} values"
        told = in_letters if course.problem.symbols else "; or ".join(_words(course, b) for b in distinct)
        text = f"{told}: with each of them the motion passes all states"
        hint = IN_GENERAL if course.problem.symbols else _apart(course, distinct)
        raise NoSolution([Diagnostic(course.problem.unknowns[0].mark, "PL635", text, hint)])


def _apart(course: MotionEquations, branches: Sequence[Branch]) -> str:
    """An inequality of a constant that has another value in each of them."""
    units = course.ledger.units
    for s in course.sought():
        told = [b.values[s] for b in branches if s in b.values]
        if len(told) == len(branches):
            numbers = [float(display(v, units[s], course.ledger.us)) for v in told]
            if max(numbers) - min(numbers) > float(SAME) * max(map(abs, numbers)):
                return hint_between(s.name, units[s], numbers)
    return IN_GENERAL


def _height(course: MotionEquations, branch: Branch, state: State, demand: Demand) -> Decimal:
    """What is to be largest, in a branch; of what is to be smallest its negative."""
    value = course.base().extended(branch.values)
    return value(course.stops[state.name].at(demand.residual)) * demand.extreme


def _is_top(course: MotionEquations, branch: Branch, state: State, demand: Demand) -> bool:
    """Is it less on both sides, where a sought constant is a little larger or smaller? What cannot be told may be."""
    top = _height(course, branch, state, demand)
    natural = course.natural(course.sought())
    for constant in (s for s in course.sought() if s in branch.values):
        for way in (-1, 1):
            beside = _beside(course, branch, state, constant, branch.values[constant] + way * ASIDE * natural[constant])
            try:
                if beside is not None and _height(course, beside, state, demand) > top:
                    return False
            except (NoValue, Unvalued):
                continue
    return True


def _beside(course: MotionEquations, branch: Branch, state: State, constant: sp.Symbol, at: Decimal) -> Branch | None:
    """The motion next to a branch with another value of one constant; None: there is none. What is largest in other
    states, of the time, stays so.
    """
    chain = course.chain()
    value, left = course.base().extended({constant: at}), chain.unknowns - {constant}
    chain = replace(chain, unknowns=left, value=value, accept=lambda values: True)
    found = chain.branches([e for e in course.equations if (e.kind, e.stop) != ("extreme", state.name)])
    whole = [replace(b, values={**b.values, constant: at}) for b in found if not b.left]
    near = [b for b in whole if set(b.values) >= set(branch.values)]
    return min(near, key=lambda b: _distance(course, b, branch), default=None)


def _distance(course: MotionEquations, one: Branch, other: Branch) -> Decimal:
    natural = course.natural(one.values)
    return sum((abs(v - other.values[s]) / natural[s] for s, v in one.values.items() if s in other.values), Decimal(0))


def _same(course: MotionEquations, one: Branch, other: Branch) -> bool:
    """Is it the same motion? Angles may differ by turns."""
    natural, units = course.natural(one.values), course.ledger.units
    for s, v in one.values.items():
        away = v - other.values.get(s, v)
        if s in units and units[s].angle:
            away -= 2 * PI * (away / (2 * PI)).to_integral_value()
        if abs(away) > SAME * max(abs(v), natural[s]):
            return False
    return True


def _same_places(course: MotionEquations, one: Branch, other: Branch) -> bool:
    """Is everything at the same places at the same times? A line in the direction φ is that in φ + 180°, on which the
    way counts the other way.
    """
    values = [course.base().extended(b.values) for b in (one, other)]
    for state in course.states:
        stop, scene = course.stops[state.name], course.readers[state.name].regime.general.instant.scene
        places = [e for body in scene.bodies.values() for e in (body.center.x, body.center.y)]
        for e in (stop.t, *map(stop.at, places)):
            a, b = (v.known(e) for v in values)
            if a is None or b is None or abs(a - b) > SAME * max(abs(a), abs(b), values[0].size(e)):
                return False
    return True


def _words(course: MotionEquations, branch: Branch) -> str:
    """The sought constants of one of them, as the file shows them."""
    units, values, us = course.ledger.units, branch.values, course.ledger.us
    shown = [(s.name, float(display(values[s], units[s], us)), units[s].text) for s in course.sought() if s in values]
    return ", ".join(f"{name} = {number:.4g} {unit}" for name, number, unit in shown)


def _hint(course: MotionEquations, fitting: Sequence[Branch], state: State) -> str:
    """A relation that tells them apart."""
    stop, regime = course.stops[state.name], course.readers[state.name].regime
    for name, body in regime.general.instant.scene.bodies.items():
        for axis, place in (("x", body.center.x), ("y", body.center.y)):
            found = [course.base().extended(b.values).known(stop.at(place)) for b in fitting]
            numbers = [v for v in found if v is not None]
            if len(numbers) == len(found) and min(numbers) < 0 < max(numbers):
                return f"say which is meant in state {state.name}, such as `{axis}({name}) > 0` or `{axis}({name}) < 0`"
    return "say which is meant: an inequality of the sought constant, or of a place"


def _left_out(course: RegimeSequence, others: list[SolvedMotion], why: str) -> tuple[str, ...]:
    """Values of sought constants with which the motion is another, in a phrase."""
    if not others:
        return ()
    values, ledger = others[-1].branch.values, course.ledger
    told = [s for s in course.sought() if s in values]
    names = [f"{s.name} = {in_unit(values[s], ledger.units[s], ledger.us)}" for s in told]
    return (f"other roots, as {', '.join(names)}, {why}",) if names else ()
