"""Files that contradict themselves or say too little: the message tells what is so, at its line."""

from __future__ import annotations

import pytest
from answered import solve

from planar_cli.errors import Diagnostic, NoSolution

UNUSED = """
title: Crank whose torque stands nowhere
plane: vertical
unknowns: {M: N*m}
points: {O: [0, 0], A: [0.1 m, 0]}
bodies: {crank: {rod: [O, A], mass: 0.8 kg}}
joints:
  - pin: {at: O, between: [ground, crank]}
motion: [omega(crank) = 100 rad/s]
instant: [theta(crank) = 0]
find: {moment: M}
"""
IDLE = """
title: Motor that does not drive the hoist
plane: vertical
given: {r: 0.2 m}
unknowns: {M: N*m}
points: {A: [-2 m, 0], O: [0, 0], T: [r, 0], L: [r, -6 m]}
bodies:
  motor: {disk: A, radius: r, inertia: 0.1 kg*m^2}
  drum: {disk: O, radius: r, inertia: 3 kg*m^2}
  cage: {particle: L, mass: 150 kg}
joints:
  - pin: {at: A, between: [ground, motor]}
  - pin: {at: O, between: [ground, drum]}
  - rope: {path: [L, T on drum]}
loads:
  - torque: {body: motor, moment: M}
states:
  1: [t = 0, at rest]
  2: [y(L) = y(L) @ 1 + 4 m, v(L).y = 2 m/s]
find: {moment: M}
"""
COMES_TO_REST = """
title: Pendulum with a rubbing pivot that never gets so high
plane: vertical
points: {O: [0, 0], E: [0.9 m, 0]}
bodies: {rod: {rod: [O, E], mass: 6 kg}}
joints:
  - pin: {at: O, between: [ground, rod], friction_torque: 8 N*m}
states:
  1: [at rest]
  2: [theta(rod) = 60 deg]
  3: [omega(rod) = 0]
find: {turned: theta(rod) @ 3}
"""


def refused(text: str) -> Diagnostic:
    """Why a file has no solution."""
    with pytest.raises(NoSolution) as error:
        solve(text)
    return error.value.diagnostics[0]


def test_an_unknown_that_stands_in_no_equation() -> None:
    why = refused(UNUSED)
    assert (why.code, why.mark.line) == ("PL606", 4)
    assert why.message == "nothing tells M: it stands in no equation"


def test_an_unknown_that_changes_nothing_of_what_is_said() -> None:
    why = refused(IDLE)
    assert (why.code, why.mark.line) == ("PL623", 5)
    assert why.message == "M is open: what the states say is the same whatever it is"


def test_a_motion_that_comes_to_rest_before_a_state() -> None:
    why = refused(COMES_TO_REST)
    assert (why.code, why.mark.line) == ("PL621", 10)
    assert why.message == "state 2 is never reached: theta(rod) = 60 deg"
    assert why.hint is not None
    assert why.hint.startswith("nothing moves any more from t = ")
