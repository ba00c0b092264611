"""Joints that touch only from a later state on: a line or a circle that is met on the way, where it is nearest."""

from __future__ import annotations

import math

import pytest
from answered import solve

from planar_cli.errors import NoSolution, PlanarError
from planar_cli.problem.structure import load_text
from planar_cli.simulate.run import Settings, Simulation, simulate

G = 9.81
BOWL = """
title: Ball that slides down a bowl, and then along a rough floor
plane: vertical
given: {m: 2 kg, R: 1.5 m, mu: 0.2}
points: {C: [0, R], A: [-R, R], B: [0, 0]}
surfaces: {bowl: {center: C, radius: R}, floor: {through: B, angle: 0 deg}}
bodies: {ball: {particle: A, mass: m}}
joints:
  - contact: {between: [ball, bowl], at: A, mu: 0, during: 1->2, name: first}
  - contact: {between: [ball, floor], mu: mu, during: 2->3, name: second}
states: {1: [t = 0, at rest], 2: [x(ball) = 0], 3: [v(ball).x = 0]}
find: {v: v(ball).mag @ 2, N: N(second) @ 2, d: x(ball) @ 3}
"""
RAMP = """
title: Block that slides along a rough floor, and then up a circular ramp
plane: vertical
given: {m: 2 kg, R: 1.5 m, mu: 0.2, d: 1 m, v_0: 5 m/s}
points: {C: [0, R], A: [-d, 0], B: [0, 0]}
surfaces: {ramp: {center: C, radius: R}, floor: {through: B, angle: 0 deg}}
bodies: {block: {particle: A, mass: m}}
joints:
  - contact: {between: [block, floor], at: A, mu: mu, during: 1->2, name: first}
  - contact: {between: [block, ramp], mu: 0, during: 2->3, name: second}
states: {1: [t = 0, v(block).x = v_0], 2: [x(block) = 0], 3: [v(block).mag = 0]}
find: {v: v(block).mag @ 2, N: N(second) @ 2, h: y(block) @ 3}
"""
ROLLING = """
title: Cylinder that rolls down a slope and on along a floor
plane: vertical
given: {beta: 20 deg, L: 3 m, R: 0.1 m}
points:
  E: [0, 0]
  C: {from: E, distance: L, angle: 180 deg - beta}
  G: {from: C, distance: R, angle: 90 deg - beta}
surfaces: {slope: {through: E, angle: -beta}, level: {through: E, angle: 0 deg}}
bodies: {cyl: {disk: G, radius: R, mass: 4 kg}}
joints:
  - rolling: {between: [cyl, slope], during: 1->2, name: on_slope}
  - rolling: {between: [cyl, level], during: 2->3, name: on_level}
states: {1: [t = 0, at rest], 2: [y(cyl) = R], 3: [x(cyl) - x(cyl) @ 2 = 4 m]}
find: {v: v(cyl).x @ 3, w: omega(cyl) @ 3, t: t @ 3}
"""
LANDING = """
title: Ball that falls on a floor and rolls on
plane: vertical
given: {h: 1 m, R: 0.1 m}
points: {F: [0, 0], G: [0, h]}
surfaces: {floor: {through: F, angle: 0 deg}}
bodies: {ball: {disk: G, radius: R, mass: 2 kg}}
joints:
  - rolling: {between: [ball, floor], during: 2->4}
states:
  1: [t = 0, v(ball).x = 3 m/s, v(ball).y = 0, omega(ball) = 0]
  2: [y(ball) = R]
  3: [just after 2]
  4: [x(ball) - x(ball) @ 3 = 2 m]
find: {v: v(ball).x @ 3, w: omega(ball) @ 3, t: t @ 4}
"""


def _first(text: str) -> dict[str, float]:
    return {name: float(f.values[0]) for name, f in solve(text).items() if f.values}


def _followed(text: str) -> Simulation:
    problem, wrong = load_text(text)
    assert problem is not None, wrong
    return simulate(problem, Settings(estimate=False), {})


def _in_both(text: str) -> dict[str, float]:
    """The same by equations and step by step."""
    found = _first(text)
    assert {a.name: a.values[0] for a in _followed(text).answers} == pytest.approx(found, rel=1e-6)
    return found


