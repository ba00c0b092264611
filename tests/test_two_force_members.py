"""A body without mass that is loaded at its two pins alone pulls or pushes along them, and has no equations."""

from __future__ import annotations

from pathlib import Path

import pytest
from worked import page_of_file, page_of_text

PLATE = """
title: Semicircular plate on two parallel links
plane: vertical
given: {m: 7 kg, r: 300 mm, l: 300 mm, beta: 60 deg, n: 200 rpm}
points:
  A: [0, 0]
  C: [2*r, 0]
  B: {from: A, distance: l, angle: beta}
  D: {from: C, distance: l, angle: beta}
  O: {midpoint: [B, D]}
bodies:
  AB: {rod: [A, B]MASS}
  CD: {rod: [C, D]}
  plate: {sector: O, radius: r, span: 180 deg, angle: 90 deg, mass: m, points: [B, D]}
joints:
  - pin: {at: A, between: [ground, AB]}
  - pin: {at: C, between: [ground, CD]}
  - pin: {at: B, between: [AB, plate]}
  - pin: {at: D, between: [CD, plate]}
LOADS
instant: [omega(AB) = -n]
find: {R_A: reaction(A).mag, C_x: reaction(C).x}
"""
BRACKET = """
title: Bracket
plane: vertical
given: {F: 100 N}
points: {A: [0, 0], B: [1 m, 0], C: [0, -1 m]}
bodies: {AB: {rod: [A, B]}, CB: {rod: [C, B]}, knot: {particle: B}}
joints:
  - pin: {at: A, between: [ground, AB]}
  - pin: {at: C, between: [ground, CB]}
  - pin: {at: B, between: [AB, knot], name: upper}
  - pin: {at: B, between: [CB, knot], name: lower}
loads: [{force: {body: knot, magnitude: F, angle: -90 deg}}]
instant: [equilibrium]
find: {R_A: reaction(A).mag, R_C: reaction(C)}
answers: {R_A: 100 N, R_C: [100 N, 100 N]}
"""


def _plate(folder: Path, mass: str = "", loads: str = "") -> str:
    return page_of_text(folder, PLATE.replace("MASS", mass).replace("LOADS", loads))


def test_one_force_along_each_link_in_place_of_four(tmp_path: Path) -> None:
    page = _plate(tmp_path)
    assert "AB and CD have no mass and are loaded at their pins alone: along them act S_AB and S_CD" in page
    assert "2 unknowns: S_AB, S_CD" in page
    assert "R_A = S_AB = 536.4 N" in page
    assert "C_x = -S_CD cos β = -325.3 cos 60° = -162.6 N" in page
    assert "checked by an independent multibody solution" in page


@pytest.mark.parametrize(
    ("mass", "loads"),
    [(", mass: 1 kg", ""), ("", "loads: [{torque: {body: AB, moment: 5 N*m}}]")],
    ids=["with mass", "with a couple"],
)
def test_a_link_that_is_loaded_between_keeps_both_components(tmp_path: Path, mass: str, loads: str) -> None:
    page = _plate(tmp_path, mass, loads)
    assert "S_AB" not in page
    assert "S_CD" in page
    assert "checked by an independent multibody solution" in page


def test_in_statics(tmp_path: Path) -> None:
    page = page_of_text(tmp_path, BRACKET)
    assert "S_AB" in page
    assert "S_CB" in page
    assert "R_A = S_AB = 100 N" in page


def test_a_particle_at_its_end() -> None:
    page = page_of_file("bob-on-a-cart")
    assert "pull = S_rod" in page
    assert "bob, perpendicular to rod: (3) ↙ ΣF: m g sin φ = -m a_O cos φ - m l α" in page
    assert "4 equations, 4 unknowns: S_rod, a_O, α, N_rail" in page
