"""A particle strikes a named point of a body, from the side of the body's mass centre or from the other."""

from __future__ import annotations

from pathlib import Path

import pytest
from answered import first, solve, solved

from planar_cli.errors import FileProblem

SLOT = """\
plane: horizontal
points: {{G: [{centre}, 0], S: [0.2 m, 0], Q: [0.5 m, 0]}}
bodies:
  cart: {{points: [G, Q], center: G, mass: 4 kg, inertia: 1 kg*m^2}}
  ball: {{particle: S, mass: 1 kg}}
joints:
  - guide: {{body: cart, along: 0 deg, name: rail}}
  - guide: {{point: S, along: cart, name: track}}
  - impact: {{{keys}}}
states:
  1: [t = 0, cart at rest, v(ball).x = 2 m/s]
  2: [x(S) = 0.5 m]
  3: [just after 2]
find: {{v: v(ball).x @ 3, lost: KE(all) @ 2 - KE(all) @ 3}}
"""
KEYS = [
    "between: [ball, cart], at: Q, normal: 0 deg, restitution: 0, during: 2->3",
    "between: [cart, ball], at: Q, normal: 180 deg, restitution: 0, during: 2->3",
    "between: [ball, cart], at: Q, normal: 0 deg, restitution: 0",
]


@pytest.mark.parametrize("keys", KEYS)
@pytest.mark.parametrize("centre", ["0", "1 m", "0.1 m", "-2 m"])
def test_a_ball_strikes_the_end_of_its_slot(tmp_path: Path, keys: str, centre: str) -> None:
    """Wherever the mass centre of the cart lies: m v = (m + M) u."""
    found = solved(tmp_path, SLOT.format(keys=keys, centre=centre))
    assert float(found["v"].values[0]) == pytest.approx(0.4)
    assert float(found["lost"].values[0]) == pytest.approx(1.6)


ROD = """\
plane: horizontal
points: {O: [0, 0], S: [0.2 m, 0], Q: [0.5 m, 0]}
bodies:
  rod: {rod: [O, Q], mass: 3 kg}
  ball: {particle: S, mass: 1 kg}
joints:
  - pin: {at: O, between: [ground, rod]}
  - guide: {point: S, along: rod, name: track}
  - impact: {between: [ball, rod], at: Q, normal: 0 deg, restitution: 0.5, during: 2->3}
states:
  1: [t = 0, omega(rod) = 0 rad/s, v(ball/rod).along(rod) = 2 m/s]
  2: [r(S/O).mag = 0.5 m]
  3: [just after 2]
find: {v: v(ball/rod).along(rod) @ 3}
"""


def test_a_ball_strikes_the_stop_at_the_end_of_a_rod(tmp_path: Path) -> None:
    found = solved(tmp_path, ROD)
    assert float(found["v"].values[0]) == pytest.approx(-1.0)


def test_a_particle_with_coordinates_strikes_from_the_side_from_which_it_comes() -> None:
    """ω = (1 + e) m v L/(I_O + m L²), turned the way in which the ball moves."""
    for way in (1, -1):
        found = solve(STRUCK_ROD.format(angle=30 + 90 * way))
        assert first(found["w"]) == pytest.approx(way * 1.5 * 4 / (1 + 1))


STRUCK_ROD = """
title: Rod on a pin struck by a ball
plane: horizontal
coordinates: {{theta: deg, x: m, y: m}}
points: {{O: [0, 0], B: {{from: O, distance: 1 m, angle: theta}}, P: [x, y]}}
bodies: {{rod: {{rod: [O, B], mass: 3 kg}}, ball: {{particle: P, mass: 1 kg}}}}
joints:
  - pin: {{at: O, between: [ground, rod]}}
  - impact: {{between: [ball, rod], normal: theta + 90 deg, restitution: 0.5}}
states:
  1:
    - theta = 30 deg
    - x = cos(30 deg)*(1 m)
    - y = sin(30 deg)*(1 m)
    - omega(rod) = 0
    - v(ball).mag = 4 m/s
    - v(ball).angle = {angle} deg
  2: [just after 1]
find: {{w: omega(rod) @ 2}}
"""


@pytest.mark.parametrize("way", [1, -1])
def test_a_normal_counted_from_the_angle_of_a_body_is_the_one_by_its_coordinate(way: int) -> None:
    text = STRUCK_ROD.format(angle=30 + 90 * way).replace("theta + 90", "theta(rod) + 90")
    assert first(solve(text)["w"]) == pytest.approx(way * 1.5 * 4 / (1 + 1))


def test_a_normal_counted_from_what_has_no_angle_is_refused() -> None:
    with pytest.raises(FileProblem) as wrong:
        solve(STRUCK_ROD.format(angle=120).replace("theta + 90", "theta(ball) + 90"))
    (told,) = wrong.value.diagnostics
    assert told.code == "PL420"
    assert "ball is a particle: it has no angle" in told.message


def test_a_direction_of_a_load_that_turns_with_a_body_is_written_with_its_coordinate() -> None:
    force = "loads: [{force: {at: B, magnitude: 1 N, angle: theta(rod) + 90 deg}}]\nstates:"
    with pytest.raises(FileProblem) as wrong:
        solve(STRUCK_ROD.format(angle=120).replace("states:", force))
    (told,) = wrong.value.diagnostics
    assert told.code == "PL413"
    assert "and here `phi + 90 deg`" in (told.hint or "")
