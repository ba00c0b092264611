"""The place of an equilibrium as an equation, before what happens near it and what is asked there."""

from __future__ import annotations

from conftest import ROOT
from worked import worked

from planar_cli.formats.terminal import Terminal
from planar_cli.report.page.narrate import narrate


def test_a_place_of_equilibrium_comes_before_its_oscillations() -> None:
    page = Terminal(width=110).render(narrate(worked(ROOT / "problems/oscillations/block-between-two-springs.yaml")[0]))
    lines = (
        "In the equilibrium rest the acceleration is zero:\n",
        "k_2 (b - l_2 - x_rest) - k_1 (x_rest - l_1) = 0\n",
        "x_rest = (k_1 l_1 + k_2 b - k_2 l_2)/(k_1 + k_2) = ",
        "Small oscillations about the equilibrium rest.",
        "F_left = k_1 (x_rest - l_1) = 500 (0.5 - 0.4) = 50 N\n",
        "F_right = k_2 (b - l_2 - x_rest) = k_1 k_2 (b - l_1 - l_2) / (k_1 + k_2)\n",
        "the equation of motion, from which f, holds follow, and all else checked by",
    )
    places = [page.find(text) for text in lines]
    assert -1 not in places
    assert places == sorted(places)
