"""What pivots is at its highest point straight above the pivot: no angle is worked out for that."""

from __future__ import annotations

from decimal import Decimal

import sympy as sp
from worked import page_of_file

from planar_cli.equation.values.exact import Valuation
from planar_cli.report.notation.whole_roots import with_whole_roots


def test_the_centre_straight_above_the_edge_is_at_the_distance_of_the_radius() -> None:
    page = page_of_file("wheel-over-a-kerb")
    assert "y_G,3 = h + R = 0.06 + 0.3 = 0.36 m" in page
    assert "θ" not in page


def test_a_root_of_no_square_stays() -> None:
    a, b = sp.symbols("a b", positive=True)
    value = Valuation({a: Decimal(3), b: Decimal(2)})
    assert with_whole_roots(sp.sqrt(a**2 + b**2), value) == sp.sqrt(a**2 + b**2)


def test_the_components_of_a_vector_are_told_once() -> None:
    page = page_of_file("wheel-over-a-kerb")
    assert "J_x" not in page
    assert "J = [J_Kx, J_Ky] = [-4.6, 7.8] N·s" in page
    assert "J_x = -J_F = -3.485 N·s" in page_of_file("tilted-block-that-falls-back")
