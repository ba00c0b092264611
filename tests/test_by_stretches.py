"""A balance in numbers that is wider than a row goes on in the letter of a stretch that stands above it."""

from __future__ import annotations

import sympy as sp

from planar_cli.report.document.as_printed import as_text
from planar_cli.report.document.blocks import Equation, Math, line
from planar_cli.report.energy.by_stretches import by_stretches

X, A, B, C, D = sp.symbols("x A B C D")
STRETCH = Equation((Math(sp.Symbol("s__4")), Math(A - B * X, {A: "0.65", B: "0.45"})), None, note=line("in m"))


def balance(width: int) -> Equation:
    """100 (0.45 x - 0.65)² = …, with other symbols for its numbers."""
    square = Math(C * (D * X - B) ** 2, {C: "100", D: "0.45", B: "0.65"})
    return Equation((square, line("b" * width)), 6)


def test_a_wide_balance_has_the_letter() -> None:
    whole = by_stretches([STRETCH, balance(85)])[-1]
    assert isinstance(whole, Equation)
    assert as_text(whole.sides[0]) == "100 s_4²"


def test_what_fits_in_a_row_stays() -> None:
    blocks = [STRETCH, balance(10)]
    assert by_stretches(blocks) == blocks


def test_another_stretch_stays() -> None:
    other = Equation((STRETCH.sides[0], Math(A - B * X, {A: "0.6", B: "0.45"})))
    assert by_stretches([other, balance(85)]) == [other, balance(85)]
