"""What is largest or smallest of a throw: the time eliminated, one formula of one constant, its derivative."""

from __future__ import annotations

from conftest import ROOT
from worked import worked

from planar_cli.formats.terminal import Terminal
from planar_cli.report.page.narrate import narrate


def _page(name: str) -> str:
    return Terminal(width=110).render(narrate(worked(ROOT / "problems" / f"{name}.yaml")[0]))


def _in_order(page: str, *lines: str) -> bool:
    places = [page.find(text) for text in lines]
    return -1 not in places and places == sorted(places)


def test_the_least_speed_to_a_target() -> None:
    page = _page("motion/least-speed-to-a-target")
    assert "together" not in page
    assert _in_order(
        page,
        "40 = v_0 t_window cos β",
        "v_0²(β) = 200 g / (5 sin(2 β) - 3 cos² β)",
        "v_0 is smallest, so its derivative with respect to β is zero:",
        "3 sin(2 β) + 10 cos(2 β) = 0",
        "tan(2 β) = -10/3 = -3.333",
        "β = π/2 - 1/2 arctan(3.333) = 53.35°",
        "v_0 = 10 √(2 g / (5 sin(2 β) - 3 cos² β))",
        "t_window = (40 m)/(v_0 cos β)",
    )


def test_the_highest_point_of_a_wall_that_a_jet_reaches() -> None:
    page = _page("motion/safety-parabola")
    assert "y_above_d(β) = d tan β - g d²/(2 v0² cos² β)" in page
    assert "arctan(v0²/(g d))" in page


def test_the_shortest_time() -> None:
    page = _page("energy/straight-chute-to-a-wall")
    assert _in_order(page, "t_1²(β) = 4 d/(g sin(2 β))", "cos(2 β) = 0", "β = 45°", "2 √(d/g)")
