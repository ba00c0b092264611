"""A link or a cord between two points on straight guides: its length in coordinates, differentiated once and twice."""

from __future__ import annotations

from pathlib import Path

import pytest
from worked import page_of_file, page_of_text

TWO = """
title: Two sliders joined by a light link
plane: horizontal
given: {m_A: 2 kg, m_B: 3 kg, F: 60 N, a: 0.3 m, b: 0.4 m}
points: {A: [a, 0], B: [0, b]}
bodies: {A: {particle: A, mass: m_A}, B: {particle: B, mass: m_B}}
joints:
  - guide: {point: A, along: 0 deg}
  - guide: {point: B, along: 90 deg}
  - link: {between: [A, B], name: rod}
loads:
  - force: {body: A, at: A, magnitude: F, angle: 0 deg}
instant: [v(A).x = 0.8 m/s]
find: {v_B: v(B).y, a_A: a(A).x, a_B: a(B).y, T: tension(rod)}
"""


def test_the_length_in_the_coordinates_of_the_file() -> None:
    page = page_of_file("two-sliders-on-a-link")
    told = ("x² + y² = AB²", "(1) v_A x + v_B y = 0", "Differentiated once more, a_A x + a_B y + v_A² + v_B² = 0: (2)")
    assert [t for t in told if t not in page] == []
    assert "+ v_A² + v_B² = 0: (2) a_A x + a_B y = -v_A² - v_B² STEP 2" in page
    assert "length AB: AB = √(x² + y²) = √(0.3² + 0.4²) = 0.5 m" in page
    assert "F - T x/AB = m_A a_A" in page
    assert page.count("√") == 2
    assert (
        "(3): a_A = F/m_A - T x/(m_A AB) (4): a_B = -T y/(m_B AB) - g (3), (4) in (2): T = AB (F x/m_A + v_A²" in page
    )
    assert "in m" not in page.partition("STEP 2")[0]


def test_coordinates_for_which_the_file_has_no_letters(tmp_path: Path) -> None:
    page = page_of_text(tmp_path, TWO)
    assert "x_A² + y_B² = AB² Differentiated, with x_A = a and y_B = b: (1) a v_A + v_B b = 0" in page


REST = {"v(A).x = 0.8 m/s": "at rest", "v_B: v(B).y, ": ""}
NUMBERS = {"a: 0.3 m, b: 0.4 m": "l: 0.5 m", "[a, 0]": "[0.3 m, 0]", "[0, b]": "[0, 0.4 m]"}
OBLIQUE = {"along: 90": "along: 120", "v_B: v(B).y, ": "", "a(B).y": "a(B).mag"}


@pytest.mark.parametrize(
    ("changes", "told"),
    [
        (REST, "Differentiated twice, with x_A = a and y_B = b: (1) a a_A + a_B b = 0"),
        (NUMBERS, "Differentiated, r_B/A · (v_B - v_A) = 0, divided by its length: (1)"),
        (OBLIQUE, "Differentiated once more, r_B/A · (a_B - a_A) + |v_B - v_A|² = 0"),
    ],
)
def test_at_rest_and_with_other_places_and_lines(tmp_path: Path, changes: dict[str, str], told: str) -> None:
    text = TWO
    for old, new in changes.items():
        text = text.replace(old, new)
    assert told in page_of_text(tmp_path, text)


def test_a_coordinate_is_not_put_in_for_itself(tmp_path: Path) -> None:
    text = TWO.replace("a: 0.3 m, b: 0.4 m", "a: 0.3 m, l: 0.5 m")
    page = page_of_text(tmp_path, text.replace("B: [0, b]", "B: {x: 0 m, distances: {A: l}, side: above}"))
    assert "Differentiated, with x_A = a: (1)" in page
