"""Particles of which speed, tangential and normal acceleration are told, and no direction."""

from __future__ import annotations

from math import hypot

import pytest
from answered import assert_close, solve

from planar_cli.formats.terminal import Terminal
from planar_cli.problem.structure import load_text
from planar_cli.report.page.narrate import narrate
from planar_cli.solve.run import solve_problem

CAR = """
title: Car that gathers speed in a bend
bodies: {car: {particle: free}}
instant: [TOLD]
find: {value: ASKED}
"""


def page_of(text: str) -> str:
    problem, wrong = load_text(text)
    assert problem is not None, wrong
    return Terminal().render(narrate(solve_problem(problem)))


@pytest.mark.parametrize(
    ("told", "asked", "value"),
    [
        ("v(car).mag = 15 m/s, a(car).t = 3 m/s^2, rho(car) = 50 m", "a(car).mag", hypot(3, 4.5)),
        ("v(car).mag = 15 m/s, a(car).t = 3 m/s^2, a(car).n = 4.5 m/s^2", "rho(car)", 50),
        ("v(car).mag = 10 m/s, a(car).t = 0, a(car).n = 5.625 m/s^2", "rho(car)", 100 / 5.625),
        ("a(car).t = 3 m/s^2, a(car).n = 4.5 m/s^2, rho(car) = 50 m", "v(car).mag", 15),
        ("v(car).mag = 15 m/s, a(car).mag = 5 m/s^2, a(car).t > 0, rho(car) = 50 m", "a(car).t", (25 - 4.5**2) ** 0.5),
        ("v(car).mag = 15 m/s, a(car).t = 3 m/s^2, a(car).mag = 5 m/s^2", "rho(car)", 56.25),
        ("v(car).t = 15 m/s, a(car).t = -3 m/s^2, 50 m = rho(car)", "a(car).mag", hypot(3, 4.5)),
    ],
)
@pytest.mark.parametrize("place", ["free", "[1 m, 2 m]"])
def test_value(told: str, asked: str, value: float, place: str) -> None:
    text = CAR.replace("TOLD", told).replace("ASKED", asked).replace("free", place)
    assert_close(solve(text)["value"], value, 9)


def test_letters() -> None:
    text = CAR.replace("bodies", "symbols: {v_0: m/s, a_0: m/s^2, R: m}\nbodies")
    text = text.replace("TOLD", "v(car).mag = v_0, a(car).t = a_0, rho(car) = R").replace("ASKED", "a(car).mag")
    page = page_of(text)
    assert "√(a_0² + (v_0²/R)²)" in page
    assert "sign(" not in page


def test_two_cars() -> None:
    text = """
title: Two cars in bends
bodies: {A: {particle: free}, B: {particle: free}}
instant:
  - v(A).mag = 15 m/s
  - a(A).t = 3 m/s^2
  - rho(A) = 40 m
  - v(B).mag = 10 m/s
  - a(B).t = 0
  - a(B).n = a(A).n
find: {value: rho(B), a: a(A).mag}
"""
    assert_close(solve(text)["value"], 100 / 5.625, 9)


def test_the_normal_component_of_a_curve_is_v_squared_by_its_radius() -> None:
    text = CAR.replace("TOLD", "v(car).mag = 10 m/s, a(car).t = 1 m/s^2, a(car).n = 4 m/s^2")
    page = page_of(text.replace("ASKED", "rho(car)"))
    assert "v_car²/ρ_car = 4" in page
