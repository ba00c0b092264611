"""Two pulls that are equal by symmetry come from the sums of forces along both axes."""

from __future__ import annotations

from worked import page_of_file

from planar_cli.formats.terminal import Terminal
from planar_cli.homework.checking import read, solve_and_compare
from planar_cli.report.narrate import narrate


def test_two_cables_in_symmetry() -> None:
    told = narrate(solve_and_compare(read("problems/hard/cables-almost-in-line.yaml"))[0])
    page = " ".join(Terminal(width=110).render(told).split())
    assert "(1) → ΣF_x: S_right cos δ - S_left cos δ = 0" in page
    assert "(2) ↑ ΣF_y: S_left sin δ + S_right sin δ - W = 0" in page
    assert "W/(2 sin δ) = 10/(2 sin(1×10⁻⁹ rad)) = 5×10⁹ N" in page


def test_a_bar_on_two_cords_in_symmetry() -> None:
    page = page_of_file("bar-on-two-slanting-cords")
    assert "(1) → ΣF_x: T_right cos β - T_left cos β = 0" in page
    assert "cos(2 β)" not in page.partition("Answer")[0]


def test_unlike_pulls_are_found_one_at_a_time() -> None:
    assert "sphere, perpendicular to the rope upper" in page_of_file("sphere-on-two-wires-in-a-circle")
