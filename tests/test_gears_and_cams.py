"""Wheels that several times roll on each other, over whole turns; a cam turned to where its follower is fastest."""

from __future__ import annotations

import math
from pathlib import Path

import pytest
import sympy as sp
from answered import assert_close, solve
from click.testing import CliRunner

from planar_cli.by_click import cli

PLANETS = """
title: Two planets between a sun and a ring
plane: horizontal
points:
  O: [0, 0]
  A: [0, 140 mm]
  B: {{from: O, distance: 140 mm, angle: {angle} deg}}
surfaces: {{ring: {{center: O, radius: 200 mm}}}}
bodies:
  sun: {{disk: O, radius: 80 mm, mass: 2 kg}}
  arm: {{points: [A, B], center: O, mass: 1 kg, inertia: 0.03 kg*m^2}}
  a: {{disk: A, radius: 60 mm, mass: 0.9 kg}}
  b: {{disk: B, radius: 60 mm, mass: 0.9 kg}}
joints:
  - pin: {{at: O, between: [ground, sun, arm]}}
  - pin: {{at: A, between: [arm, a]}}
  - pin: {{at: B, between: [arm, b]}}
  - rolling: {{between: [a, sun], name: sun_a}}
  - rolling: {{between: [b, sun], name: sun_b}}
  - rolling: {{between: [a, ring], at: [0, 200 mm]}}
  - rolling: {{between: [b, ring], at: {{from: O, distance: 200 mm, angle: {angle} deg}}}}
loads:
  - torque: {{body: arm, moment: 6 N*m}}
"""
AT_REST = "instant: [at rest]\nfind: {alpha: alpha(arm)}\n"
TURNING = """states:
  1: [t = 0, at rest]
  2: [{after}]
find: {{omega: omega(arm) @ 2}}
"""

CAM = """
title: Eccentric cam with a flat-faced follower
symbols: {{R: m, e: m, w: rad/s}}
assume: [e < R]
coordinates: {{theta: deg}}
points:
  O: [0, 0]
  G: [e*cos(theta), e*sin(theta)]
  P: [0, e*sin(theta) + R]
  Q: [0, e*sin(theta) + 3*R]
surfaces: {{face: {{through: P, angle: 0 deg, body: follower}}}}
bodies: {{cam: {{disk: G, radius: R, points: [O]}}, follower: {{rod: [P, Q]}}}}
joints:
  - pin: {{at: O, between: [ground, cam]}}
  - guide: {{body: follower, along: 90 deg}}
  - contact: {{between: [cam, face], mu: 0, name: touch}}
motion: [omega(cam) = w]
instant: [{extreme}]
find: {{most: {asked}.mag, place: theta}}
"""
ARM, PLANET, SUN = 0.03, 0.9 * (0.14**2 + 0.5 * 0.14**2), 0.5 * 2 * 0.08**2 * (0.28 / 0.08) ** 2
ALPHA = 6 / (ARM + 2 * PLANET + SUN)


@pytest.mark.slow
@pytest.mark.parametrize("angle", ["210", "-90"])
@pytest.mark.parametrize("after", ["theta(arm) = 4 rev", "theta(arm) @ 2 - theta(arm) @ 1 = 4 rev"])
def test_a_planetary_gear_turns_several_times(tmp_path: Path, angle: str, after: str) -> None:
    file = tmp_path / "gear.yaml"
    text = PLANETS.format(angle=angle) + TURNING.format(after=after)
    file.write_text(f"{text}answers: {{omega: {math.sqrt(16 * math.pi * ALPHA)} rad/s}}\ntolerance: 0.000001\n")
    shown = CliRunner().invoke(cli, ["check", str(file)])
    assert shown.exit_code == 0, shown.output


@pytest.mark.parametrize("angle", ["210", "-90"])
def test_what_moves_is_unique_though_tooth_forces_are_not(angle: str) -> None:
    assert_close(solve(PLANETS.format(angle=angle) + AT_REST)["alpha"], ALPHA)


@pytest.mark.parametrize(
    ("extreme", "asked", "power", "place"),
    [("v(P).y is largest", "v(P)", 1, sp.S.Zero), ("a(P).y is smallest", "a(P)", 2, sp.pi / 2)],
)
def test_a_flat_follower_is_fastest(extreme: str, asked: str, power: int, place: sp.Expr) -> None:
    found = solve(CAM.format(extreme=extreme, asked=asked))
    most, at = (found[name].expressions for name in ("most", "place"))
    assert most is not None
    assert at is not None
    e, w = (next(s for s in most[0].free_symbols if s.name == name) for name in ("e", "w"))
    assert sp.simplify(most[0] - e * w**power) == 0
    assert at[0] == place


def test_a_quantity_at_the_beginning_of_a_line_keeps_its_small_letter(tmp_path: Path) -> None:
    file = tmp_path / "cam.yaml"
    file.write_text(CAM.format(extreme="a(P).y is smallest", asked="a(P)"), encoding="utf-8")
    shown = CliRunner().invoke(cli, ["solve", str(file)])
    assert "\n  a_Py is smallest, so its derivative" in shown.output


SHAPER = """
title: Shaper with a quick return
points:
  O: [0, 0]
  A: {from: O, distance: 100 mm, angle: 30 deg}
  C: [0, -250 mm]
  D: {from: C, towards: A, distance: 450 mm}
  E: {y: 200 mm, distances: {D: 150 mm}, side: right}
bodies: {crank: {rod: [O, A]}, arm: {rod: [C, D]}, rod: {rod: [D, E]}, ram: {particle: E}}
joints:
  - pin: {at: O, between: [ground, crank]}
  - pin: {at: C, between: [ground, arm]}
  - guide: {point: A, along: arm}
  - pin: {at: D, between: [arm, rod]}
  - pin: {at: E, between: [rod, ram]}
  - guide: {point: E, along: 0 deg, name: ways}
motion: [omega(crank) = 60 rpm]
states:
  start: [t = 0]
  back: [v(ram).x is smallest]
find: {v: v(ram).x @ back, level: theta(rod) @ back}
"""


def test_a_zero_that_is_solved_for_is_zero() -> None:
    """With the crank upright the rod lies level; no rounding of the last step is left of its angle."""
    found = solve(SHAPER)
    assert_close(found["v"], -2 * math.pi * 0.1 * 0.45 / 0.35, 12)
    assert found["level"].values == (0,)
