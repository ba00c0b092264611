"""What rolls on a fixed rim is told by the angle of the line of centres; by θ where that is asked."""

from __future__ import annotations

from math import acos, degrees
from pathlib import Path

import pytest
from worked import page_of_file

from planar_cli.formats.terminal import Terminal
from planar_cli.homework.checking.checking import read, solve_and_compare
from planar_cli.report.page.narrate import narrate

DRUM = """
title: Cylinder that rolls off a drum
plane: vertical
given: {{R: 300 mm, r: 100 mm}}
points: {{O: [0, 0], C: [0, R], G: [0, R + r]}}
surfaces: {{drum: {{center: O, radius: R}}}}
bodies: {{roller: {{disk: G, radius: r, mass: 2 kg}}}}
joints:
  - rolling: {{between: [roller, drum], at: C}}
states:
  top: [at rest]
  leaves: [N(C) = 0]
find: {find}
"""


@pytest.mark.parametrize(
    ("stem", "lines"),
    [
        (
            "cylinder-that-rolls-off-a-cylinder",
            ["φ: the angle of OG from the vertical, counterclockwise", "N_C - m g cos φ = -m r² ω² / (R + r)", "= 4/7"],
        ),
        ("ball-that-just-rolls-round-a-loop", ["At top, as given: φ_top = 180°", "N_K - m g cos φ ="]),
        ("ball-rolling-in-a-bowl", ["α = 5 g sin φ / (7 r)"]),
    ],
)
def test_the_angle_of_the_line_of_centres(stem: str, lines: list[str]) -> None:
    page = page_of_file(stem)
    assert all(told in page for told in lines)
    assert "has turned" not in page


def test_how_far_it_has_turned_where_that_is_asked(tmp_path: Path) -> None:
    """The arc R φ that was passed and the turned line of centres come to θ = (R + r) φ/r."""
    file = tmp_path / "drum.yaml"
    file.write_text(DRUM.format(find="{turned: theta(roller) @ leaves in deg}"))
    solution, _ = solve_and_compare(read(str(file)), None)
    assert "has turned" in Terminal(200).render(narrate(solution))
    (found,) = solution.parts[0].found
    assert found.values is not None
    assert degrees(float(found.values[0])) == pytest.approx(4 * degrees(acos(4 / 7)))


def test_a_coordinate_of_the_file_stays_the_angle() -> None:
    """A file that places the disk by an angle has that as its coordinate, and none beside it."""
    page = page_of_file("disk-rolling-in-a-trough")
    assert "v_G = " in page
