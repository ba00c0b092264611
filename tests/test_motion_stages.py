"""The stages of a motion, each by itself: regimes in sequence, what is stated, equations between states, the trace."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import fields, is_dataclass, replace
from decimal import Decimal
from functools import cache
from typing import Any

import pytest
import sympy as sp

from planar_cli.problem.structure import load_text
from planar_cli.solve.between.equations.motion_equations import MotionEquations, all_equations, first_equations
from planar_cli.solve.between.equations.stated_motion import StatedMotion, stated_motion
from planar_cli.solve.between.trace.span_trace import SpanIntegral
from planar_cli.solve.between.trace.trace import MotionTrace
from planar_cli.solve.following.starts import Start, certain_start
from planar_cli.solve.regimes.first_modes import first_modes
from planar_cli.solve.regimes.mode_sequence import Workshop
from planar_cli.solve.regimes.regime_sequence import RegimeSequence, regime_sequence
from planar_cli.solve.run import solve_problem

THROW = """
plane: vertical
bodies: {P: {particle: [0, 0], mass: 2 kg}}
states:
  1: [t = 0, v(P).x = 3 m/s, v(P).y = 4 m/s]
  2: [v(P).y = 0]
find: {h: y(P) @ 2}
"""
BOUNCE = """
plane: vertical
points: {O: [0, 0]}
surfaces: {floor: {through: O, angle: 0 deg}}
bodies: {P: {particle: [0, 2 m], mass: 2 kg}}
joints: [impact: {between: [P, floor], normal: 90 deg, restitution: 0.5, during: 2->3, name: hit}]
states:
  1: [at rest]
  2: [y(P) = 0]
  3: [just after 2]
  4: [v(P).y = 0]
find: {h: y(P) @ 4, J: impulse(hit/P).y @ 2->3}
"""
G = Decimal("9.81")
DIGITS = Decimal("1e-30")


def sequence(text: str) -> RegimeSequence:
    problem, wrong = load_text(text)
    assert problem is not None, wrong
    workshop = Workshop({})
    return regime_sequence(problem, first_modes(problem, workshop), workshop)


@cache
def stated() -> StatedMotion:
    return stated_motion(sequence(THROW))


@cache
def equations() -> MotionEquations:
    return first_equations(stated())


@cache
def trace(text: str) -> MotionTrace:
    problem, wrong = load_text(text)
    assert problem is not None, wrong
    motion = solve_problem(problem).parts[0].motion
    assert motion is not None
    return motion


def own(motion: RegimeSequence, state: str) -> dict[str, sp.Symbol]:
    """The symbols of a state by the names of the general position."""
    return {s.name: mine for s, mine in motion.stops[state].letters.items()}


def apex() -> dict[sp.Symbol, Decimal]:
    """Both states of the throw, from v = v_0 - g t."""
    t = 4 / G
    at = {"1": ("0", "0", "0", "3", "4"), "2": (t, 3 * t, 8 / G, "3", "0")}
    names = ("t", "x_P", "y_P", "v_Px", "v_Py")
    motion = equations()
    general = motion.regimes[0].letters
    assert len(general) == len(names)
    found = {}
    for state, values in at.items():
        mine = [motion.stops[state].letters[s] for s in general]
        found.update(dict(zip(mine, map(Decimal, values), strict=True)))
    return found


def test_a_sequence_knows_regimes_and_symbols_before_anything_is_worked_out() -> None:
    found = sequence(THROW)
    assert [s.name for s in found.states] == ["1", "2"]
    assert len(found.regimes) == 1
    assert not found.regimes[0].rates
    assert not set(own(found, "1").values()) & set(own(found, "2").values())
    assert not found.is_impulsive(0)


def test_a_sequence_tells_where_no_time_passes() -> None:
    found = sequence(BOUNCE)
    assert [found.is_impulsive(i) for i in range(3)] == [False, True, False]
    assert [s.name for s in found.states] == ["1", "2", "3", "4"]


def test_what_is_stated_is_an_equation_between_symbols_of_its_state() -> None:
    found = stated()
    regime = found.regimes[0]
    g = found.ledger.symbols["g"]
    assert set(regime.accelerations.values()) == {sp.S.Zero, -g}
    (demand,) = found.demands["2"]
    assert demand.residual.free_symbols <= set(own(found, "2").values())
    assert len(found.demands["1"]) == 3
    assert found.laws[0].laws


def test_the_equations_of_the_first_state_fix_it() -> None:
    start = certain_start(equations())
    assert not isinstance(start, Start)
    assert sorted(start.values()) == [0, 0, 0, 3, 4]


def test_every_equation_holds_along_the_known_motion() -> None:
    found = all_equations(equations())
    assert len(found.equations) > len(equations().equations)
    value = found.base().extended(apex())
    for e in found.equations:
        assert abs(value(e.residual)) <= DIGITS * max(value.size(e.residual), Decimal(1)), (e.kind, e.words)


def test_a_stage_is_not_changed_by_the_next() -> None:
    motion = equations()
    before = motion.equations
    more = replace(all_equations(motion), equations=())
    assert motion.equations is before
    assert not more.equations
    assert all(stage.__dataclass_params__.frozen for stage in (RegimeSequence, StatedMotion, MotionEquations))


def parts_of(thing: Any) -> Iterator[Any]:
    """All that a trace consists of, its own classes opened."""
    yield thing
    inside: list[Any] = []
    if isinstance(thing, Mapping):
        inside = list(thing.values())
    elif isinstance(thing, tuple | list):
        inside = list(thing)
    elif is_dataclass(thing) and type(thing).__module__ == MotionTrace.__module__:
        inside = [getattr(thing, f.name) for f in fields(thing)]
    for part in inside:
        yield from parts_of(part)


@pytest.mark.parametrize("text", [THROW, BOUNCE], ids=["throw", "bounce"])
def test_a_trace_is_frozen_and_holds_nothing_of_what_solved_it(text: str) -> None:
    solver = MotionTrace.__module__.rpartition(".")[0]
    homes = (MotionTrace.__module__, SpanIntegral.__module__)
    for part in parts_of(trace(text)):
        home = type(part).__module__
        assert not home.startswith(solver) or home in homes, type(part)
        if home in homes:
            assert type(part).__dataclass_params__.frozen


def test_a_trace_leads_to_what_is_asked() -> None:
    found = trace(BOUNCE)
    (h, impulse) = found.requests
    assert abs(found.value(h.parts[0]) - Decimal("0.5")) <= DIGITS
    told = {r.unknown for step in found.route.steps for r in step.results} | set(found.route.plain)
    assert all(s in told for r in (h, impulse) for p in r.parts for s in p.free_symbols & found.unknowns)
    assert "blow" in {e.kind for step in found.route.steps for e in step.relations}
