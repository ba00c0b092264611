"""Kepler's equation, whole periods, and the mass of a body in the law of the force on it."""

from __future__ import annotations

import math
import re

import pytest

from planar_cli.formats.terminal import Terminal
from planar_cli.problem.structure import load_text
from planar_cli.report.page.narrate import narrate
from planar_cli.solve.run import solve_problem

SCENE = """
title: Comet
plane: horizontal
given: {K: 4 m^3/s^2}
points: {S: [0, 0], P: [2 m, 0]}
bodies: {comet: {particle: P, mass: MASS}}
loads:
  - force: {body: comet, at: P, magnitude: (3 kg)*K/r(P/S).mag^2, towards: S}
states:
  1: [t = 0, v(P).x = 0, v(P).y = SPEED]
  2: [WHEN]
find: {FIND}
"""
PERIOD = 2 * math.pi * math.sqrt(4**3 / 4)
"""Of v² = μ (2/r - 1/a) = 4 (2/2 - 1/4) = 3 m²/s²: a = 4 m, e = 1/2."""


def page(when: str, find: str, speed: str = "(sqrt(3)) m/s", mass: str = "3 kg") -> str:
    """The page of a comet that starts where it is nearest to the sun."""
    written = SCENE.replace("WHEN", when).replace("FIND", find).replace("SPEED", speed).replace("MASS", mass)
    problem, diagnostics = load_text(written)
    assert problem is not None, diagnostics
    return re.sub(r"\s+", " ", Terminal(200).render(narrate(solve_problem(problem))))


def answer(told: str, name: str) -> float:
    return float(re.findall(rf"Answer.* {name} = (?:[^ =]+ = )?(-?[\d.]+)", told)[0])


@pytest.mark.parametrize("way", [1, -1])
@pytest.mark.parametrize("t", [3, 10, 15, 22, 40])
def test_the_place_at_a_time(t: float, way: int) -> None:
    told = page(f"t = {t} s", "x: x(P) @ 2, y: y(P) @ 2", f"({'-' * (way < 0)}sqrt(3)) m/s")
    mean = 2 * math.pi * t / PERIOD
    anomaly = mean
    for _ in range(200):
        anomaly = mean + 0.5 * math.sin(anomaly)
    assert "Kepler's equation" in told
    assert "numerical integration" not in told
    assert answer(told, "x") == pytest.approx(4 * (math.cos(anomaly) - 0.5), rel=2e-3)
    assert answer(told, "y") == pytest.approx(way * 4 * math.sqrt(0.75) * math.sin(anomaly), rel=2e-3)


@pytest.mark.parametrize("degrees", [70, 200, 290])
def test_the_time_at_a_direction(degrees: float) -> None:
    told = page(f"r(P).angle = {degrees} deg", "T: t @ 2")
    half = math.radians(degrees) / 2
    anomaly = 2 * math.atan2(math.sin(half) / math.sqrt(3), math.cos(half)) % (2 * math.pi)
    assert "numerical integration" not in told
    assert answer(told, "T") == pytest.approx((anomaly - 0.5 * math.sin(anomaly)) * 4, rel=1e-3)


@pytest.mark.parametrize(("speed", "angle"), [("(sqrt(3)) m/s", "φ"), ("(-sqrt(3)) m/s", "Δφ")])
def test_the_angle_counts_the_way_it_flies(speed: str, angle: str) -> None:
    """Clockwise φ is the opposite of the angle that it has turned through."""
    for when, find in (
        ("t = 3 s", "phi: r(P).angle @ 2"),
        (f"r(P).angle = {70 if angle == 'φ' else -70} deg", "T: t @ 2"),
    ):
        assert f"tan({angle}/2)" in page(when, find, speed)


@pytest.mark.parametrize("periods", [1, 2])
def test_after_whole_periods_it_is_at_the_start(periods: int) -> None:
    told = page(f"t = {8 * periods}*pi*(1 s)", "x: x(P) @ 2, y: y(P) @ 2")
    assert "at the start again" in told
    assert "x = r_2 = 2 m y = 0 m" in told


def test_half_a_period() -> None:
    assert answer(page("t = 4*pi*(1 s)", "r: r(P).mag @ 2"), "r") == pytest.approx(6, rel=1e-3)


def test_the_mass_of_the_body_is_its_letter() -> None:
    told = page("t = 3 s", "x: x(P) @ 2")
    assert "force = m K/SP²" in told
    assert "ΣF" not in told


def test_another_mass_stays_a_number() -> None:
    told = page("t = 3 s", "r: r(P).mag @ 2", mass="2 kg")
    assert "m = 2 kg, force = 3 kg · K/SP²;" in told
    assert "F_P = 3 K/r_comet²" in told


def test_equal_masses_of_two_bodies_are_not_told_apart() -> None:
    """Of G (5 kg) (5 kg)/r² one is the mass of the other body."""
    stars = """
title: Two stars
plane: horizontal
given: {G: 2 N*m^2/kg^2}
points: {A: [0, 0], B: [2 m, 0]}
bodies: {A: {particle: A, mass: 5 kg}, B: {particle: B, mass: 5 kg}}
loads: [{force: {body: A, at: A, towards: B, magnitude: G*LAW/r(A/B).mag^2}}]
instant: [at rest]
find: {a_A: a(A).x}
"""
    for law in ("(5 kg)*(5 kg)", "(5 kg)^2"):
        problem, diagnostics = load_text(stars.replace("LAW", law))
        assert problem is not None, diagnostics
        told = re.sub(r"\s+", " ", Terminal(200).render(narrate(solve_problem(problem))))
        assert "m_A²" not in told
        assert "m_A m_B" not in told
        assert "a_A = 2.5 m/s²" in told


def test_a_root_is_said_as_mathematics() -> None:
    told = page("t = 3 s", "x: x(P) @ 2", "sqrt(3*K/(4 m))")
    assert "√(3 K/(4 m)):" in told
    assert "sqrt" not in told


def test_coordinates_by_the_eccentric_anomaly() -> None:
    told = page("t = 3 s", "x: x(P) @ 2, y: y(P) @ 2")
    assert "x = a (cos E_2 - ε) = 4 (cos(" in told
    assert "arctan" not in told
    assert "r_2" not in told
    assert "arctan" in page("t = 3 s", "x: x(P) @ 2, r: r(P).mag @ 2")
