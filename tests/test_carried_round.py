"""What lies on a turning table slides as both components of its friction reach the limit: told by an equation."""

from __future__ import annotations

import sympy as sp
from worked import page_of_file

from planar_cli.solve.regimes.kept_radius import with_kept_radius

x, y, w, r = sp.symbols("x_P y_P omega r", real=True)
DRAWN, ROUND = {x: r, y: sp.S.Zero}, {x: -w * y, y: w * x}


def test_a_distance_that_stays_is_put_in() -> None:
    assert with_kept_radius(w**4 * (x**2 + y**2), DRAWN, ROUND, lambda *_: True) == r**2 * w**4


def test_other_formulas_stay() -> None:
    for expr in (x * w, w * (x**2 + 2 * y**2)):
        assert with_kept_radius(expr, DRAWN, ROUND, lambda *_: True) == expr
    assert with_kept_radius(x**2 + y**2, DRAWN, {x: w}, lambda *_: True) == x**2 + y**2
    assert with_kept_radius(x**2 + y**2, DRAWN, ROUND, lambda *_: False) == x**2 + y**2


def test_the_coin_slides_as_its_friction_reaches_the_limit() -> None:
    page = page_of_file("coin-on-a-table-that-gathers-speed")
    assert "ω_2 = (μ² g² - r² α_0²)^(1/4)/√r = (0.35² · 9.81² - 0.2² · 1.5²)^(1/4)/√0.2 = 4.135 rad/s" in page
    assert "t_2 = ω_2/α_0 = 4.135/1.5 = 2.757 s" in page
    assert "F_x² + F_y² ≤ (μ N)² with x² + y² constant" in page
    assert "(1) → ΣF_x: F_Cx = -m (x_P ω² + y_P α_0)" in page
    assert "numerical" not in page
    assert "coin slides on table" not in page, "nothing rests on what follows the last state"
