"""A blow that the file names and in which nothing strikes is refused, and not told as one that changes nothing."""

from __future__ import annotations

import math

import pytest
from answered import first, solve

from planar_cli.errors import NoSolution

JUMP = """
title: Skier who lands on a slope
plane: vertical
given: {beta: 25 deg, gamma: 35 deg, s: 30 m, h: HEIGHT}
points: {E: [0, 0], S: {from: E, distance: s, angle: 180 deg - beta}, F: [0, -h]}
surfaces: {ramp: {through: E, angle: -beta}, hill: {through: F, angle: -gamma}}
bodies: {skier: {particle: S, mass: 70 kg}}
joints:
  - contact: {between: [skier, ramp], at: S, mu: 0, during: 1->2}
  - impact: {between: [skier, hill], restitution: 0, during: 3->4}
states:
  1: [at rest]
  2: [x(skier) = 0]
  3: [y(skier) = -h - x(skier)*tan(gamma)]
  4: [just after 3]
find: {v: v(skier).mag @ 4}
"""


@pytest.mark.parametrize(("mu", "code", "line"), [("mu: 0", "PL706", 13), ("mu_k: 0.05", "PL706", 13)])
def test_the_slope_has_no_end_and_the_start_lies_on_its_other_side(mu: str, code: str, line: int) -> None:
    with pytest.raises(NoSolution) as raised:
        solve(JUMP.replace("HEIGHT", "2 m").replace("mu: 0", mu).replace(", during: 3->4}", "}"))
    (why,) = raised.value.diagnostics
    assert (why.code, why.mark.line) == (code, line)
    assert "`during" in why.hint


@pytest.mark.parametrize("height", [2, 20])
def test_in_one_blow_it_lands_from_where_it_comes(height: int) -> None:
    found = solve(JUMP.replace("HEIGHT", f"{height} m"))
    b, c = math.radians(25), math.radians(35)
    v = math.sqrt(2 * 9.81 * 30 * math.sin(b))
    along, down = v * math.cos(b), v * math.sin(b) - v * math.cos(b) * math.tan(c)
    t = (-down + math.sqrt(down**2 + 2 * 9.81 * height)) / 9.81
    assert first(found["v"]) == pytest.approx(along * math.cos(c) + (v * math.sin(b) + 9.81 * t) * math.sin(c))


DROP = """
title: A ball meets a slope that passes above its start
plane: vertical
given: {R: 0.5 m}
points: {A: [0, 0], S: [30 m, -12 m]}
surfaces: {slope: {through: S, angle: -30 deg}}
bodies: {ball: {SHAPE, mass: 7 kg}}
joints:
  - impact: {between: [ball, slope], restitution: 0.5, during: 2->3}
states:
  1: [v(A).x = 20 m/s, v(A).y = 0SPIN]
  2: [x(A) > 30 m, y(A) = -12 m - tan(30 deg)*(x(A) - 30 m)RADIUS]
  3: [just after 2]
find: {along: v(A).along(-30 deg) @ 3, away: v(A).along(60 deg) @ 3, x: x(A) @ 2}
"""


@pytest.mark.parametrize(
    ("shape", "spin", "radius"), [("particle: A", "", 0), ("disk: A, radius: R", ", omega(ball) = 0", 0.5)]
)
def test_a_point_and_a_disk_bounce(shape: str, spin: str, radius: float) -> None:
    text = DROP.replace("SHAPE", shape).replace("SPIN", spin).replace("RADIUS", " + R/cos(30 deg)" if radius else "")
    found = solve(text)
    s, c = 0.5, math.sqrt(3) / 2
    # -g t²/2 = -12 - tan 30° (20 t - 30) + R/cos 30°, the later root.
    p, q = 20 * s / c, 12 - 30 * s / c - radius / c
    t = (p + math.sqrt(p**2 + 2 * 9.81 * q)) / 9.81
    vy = -9.81 * t
    expected = (20 * c - vy * s, -0.5 * (20 * s + vy * c), 20 * t)
    assert [first(found[n]) for n in ("along", "away", "x")] == pytest.approx(expected)
