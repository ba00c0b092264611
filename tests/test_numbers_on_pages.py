"""A number in an equation of numbers has a line that says what it is made of."""

from __future__ import annotations

import pytest
from conftest import ROOT
from worked import worked

from planar_cli.formats.terminal import Terminal
from planar_cli.report.page.narrate import narrate


def _page(name: str) -> str:
    return Terminal(width=140).render(narrate(worked(ROOT / "problems" / f"{name}.yaml")[0]))


@pytest.mark.parametrize(
    ("name", "lines"),
    [
        # Of moments, forces times arms, then collected.
        (
            "friction/ladder-sliding",
            [
                "15 · 9.81 · 0.6343 = 20 α - 15 · 1.826 α + 15 · 1.724 a_A",
                "collected:   93.34 = -7.389 α + 25.86 a_A",
            ],
        ),
        # Of a relation between velocities or accelerations, lengths times what was found before.
        (
            "kinematics/four-bar",
            ["0.4729 ω_BC = -0.1219 (-10) = 1.219", "0.1625 · 2.578² + 0.1585 · 10² - 0.4 · 2.916²"],
        ),
        # Where components of known vectors stand before it, these.
        ("textbook/ex-2-09", ["= v_D · n = -0.5 · 0.8619 = -0.4309 m/s", "= -1.44973 - (-1.39282) = -0.05691 m/s²"]),
        # A constant angular velocity leaves a known acceleration.
        (
            "kinematics/quick-return",
            [
                "a_P = -ω_crank² r_P/O = [-0.14095 · 6², -0.05130 · 6²] = [-5.074, -1.847] m/s²",
                "a_P · n - a_cor · n = 4.1756 - 1.8675",
            ],
        ),
        # All components of a point of a body.
        ("kinematics/slider-crank-offset", ["[-40.60 - (-0.1066) · 159.9 - 0.2804 · 5.761², 0]"]),
    ],
)
def test_where_a_number_comes_from(name: str, lines: list[str]) -> None:
    page = _page(name)
    for told in lines:
        assert told in page


def test_letters_stand_where_they_fill_a_line() -> None:
    """An equation of letters with plain factors is not put in numbers for its length alone."""
    whole = "√2/4 m g L + √2/2 m_A g L = √2/4 m a_Gx L + √2/2 m_A a_A L + I_bar α - √2/4 m a_Gy L"
    assert whole in _page("textbook/ex-4-16")


def test_a_weight_alone_is_worked_out_at_once() -> None:
    page = _page("rigid-bodies/boom-when-its-rope-breaks")
    assert "A_y + 0.6278 T - 98.1 = 0" in page
    assert page.count("collected:") <= 2
