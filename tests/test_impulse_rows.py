"""Diagrams of impulses over a time, what is taken for granted of bodies without mass, and the check by one work."""

from __future__ import annotations

from pathlib import Path

from worked import page_of_file, page_of_text

CART = """\
title: Cart up a slope
plane: vertical
method: momentum
given: {m: 7 kg, r: 0.35 m, M: 100 N*m, b: 1 m, beta: 10 deg}
points:
  A: [0, 0]
  B: {from: A, distance: b, angle: beta}
  O_A: {from: A, distance: r, angle: beta + 90 deg}
  O_B: {from: B, distance: r, angle: beta + 90 deg}
  G: {from: A, distance: b/2, angle: beta}
surfaces: {road: {through: A, angle: beta}}
bodies:
  frame: {points: [O_A, O_B], center: G, mass: m}
  rear: {disk: O_A, radius: r, mass: m}
  front: {disk: O_B, radius: r, mass: m}
joints:
  - pin: {at: O_A, between: [frame, rear]}
  - pin: {at: O_B, between: [frame, front]}
  - rolling: {between: [rear, road], at: A}
  - rolling: {between: [front, road], at: B}
loads:
  - torque: {name: chain, between: [rear, frame], moment: -M}
states:
  1: [t = 0, at rest]
  2: [t = 10 s]
find: {v: v(frame).along(beta) @ 2}
"""


def test_impulses_over_a_time_are_drawn_before_their_equations() -> None:
    page = page_of_file("ex-4-18")
    assert (
        "From 1 to 2, from rest: impulses = momenta at 2 (J: impulse of a reaction; m_rear, m_front: parts of m; the "
        "vertical impulses do not enter)" in page
    )
    assert "frame, rear, front: J_F,A → at A, J_F,B ← at B = m v → at G" in page
    assert page.count("= m v → at G") == 1


def test_a_wheel_whose_mass_is_counted_elsewhere_has_its_momentum() -> None:
    page = page_of_file("ex-4-18")
    assert "rear: M t_2 ↻, J_OAx → at O_A, J_F,A → at A = m_rear v → at O_A, I_r ω_rear,2 ↻" in page
    assert "front: J_OBx → at O_B, J_F,B ← at B = m_front v → at O_B, I_f ω_front,2 ↻" in page


def test_the_speed_that_is_asked_is_the_unknown_and_its_kinematics_come_first() -> None:
    page = page_of_file("ex-4-18")
    first = "Kinematics, at 2: ω_rear,2 = ω_front,2 = v/r rear and front roll without slipping"
    assert first in page
    assert page.index(first) < page.index("impulses = momenta")
    assert "hence: v = M r t_2 / (m r² + I_f + I_r)" in page


def test_an_impulse_counts_as_it_acts_and_inner_ones_cancel() -> None:
    """The road holds the front wheel back; of the whole cycle no impulse of an axle enters."""
    page = page_of_file("ex-4-18")
    assert "(1) ↻ H_O,A: M t_2 - J_F,A r = I_r v/r" in page
    assert "(2) → J_F,A - J_F,B = m v" in page
    assert "↻ H_O,B: J_F,B r = I_f v/r" in page


def test_equal_weights_of_several_bodies_do_not_cancel(tmp_path: Path) -> None:
    """Nor does the chain's torque stay, which acts on the frame and back on the wheel."""
    page = page_of_text(tmp_path, CART)
    assert (
        "frame, rear, front: m g t_2 ↓ at G, m g t_2 ↓ at O_A, J_N,A ↖ at A, J_F,A ↙ at A, m g t_2 ↓ at O_B, "
        "J_N,B ↖ at B, J_F,B ↗ at B = m v ↗ at G" in page
    )


def test_balances_without_such_impulses_need_no_diagram() -> None:
    assert "impulses = momenta" not in page_of_file("ex-4-12")


def test_a_body_without_mass_that_moves_on_is_told() -> None:
    told = "m is the mass of frame together with rear and front; of these only the rotation is added."
    assert told in page_of_file("ex-4-18")
    assert "the rotation is added" not in page_of_file("two-wheels-pressed-together")


def test_the_work_of_one_source_is_the_kinetic_energy() -> None:
    told = "work and energy: U = M θ_rear,2 = 10 · 52.15 = 521.5 J = T_2"
    assert told in page_of_file("ex-4-18")


TRAIN = """\
title: Two sledges that are braked
plane: vertical
method: momentum
given: {m_A: 3 kg, m_B: 2 kg, mu: 0.2, F: 60 N}
bodies:
  A: {particle: [0, 0], mass: m_A}
  B: {particle: [-2 m, 0], mass: m_B}
surfaces: {floor: {through: [0, 0], angle: 0 deg}}
joints:
  - contact: {between: [A, floor], mu: mu, at: A}
  - contact: {between: [B, floor], mu: mu, at: B}
  - link: {between: [B, A], name: bar}
loads:
  - force: {body: A, magnitude: F, angle: 180 deg}
states:
  1: [t = 0, v(A).x = 20 m/s]
  2: [t = 1 s]
find: {v: v(A).x @ 2}
"""


def test_what_moves_at_first_does_not_start_from_rest(tmp_path: Path) -> None:
    """Also where a balance across its motion, with nothing before, stands by itself."""
    page = page_of_text(tmp_path, TRAIN)
    assert "J_N,A - m_A g t_2 = 0" in page
    assert "from rest" not in page