def test_a_bowl_and_then_a_floor() -> None:
    """v² = 2 g R, and d = v²/(2 μ g)."""
    found = _first(BOWL)
    assert found == pytest.approx({"v": math.sqrt(2 * G * 1.5), "N": 2 * G, "d": 1.5 / 0.2})


def test_a_floor_and_then_a_ramp() -> None:
    """v² = v_0² - 2 μ g d; just after it N = m g + m v²/R; h = v²/(2 g)."""
    square = 25 - 2 * 0.2 * G
    expected = {"v": math.sqrt(square), "N": 2 * (G + square / 1.5), "h": square / (2 * G)}
    assert _first(RAMP) == pytest.approx(expected)


def test_a_force_of_a_contact_that_is_over() -> None:
    """At the state where it ends it is the last one: m g + m v²/R = 3 m g."""
    assert _first(BOWL.replace("N(second)", "N(first)"))["N"] == pytest.approx(3 * 2 * G)


def test_a_wheel_that_comes_to_a_floor() -> None:
    """m g h = 3/4 m v², and v stays what it is."""
    height = 3 * math.sin(math.radians(20)) + 0.1 * math.cos(math.radians(20)) - 0.1
    v = math.sqrt(4 / 3 * G * height)
    expected = {"v": v, "w": -v / 0.1, "t": 2 * height / math.sin(math.radians(20)) / v + 4 / v}
    assert _in_both(ROLLING) == pytest.approx(expected)


@pytest.mark.parametrize("joint", ["rolling: {", "contact: {mu: 0.6, "])
@pytest.mark.parametrize("during", ["2->4", "3->4"])
def test_a_ball_that_lands(joint: str, during: str) -> None:
    """The blow turns it about the point that strikes: I ω = J R and m (3 m/s - v) = J with v = ω R."""
    found = _in_both(LANDING.replace("rolling: {", joint).replace("2->4", during))
    assert found == pytest.approx({"v": 2, "w": -20, "t": math.sqrt(2 * 0.9 / G) + 1})


@pytest.mark.parametrize(
    "text", [ROLLING.replace("y(cyl) = R", "y(cyl) = 2*R"), BOWL.replace("x(ball) = 0", "x(ball) = -1 m")]
)
def test_what_begins_must_touch(text: str) -> None:
    with pytest.raises(NoSolution) as caught:
        solve(text)
    assert [d.code for d in caught.value.diagnostics] == ["PL718"]
    assert _followed(text).run.trajectory.outcome.code == "PL718"


def test_a_small_wheel_far_from_the_origin() -> None:
    """Its places are rounded more than its radius is."""
    text = ROLLING.split("  - rolling: {between: [cyl, level]", maxsplit=1)[0] + ROLLING[ROLLING.index("states") :]
    text = text.replace("2: [y(cyl) = R], 3: [x(cyl) - x(cyl) @ 2 = 4 m]", "3: [x(cyl) = 0]")
    found = _in_both(text.replace("R: 0.1 m", "R: 0.001 m").replace(", during: 1->2", ""))
    assert found["v"] == pytest.approx(
        math.sqrt(4 * G * math.sin(math.radians(20))) * math.cos(math.radians(20)), rel=1e-3
    )


def test_a_state_that_does_not_come_after_one_in_which_nothing_is_in_sight() -> None:
    text = ROLLING.replace("R: 0.1 m", "R: 0.001 m").replace("3: [x(cyl) - x(cyl) @ 2 = 4 m]", "3: [x(cyl) = 0]")
    with pytest.raises(PlanarError):
        solve(
            text.replace("  - rolling: {between: [cyl, level], during: 2->3, name: on_level}\n", "").replace(
                "1->2", "1->3"
            )
        )


@pytest.mark.parametrize(("mu", "turns"), [(0.5, 1.5), (0, 1)])
def test_a_wheel_that_may_slip_goes_on_turning_as_it_did(mu: float, turns: float) -> None:
    """Rough enough it rolls on; on smooth ground it does not turn, and m g h = m v²/2."""
    height = 3 * math.sin(math.radians(20)) + 0.1 * math.cos(math.radians(20)) - 0.1
    v = math.sqrt(2 * G * height / turns)
    found = _in_both(ROLLING.replace("rolling: {", f"contact: {{mu: {mu}, "))
    assert found["v"] == pytest.approx(v)
    assert found["w"] == pytest.approx(-v / 0.1 if mu else 0)


