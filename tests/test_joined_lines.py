"""A heading over velocities and that of the first of them make one line."""

from __future__ import annotations

import sympy as sp

from planar_cli.report.document.blocks import Equation, Math, Paragraph, line
from planar_cli.report.document.joined_lines import ACCELERATIONS, VELOCITIES, joined_headings

ANGLE, AGAIN = Paragraph(line("Angle of bar:")), Paragraph(line("(1), differentiated:"))
RATE = Equation((line("ω"), line("θ̇")), 1)


def test_two_headings_in_one_line() -> None:
    told = list(joined_headings([VELOCITIES, ANGLE, RATE, ACCELERATIONS, AGAIN, RATE]))
    velocities, accelerations = Paragraph(line("Velocities, angle of bar:")), line("Accelerations, (1) differentiated:")
    assert told == [velocities, RATE, Paragraph(accelerations), RATE]


def test_what_says_more_stays_under_its_heading() -> None:
    given = Paragraph(line("Given: ", Math(sp.Symbol("v"))))
    for blocks in ([VELOCITIES, given, RATE], [VELOCITIES, RATE, ANGLE, RATE], [ANGLE, RATE]):
        assert list(joined_headings(blocks)) == blocks
