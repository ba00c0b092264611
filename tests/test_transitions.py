"""What begins, holds and ends along a motion: nothing rests for ever, nothing slack is taut, nothing held lifts off."""

from __future__ import annotations

from math import cos, pi

import pytest
from answered import first, solve

from planar_cli.errors import NoSolution

CARRIAGES = """
title: Two carriages joined by an elastic cord
plane: horizontal
points: {A: [0, 0], B: [1 m, 0]}
bodies: {a: {particle: A, mass: 2 kg}, b: {particle: B, mass: 3 kg}}
joints:
  - guide: {point: A, along: 0 deg}
  - guide: {point: B, along: 0 deg}
loads:
  - spring: {between: [A, B], stiffness: 30 N/m, natural_length: 1.5 m, acts: pull, name: cord}
states:
  1: [t = 0, v(a).x = -2 m/s, v(b).x = 0]
  2: [t = %s s]
find: {v_a: v(a).x @ 2, v_b: v(b).x @ 2}
"""


@pytest.mark.parametrize("time", [0.2, 0.6, 1])
def test_what_is_pulled_later_moves_then(time: float) -> None:
    """Slack for 0.25 s; then half a swing of the reduced mass 6/5 kg, w = 5 1/s; then slack again."""
    found = solve(CARRIAGES % time)
    phase = min(max(5 * (time - 0.25), 0), pi)
    mean, relative = -4 / 5, 2 * cos(phase)
    assert first(found["v_a"]) == pytest.approx(mean - 3 / 5 * relative)
    assert first(found["v_b"]) == pytest.approx(mean + 2 / 5 * relative, abs=1e-12)


ROPE = """
title: Slack rope, and loads that begin
plane: horizontal
points: {A: [0, 0], B: [1 m, 0]}
bodies: {a: {particle: A, mass: 1 kg}, b: {particle: B, mass: 1 kg}}
joints:
  - guide: {point: A, along: 0 deg}
  - guide: {point: B, along: 0 deg}
  - rope: {path: [A, B], name: rope}
loads:
%s
states:
%s
find: {v_a: v(a).x @ end, v_b: v(b).x @ end, rope: mode(rope) @ end = slack}
"""
FORCE = "  - force: {body: %s, magnitude: %s N, angle: 0 deg, during: %s}"


def test_a_slack_rope_is_not_taut_where_a_load_begins() -> None:
    """One carriage has come nearer to the other, and is braked."""
    states = "  1: [t = 0, v(a).x = 1 m/s, v(b).x = 0]\n  2: [t = 0.5 s]\n  end: [t = 0.7 s]"
    found = solve(ROPE % (FORCE % ("a", -2, "2->end"), states))
    assert first(found["v_a"]) == pytest.approx(0.6)
    assert first(found["v_b"]) == 0
    assert found["rope"].word == "true"


def test_a_slack_rope_at_rest_is_not_taut_either() -> None:
    """Both at rest, half a metre nearer to each other than the rope is long: only one of them is drawn away."""
    loads = [FORCE % x for x in (("a", 4, "1->2"), ("a", -4, "2->3"), ("a", -1, "3->end"))]
    states = "  1: [t = 0, at rest]\n  2: [t = 0.25 s]\n  3: [t = 0.5 s]\n  end: [t = 0.6 s]"
    found = solve(ROPE % ("\n".join(loads), states))
    assert first(found["v_a"]) == pytest.approx(-0.1)
    assert first(found["v_b"]) == 0


AIR = """
title: Ball thrown up by a force, and a wind that begins at the top
plane: vertical
points: {P: [0, 0]}
surfaces: {floor: {through: P, angle: 0 deg}}
bodies: {ball: {particle: P, mass: 1 kg}}
joints:
  - contact: {between: [ball, floor], at: P, mu: 0.3}
loads:
  - force: {body: ball, magnitude: 19.62 N, angle: 90 deg, during: 1->2}
  - force: {body: ball, magnitude: 2 N, angle: 0 deg, during: 3->4}
states: {1: [t = 0, at rest], 2: [t = 1 s], 3: [v(ball).y = 0], 4: [t = 2.5 s]}
find: {x: v(ball).x @ 4, y: v(ball).y @ 4, h: y(ball) @ 3}
"""


def test_a_ball_at_its_top_does_not_stand_on_the_floor() -> None:
    found = solve(AIR)
    assert first(found["h"]) == pytest.approx(9.81)
    assert first(found["x"]) == pytest.approx(1)
    assert first(found["y"]) == pytest.approx(-9.81 / 2)


BRAKE = """
title: Wheel with a brake block
plane: vertical
points: {O: [0, 0], T: [0, 0.5 m]}
surfaces: {block: {through: T, angle: 0 deg}}
bodies: {wheel: {disk: O, radius: 0.5 m, mass: 4 kg}}
joints:
  - pin: {at: O, between: [ground, wheel]}
  - contact: {between: [wheel, block], at: T, %s}
"""
STATES = """
states: {1: [t = 0, omega(wheel) = 10 rad/s], 2: [omega(wheel) = 0]}
find: {t: t @ 2, phi: theta(wheel) @ 2 - theta(wheel) @ 1, stays: mode(T) @ 2 = stick}
"""
INSTANT = """
instant: [omega(wheel) = 10 rad/s]
find: {alpha: alpha(wheel)}
"""


def test_a_braked_wheel_on_a_fixed_axle() -> None:
    """I alpha = R F: alpha = 0.5 * 25/(4 * 0.25/2) = 25 rad/s², whatever presses the block on."""
    assert first(solve(BRAKE % "friction: 25 N" + INSTANT)["alpha"]) == -25
    found = solve(BRAKE % "friction: 25 N" + STATES)
    assert first(found["t"]) == pytest.approx(10 / 25)
    assert first(found["phi"]) == pytest.approx(10**2 / (2 * 25))
    assert found["stays"].word == "true"


@pytest.mark.parametrize("asked", [INSTANT, STATES])
def test_a_friction_that_rests_on_an_open_force_is_open(asked: str) -> None:
    with pytest.raises(NoSolution, match=r"not unique: N\(T\)|accelerations are open"):
        solve(BRAKE % "mu: 0.3" + asked)
