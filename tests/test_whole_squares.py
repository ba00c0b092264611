"""(v²/R)² in a sum of squares, and nothing else."""

from __future__ import annotations

import pytest
import sympy as sp
from worked import page_of_file

from planar_cli.report.notation.whole_squares import whole_square, without_sign

V, R, B = sp.symbols("v R b", positive=True)


def test_the_square_of_a_normal_acceleration() -> None:
    page = page_of_file("train-braking-on-a-curve")
    assert "a_1 = √((v_P,1²/R)² + b²) = √((25²/800)² + 0.5²) = 0.9276 m/s²" in page


@pytest.mark.parametrize("term", [V**4, V**4 / R, V**2 / R**2, 2 * V**4 / R**2, V**4 * B / R**2, B])
def test_other_terms_stay(term: sp.Expr) -> None:
    assert whole_square(term) is term


def test_it_is_the_same_number() -> None:
    assert whole_square(V**4 / R**2).doit() - V**4 / R**2 == 0


def test_a_square_has_no_sign_inside() -> None:
    assert without_sign(-V - R) == V + R
    assert without_sign(V - R) == V - R
    assert without_sign(V) is V