PLATEAU = """
title: Cylinder that rolls up a ramp to a plateau, on whose other side it is drawn
plane: vertical
given: {beta: 20 deg, L: 1 m, R: 0.1 m}
points:
  E: [0, 0]
  C: {from: E, distance: L, angle: 180 deg + beta}
  G: {from: C, distance: R, angle: 90 deg + beta}
surfaces: {ramp: {through: E, angle: beta}, level: {through: E, angle: 0 deg}}
bodies: {cyl: {disk: G, radius: R, mass: 4 kg}}
joints:
  - rolling: {between: [cyl, ramp], during: 1->2, name: on_ramp}
  - rolling: {between: [cyl, level], during: 2->3, name: on_level}
states: {1: [t = 0, v(cyl).mag = 4 m/s, omega(cyl) < 0], 2: [y(cyl) = R], 3: [x(cyl) - x(cyl) @ 2 = 4 m]}
find: {v: v(cyl).x @ 3, w: omega(cyl) @ 3}
"""


def test_a_wheel_stays_on_the_side_on_which_it_rolls() -> None:
    rise = 0.1 + math.sin(math.radians(20)) - 0.1 * math.cos(math.radians(20))
    v = math.sqrt(16 - 4 / 3 * G * rise)
    assert _in_both(PLATEAU) == pytest.approx({"v": v, "w": -v / 0.1})


def test_what_slips_does_not_roll_at_once() -> None:
    text = ROLLING.replace("rolling: {between: [cyl, slope]", "contact: {mu: 0, between: [cyl, slope]")
    with pytest.raises(NoSolution) as caught:
        solve(text)
    assert [d.code for d in caught.value.diagnostics] == ["PL717"]


ROD_AND_BOX = """
title: Rod that falls from level and knocks a box away
plane: vertical
given: {L: 0.9 m, e: 0.6, mu: 0.3}
points: {A: [0, 0], B: [-L, 0], C: [0, -L]}
surfaces: {floor: {through: C, angle: 0 deg}}
bodies: {rod: {rod: [A, B], mass: 3 kg}, box: {particle: C, mass: 1.2 kg}}
joints:
  - pin: {at: A, between: [ground, rod]}
  - contact: {between: [box, floor], at: C, mu: mu}
  - impact: {between: [rod, box], normal: 0 deg, restitution: e, during: 2->3}
states: {1: [t = 0, at rest], 2: [x(B) = 0], 3: [just after 2], 4: [box at rest]}
find: {w: omega(rod) @ 3, d: x(box) @ 4}
"""


def test_a_rod_that_is_drawn_along_the_normal_strikes_with_its_side_once_it_has_turned() -> None:
    found = _first(ROD_AND_BOX)
    arriving = math.sqrt(3 * G / 0.9)
    w = arriving * (1 - 1.2 * 0.6) / 2.2
    v = 0.9 * (w + 0.6 * arriving)
    assert found == pytest.approx({"w": w, "d": v * v / (2 * 0.3 * G)})


LOCKED = """
title: Collar that slides out on a turning rod, is locked to it and goes round with it
plane: horizontal
points: {O: [0, 0], E: [1 m, 0], P: [0.2 m, 0]}
bodies: {rod: {rod: [O, E], mass: 3 kg}, collar: {particle: P, mass: 1 kg}}
joints:
  - pin: {at: O, between: [ground, rod]}
  - guide: {point: P, along: rod}
  - weld: {at: P, between: [rod, collar], during: 2->4}
loads:
  - torque: {body: rod, moment: 2 N*m, during: 3->4}
states:
  1: [t = 0, omega(rod) = 6 rad/s, v(P/rod).mag = 0]
  2: [r(P).mag = 0.8 m]
  3: [just after 2]
  4: [theta(rod) - theta(rod) @ 3 = 2 rad]
find: {w: omega(rod) @ 3, end: omega(rod) @ 4, r: r(P).mag @ 4}
"""


