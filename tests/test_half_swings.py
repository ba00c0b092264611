"""A harmonic motion from rest to rest: half a period, and the mirror about a midpoint that friction moves."""

from __future__ import annotations

import math
import unicodedata
from pathlib import Path

import pytest
from answered import first
from conftest import ROOT
from worked import worked

from planar_cli.formats.terminal import Terminal
from planar_cli.homework.checking.checking import read
from planar_cli.report.page.narrate import narrate
from planar_cli.solve.run import solve_problem
from planar_cli.solve.solved_problem import Solution

BLOCK = """
title: Block on a spring
plane: vertical
given: {{m: 2 kg, k: 200 N/m, {given}c: 120 mm, l: 0.4 m}}
points: {{W: [-l, 0], P: [c, 0]}}
surfaces: {{floor: {{through: P, angle: 0 deg}}}}
bodies: {{block: {{particle: P, mass: m}}}}
joints:
  - contact: {{between: [block, floor], at: P{friction}}}
loads:
  - spring: {{between: [W, P], stiffness: k, natural_length: l}}
states:
  1: [t = 0, {start}]
  2: [v(block).x = 0]
  3: [v(block).x = 0]
  4: [v(block).x = 0]
find: {{x_4: x(block) @ 4, t_4: t @ 4}}
"""
ROUGH = BLOCK.format(given="mu: 0.15, ", friction=", mu: mu", start="at rest")


def _read(tmp_path: Path, text: str) -> tuple[str, dict[str, float]]:
    file = tmp_path / "block.yaml"
    file.write_text(text, encoding="utf-8")
    solution = solve_problem(read(str(file)))
    return _shown(solution), {f.name: first(f) for part in solution.parts for f in part.found}


def _shown(solution: Solution) -> str:
    return " ".join(unicodedata.normalize("NFC", Terminal(200).render(narrate(solution))).split())


def test_friction_moves_the_midpoint_at_each_turn(tmp_path: Path) -> None:
    page, told = _read(tmp_path, ROUGH)
    midpoint = 0.15 * 2 * 9.81 / 200
    assert told["x_4"] == pytest.approx(-(0.12 - 6 * midpoint), rel=1e-9)
    assert told["t_4"] == pytest.approx(3 * math.pi / 10, rel=1e-9)
    assert "it goes as far beyond the midpoint as it began before it" in page
    assert "x_2 = 2 x_eq - c = 2 · 0.014715 - 0.12 = -0.09057 m" in page
    assert "3 half swings of π/ω_n each, with the same ω_n either way: " in page
    assert "t_4 = 3 π/ω_n = 3 π/10 = 0.9425 s" in page
    assert "work and kinetic energy;" not in page


def test_what_does_not_begin_at_rest_comes_to_rest_first(tmp_path: Path) -> None:
    moving = BLOCK.format(given="mu: 0.15, v_0: 1 m/s, ", friction=", mu: mu", start="v(block).x = v_0")
    page, told = _read(tmp_path, moving)
    assert "From 1 to 2, from rest to rest" not in page
    assert "t_4 = 2 π/ω_n + t_2 = 2 π/10 + 0.06386 = 0.6922 s" in page
    turn = math.sqrt((0.12 + 0.014715) ** 2 + 0.01) - 0.014715
    assert told["x_4"] == pytest.approx(turn - 4 * 0.014715, rel=1e-6)


def test_what_a_mode_alone_dates_is_derived() -> None:
    page = _shown(worked(ROOT / "problems/oscillations/block-coming-to-rest-by-dry-friction.yaml")[0])
    assert "t_stops_2 = 4 π/ω_n = 4 π/10 = 1.257 s At stop: t_stop = t_stops_2 = 1.257 s" in page
    assert "numerical integration" not in page
    assert "It turns round at state stops: v = 0. It stops sliding at state stops_2: v = 0." in page
    assert "Q = μ m g way = 0.15 · 2 · 9.81 · 0.4891 = 1.439 J" in page
    assert "(x_start - x_turn_1) + (x_turn_2 - x_turn_1) + (x_turn_2 - x_stops) + (x_stops_2 - x_stops)" in page
    assert "as before: the diagram, (1) and (2)" in page
    assert page.count("; there, between both midpoints, friction holds it: (9) x_stops_2 = ") == 1
    assert page.count("friction holds it") == 1


def test_an_angle_is_worked_out_in_radians(tmp_path: Path) -> None:
    text = """
title: Rod on a torsion spring with friction in its axle
plane: horizontal
given: {I: 0.5 kg*m^2, c: 8 N*m, M: 0.4 N*m}
coordinates: {phi: deg}
points: {O: [0, 0], A: {from: O, distance: 0.3 m, angle: phi}}
bodies: {rod: {rod: [O, A], mass: 5 kg, inertia: I, about: O}}
joints: [pin: {at: O, between: [ground, rod], friction_torque: M}]
loads: [torque: {body: rod, moment: -c*phi}]
states: {1: [phi = 60 deg, at rest], 2: [omega(rod) = 0], 3: [omega(rod) = 0]}
find: {phi_2: phi @ 2 in deg, t_3: t @ 3}
"""
    page, _ = _read(tmp_path, text)
    assert "φ_2 = 2 φ_eq - φ_1 = 2 · 0.05 - 1.0472 = -0.9472 rad = -54.27°" in page
    assert "For the coordinate φ:" in page
