"""Dimensions are lengths that the text gives, not those that only place what is drawn."""

from __future__ import annotations

import pytest
from test_figures_bodies import drawings

from planar_cli.report.document.lines import Value
from planar_cli.report.document.marks import Dimension


@pytest.mark.parametrize(
    ("name", "numbers"),
    [
        ("friction/block-carried-by-an-accelerated-wedge", set()),
        ("kinematics/car-seen-from-a-bend", {"100", "40", "30"}),
        ("kinematics/rod-drawn-over-an-edge", {"3", "1.2", "1.6"}),
        ("textbook/ex-1-14", {"500"}),
    ],
)
def test_numbers_that_nobody_gave_are_not_dimensioned(name: str, numbers: set[str]) -> None:
    dimensions = [m for m in drawings(name)["scene"].panels[0].marks if isinstance(m, Dimension)]
    told = {f"{piece.number:f}" for m in dimensions for piece in m.words if isinstance(piece, Value)}
    assert {f"{float(n):g}" for n in told} == numbers
