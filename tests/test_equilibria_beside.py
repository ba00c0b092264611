"""An equilibrium beside a motion: listed first or last, spoken of by the states, struck, and drawn."""

from __future__ import annotations

import math

import pytest
from answered import assert_close, number, solve

from planar_cli.problem.structure import load_text
from planar_cli.simulate.answers import Answered
from planar_cli.simulate.run import Settings, simulate

BLOCK = """
title: Block hung on a spring
plane: vertical
given: {m: 2 kg, k: 200 N/m, l_0: 0.5 m, d: 0.1 m, J: 1 N*s, u: 1 m/s}
coordinates: {y: m}
points: {P: [0, 0], Q: [0, y]}
bodies: {block: {particle: Q, mass: m}}
joints:
  - guide: {point: Q, along: 90 deg}
loads:
  - spring: {between: [P, Q], stiffness: k, natural_length: l_0}
"""
REST = -0.5 - 2 * 9.81 / 200
"""Where the weight and the spring balance [m]."""
FIRST, LAST = (
    "states:\n  rest: [equilibrium, y < 0]\n  {}\n  {}\n",
    "states:\n  {}\n  {}\n  rest: [equilibrium, y < 0]\n",
)
ORDERS = pytest.mark.parametrize("states", [FIRST, LAST], ids=["equilibrium first", "equilibrium last"])


def followed(text: str) -> dict[str, Answered]:
    """What the motion alone answers."""
    problem, wrong = load_text(text)
    assert problem is not None
    assert not wrong
    return {a.name: a for a in simulate(problem, Settings(estimate=False)).answers}


@ORDERS
def test_it_stands_beside_the_motion_wherever_it_is_listed(states: str) -> None:
    text = BLOCK + states.format("1: [t = 0, at rest, y = -l_0 - 2*m*g/k]", "2: [y = -l_0 - m*g/k]")
    text += "find: {y_rest: y @ rest, T: period(rest), v: v(block).mag @ 2, t_2: t @ 2}\n"
    found = solve(text)
    assert_close(found["y_rest"], REST)
    assert_close(found["T"], 2 * math.pi / 10)
    assert_close(found["v"], "0.981")
    assert_close(found["t_2"], math.pi / 20)
    seen = followed(text)
    assert seen["v"].values == pytest.approx((0.981,), rel=1e-8)
    assert seen["t_2"].values == pytest.approx((math.pi / 20,), rel=1e-8)
    assert "not reached" in seen["y_rest"].why


@ORDERS
@pytest.mark.parametrize("place", ["y", "y(block)"])
def test_states_speak_of_it(states: str, place: str) -> None:
    """Pulled down from its equilibrium, through which it passes."""
    text = BLOCK + states.format(f"1: [t = 0, at rest, {place} = {place} @ rest - d]", f"2: [{place} = {place} @ rest]")
    text += "find: {y_1: y @ 1, v: v(block).mag @ 2, t_2: t @ 2}\n"
    found = solve(text)
    assert_close(found["y_1"], REST - 0.1)
    assert_close(found["v"], 1)
    assert_close(found["t_2"], math.pi / 20)
    seen = followed(text)
    assert seen["y_1"].values == pytest.approx((REST - 0.1,), rel=1e-8)
    assert seen["v"].values == pytest.approx((1,), rel=1e-6)


def test_a_state_begins_where_it_is() -> None:
    states = "states: {0: [equilibrium, y < 0], 1: [y = y @ 0, v(block).y = -u], 2: [at rest]}\n"
    found = solve(f"{BLOCK}{states}find: {{down: y @ 0 - y @ 2}}\n")
    assert_close(found["down"], "0.1")


def test_what_is_struck_in_it_moves_from_there() -> None:
    text = BLOCK + "  - impulse: {body: block, at: Q, magnitude: J, angle: -90 deg, during: 1->2}\n"
    text += "states: {1: [equilibrium, y < 0], 2: [just after 1], 3: [v(block).y = 0]}\n"
    text += "find: {y_1: y @ 1, v: v(block).y @ 2, y_3: y @ 3}\n"
    found = solve(text)
    assert_close(found["y_1"], REST)
    assert_close(found["v"], "-0.5")
    assert_close(found["y_3"], REST - 0.05)


ROD = """
title: Rod that hangs as drawn
plane: vertical
given: {m: 2 kg, l: 1 m}
points: {A: [0, 0], B: [0, -l]}
bodies: {rod: {rod: [A, B], mass: m}}
joints:
  - pin: {at: A, between: [ground, rod]}
states:
  rest: [equilibrium]
  1: [theta(rod) = -60 deg, at rest]
  2: [theta(rod) = -90 deg]
find: {w: omega(rod) @ 2, T: period(rest)}
"""


def test_it_is_drawn_where_it_is_the_first_state_of_the_file() -> None:
    found = solve(ROD)
    assert_close(found["w"], -math.sqrt(3 * 9.81 * (1 - math.sqrt(3) / 2)))
    assert_close(found["T"], 2 * math.pi / math.sqrt(1.5 * 9.81))
    assert followed(ROD)["w"].values == pytest.approx((-math.sqrt(3 * 9.81 * (1 - math.sqrt(3) / 2)),), rel=1e-8)


def test_what_acts_from_it_on_acts_in_it_alone() -> None:
    """A force that pulls until the block is let go."""
    text = BLOCK + "  - force: {body: block, at: Q, magnitude: k*d, angle: -90 deg, during: rest->1}\n"
    text += FIRST.format("1: [t = 0, at rest, y = y @ rest]", "2: [at rest]")
    found = solve(f"{text}find: {{y_1: y @ 1, y_2: y @ 2, t_2: t @ 2}}\n")
    assert_close(found["y_1"], REST - 0.1)
    assert_close(found["y_2"], REST + 0.1)
    assert_close(found["t_2"], math.pi / 10)


def test_equations_nonlinear_in_two_coordinates() -> None:
    """A weight hangs between two springs; that it hangs in the middle is nothing that the equations tell."""
    text = """
title: Weight between two springs
plane: vertical
coordinates: {x: m, y: m}
points: {A: [-1 m, 0], B: [1 m, 0], P: [x, y]}
bodies: {weight: {particle: P, mass: 2 kg}}
loads:
  - spring: {between: [A, P], stiffness: 100 N/m, natural_length: 1 m}
  - spring: {between: [B, P], stiffness: 100 N/m, natural_length: 1 m}
states: {1: [equilibrium]}
find: {y: y(P) @ 1}
"""
    found = solve(text.replace("P: [x, y]", "P: [0, y]").replace("x: m, ", ""))
    y = float(number(found["y"]))
    low = solve(text.replace("[equilibrium]", "[equilibrium, y < -0.1 m]"))
    assert float(number(low["y"])) == pytest.approx(y)
    length = (1 + y * y) ** 0.5
    assert -2 * 100 * (length - 1) * y / length == pytest.approx(2 * 9.81)
