"""Places that a file constructs are told by their construction, and arms in letters before their numbers."""

from __future__ import annotations

import pytest
from worked import page_of_file


@pytest.mark.parametrize(
    ("stem", "words"),
    [
        ("ex-1-02", "x_A = r cos 60° = r/2"),
        ("ex-1-02", "x_B = r cos 60° + l = l + r/2"),
        ("ex-1-02", "y_A2 - y_A = r sin(-30°) - r sin 60° = -1/2 (1 + √3) r"),
        ("slider-crank-offset", "r_A/O = [r_OA cos 50°, r_OA sin 50°] = [0.06428, 0.07660] m"),
        ("four-bar", "r_C/D = [x_C - d, y_C] = [-0.05264, 0.3965] m"),
    ],
)
def test_by_the_construction(stem: str, words: str) -> None:
    assert words in page_of_file(stem)


def test_no_coordinate_that_the_page_does_not_tell() -> None:
    """Nothing but an answer needs where D is, so that its arm has numbers alone."""
    page = page_of_file("quick-return")
    assert "r_D/C = [0.2320, 0.6604] m" in page
    assert "x_D" not in page


@pytest.mark.parametrize(("stem", "lines"), [
    ("ex-4-07", ["IO = √2 l/2", "IG = l/2"]),
    ("pendulum-tension", ["T = m (√3 g/2 + v_P²/l)", "a_Pt = -g/2"]),
    ("plate-on-parallel-links", ["a_Ct = g/2"]),
])  # fmt: skip
def test_coordinates_of_few_lengths_have_no_names(stem: str, lines: list[str]) -> None:
    told = page_of_file(stem)
    assert [line for line in lines if line not in told] == []


def test_energies_of_bodies_have_lines() -> None:
    told = page_of_file("ex-4-07")
    assert "T of disk = 1/2 M v_O² + 1/2 I_disk ω_disk² = 1/2 · 1 · 1² + 1/2 · 0.005 · 10² = 0.75 J" in told
    assert "T = 0.75 + 0.1667 = 0.9167 J" in told


def test_motions_alone_tell_no_forces() -> None:
    """Nothing says what drives a disk whose speed is given, and with it how a rod presses on the wall."""
    told = page_of_file("ex-4-07")
    assert "N_E" not in told
    assert "ω_rod = v_O/IO = 1/0.21213 = 4.714 rad/s" in told


def test_a_point_that_numbers_tell_has_a_line_before_its_arm() -> None:
    told = page_of_file("ex-2-09")
    place = "D is on the line through A at 30° and at x = 400 mm: D = [0.4, 0.4 tan 30°] = [0.4, 0.2309] m"
    assert told.index(place) < told.index("r_D/C = [0, 0.4309] m")
