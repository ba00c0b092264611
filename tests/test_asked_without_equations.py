"""What an answer rests on is told where no equation has told it, and what is zero is no small number."""

from __future__ import annotations

import pytest
from conftest import ROOT
from worked import worked

from planar_cli.formats.terminal import Terminal
from planar_cli.problem.structure import load_text
from planar_cli.report.narrate import narrate
from planar_cli.solve.run import solve_problem
from planar_cli.solve.solved_problem import Solution

FLYWHEEL = """
title: Moment of inertia of a flywheel with four holes
plane: vertical
given: {rho: 7850 kg/m^3, R: 300 mm, t_d: 40 mm, r_h: 60 mm, s: 180 mm, r_n: 70 mm, t_n: 50 mm, m_h: rho*t_d*pi*r_h^2}
points: {O: [0, 0], A: [s, 0], B: [0, s], C: [-s, 0], D: [0, -s]}
bodies:
  wheel:
    parts:
      - {disk: O, radius: R, mass: rho*t_d*pi*R^2}
      - {disk: O, radius: r_n, mass: rho*t_n*pi*r_n^2}
      - {disk: A, radius: r_h, mass: -m_h}
      - {disk: B, radius: r_h, mass: -m_h}
      - {disk: C, radius: r_h, mass: -m_h}
      - {disk: D, radius: r_h, mass: -m_h}
find: {m: mass(wheel), I_O: I(wheel/O), k_O: sqrt(I(wheel/O)/mass(wheel)) in mm}
"""


def _page(name: str) -> str:
    """The page with single spaces."""
    return _spaced(worked(ROOT / "problems" / f"{name}.yaml")[0])


def _spaced(solution: Solution) -> str:
    return " ".join(Terminal(200).render(narrate(solution)).split())


def test_the_force_of_a_stream_that_is_asked() -> None:
    page = _page("momentum/vane-that-runs-before-a-jet")
    assert "momentum per second of the stream jet: F_jet = ρ (v_j - u)² A = 1000 (30 - 12)² · 0.0005 = 162 N" in page
    assert "Principle Momentum of a stream: its force is the mass per second times its velocity." in page


def test_the_parts_of_a_moment_of_inertia_that_is_asked() -> None:
    problem, wrong = load_text(FLYWHEEL)
    assert not wrong
    solution = solve_problem(problem)
    numbers = {f.name: float(f.values[0]) for f in solution.parts[0].found if f.values}
    assert numbers == pytest.approx({"m": 80.6185, "I_O": 3.52416, "k_O": 0.209079}, rel=1e-5)
    page = _spaced(solution)
    assert "I_wheel,3 = 1/2 m_wheel,3 r_h² = 1/2 (-3.551) · 0.06² = -0.006392 kg·m²" in page
    assert "k_O = √(I/m)" in page
    assert "x_G" not in page


def test_the_acceleration_at_a_largest_speed() -> None:
    page = _page("energy/plate-let-go-at-a-corner")
    assert "α_lowest = -3 g (b cos θ_lowest + h sin θ_lowest) / (2 (b² + h²)) = 0 rad/s²" in page
    assert "×10⁻" not in page
