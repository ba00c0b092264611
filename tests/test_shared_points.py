"""A point of two bodies that no joint holds together there is two points as soon as they move: it is refused."""

from __future__ import annotations

from math import atan2, sqrt

import pytest
from answered import first, solve
from conftest import ROOT

from planar_cli.errors import FileProblem

PARALLELOGRAM = (ROOT / "problems/hard/parallelogram-through-its-change-point.yaml").read_text(encoding="utf-8")
FRAMES = (ROOT / "problems/motion/paths-from-three-frames.yaml").read_text(encoding="utf-8")


def refused(text: str) -> str:
    with pytest.raises(FileProblem) as error:
        solve(text)
    assert [d.code for d in error.value.diagnostics] == ["PL467"]
    return error.value.diagnostics[0].message


def test_a_pin_holds_all_bodies_of_its_point() -> None:
    text = PARALLELOGRAM.replace("AB: {rod: [A, B]}", "AB: {rod: [A, C]}")
    assert refused(text) == "C is a point of AB too, which no joint holds there"


def test_the_same_with_a_point_of_its_own() -> None:
    """AE begins as far below the line of the pins as it leads DC, which is 30 degrees below it."""
    text = PARALLELOGRAM.replace("AB: {rod: [A, B]}", "AB: {rod: [A, E]}")
    text = text.replace("bodies:", "  E: {from: D, distance: 1 m, angle: -30 deg}\nbodies:")
    found = solve(text)
    assert first(found["phi"]) == pytest.approx(atan2(0.5, 2 + sqrt(3) / 2))
    assert first(found["omega"]) == pytest.approx(1)


@pytest.mark.parametrize("change", [("points: [A]", "points: [B]"), ("center: A}", "center: B}")])
def test_what_turns_about_a_pin_parts_elsewhere(change: tuple[str, str]) -> None:
    message = refused(FRAMES.replace(*change))
    assert message == "cart and groove turn about A, where a pin holds them, and B is a point of both: there they part"


def test_what_strikes_a_body_may_be_drawn_where_it_does() -> None:
    text = (ROOT / "problems/impact/level-rod-caught-by-an-edge.yaml").read_text(encoding="utf-8")
    assert "omega" in solve(text)


def test_a_pin_whose_bodies_could_not_be_read_holds_none() -> None:
    with pytest.raises(FileProblem) as error:
        solve(PARALLELOGRAM.replace("pin: {at: C, between:", "pin: {at: C, betweenn:"))
    assert [d.code for d in error.value.diagnostics] == ["PL311", "PL310"]


THREE_RODS = """
plane: vertical
points: {A: [0, 0], B: [1 m, 0], C: [0, 1 m], D: [-1 m, 0]}
bodies: {a: {rod: [A, B], mass: 2 kg}, b: {rod: [A, C], mass: 2 kg}, c: {rod: [A, D], mass: 1 kg}}
joints:
  - pin: {at: A, between: [ground, c]}
  - contact: {at: A, between: [a, b], mu: 0}
instant: [at rest]
find: {x: alpha(c)}
"""


def test_what_touches_is_held_by_no_pin() -> None:
    assert refused(THREE_RODS) == "A is a point of a too, which no joint holds there"
