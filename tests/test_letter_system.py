"""Systems in letters whose rows are plain numbers: who solves the rows gets the roots that stand below them."""

from __future__ import annotations

import re
from fractions import Fraction

import pytest
import sympy as sp
from worked import page_of_file

from planar_cli.report.equations.letter_system import _common

M, L, G, BETA = sp.symbols("m L g beta", positive=True)
ROW = re.compile(r"\((1[1-5])\)((?: -?\d+(?:/\d+)?){6})(?= )")
ROOT = re.compile(r"(α_\w+) = (-?)(\d+)? ?g cos β / \((\d+) L\)")


def test_rows_give_the_roots() -> None:
    page = page_of_file("chain-5-symbols").partition("CASE inner")[0]
    assert "(11) to (15) with (1) to (10) put in, divided by m L²." in page
    rows = {int(m[1]): [Fraction(n) for n in m[2].split()] for m in ROW.finditer(page)}
    assert sorted(rows) == [11, 12, 13, 14, 15]
    names = ["α_OA", "α_AB", "α_BC", "α_CD", "α_DE"]
    roots = {m[1]: Fraction(f"{m[2]}{m[3] or 1}/{m[4]}") for m in ROOT.finditer(page)}
    assert sorted(roots) == sorted(names)
    for *coefficients, side in rows.values():
        assert sum(c * roots[s] for c, s in zip(coefficients, names, strict=True)) == side


def test_an_earlier_case_had_the_rows() -> None:
    inner = page_of_file("chain-5-symbols").partition("CASE inner")[2]
    assert "put in" not in inner
    assert "As before: α_OA = -459 g cos β / (362 L)" in inner


@pytest.mark.parametrize(
    ("terms", "product"),
    [
        ([M * L**2 / 3, -2 * M * L**2, 0], M * L**2),
        ([M * L**2, M * L**2 * sp.cos(BETA)], None),
        ([M * L**2 + M * G, M * L**2], None),
        ([0, 0], None),
    ],
)
def test_product_of_letters(terms: list[sp.Expr], product: sp.Expr | None) -> None:
    assert _common(map(sp.sympify, terms)) == product
