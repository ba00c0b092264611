"""A path stands with the places from which it follows, a hodograph with the velocities; reasons behind their lines."""

from __future__ import annotations

import sympy as sp
from worked import page_of_file

from planar_cli.report.laws.passages import in_order, is_quarter_turn
from planar_cli.solve.passages import CURVE, PLACES, RATES, Passage, Row


def test_curves_follow_what_they_rest_on() -> None:
    places, rates, later = (
        Passage("Positions:", (), PLACES),
        Passage("Velocities:", (), RATES),
        Passage("Magnitudes:", ()),
    )
    path, hodograph = Passage("Path of P:", (), CURVE), Passage("Hodograph of P:", (), CURVE)
    seen = Passage("Path of P seen from A:", (), CURVE)
    assert in_order([places, rates, later, path, hodograph]) == [places, path, rates, hodograph, later]
    assert in_order([places, rates, seen]) == [places, rates, seen]
    assert in_order([later, path]) == [later, path]


def test_a_velocity_is_a_quarter_turn_ahead_on_a_circle_alone() -> None:
    r, w, t = sp.symbols("r w t", positive=True)

    def rows(x: sp.Expr, y: sp.Expr, names: str = "x y") -> list[Row]:
        return [Row("", sp.Eq(sp.Symbol(name), e)) for name, e in zip(names.split(), (x, y), strict=True)]

    circle = r * sp.cos(w * t), r * sp.sin(w * t)
    ellipse = 2 * r * sp.cos(w * t), r * sp.sin(w * t)
    for place, turned in ((circle, True), (circle[::-1], True), (ellipse, False)):
        rates = rows(*(sp.diff(e, t) for e in place))
        assert is_quarter_turn(rows(*place), rates) == turned
        assert is_quarter_turn(rows(*place, names="x_P y_P"), rates) == turned
        # The sliders of a trammel, each on its own axis.
        assert not is_quarter_turn(rows(*place, names="x_P y_Q"), rates)


def test_a_circle_in_its_order() -> None:
    page = page_of_file("ex-1-12")
    told = ["x_P = 15 cos(π t/4) given", "x² + y² = 15² squared and added", "a quarter turn ahead", "Accelerations"]
    assert [page.index(words) for words in told] == sorted(page.index(words) for words in told)


def test_a_component_of_no_acceleration_has_its_reason() -> None:
    page = page_of_file("ex-1-05")
    assert page.count("_G is constant") == 1
    assert "|a_P| = r ω² since sin² + cos² = 1 Answer" in page
