"""The linear equation of a small motion names what is put for the functions that stand in the whole equation."""

from __future__ import annotations

from pathlib import Path

from worked import page_of_file, page_of_text

PENDULUM = """
title: Damped pendulum
plane: vertical
given: {m: 2 kg, l: 0.5 m, c: 0.4 N*m*s}
coordinates: {theta: deg}
points: {O: [0, 0]}
bodies: {bar: {rod: [O, theta - 90 deg], length: l, mass: m}}
joints:
  - pin: {at: O, between: [ground, bar]}
loads:
  - torque: {body: bar, moment: -c*dot(theta)}
states:
  1: [theta = 10 deg, at rest]
  2: [theta = 0]
find: {t_2: t @ 2}
"""


def test_no_cosine_is_spoken_of_where_none_stands(tmp_path: Path) -> None:
    page = page_of_text(tmp_path, PENDULUM)
    assert "For small θ the equation of motion is linear, as sin θ ≈ θ." in page
    assert "cos θ ≈ 1" not in page


def test_both_are_named_where_both_stand() -> None:
    assert "as sin θ ≈ θ and cos θ ≈ 1." in page_of_file("bar-with-spring-and-damper")
