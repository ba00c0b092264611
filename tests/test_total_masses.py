"""Masses that go together on the page: (m_1 + m_2) g for m_1 g + m_2 g."""

from __future__ import annotations

import pytest
import sympy as sp
from worked import page_of_file

from planar_cli.equation.values.ledger import Ledger
from planar_cli.report.notation.notation import plain
from planar_cli.report.notation.total_masses import with_totals

LEDGER = Ledger()
m_1, m_2, m_3 = (LEDGER.letter(name, "kg") for name in ("m_1", "m_2", "m_3"))
I_1, I_2 = (LEDGER.letter(name, "kg*m^2") for name in ("I_1", "I_2"))
open_mass = LEDGER.seek("m_4", "kg")
g, v, w, h, R = sp.symbols("g v w h R", positive=True)


@pytest.mark.parametrize(
    ("expr", "text"),
    [
        (R - m_1 * g - m_2 * g, "R - (m_1 + m_2) g"),
        (2 * m_1 * g + 2 * m_2 * g, "2 (m_1 + m_2) g"),
        (2 * m_1 * g + m_2 * g + R, "(2 m_1 + m_2) g + R"),
        (m_1 * v**2 / R + m_2 * v**2 / R - m_1 * g - m_2 * g, "(m_1 + m_2) (v²/R - g)"),
        (m_1 * g * sp.sin(v) - m_1 * g * sp.sin(w) + m_2 * g * sp.sin(v) - m_2 * g * sp.sin(w),
         "(m_1 + m_2) g (sin v - sin w)"),
        ((m_1 * v + m_2 * v - m_3 * w) / (m_1 + m_2 + m_3), "((m_1 + m_2) v - m_3 w)/(m_1 + m_2 + m_3)"),
        (m_1 * R**2 + m_2 * R**2 + I_1 + I_2, "(m_1 + m_2) R² + I_1 + I_2"),
        (sp.sqrt((m_1 * v**2 - 2 * m_1 * g * h - 2 * m_2 * g * h) / m_1), "√((m_1 v² - 2 (m_1 + m_2) g h)/m_1)"),
        # A kinetic energy and a work are not put together, nor is what is unknown, nor what has both masses.
        (m_1 * v**2 / 2 + m_2 * v**2 / 2 + m_1 * g * h + m_2 * g * h, "(m_1 + m_2) g h + 1/2 (m_1 + m_2) v²"),
        (m_1 * g + open_mass * g, "m_1 g + m_4 g"),
        (m_1 * m_2 * g + m_1 * m_3 * g, "m_1 m_2 g + m_1 m_3 g"),
        (m_1 * g - m_2 * g, "m_1 g - m_2 g"),
        (m_1 * v**2 / 2 + m_2 * v**2, "1/2 m_1 v² + m_2 v²"),
    ],
)  # fmt: skip
def test_terms_that_differ_in_a_mass_alone(expr: sp.Expr, text: str) -> None:
    told = with_totals(expr, LEDGER)
    assert plain(told) == text
    assert sp.expand(told**2 - expr**2) == 0


def test_a_mean_acceleration_is_shorter_by_the_total_mass() -> None:
    page = page_of_file("pile-driven-into-soil-of-constant-resistance")
    assert "(m_1 + m_2) g - R = (m_1 + m_2) a_P" in page
    assert "a_P = g - R/(m_1 + m_2) = 9.81 - 80000/(300 + 200) = -150.2 m/s²" in page


def test_the_numbers_go_together_as_the_letters_do() -> None:
    page = page_of_file("body-atwood-with-heavy-pulley")
    assert "α = (m_A - m_B) g r / ((m_A + m_B) r² + I_pulley) = (6 - 4) · 9.81 · 0.2 / ((6 + 4) · 0.2² + 0.16)" in page
