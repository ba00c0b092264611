"""A constant that closed equations in several times give is worked out, not found by trial."""

from __future__ import annotations

from decimal import Decimal

import pytest
import sympy as sp
from conftest import ROOT
from worked import worked

from planar_cli.formats.terminal import Terminal
from planar_cli.report.page.narrate import narrate
from planar_cli.solve.between.roots.substitution import same_as
from planar_cli.solve.between.trace.trace import Result
from planar_cli.solve.multibody.linear import determinant


@pytest.mark.parametrize(
    ("name", "formula"),
    [
        ("impact/ball-thrown-against-a-wall", "v = √((1 + e) g d / (sin(2 α) e))"),
        ("motion/throw-at-a-basketball-ring", "v_0 = d √(g/(d sin(2 θ) + 2 h cos² θ - 2 H cos² θ))"),
    ],
)
def test_a_speed_is_worked_out(name: str, formula: str) -> None:
    """The laws in time of both flights give the times by the speed, and what is left gives the speed."""
    solution, verdicts = worked(ROOT / "problems" / f"{name}.yaml")
    printed = Terminal(width=110).render(narrate(solution))
    assert all(v.agrees for v in verdicts)
    assert formula in printed
    assert "numerical integration" not in printed


def test_determinant_of_many_rows() -> None:
    """Fifteen equations are no more than a moment's work."""
    rows = [[Decimal(1) / (i + j + 1) + (3 if i == (j + 1) % 15 else 0) for j in range(15)] for i in range(15)]
    exact = sp.Matrix([[sp.Rational(str(c)) for c in row] for row in rows]).det()
    assert abs(float(determinant(rows)) / float(exact) - 1) < 1e-12
    assert determinant([[Decimal(0), Decimal(1)], [Decimal(2), Decimal(0)]]) == -2
    assert determinant([[Decimal(1), Decimal(2)], [Decimal(2), Decimal(4)]]) == 0


def test_letters_that_are_another_s() -> None:
    """A ball that is back at its height, and a place that is a length of the file."""
    y_0, y_3, x_2, v_3, d = sp.symbols("y__0 y__3 x__2 v__3 d")
    height = sp.Rational(3, 2)
    told = [Result(y_3, height, Decimal("1.5")), Result(x_2, d, Decimal(6)), Result(v_3, height, Decimal("1.5"))]
    assert same_as(told, {y_0: height}) == {y_3: y_0, x_2: d}
