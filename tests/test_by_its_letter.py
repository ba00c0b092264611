"""What would be fractions of fractions in letters is told in numbers, each line once, with its terms before
their sum, and then evaluated.
"""

from __future__ import annotations

import pytest
import sympy as sp
from worked import page_of_file

from planar_cli.report.notation.nested import in_storeys

M, R, i, m, alpha = sp.symbols("M R I m alpha")


@pytest.mark.parametrize("line", [
    "disk: M g ↓ at O, N_C ↑ at C, F_C → at C (assumed), O_x ← at O, O_y ↓ at O = M a_O → at O",
    "= m a_O → at G_rod, 1/2 m l α_rod ↖ at G_rod",
    "(4) → ΣF_x: O_x - N_E = m a_O - √2/4 m l α_rod",
    "(2): α_disk = -2.121 α_rod in rad/s² (1) in (3): O_x = 0.15 α_disk = -0.3182 α_rod in N",
    "(1) in (4): N_E = -0.3182 α_rod - 0.1061 α_rod + 0.05303 α_rod = -0.3712 α_rod in N",
    "(2) to (4) in (5): α_rod = -0.52025/0.0825 = -6.306 rad/s²",
    "(3): O_x = -0.3182 (-6.306) = 2.007 N (4): N_E = -0.3712 (-6.306) = 2.341 N",
])  # fmt: skip
def test_a_disk_with_a_rod_at_a_wall(line: str) -> None:
    assert line in page_of_file("rod-disk-wall")


def test_what_has_a_short_result_in_letters_keeps_its_letters() -> None:
    page = page_of_file("cylinder-that-unwinds-from-another")
    assert "(3): α_A = -m g R/I_A - m a_Gy R/I_A" in page


@pytest.mark.parametrize(
    ("formula", "storeys"),
    [
        ((m / 2 + (M * R + i / R) / R) * alpha, True),
        (1 / (m + i / R), True),
        ((M * R**2 + i) * alpha / R, False),
        (m / R - i / R, False),
    ],
)
def test_fractions_of_fractions(formula: sp.Expr, storeys: bool) -> None:
    assert in_storeys(formula) == storeys


@pytest.mark.parametrize(
    ("stem", "result"),
    [
        ("slider-crank-driven", "(4): B_y = (6.648 - 0.045 · 116.95 - 0.08660 (-26.71))/0.2872 = 12.88 N"),
        ("skier-in-a-parabolic-dip", "(2): N = 134.2 + 0.04167 · 30² = 171.7 lbf"),
    ],
)
def test_the_result_of_one_equation_has_its_numbers_once(stem: str, result: str) -> None:
    page = page_of_file(stem)
    assert result in page
    assert "in numbers:" not in page


def test_a_long_formula_of_an_acceleration_stands_in_its_line_alone() -> None:
    page = page_of_file("slider-crank-driven")
    formula = "a_B = √3/2 r α_AB + (r/2 - x_B) ω_AB² - 1/2 r ω_OA²"
    assert page.count(formula) == 1
    assert "(5): a_B = √3/2 · 0.1 · 116.95 + (0.1/2 - 0.3372) · 3.482² - 1/2 · 0.1 · 20² = -13.35 m/s²" in page
    assert "(4): a_G,AB,y = 0.1436 · 116.95 - 34.116 = -17.32 m/s²" in page


def test_an_equation_that_is_solved_at_once_has_no_second_row() -> None:
    page = page_of_file("slider-crank-with-a-spring")
    assert "(7) in numbers" not in page
    assert "(9) in numbers" not in page
    assert "(7) in (8): O_x = 1.238 α_AB - 154.2 in N (7), (8) in (9): O_y = 0.5963 α_AB - 80.27 in N" in page
    assert "(7) to (9) in (10): α_AB = 52.86/0.5742 = 92.06 rad/s²" in page
