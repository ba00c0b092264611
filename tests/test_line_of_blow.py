"""A blow along a line whose ends are known in numbers is told by the angle of that line."""

from __future__ import annotations

from pathlib import Path

from worked import page_of_file, page_of_text

BOTH_MOVE = """
title: Cord between two bodies that jerks taut
plane: horizontal
given: {m_A: 4 kg, m_B: 2.5 kg, l: 2 m, beta: 120 deg}
bodies:
  A: {particle: [0.2 m, 0.1 m], mass: m_A}
  B: {particle: [-1 m, 0], mass: m_B}
joints:
  - rope: {path: [A, B], name: cord, during: 2->3}
states:
  1: [t = 0, v(A).x = 1 m/s, v(A).y = 0.2 m/s, v(B).mag = 5 m/s, v(B).angle = beta]
  2: [r(B/A).mag = l]
  3: [just after 2]
find: {v_A: v(A) @ 3, J: impulse(cord/A).mag @ 2->3}
"""


def test_the_angle_stands_for_sines_and_cosines_of_places() -> None:
    page = page_of_file("impact/rope-that-jerks-taut")
    lines = [
        "β = arctan(y_B,2/x_B,2) = arctan(1.128/1.651) = 34.34°",
        "0 = m_A (v_Ay,3 cos β - v_Ax,3 sin β)",
        "m_B (v_Bx,2 cos β + v_By,2 sin β) = (m_A + m_B) (v_Ax,3 cos β + v_Ay,3 sin β)",
        "v_Ay,3 = m_B sin(β) (v_Bx,2 cos β + v_By,2 sin β) / (m_A + m_B)",
        "v_Ax,3 = v_Ay,3/tan β = 0.9779/tan 34.34° = 1.431 m/s",
        "J = m_A v_Ax,3/cos β = 4 · 1.4313 / cos 34.34° = 6.934 N·s",
    ]
    assert [told for told in lines if told not in page] == []
    assert "√(x_B" not in page
    assert "nothing moves during a blow" not in page


def test_another_letter_where_the_file_has_this_one(tmp_path: Path) -> None:
    """A line from the left up to the right is told, whichever of its ends comes first."""
    page = page_of_text(tmp_path, BOTH_MOVE)
    lines = [
        "γ = arctan((y_B,2 - y_A,2)/(x_B,2 - x_A,2)) = arctan((0.8349 - 0.1386)/(-1.482 - 0.3928)) = -20.38°",
        "m_A (v_Ax,2 sin γ - v_Ay,2 cos γ) = m_A (v_Ax,3 sin γ - v_Ay,3 cos γ)",
        "m_A v_Ax,2 - J cos γ = m_A v_Ax,3",
        "J = 7.260 N·s",
    ]
    assert [told for told in lines if told not in page] == []


def test_a_find_of_that_name_leaves_the_letter_to_it(tmp_path: Path) -> None:
    asked = "find: {psi: v(B).angle @ 3 in deg, gamma: v(A).angle @ 3 in deg, lost: KE(all) @ 2 - KE(all) @ 3}"
    page = page_of_text(tmp_path, f"{BOTH_MOVE.partition('find:')[0]}{asked}\n")
    assert "φ = arctan((y_B,2 - y_A,2)/(x_B,2 - x_A,2))" in page
    assert "tan γ = v_Ay,3/v_Ax,3" in page
    # The velocities that the cord gives are by the angle as well.
    assert "v_Bx,3 = " in page
    assert "√((x_B" not in page
    assert "nothing moves during a blow" not in page
