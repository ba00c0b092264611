"""A later balance of energies goes back to what the first has told, and no line takes more rows than it needs."""

from __future__ import annotations

from decimal import Decimal

import pytest
import sympy as sp
from worked import page_of_file

from planar_cli.report.document.as_printed import as_text
from planar_cli.report.document.blocks import Block, Equation, Math, Name, Value, line
from planar_cli.report.energy.few_lines import breaks, in_few_lines

SLIDER_CRANK = "slider-crank-with-a-spring"
TOLD = Equation((Math(sp.Symbol("x")), Math(sp.Symbol("y"))), 1, line(Name("T__1"), " + U = ", Name("T__2"), ":"))


@pytest.mark.parametrize(("stem", "told"), [
    (SLIDER_CRANK, "N_rail (normal to the motion) do no work, the internal forces between the bodies no net work:"),
    (SLIDER_CRANK, "From 1 to 2, work and kinetic energy, T_1 = 0; O_x, O_y (O is fixed), N_rail (normal to the"),
    (SLIDER_CRANK, "From 1 to 3, work and kinetic energy; the same forces do no work:"),
    (SLIDER_CRANK, "T_2 of crank = 1/2 (1/4 m_c r_c² + I_crank) ω_crank,2² = 0.0045 ω_crank,2² in J; crank turns"),
    (SLIDER_CRANK, "T_3 of crank = 1/6 m_c r_c² ω_crank,3² = 0.0045 ω_crank,3² in J; crank turns about O v_G,AB,3"),
    (SLIDER_CRANK, "y_G,crank,1 = y_G,AB,1 = √3 r_c/4 = √3 · 0.15 / 4 = 0.06495 m"),
    (SLIDER_CRANK, "y_G,crank,3 = y_G,AB,3 = 0 m, s_3 = 0.05 m U"),
    (SLIDER_CRANK, "T_1 + U = T_2: 0.8618 + 2.989 = 3.851 = 0.02461 ω_crank,2² in J"),
    (SLIDER_CRANK, "y_G,crank,2 = y_G,AB,2 = 1/2 r_c sin θ_crank,2 = 1/2 · 0.15 sin 30° = 0.0375 m"),
    (SLIDER_CRANK, "U of the weights of crank, AB = (m_c + m_r) g (y_G,crank,1 - y_G,crank,2) = (1.2 + 2) · 9.81"),
    (SLIDER_CRANK, "(5), (6) together: θ_AB,4 = 19.31°, θ_crank,4 = -82.80° solved numerically"),
    (SLIDER_CRANK, "U of the weights of crank, AB = 2.354 (0.8660 - sin θ_crank,4) in J s_4 = 0.65 - 0.45 cos"),
    (SLIDER_CRANK, "U of the spring coil = 4.156 - 200 s_4² in J"),
    (SLIDER_CRANK, "T_1 + U = T_4: 6.195 - 2.354 sin θ_crank,4 - 200 s_4² = 0 in J"),
    ("crate-winched-up-a-slope", "U of the weight of crate = m g (y_1 - y_mid) = -m g s_mid sin β = "),
    ("crate-winched-up-a-slope", "energy, T_3 = 0; N_P does no work: U of the weight of crate = -m g s_3 sin β U"),
    ("satellite-launched-at-a-slant", "(-m g R²/r²) dr = m g R² (1/r_apogee - 1/r_burnout) = "),
    ("satellite-launched-at-a-slant", "U of gravity = m g R² (1/r_perigee - 1/r_burnout) = 3.981"),
])  # fmt: skip
def test_what_is_said(stem: str, told: str) -> None:
    assert told in page_of_file(stem)


@pytest.mark.parametrize(("stem", "again"), [
    (SLIDER_CRANK, "v_G,crank,3"),
    (SLIDER_CRANK, "stretch of the spring coil, s_3"),
    (SLIDER_CRANK, "T_2 = 0.02461"),
    (SLIDER_CRANK, "θ_crank,1 = 60°"),
    ("block-between-two-springs", "(2) in numbers"),
    ("crate-winched-up-a-slope", "y_3"),
])  # fmt: skip
def test_what_is_not_told_again(stem: str, again: str) -> None:
    assert again not in page_of_file(stem)


def height(name: str, *sides: Math | Value) -> Equation:
    return Equation((Math(sp.Symbol(name)), *sides))


def texts(blocks: list[Block]) -> list[str]:
    return [" = ".join(map(as_text, b.sides)) for b in blocks if isinstance(b, Equation)]


def test_heights_of_one_state_and_value_share_a_line() -> None:
    formula, nought = Math(sp.Symbol("h")), Value(Decimal(0), "m")
    one, other, apart = (height(name, formula) for name in ("y_A__1", "y_B__1", "y_C__2"))
    assert texts(in_few_lines([one, other, apart], TOLD)) == ["y_A,1 = y_B,1 = h", "y_C,2 = h"]
    seen = [height("y_A__1", nought), one, height("y_B__2", nought)]
    assert texts(in_few_lines(seen, TOLD)) == ["y_A,1 = 0 m,  y_B,2 = 0 m", "y_A,1 = h"]


def test_only_a_sum_that_ends_its_balance_is_left_to_it() -> None:
    number = sp.Symbol("number")
    ends = Math(number * sp.Symbol("u") ** 2, {number: "0.5"})
    told = Equation((Math(sp.Symbol("x")), ends), 1, TOLD.lead)
    whole = Equation((line(Name("T__2")), ends))
    assert in_few_lines([whole], told) == []
    assert in_few_lines([whole], TOLD) == [whole]


def test_what_is_wider_than_a_row() -> None:
    assert not breaks(Equation((line("a" * 50), line("b" * 53))))
    assert not breaks(Equation((line("a" * 50), line("b" * 60))), 2)
    assert breaks(Equation((line("a" * 50), line("b" * 54))))
    assert breaks(Equation((line("a" * 50), line("b" * 47)), None, (), line("in J")))
