"""Letters of a page with one particle: no word says whose they are, where nothing else moves."""

from __future__ import annotations

from pathlib import Path

import pytest
from answered import GUN
from worked import page_of_file, page_of_text


@pytest.mark.parametrize(("stem", "lines"), [
    # On a line, without an axis; what is across it is no datum.
    ("ex-1-06", ["thrown: v = v0; top: y largest", "v_half = -√(g h + v0²), that is downward"]),
    ("car-three-phases", ["a = 2 m/s² from start to cruise", "cruise: v = 90 km/h", "v_cruise = a_start t_cruise"]),
    # In the plane with its axes.
    ("ex-1-11", ["parallel: v_y = -3/4 v_x", "x_B = v_x,launch t_B"]),
    # What is asked as v_5 is the size of the velocity, and keeps its name.
    ("parachutist", ["v_5 = v_after_5 = 39.75 m/s", "dv = ∫[0 → t] dt", "s_after_5 = v_t² ln"]),
    ("sledge-down-a-slope-and-out-over-level-snow", ["s̈ = a_1", "v_2² = 2 a_1 L"]),
    # Another point that moves, or a distance from a pole.
    ("ball-that-grips-a-rough-floor", ["m v_Gx,2 → at G"]),
    ("pin-in-a-limacon-groove", ["r_pin"]),
])  # fmt: skip
def test_letters(stem: str, lines: list[str]) -> None:
    page = page_of_file(stem)
    assert not [line for line in lines if line not in page]


def test_a_speed_and_its_component_keep_two_names(tmp_path: Path) -> None:
    """Where the derivation of one answer has only the component along y beside the speed."""
    page = page_of_text(tmp_path, GUN, why="t_f")
    assert "v_y,2 = v_2 sin β" in page
    assert "v_2 = v_2" not in page
