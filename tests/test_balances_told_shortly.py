"""Work and energy between states as a book writes it: nothing unused, heights and stretches by what is given."""

from __future__ import annotations

import pytest
import sympy as sp
from worked import page_of_file

from planar_cli.report.notation.reciprocals import with_reciprocals


@pytest.mark.parametrize(("stem", "line"), [
    ("cylinder-that-rolls-off-a-cylinder", "= 3/4 m r² ω_leaves² y_G,top = R + r y_G,leaves = (R + r) cos φ_leaves U"),
    ("ex-4-11", "U of the spring AD = 1/2 k (s_1² - s_2²) = -1/2 k x_max² (1)"),
    ("ex-4-11", "At 2, y_D is smallest: β̇_2 = 0 to be found:"),
    ("ex-4-11", "stretch of the spring AD, s_1 = 0 the spring is relaxed"),
    ("ex-4-10", "stretch of the spring CB, s_1 = CB_1 - l_0 = 0.4 - 0.2828 = 0.1172 m"),
    ("ex-4-10", "stretch of the spring CB, s_2 = CB_2 - l_0 = 0 the spring is relaxed U"),
    ("box-that-tips-over", "At 3, x_G = 0. The limit: the box comes to rest at 3 in equilibrium;"),
    ("sliding-crate-that-strikes-a-curb", "At 3, x_G = b/2. The limit: "),
    ("box-that-tips-over", "y_G,3 = √(b² + h²)/2 = √(0.6² + 1²)/2 = 0.5831 m"),
    ("satellite-perigee-apogee", "v_A, v_B: the speeds at A and B, perpendicular to the radius ("),
    ("satellite-perigee-apogee", "1/2 m v_A² + m g R² (1/r_B - 1/r_A) = 1/2 m v_B²"),
])  # fmt: skip
def test_each_part_of_a_balance(stem: str, line: str) -> None:
    assert line in page_of_file(stem)


@pytest.mark.parametrize(("stem", "idle"), [
    ("cylinder-that-rolls-off-a-cylinder", "0.015 ω_leaves²"),
    ("ex-4-10", "θ_1"),
    ("ex-4-10", "y_A,1"),
    ("box-that-tips-over", "θ_3"),
    ("satellite-perigee-apogee", "400 v_A²"),
    ("satellite-perigee-apogee", "Kinematic analysis"),
    ("satellite-perigee-apogee", "At A: r_A"),
])  # fmt: skip
def test_what_no_line_uses_is_not_told(stem: str, idle: str) -> None:
    assert idle not in page_of_file(stem)


def test_a_value_stands_once() -> None:
    """v_A ends a line of the solution; it gets no line of its own below that, and no heading."""
    told = page_of_file("satellite-perigee-apogee")
    assert told.count("v_A = 8110 m/s") == 1
    assert "Hence, at A:" not in told


def test_the_difference_of_two_reciprocals() -> None:
    a, b, k = sp.symbols("a b k", positive=True)
    assert with_reciprocals(-k * (b - a) / (a * b)) == k * (1 / b - 1 / a)
    assert with_reciprocals(k * (b - a) / a) == k * (b - a) / a


@pytest.mark.parametrize(("stem", "line"), [
    ("cylinder-that-rolls-off-a-cylinder", "r² ω² / (R + r) a_n: G moves on a circle of radius R + r"),
    ("weight-on-a-cord-held-by-a-spring", "midpoint: x_eq = m_2 g/k = 2 · 9.81 / 250 = 0.07848 m"),
    ("weight-on-a-cord-held-by-a-spring", "At 1, v_block,x is largest, where its derivative is zero: x_1 = x_eq (3)"),
])  # fmt: skip
def test_what_stands_before_its_use(stem: str, line: str) -> None:
    assert line in page_of_file(stem)


def test_a_slack_cord_has_no_length_that_is_natural() -> None:
    assert "OP_1 - l = 0" not in page_of_file("bungee-jump")


def test_a_speed_by_numbers_has_its_unit() -> None:
    """Beside the letter that is sought."""
    assert "v_G,leaves = 0.2 ω_leaves in m/s; rod turns about O" in page_of_file("exercise-4-35")
