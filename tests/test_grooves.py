"""A point in a groove r(θ) and on a rod through its pole: r, how it changes, and the angle of the groove."""

from __future__ import annotations

import re
from math import atan2, cos, degrees, hypot, pi, sin
from pathlib import Path
from unicodedata import normalize

import pytest
from worked import page_of_file

from planar_cli.formats.terminal import Terminal
from planar_cli.homework.checking.checking import read, solve_and_compare
from planar_cli.report.page.narrate import narrate

SPIRAL = """
title: Pin in a spiral groove, driven by a rod that speeds up
plane: horizontal
given: {c: 50 mm, m: 0.2 kg}
coordinates: {theta: deg}
points: {O: [0, 0], A: {from: O, distance: 8*c, angle: theta}, P: {from: O, distance: c*theta, angle: theta}}
surfaces: {groove: {r: c*theta}}
bodies:
  rod: {rod: [O, A]}
  pin: {particle: P, mass: m}
joints:
  - pin: {at: O, between: [ground, rod]}
  - guide: {name: slot, point: P, along: rod}
  - guide: {name: wall, point: P, along: groove}
instant: [theta = 80 deg, omega(rod) = 3 rad/s, alpha(rod) = 2 rad/s^2]
find: {v: v(P).mag, a: a(P).mag, F: reaction(slot/pin).mag, N: reaction(wall).mag}
"""


@pytest.mark.parametrize(
    "told",
    [
        "r = b (2 - cos θ) = 0.04 (2 - cos 120°) = 0.1 m",
        "(1) ṙ = b ω sin θ = 0.04 · 6 sin 120° = 0.2078 m/s",
        "(2) r̈ = b ω² cos θ = 0.04 · 6² cos 120° = -0.72 m/s²",
        "ψ = 70.89°, from OP to the tangent of groove; sin ψ = 0.9449",
        "a_r = r̈ - r ω² = -0.72 - 0.1 · 6² = -4.32 m/s²",
        "a_θ = 2 ṙ ω = 2 · 0.2078 · 6 = 2.494 m/s² θ̈ = 0",
        "N_wall ↘ (normal to groove) = m a_r ↖, m a_θ ↙",
        "(3) ↖ ΣF_r: -N_wall sin ψ = m a_r",
        "(4) ↙ ΣF_θ: N_fork + N_wall cos ψ = m a_θ",
        "(3), (4), 2 unknowns: N_wall, N_fork",
        "(3): N_wall = -m a_r/sin ψ",
    ],
)
def test_a_can_in_a_groove(told: str) -> None:
    page = normalize("NFC", page_of_file("can-driven-along-a-groove"))
    assert normalize("NFC", told) in page
    assert "unit vector" not in page


def test_a_spiral_with_an_angular_acceleration(tmp_path: Path) -> None:
    """Against polar components: r = c θ, a_r = r̈ - r ω², a_θ = r α + 2 ṙ ω; N is across the tangent."""
    file = tmp_path / "spiral.yaml"
    file.write_text(SPIRAL)
    solution, _ = solve_and_compare(read(str(file)), None)
    page = normalize("NFC", re.sub(r"\s+", " ", Terminal(200).render(narrate(solution))))
    assert normalize("NFC", "ṙ = c ω = 0.05 · 3 = 0.15 m/s") in page
    assert normalize("NFC", "r̈ = c α = 0.05 · 2 = 0.1 m/s²") in page
    assert normalize("NFC", "a_r = r̈ - r ω² =") in page
    assert normalize("NFC", "a_θ = r α + 2 ṙ ω =") in page
    theta, omega, alpha, c, m = 80 * pi / 180, 3.0, 2.0, 0.05, 0.2
    r, dr, ddr = c * theta, c * omega, c * alpha
    a_r, a_t = ddr - r * omega**2, r * alpha + 2 * dr * omega
    psi = atan2(r, c)
    n = abs(m * a_r / sin(psi))
    found = {a.name: float(a.values[0]) for a in solution.parts[0].found if a.values is not None}
    assert found["v"] == pytest.approx(hypot(dr, r * omega))
    assert found["a"] == pytest.approx(hypot(a_r, a_t))
    assert found["N"] == pytest.approx(n)
    assert found["F"] == pytest.approx(abs(m * a_t + m * a_r * cos(psi) / sin(psi)))
    assert f"ψ = {degrees(psi):.2f}°" in page


def test_the_size_of_a_force_with_one_direction_is_its_letter() -> None:
    """No line says F = N_fork = 0.4988 N once more."""
    page = normalize("NFC", page_of_file("can-driven-along-a-groove"))
    assert "0.4988 N Answer N_fork = 0.4988 N N_wall = 2.286 N Check" in page


def test_where_forces_tell_how_it_slides_no_letter_stands_for_its_components(tmp_path: Path) -> None:
    """a_r and a_θ have no line where the rod is free."""
    file = tmp_path / "free.yaml"
    text = SPIRAL.replace("{rod: [O, A]}", "{rod: [O, A], mass: 1 kg}").replace(", alpha(rod) = 2 rad/s^2", "")
    file.write_text(text.replace("find: {", "find: {alpha: alpha(rod), "))
    page = Terminal(200).render(narrate(solve_and_compare(read(str(file)), None)[0]))
    assert "m a_r" not in page
    assert "m a_θ" not in page
    assert re.search(r"angle from the radius of P to the tangent: +ψ = ", page)
