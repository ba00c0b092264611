"""A point on a fixed line in polar coordinates: across the line nothing moves, so that r̈ is not needed."""

from __future__ import annotations

import re
from math import cos, pi, sin, tan
from pathlib import Path

import pytest
from worked import page_of_file

from planar_cli.formats.terminal import Terminal
from planar_cli.homework.checking.checking import read, solve_and_compare
from planar_cli.report.page.narrate import narrate

UPRIGHT = """
title: Slotted arm that drives a collar up an upright rod
coordinates: {theta: rad}
points:
  O: [0, 0]
  B: {from: O, distance: 900 mm, angle: theta}
  P: {x: 400 mm, line: [O, theta]}
bodies:
  arm: {rod: [O, B]}
  collar: {particle: P}
joints:
  - pin: {at: O, between: [ground, arm]}
  - guide: {point: P, along: 90 deg, name: rod}
  - guide: {point: P, along: arm, name: slot}
motion: [theta = pi/6 + pi/8*sin(2 rad/s * t)]
instant: [t = 3 s]
find: {v_r: v(P/O).r, v_theta: v(P/O).theta, a_r: a(P/O).r, a_theta: a(P/O).theta}
"""


def test_a_collar_on_a_level_rod() -> None:
    page = page_of_file("ex-1-14")
    assert "Distance of P from O: r = y_P/sin θ" in page
    assert (
        "v_r = r\u0307 = -y_P θ\u0307 cos θ / sin² θ = -0.5 · 0.27225 cos(2.0619 rad) / sin²(2.0619 rad) = 0.08256 m/s"
        in page
    )
    assert (
        "[-sin θ, cos θ]; P moves horizontally, so that its acceleration has no y component, and r̈ need not be found"
        in page
    )
    assert "a_r sin θ + a_θ cos θ = 0 so that: a_r = -a_θ/tan θ" in page
    assert "r̈ =" not in page


def test_a_collar_on_an_upright_rod(tmp_path: Path) -> None:
    """Against r = d/cos θ, differentiated twice."""
    file = tmp_path / "upright.yaml"
    file.write_text(UPRIGHT)
    solution, _ = solve_and_compare(read(str(file)), None)
    page = re.sub(r"\s+", " ", Terminal(200).render(narrate(solution)))
    assert "v_r = r\u0307_P = x_P θ\u0307 sin θ / cos² θ" in page
    assert "P moves vertically, so that its acceleration has no x component, and r̈ need not be found:" in page
    assert "a_r cos θ - a_θ sin θ = 0 so that: a_r = a_θ tan θ" in page
    found = {a.name: float(a.values[0]) for a in solution.parts[0].found if a.values is not None}
    assert found == pytest.approx(_by_r(), rel=1e-9)


def _by_r() -> dict[str, float]:
    t, d = 3.0, 0.4
    theta, omega, alpha = pi / 6 + pi / 8 * sin(2 * t), pi / 4 * cos(2 * t), -pi / 2 * sin(2 * t)
    r = d / cos(theta)
    dr = r * tan(theta) * omega
    ddr = dr * tan(theta) * omega + r * omega**2 / cos(theta) ** 2 + r * tan(theta) * alpha
    return {"v_r": dr, "v_theta": r * omega, "a_r": ddr - r * omega**2, "a_theta": r * alpha + 2 * dr * omega}
