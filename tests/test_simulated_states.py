"""States of a motion that is followed in numbers: when each is reached, and what is read off there."""

from __future__ import annotations

from math import atan, pi, sqrt

import pytest
from answered import CORD, assert_close, solve

from planar_cli.problem.structure import load_text
from planar_cli.simulate.answers import Answered
from planar_cli.simulate.run import Settings, Simulation, prepared, simulate

THROWN = """
title: Stone thrown up
plane: vertical
bodies: {P: {particle: [0, 0], mass: 1 kg}}
states: {1: [t = 0, v(P).x = 0, v(P).y = sqrt(2*g*(3 m))], 2: [y(P) = 3 m, at rest]}
find: {t: t @ 2}
"""
TURNING = """
title: Turning crank
points: {O: [0, 0], P: [1 m, 0]}
bodies: {crank: {rod: [O, P]}}
joints: [pin: {at: O, between: [ground, crank]}]
motion: [omega(crank) = 1 rad/s]
states: {1: [t = 0], 2: [%s], 3: [t = 40 s]}
find: {t: t @ 2, turned: r(P).angle @ 2}
"""
LONGEST = """
title: Longest throw
plane: vertical
unknowns: {beta: deg}
bodies: {P: {particle: [0, 0], mass: 1 kg}}
states:
  1: [t = 0, v(P).mag = 10 m/s, v(P).angle = beta]
  2: [y(P) = 0, x(P) is largest]
find: {d: x(P) @ 2}
"""

SWINGING = """
title: Ball on a spring, x = cos(t)
plane: horizontal
points: {O: [0, 0]}
bodies: {P: {particle: [1 m, 0], mass: 1 kg}}
joints: [guide: {point: P, along: 0 deg}]
loads: [spring: {between: [O, P], stiffness: 1 N/m, natural_length: 0 m}]
states: {start: [t = 0, at rest], %s}
find: {t: t @ it}
"""


def simulated(text: str, **values: float) -> Simulation:
    problem, wrong = load_text(text)
    assert problem is not None
    assert not wrong
    return simulate(problem, Settings(values=values, estimate=False))


def answers(text: str, **values: float) -> dict[str, Answered]:
    return {a.name: a for a in simulated(text, **values).answers}


def test_a_load_without_a_name_leaves_the_weight_alone() -> None:
    """Both are called by the body: as long as the cord is slack the stone falls. 2 g (1 + s) = 100 s²."""
    weight = 2 * 9.81
    assert answers(CORD)["y"].values == pytest.approx([-2 - (weight + sqrt(weight**2 + 400 * weight)) / 200])


def test_a_place_that_is_only_just_reached_at_rest() -> None:
    assert answers(THROWN)["t"].values == pytest.approx([sqrt(6 / 9.81)])


def test_a_pole_is_no_zero() -> None:
    """tan θ = 2 with x < 0; at 90° the difference changes its sign as well."""
    found = answers(TURNING % "tan(theta(crank)) = 2, x(P) < 0")
    assert found["t"].values == pytest.approx([pi + atan(2)])


def test_turns_are_counted_up_to_the_state_that_is_asked_about() -> None:
    """Six more turns follow until the last state."""
    found = answers(TURNING % "t = 1 s")
    assert found["turned"].values == pytest.approx([1.0])


def test_what_is_largest_over_a_constant_leaves_the_time_to_the_other_relation() -> None:
    assert answers(LONGEST, beta=pi / 4)["d"].values == pytest.approx([100 / 9.81])


@pytest.mark.parametrize(
    ("states", "time"),
    [
        ("late: [t = 6 s], it: [x(P) = 0]", 2.5 * pi),
        ("late: [t = 6 s], 2: [x(P) = 0], it: [v(P).x = 0]", 3 * pi),
        ("2: [v(P).x = 0], late: [t = 6 s], it: [x(P) = 0]", 2.5 * pi),
        ("2: [v(P).x = 0], soon: [t = 1 s], it: [x(P) = 0]", 0.5 * pi),
        ("later: [t = 9 s], late: [t = 6 s], it: [x(P) = 0]", 2.5 * pi),
        ("late: [t = 6 s], it: [x(P) = 0, t < 2 s]", 0.5 * pi),
        ("late: [t = 3 s], later: [t = 6 s], it: [x(P) = 0, t < 2 s]", 0.5 * pi),
        ("late: [t = 6 s], 2: [x(P) = 0, t < 2 s], it: [v(P).x = 0]", pi),
    ],
)
def test_what_is_listed_behind_a_given_time_comes_after_it(states: str, time: float) -> None:
    """But what never happens after it may have happened before it."""
    assert answers(SWINGING % states)["t"].values == pytest.approx([time])


