"""Small oscillations in their order: the formula of the period, then what it picks; what is small near the place."""

from __future__ import annotations

from conftest import ROOT
from worked import worked

from planar_cli.formats.terminal import Terminal
from planar_cli.report.narrate import narrate


def _page(name: str) -> str:
    return Terminal(width=110).render(narrate(worked(ROOT / "problems" / f"{name}.yaml")[0]))


def _in_order(page: str, *lines: str) -> bool:
    places = [page.find(text) for text in lines]
    return -1 not in places and places == sorted(places)


def test_a_measured_period_gives_a_radius_of_gyration() -> None:
    page = _page("oscillations/connecting-rod-on-a-knife-edge")
    period = "T = 2 π/ω_0 = 2 π √((k² + a²) / (g a))\n"
    assert _in_order(page, period, "At hang: the period about hang = T_A:\n", "hang:   k = ")
    # What was measured is not computed from itself.
    assert "0.93 s\n" not in page.partition("CASE  from B")[0].partition("STEP 1")[2]


def test_the_shortest_period_is_derived_from_its_formula() -> None:
    page = _page("oscillations/pivot-of-the-shortest-period")
    lines = (
        "T(b) = 2 π/ω_0 = ",
        "T(b) is smallest where",
        "(12 b² + l²)/b = 12 b + l²/b\n",
        "12 - l²/b² = 0\n",
        "12 b² = l²\n",
        "= 1.524 s\n",
    )
    assert _in_order(page, *lines)
    # The name of the smallest value is not that of the function.
    assert "T_min = 2 π/ω_0" not in page


def test_sines_and_cosines_near_an_equilibrium() -> None:
    assert "from there, θ = -90° + δ, cos θ ≈ δ, its" in _page("oscillations/pivot-of-the-shortest-period")
    assert "from there, θ = -180° + δ, sin θ ≈ -δ, its" in _page("oscillations/connecting-rod-on-a-knife-edge")
