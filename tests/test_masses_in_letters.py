"""A mass that is a multiple of a letter of the file is written so wherever it stands: 4 m g, 1/12 (3 m) l²."""

from __future__ import annotations

from pathlib import Path

from worked import page_of_file, page_of_text

ATWOOD = """\
title: Two blocks on a rope
plane: vertical
symbols: {m: kg}
points: {Q: [1 m, 0]}
bodies: {a: {particle: [0, -1 m], mass: 4*m}, b: {particle: [2 m, -1 m], mass: m}}
joints:
  - rope: {path: [a, over Q, b], along: 90 deg}
instant: [at rest]
find: {a_a: a(a).y}
"""


def test_in_equations(tmp_path: Path) -> None:
    page = page_of_text(tmp_path, ATWOOD)
    assert "4 m g ↓" in page
    assert "- 4 m g = 4 m a_ay" in page


def test_in_a_moment_of_inertia() -> None:
    assert "I_rod = 1/12 (3 m) l² = 1/4 m l²" in page_of_file("collar-let-loose-on-a-turning-rod")


HALF = """\
title: Half cylinder with a load
plane: vertical
given: {R: 0.3 m, m: 5 kg, m_0: 2 kg}
points: {Z: [0, 0], C: [0, R], G: [0, R - 4*R/(3*pi)]}
surfaces: {floor: {through: Z, angle: 0 deg}}
bodies:
  half: {parts: [{sector: C, radius: R, span: 180 deg, angle: -90 deg, mass: m}, {particle: C, mass: m_0}]}
joints:
  - rolling: {between: [half, floor], at: Z}
states:
  rest: [equilibrium]
find: {T: period(rest)}
"""


def test_a_point_of_the_file_and_a_mass_centre_have_names_of_their_own(tmp_path: Path) -> None:
    """G is a point of the file, m a mass of it: the body of both has m′ and G_half."""
    assert "m′ g ↓ at G_half" in page_of_text(tmp_path, HALF)