@pytest.mark.parametrize("joint", ["weld", "pin"])
def test_what_is_caught_on_a_moving_body_stays_where_it_was_then(joint: str) -> None:
    """I + m r² goes from 1.04 to 1.64 kg m², and stays."""
    w = 6 * 1.04 / 1.64
    expected = {"w": w, "end": math.sqrt(w * w + 2 * 2 * 2 / 1.64), "r": 0.8}
    assert _in_both(LOCKED.replace("weld", joint)) == pytest.approx(expected)


CARRIER = """
title: Block that strikes the end of the wagon on which it slides
plane: vertical
points: {B: [0, 0], E: [0.5 m, 0], G: [-0.5 m, -0.1 m]}
surfaces:
  deck: {through: B, angle: 0 deg, body: wagon}
  stop: {through: E, angle: 90 deg, body: wagon}
bodies:
  block: {particle: B, mass: 3 kg}
  wagon: {plate: G, width: 2 m, height: 0.2 m, mass: 30 kg, points: [E]}
joints:
  - guide: {body: wagon, along: 0 deg}
  - contact: {between: [block, deck], mu: 0.2}
  - impact: {between: [block, stop], restitution: 0.4, during: 1->2}
states: {1: [x(block) = x(E)], 2: [just after 1], 3: [v(block/wagon).x = 0]}
find: {v: v(block).x @ 2, u: v(wagon).x @ 2, d: x(E) @ 3 - x(block) @ 3}
"""


def test_what_strikes_an_edge_far_from_the_mass_centre_of_the_body_that_carries_it() -> None:
    """(u' - v') = e (v - u); then the relative speed is braked by μ g (1 + m/M)."""
    text = CARRIER.replace("states: {1", "states: {0: [t = 0, wagon at rest, v(block).x = 5 m/s], 1")
    braking = 0.2 * G * 1.1
    coming = math.sqrt(25 - 2 * braking * 0.5)
    u = (15 + 3 * 0.4 * coming) / 33
    expected = {"v": u - 0.4 * coming, "u": u, "d": (0.4 * coming) ** 2 / (2 * braking)}
    assert _in_both(text) == pytest.approx(expected)


THROWN = """
title: Ball thrown over the edge of a slope, which lands on it and slides down
plane: vertical
given: {m: 2 kg, mu: 0.2}
points: {Q: [5 m, 1 m]}
surfaces: {slope: {through: Q, angle: ANGLE}}
bodies: {ball: {particle: [0, 0], mass: m}}
joints:
  - contact: {between: [ball, slope], mu: mu, during: 3->4}
states:
  1: [t = 0, v(ball).mag = 14 m/s, v(ball).angle = 60 deg]
  2: [y(ball) = 1 m - (x(ball) - 5 m)*tan(20 deg), v(ball).y < 0]
  3: [just after 2]
  4: [t = t @ 3 + 1 s]
find: {x_2: x(ball) @ 2, v_3: v(ball).mag @ 3, v_4: v(ball).mag @ 4}
"""
"""The line of the slope, prolonged, passes above the start."""


@pytest.mark.slow
@pytest.mark.parametrize("angle", ["-20 deg", "160 deg"])
def test_from_which_side_it_comes_counts_not_where_it_is_drawn(angle: str) -> None:
    slope, v_x, v_y, mu = math.radians(20), 7.0, 14 * math.sin(math.radians(60)), 0.2
    steep = math.tan(slope)
    half, rest = (v_y + v_x * steep) / G, 2 * (1 + 5 * steep) / G
    t = half + math.sqrt(half * half - rest)
    down = v_y - G * t
    across = v_x * math.sin(slope) + down * math.cos(slope)
    v_3 = v_x * math.cos(slope) - down * math.sin(slope) + mu * across
    v_4 = v_3 + G * (math.sin(slope) - mu * math.cos(slope))
    expected = {"x_2": v_x * t, "v_3": v_3, "v_4": v_4}
    assert _in_both(THROWN.replace("ANGLE", angle)) == pytest.approx(expected)


def test_what_strikes_a_line_from_below_does_not_lie_on_it_then() -> None:
    below = THROWN.replace("ANGLE", "10 deg").replace("mu: mu", "mu: 0").replace("[5 m, 1 m]", "[0, 2 m]")
    below = below.replace("1 m - (x(ball) - 5 m)*tan(20 deg), v(ball).y < 0", "2 m + x(ball)*tan(10 deg)")
    with pytest.raises(PlanarError, match="presses"):
        solve(below)
