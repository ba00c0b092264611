"""Moments that vanish for the numbers of a file alone are spoken of; an unknown force that no equation has is drawn the
way it acts.
"""

from __future__ import annotations

from pathlib import Path

from worked import page_of_file, page_of_text

ROD = """
title: Rod pinned to a rolling disk
plane: vertical
given: {m_D: 15 kg, R: RADIUS, m_R: 10 kg, l: 1.2 m}
points: {C: [0, 0], G: [0, R], B: {from: G, distance: l, angle: -30 deg}}
surfaces: {floor: {through: C, angle: 0 deg}}
bodies: {disk: {disk: G, radius: R, mass: m_D}, rod: {rod: [G, B], mass: m_R}}
joints: [{rolling: {between: [disk, floor], at: C}}, {pin: {at: G, between: [disk, rod]}}]
instant: [at rest]
find: {alpha_rod: alpha(rod), friction_C: friction(C).x}
"""


def test_a_line_through_the_point_by_the_numbers_of_the_file(tmp_path: Path) -> None:
    """R - l/4 = 0 is no identity: the equation in letters has no moment of m_R R α_disk for 0.3 m alone."""
    text = page_of_text(tmp_path, ROD.replace("RADIUS", "0.3 m"))
    assert "moments about C, through which the line of m_R R α_disk passes, as R - l/4 = 0.3 - 1.2/4 = 0:" in text
    assert "through which" not in page_of_text(tmp_path, ROD.replace("RADIUS", "0.35 m"))


def test_a_guide_presses_the_way_it_acts() -> None:
    """The pin pulls the block to the left, which has no acceleration that way: the guide pushes it to the right."""
    assert "N_block → at A" in page_of_file("ex-4-16")
