"""What slides along a body: the component across it, from the vectors that are known, with the numbers."""

from __future__ import annotations

import pytest
from conftest import ROOT
from worked import worked

from planar_cli.formats.terminal import Terminal
from planar_cli.report.narrate import narrate


def _page(name: str) -> str:
    return " ".join(Terminal(200).render(narrate(worked(ROOT / "problems" / f"{name}.yaml")[0])).split())


@pytest.mark.parametrize(
    "words",
    [
        "v_D = ω_CD × r_D/C = [0.8619, 0] m/s r_D/C",
        "n = [-0.5, 0.8660] unit vector across AB",
        "v_D · n = -0.5 · 0.86188 = -0.4309 m/s v_D′ · n = 0.4619 ω_AB",
        "a_D · n = -0.5 (-0.0861880) + 0.866025 (-1.72376) = -1.44973 m/s²",
        "a_cor · n = -0.5 · 0.696410 + 0.866025 (-1.20622) = -1.39282 m/s²",
        "a_D′ · n = 0.4619 α_AB",
        "v_rel = 746.4 mm/s from A towards B",
        "a_rel = 534.4 mm/s² from B towards A",
        "-1.72376 - (-0.250318) - (-1.20622)] = [-0.4628, -0.2672] m/s²",
    ],
)
def test_a_point_that_slides_along_a_bar(words: str) -> None:
    page = _page("textbook/ex-2-09")
    assert words in page
    assert page.count("v_D = ω_CD × r_D/C") == 1
    assert page.count("n = [-0.5, 0.8660]") == 1
    assert "Path coordinates" not in page


def test_no_component_is_told_by_halves() -> None:
    """The point of the arm has an acceleration of its own, which the page does not know there."""
    assert " · n = " not in _page("kinematics/rod-through-a-swivelling-sleeve")


def test_why_a_component_is_taken_stands_after_the_vectors() -> None:
    assert "D is fixed, v_D = 0; along BC, where ω_BC does not enter:" in _page("kinematics/four-bar")
