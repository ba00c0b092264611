"""Coordinates of different frames have different names on a page."""

from __future__ import annotations

import pytest
from worked import page_of_file


@pytest.mark.parametrize(("stem", "lines"), [
    ("ex-1-01", [
        "y = h Path of B seen from a frame that moves with A",
        "in which A is at rest, the origin of x′, y′",
        "x′ = l cos β",
        "origin at A, x″ axis along the boom",
        "path_A: straight line parallel to the x axis, y = h",
        "path_B: circle about A of radius l, x′² + y′² = l²",
        "path_C: straight line through A along the boom, y″ = 0",
    ]),
    # The hodograph is no path, and its axes are those of velocities.
    ("cycloid-of-a-rim-point", ["x′² + y′² = r² squared and added", "tip: circle about (r w, 0)"]),
    # One frame alone.
    ("ex-1-12", ["trajectory: circle about the origin of radius 15 m, x² + y² = 15²"]),
])  # fmt: skip
def test_axes_of_frames(stem: str, lines: list[str]) -> None:
    page = page_of_file(stem)
    assert not [line for line in lines if line not in page]


@pytest.mark.parametrize(
    "told",
    [
        "over the ground: x_B = l cos β + s s and β vary y_B = h + l sin β in this frame: x′ = l cos β",
        "from A, without turning: x_C/A = c cos β β and c vary y_C/A = c sin β in this frame: x″ = c",
    ],
)
def test_what_a_frame_leaves_out(told: str) -> None:
    assert told in page_of_file("ex-1-01")
