"""Two pulls that are equal by symmetry come from the sums of forces along both axes."""

from __future__ import annotations

from pathlib import Path

from worked import page_of_file, page_of_text

from planar_cli.formats.terminal import Terminal
from planar_cli.homework.checking.checking import read, solve_and_compare
from planar_cli.report.page.narrate import narrate


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


def test_a_pull_that_is_the_weight_is_told_once(tmp_path: Path) -> None:
    text = """
title: Load on two links
plane: vertical
symbols: {W: N, l: m}
points: {P: [0, 0], A: {from: P, distance: l, angle: 30 deg}, B: {from: P, distance: 2*l, angle: 150 deg}}
bodies: {load: {particle: P, weight: W}}
joints: [{link: {between: [P, A], name: right}}, {link: {between: [P, B], name: left}}]
instant: [at rest]
find: {T: tension(right), S: tension(left)}
"""
    solving = page_of_text(tmp_path, text).partition("STEP 2")[2].partition("Answer")[0]
    assert solving.count("S_left = W") == 1
    assert solving.count("S_right = W") == 1