COUNTED = """
title: Ball on a spring, x = cos(t)
plane: horizontal
points: {O: [0, 0]}
bodies: {P: {particle: [1 m, 0], mass: 1 kg}}
joints: [guide: {point: P, along: 0 deg}]
loads: [spring: {between: [O, P], stiffness: 1 N/m, natural_length: 0 m}]
states: {start: [t = 0, at rest], cross: [x(P) = 0], turn: [v(P).x = 0], again: [x(P) = 0], late: [t = 6 s]}
find: {n: count(%s) @ %s}
"""


@pytest.mark.parametrize(
    ("relation", "span", "number"),
    [
        ("x(P) = 0", "start->turn", 1),
        ("x(P) = 0", "start->cross", 1),
        ("x(P) = 0", "cross->turn", 0),
        ("x(P) = 0", "cross->again", 1),
        ("x(P) = 0", "start->late", 2),
        ("v(P).x = 0", "start->turn", 1),
        ("x(P) = -1 m", "start->late", 1),
        ("x(P) = -0.9999 m", "start->late", 2),
        ("x(P) > 0", "start->late", 1),
        ("x(P) < 0", "start->late", 1),
        ("x(P) < -0.9999 m", "start->late", 1),
    ],
)
def test_how_often_a_relation_comes_to_hold(relation: str, span: str, number: int) -> None:
    """The beginning does not count, the end does; a state between does not hide what happens there."""
    assert answers(COUNTED % (relation, span))["n"].values == (number,)


def test_a_motion_of_blows_alone_ends_with_its_last_state() -> None:
    text = THROWN.replace("[y(P) = 3 m, at rest]", "[just after 1]")
    trajectory = simulated(text).run.trajectory
    assert trajectory.outcome.kind == "reached"
    assert trajectory.t1 == 0


def test_a_state_told_by_turns_just_after_a_balance() -> None:
    """What has been counted is counted once: the balance of energy goes the same way again."""
    text = TURNING.replace("motion: [omega(crank) = 1 rad/s]\n", "").replace("title:", "plane: horizontal\ntitle:")
    text = text.replace("rod: [O, P]", "rod: [O, P], mass: 1 kg").replace("[t = 0]", "[t = 0, omega(crank) = 2 rad/s]")
    found = answers(text % "r(P).angle = 800 deg")
    assert found["t"].values == pytest.approx([800 * pi / 360])
    assert found["turned"].values == pytest.approx([800 * pi / 180])


SHOT = """
title: Shot straight up from a planet, a law of places alone
given: {R: 6371 km, v_0: 8 km/s, g_0: 9.81 m/s^2}
bodies: {P: {particle: [0, 0]}}
motion: [a(P).y = -g_0*R^2/(R + y(P))^2, x(P) = 0]
states:
  1: [t = 0, v(P).y = v_0]
  2: [v(P).y = 0]
find: {H: y(P) @ 2}
"""


def test_how_quick_a_motion_is_that_only_a_law_tells() -> None:
    """Minutes, as accelerations and lengths say, and not a second."""
    problem, wrong = load_text(SHOT)
    assert problem is not None, wrong
    height = solve(SHOT)["H"]
    assert_close(height, 6371e3 * 64e6 / (2 * 9.81 * 6371e3 - 64e6))
    scales = prepared(problem, {}).model.scales
    assert scales.time == pytest.approx((6371e3 / 9.81) ** 0.5)


def test_what_the_start_takes_for_granted_is_told() -> None:
    """Two weights on a rope over a peg: how they sway at the start is not in the file."""
    text = """
title: Weights on a rope that may sway
plane: vertical
points: {A: [0, -1 m], D: [0.5 m, 0], B: [1 m, -1 m]}
bodies: {a: {particle: A, mass: 2 kg}, b: {particle: B, mass: 3 kg}}
joints:
  - rope: {path: [A, over D, B]}
states: {1: [t = 0, v(a).y = 1 m/s], 2: [t = 0.2 s]}
find: {y: y(a) @ 2}
"""
    assert any("without swaying of a, b" in note for note in simulated(text).run.trajectory.notes)


BUFFER = """
title: Block that runs into a buffer
plane: vertical
points: {P: [0, 0], W: [1.7 m, 0]}
bodies: {block: {particle: P, mass: 2 kg}}
joints: [guide: {point: P, along: 0 deg}]
loads: [spring: {between: [P, W], stiffness: 800 N/m, natural_length: 0.5 m, acts: push, name: buffer}]
states:
  0: [t = 0, v(P).x = 3 m/s]
  meets: [x(P) = 1.2 m]
  deepest: [v(P).x = 0]
find: {E: PE(buffer) @ 0, E_all: PE(all) @ 0, E_meets: PE(buffer) @ meets, E_deepest: PE(buffer) @ deepest}
"""


def test_a_spring_that_is_free_has_no_energy() -> None:
    """The page said 0, the motion that was followed 576 J."""
    truth = {"E": 0.0, "E_all": 0.0, "E_meets": 0.0, "E_deepest": 9.0}
    assert {name: one.values[0] for name, one in answers(BUFFER).items()} == pytest.approx(truth, abs=1e-6)
    for name, found in solve(BUFFER).items():
        assert_close(found, truth[name])
