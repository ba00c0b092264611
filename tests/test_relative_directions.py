"""Directions that a file gives and asks of relative velocities: components, the quadrant, the answer in words."""

from __future__ import annotations

from pathlib import Path

import sympy as sp
from worked import page_of_file, page_of_text

from planar_cli.report.words.origins import components_of, without_number

v, w = sp.symbols("v w", real=True)


def test_a_number_that_all_is_multiplied_by_is_left_out() -> None:
    assert without_number(sp.sqrt(2) * (v - w) / 2) == v - w
    assert without_number(v - w) == v - w


def test_a_given_direction_says_what_its_components_are() -> None:
    assert components_of("v(air/cyclist).angle = -90 deg") == ", so that its x component is zero"
    assert components_of("v(P).angle = 180 deg") == ", so that its y component is zero"
    assert components_of("v(P).angle = 30 deg") == ", so that its y component is tan(30°) times its x component"
    assert components_of("v(P).x = 3 m/s") == ""


def test_the_page_of_a_wind() -> None:
    page = page_of_file("wind-felt-by-a-cyclist")
    assert "(1) given, w_x unknown: v_air,x = w_x" in page
    assert "v_air/cyclist = v_air - v_cyclist = [v_air,x - v_cyclist,x, v_air,y - v_cyclist,y]" in page
    assert "(3) v_cyclist,x,fast + w_y = w_x (3): w_y = w_x - v_cyclist,x,fast" in page
    assert "direction = arctan(-1) = -45° as w_x > 0" in page
    assert "direction = -45°, that is 45° below +x" in page


AT_THE_FAR_END = """
title: Crank pin at the far end of its slot
points: {C: [0, 0], O: [0.4 m, 0.3 m], P: [0.56 m, 0.42 m]}
bodies: {crank: {rod: [O, P]}, arm: {rod: [C, P]}}
joints:
  - pin: {at: O, between: [ground, crank]}
  - pin: {at: C, between: [ground, arm]}
  - guide: {point: P, along: arm}
motion: [omega(crank) = 4 rad/s]
find: {alpha: alpha(arm)}
"""


def test_what_products_cancel_to_is_zero_once(tmp_path: Path) -> None:
    assert "along e: v_rel = v_P · e = 0 m/s" in page_of_text(tmp_path, AT_THE_FAR_END)
