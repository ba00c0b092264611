"""Equations with numbers that are solved together: each row has the number of the equation that it is."""

from __future__ import annotations

from pathlib import Path

from worked import page_of_text

BOAT = """\
title: Boat across a river
plane: horizontal
given: {u: 2 m/s}
unknowns: {w: m/s, beta: deg}
points: {A: [0, 0]}
bodies: {boat: {particle: A}}
instant:
  - v(boat).x = -u + w*cos(beta)
  - v(boat).y = w*sin(beta)
  - v(boat).angle = 150 deg
  - w is smallest
  - beta > 0 deg
  - beta < 180 deg
find: {w_min: w, beta: beta in deg}
"""


def test_rows_have_the_numbers_of_their_equations(tmp_path: Path) -> None:
    page = page_of_text(tmp_path, BOAT)
    assert "(1) (√3 v_y + v_x)/2 = 0" in page
    assert "row v_y w v_x right side in m/s" in page
    assert "(1) 0.866 0 0.5 0" in page
    assert "(2) w cos β = u + v_x" in page
    assert "(2) 0 0.500 -1.0 2" in page
