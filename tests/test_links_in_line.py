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
        "At 2, v_slider,x = 0, OA and AB lie in one line, stretched:",
        "(l - r_c) sin θ_crank,1 = e",
        "Not 23.58°: there AB would point to the left",
        "At 3, v_slider,x = 0, folded as at 1, one turn later:",
        "stroke = √((l + r_c)² - e²) - √((l - r_c)² - e²)",
        "turning = √((l - r_c)² - e²)",
        "B stays on its line:",
    ],
)
def test_told(page: str, told: str) -> None:
    assert told in page


def test_no_velocities(page: str) -> None:
    """Geometry tells the positions: no equation of velocities is needed for them."""
    assert "ω_AB" not in page
    assert "B_2" not in page
