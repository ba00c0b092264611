"""Components along and across a radius that are asked of a vector have their numbers, not a value alone."""

from __future__ import annotations

from pathlib import Path

from worked import page_of_text

COLLAR = """
title: Collar in a vertical slot, driven by a rotating arm
plane: vertical
given: {m: 1 kg, w: 2 rad/s, d: 0.4 m, theta: 30 deg}
points:
  A: [0, 0]
  P: {x: d, line: [A, theta]}
  B: {from: A, distance: 1.6*d, angle: theta}
bodies: {AB: {rod: [A, B]}, P: {particle: P, mass: m}}
joints:
  - pin: {at: A, between: [ground, AB]}
  - guide: {point: P, along: AB, name: arm}
  - guide: {point: P, along: 90 deg, name: slot}
motion: [omega(AB) = w]
find: {v_r: v(P/A).r, v_theta: v(P/A).theta, a_r: a(P).r, a_theta: a(P).theta}
"""


def test_components_by_the_numbers_of_the_vector(tmp_path: Path) -> None:
    page = page_of_text(tmp_path, COLLAR)
    assert "v_r = 0.5 · 1.0667 = 0.5333 m/s the component of v_P/A ↗" in page
    assert "v_θ = 0.86603 · 1.0667 = 0.9238 m/s the component of v_P/A ↖" in page
    assert "a_r = 0.5 · 2.463 = 1.232 m/s² the component of a_P ↗" in page
    assert "a_θ = 0.8660 · 2.463 = 2.133 m/s² the component of a_P ↖" in page


def test_relative_to_a_point_at_rest_nothing_goes_off(tmp_path: Path) -> None:
    page = page_of_text(tmp_path, COLLAR)
    assert "v_P/A = v_P = [0, 1.067] m/s" in page
    assert "v_P - v_A" not in page
