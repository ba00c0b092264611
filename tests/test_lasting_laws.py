"""A constant velocity that goes on while something else begins, and a first speed that is sought."""

from __future__ import annotations

from pathlib import Path

from worked import page_of_file, page_of_text


def test_what_goes_on_unchanged_has_one_law() -> None:
    page = page_of_file("police-chase")
    assert "t_gap = 30 · 9.5 = 285 m" in page
    assert "x_A,go" not in page
    assert "mean velocity times the time, x_B:" in page


def test_a_first_speed_that_is_sought_has_no_equation() -> None:
    page = page_of_file("wheel-over-a-kerb").partition("CASE")[2]
    assert "wheel: m v_0 → at G" in page
    assert "v_Gx,1" not in page


def test_what_another_datum_gives_keeps_its_letter() -> None:
    assert "v_cyclist,x,slow = 12 km/h" in page_of_file("wind-felt-by-a-cyclist")
    assert "h = s_splash" in page_of_file("stone-in-well")


BOUNCE = """
title: Block that comes back from a wall
plane: vertical
given: {m: 2 kg, d: 3 m, mu: 0.2, e: 0.5}
unknowns: {v_0: m/s}
points: {A: [0, 0], W: [d, 0]}
surfaces: {floor: {through: A, angle: 0 deg}, wall: {through: W, angle: 90 deg}}
bodies: {B: {particle: A, mass: m}}
joints:
  - contact: {between: [B, floor], mu: mu}
  - impact: {between: [B, wall], restitution: e}
states:
  1: [t = 0, v(B).x = v_0]
  2: [x(B) = d]
  3: [just after 2]
  4: [v(B).x = 0, x(B) = 0]
find: {v1: v(B).x @ 1}
"""


def test_a_first_speed_that_is_asked_finds_the_constant_it_is(tmp_path: Path) -> None:
    page = page_of_text(tmp_path, BOUNCE)
    assert "v_0 = √(2 μ g d + v_2²)" in page
    assert "v1 = v_0 = 7.672 m/s" in page
