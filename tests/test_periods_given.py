"""Small oscillations in their order: the formula of the period, then what it picks; what is small near the place."""

from __future__ import annotations

import pytest
from conftest import ROOT
from worked import worked

from planar_cli.errors import NoSolution
from planar_cli.formats.terminal import Terminal
from planar_cli.problem.structure import load_text
from planar_cli.report.page.narrate import narrate
from planar_cli.solve.run import solve_problem


def _page(name: str) -> str:
    return Terminal(width=110).render(narrate(worked(ROOT / "problems" / f"{name}.yaml")[0]))


def _in_order(page: str, *lines: str) -> bool:
    places = [page.find(text) for text in lines]
    return -1 not in places and places == sorted(places)


def test_a_measured_period_gives_a_radius_of_gyration() -> None:
    page = _page("oscillations/connecting-rod-on-a-knife-edge")
    period = "T = 2 π/ω_0 = 2 π √((k² + a²) / (g a))\n"
    assert _in_order(page, period, "At hang, the period about hang = T_A:\n", "k = √(T_A² g a - 4 π² a²) / (2 π) = ")
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
    assert "from there, θ = 180° + δ, sin θ ≈ -δ, its" in _page("oscillations/connecting-rod-on-a-knife-edge")


HUNG = """
title: Rod that swings about a knife edge
plane: vertical
given: {d: 10.5 in, g: 32.2 ft/s^2}
symbols: {r_a: in}
unknowns: {k: in}
points: {A: [0, 0], G: [0, -r_a], B: [0, -d]}
bodies: {rod: {points: [A, B], center: G, weight: 6 lbf, radius_of_gyration: k}}
joints:
  - pin: {at: A, between: [ground, rod]}
states: {hang: [equilibrium, theta(rod) = 0, period(hang) = 0.895 s]}
find: {k: k}
"""
TWO = """
title: Two rods that swing each about its own edge
plane: vertical
given: {d: 10.5 in, r_a: 6 in}
unknowns: {k: in}
points: {A: [0, 0], G: [0, -r_a], C: [3 ft, 0], H: [3 ft, -r_a]}
bodies:
  first: {points: [A], center: G, weight: 6 lbf, radius_of_gyration: k}
  second: {points: [C], center: H, weight: 6 lbf, radius_of_gyration: k}
joints:
  - pin: {at: A, between: [ground, first]}
  - pin: {at: C, between: [ground, second]}
states: {hang: [equilibrium, period(hang) = 0.895 s]}
find: {k: k}
"""


def test_constant_of_a_period_in_letters_has_no_number() -> None:
    """k² = (T/2π)² g r_a - r_a² where r_a is less than 7.8 in: letters that are drawn larger show nothing."""
    page = Terminal().render(narrate(solve_problem(load_text(HUNG)[0])))
    (told,) = [row for row in page.splitlines() if row.strip().startswith("At hang:   k =")]
    assert told.count("=") == 1


def test_period_of_several_freedoms_is_refused_where_it_stands() -> None:
    with pytest.raises(NoSolution) as error:
        solve_problem(load_text(TWO)[0])
    (why,) = error.value.diagnostics
    assert (why.code, why.mark.line) == ("PL632", 13)
