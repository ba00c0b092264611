"""Forms of formulas as a person writes them: minus signs inside differences, times between two states."""

from __future__ import annotations

import pytest
import sympy as sp

from planar_cli.formats.terminal import Terminal
from planar_cli.problem.structure import load_text
from planar_cli.report.durations import over_durations
from planar_cli.report.narrate import narrate
from planar_cli.report.notation import plain
from planar_cli.solve.run import solve_problem

NAMES = m, g, k, mu, v, x, phi = sp.symbols("m g k mu v x phi")
LONG, SHORT = sp.symbols("R r")
TIMES = t_3, t_2 = sp.symbols("t_3 t_2")


@pytest.mark.parametrize(
    ("expr", "text"),
    [
        (-(m * g * mu - k) / m, "(k - μ m g)/m"),
        (-m * g * (sp.sin(phi) - mu * sp.cos(phi)), "m g (μ cos φ - sin φ)"),
        (-(-m * g - k * x) / k, "(m g + k x)/k"),
        (sp.Mul(-1, LONG - SHORT, v, evaluate=False), "-(R - r) v"),
        (x - (m * g - k) / m, "x - (m g - k)/m"),
    ],
)
def test_a_minus_sign_goes_into_a_difference(expr: sp.Expr, text: str) -> None:
    assert plain(expr) == text


@pytest.mark.parametrize(
    ("expr", "text"),
    [
        (x + v * t_3 - v * t_2, "x + v (t_3 - t_2)"),
        ((v + sp.sqrt(g * x) + g * t_2) / g, "(v + √(g x))/g + t_2"),
        (t_3 - t_2, "t_3 - t_2"),
        (x - g * t_3**2 / 2 - g * t_2**2 / 2 + g * t_2 * t_3, "x - 1/2 g (t_3 - t_2)²"),
        ((2 * v + g * t_2) / (2 * g), "(2 v + g t_2) / (2 g)"),
    ],
)
def test_the_time_between_two_states_is_one_bracket(expr: sp.Expr, text: str) -> None:
    assert plain(over_durations(expr, TIMES)) == text


THROWN = """
title: Thrown up from a cliff, and back down past it
plane: vertical
bodies: {P: {particle: [0, 0], mass: any}}
states:
  1: [v(P).x = 4 m/s, v(P).y = 3 m/s]
  2: [y(P) = -5 m]
  3: [y(P) = -20 m]
find: {t: t @ 2, v: v(P).y @ 2, later: t @ 3, x: x(P) @ 3 - x(P) @ 2}
"""


def test_a_root_is_left_out_by_what_rules_it_out() -> None:
    problem, _ = load_text(THROWN)
    assert problem is not None
    page = Terminal(width=110).render(narrate(solve_problem(problem)))
    assert "the positive root, as t_2 > 0" in page
    assert "the negative root, as it moves downward there" in page
    assert "not -" not in page
