"""A radius of curvature has its line: from v and a of the point, or as the radius of a path that is known."""

from __future__ import annotations

import pytest
from worked import page_of_file

from planar_cli.formats.terminal import Terminal
from planar_cli.problem.structure import load_text
from planar_cli.report.page.narrate import narrate
from planar_cli.solve.run import solve_problem

BOOM = """
title: Truck with a telescopic boom
points:
  A: [0, 0]
  B: {from: A, distance: 8 m, angle: 40 deg}
  C: {from: A, distance: 5 m, angle: 40 deg}
bodies: {truck: {points: [A]}, boom: {rod: [A, B]}, slide: {particle: C}}
joints:
  - guide: {body: truck, along: 0 deg}
  - pin: {at: A, between: [truck, boom]}
  - guide: {point: C, along: boom}
instant:
  - v(A).x = 2 m/s
  - a(A).x = 0.5 m/s^2
  - omega(boom) = 0.2 rad/s
  - alpha(boom) = -0.05 rad/s^2
  - v(C/boom).along(B/A) = -0.6 m/s
  - a(C/boom).along(B/A) = 0.15 m/s^2
find: {rho_C: rho(C)}
"""


def test_from_velocity_and_acceleration() -> None:
    """Both are told first, though only the radius is asked."""
    problem, wrong = load_text(BOOM, "scene.yaml")
    assert problem is not None, wrong
    page = " ".join(Terminal(width=200).render(narrate(solve_problem(problem))).split())
    told = "ρ_C = |v_C|³/|v_Cx a_Cy - v_Cy a_Cx| = 0.9749³/|0.8976 (-0.4075) - 0.3804 · 0.7767| = 1.401 m"
    before, line, _ = page.partition(told)
    assert line
    assert "v_C = v_A + ω_boom × r_C/A" in before
    assert "= [0.7767, -0.4075] m/s²" in before


@pytest.mark.parametrize(
    ("stem", "line"),
    [
        ("disk-in-circular-track", "ρ_G = R - r_d = 0.5 - 0.15 = 0.35 m"),
        ("paths-of-points-of-a-wheel", "ρ_T = 4 R = 4 · 0.4 = 1.6 m"),
        ("ex-1-13", "ρ = (1 + y′²)^(3/2)/y″ = (1 + 2²)^(3/2)/1 = 5 √5 m = 11.18 m"),
    ],
)
def test_where_less_tells_it(stem: str, line: str) -> None:
    assert line in page_of_file(stem)
