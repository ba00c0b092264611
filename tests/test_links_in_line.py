"""The extreme positions of a mechanism: crank and rod in one line, with the reason; places in lengths alone."""

from __future__ import annotations

import pytest
from conftest import PROBLEMS
from worked import worked

from planar_cli.formats.terminal import Terminal
from planar_cli.report.narrate import narrate

FILES = {p.stem: p for p in PROBLEMS}


@pytest.fixture(scope="module")
def page() -> str:
    return " ".join(Terminal(300).render(narrate(worked(FILES["body-offset-slider-crank-strokes"])[0])).split())


@pytest.mark.parametrize(
    "told",
    [
        "B rests for a moment: A then moves perpendicularly to AB and to OA, so that OA and AB lie in one line",
        "At 2, v_slider,x = 0, OA and AB lie in one line, stretched, inclined at φ_2:",
        "(l - r_c) sin φ_1 = e",
        "From 1 to 2 the crank turns, at its constant rate, through: Δθ_2 = π + φ_1 - φ_2 = 180° + 23.58° - 11.54°",
        "folded as one turn before; from 2 to 3 the crank turns, at its constant rate, through: Δθ_3 = 2 π - Δθ_2",
        "x_1 = √((l - r_c)² - e²)",
        "stroke = x_2 - x_1",
        "first_way = Δθ_2/ω_crank",
        "ratio = Δθ_2/Δθ_3",
    ],
)
def test_told(page: str, told: str) -> None:
    assert told in page


def test_no_velocities(page: str) -> None:
    """Geometry tells the positions: no equation of velocities is needed for them."""
    assert "ω_AB" not in page
    assert "θ_AB" not in page
    assert "B_2" not in page
