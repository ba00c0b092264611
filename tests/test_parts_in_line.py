"""Bodies of parts on one line through their pin, and wheels out of balance: distances, I about the pin, components."""

from __future__ import annotations

from pathlib import Path

from worked import page_of_file, page_of_text

CLOCK = """
title: Clock pendulum in letters
plane: vertical
symbols: {m: kg, l: m, M: kg, R: m}
coordinates: {theta: deg}
points: {O: [0, 0], B: {from: O, distance: l, angle: theta}, C: {from: O, distance: l + R, angle: theta}}
bodies: {pendulum: {parts: [{rod: [O, B], mass: m}, {disk: C, radius: R, mass: M}]}}
joints: [{pin: {at: O, between: [ground, pendulum]}}]
states: {1: [theta = 0, at rest], 2: [theta = -90 deg]}
find: {omega: omega(pendulum) @ 2, I_O: I(pendulum/O)}
"""


def test_distances_along_the_line_of_a_pendulum() -> None:
    """I_O = 1/3 m_1 l² + 1/2 m_2 r² + m_2 d_2²; I about G from it."""
    text = page_of_file("rod-and-disk-pendulum")
    assert "OG = (m_1 d_1 + m_2 d_2)/m = (2 · 0.4 + 4 · 0.9)/6 = 0.7333 m" in text
    assert "about its end O: I_1 = 1/3 m_1 OB² = 1/3 · 2 · 0.8² = 0.4267 kg·m²" in text
    assert "I_O = m_2 d_2² + I_1 + I_2 = 4 · 0.9² + 0.4267 + 0.02 = 3.687 kg·m²" in text
    assert "I = I_O - m OG²" in text
    assert "ΣM_O: -√3/2 m g OG = I_O α" in text
    assert "a_G = α × r_G/O - ω² r_G/O = OG α e_t + OG ω² e_n" in text
    assert "x_G" not in text


def test_in_letters_about_the_pin(tmp_path: Path) -> None:
    text = page_of_text(tmp_path, CLOCK)
    assert "I_O = 1/2 M R² + M (l + R)² + 1/3 m l²" in text
    assert "OG = (M (l + R) + 1/2 m l)/m′" in text


def test_a_counterweight_beyond_the_pin_keeps_its_coordinates(tmp_path: Path) -> None:
    text = page_of_text(tmp_path, CLOCK.replace("distance: l + R, angle: theta", "distance: R, angle: theta + 180 deg"))
    assert "OG = " not in text
    assert "I_O = 3/2 M R² + 1/3 m l²" in text


def test_a_hole_beside_the_pin_leaves_no_negative_distance(tmp_path: Path) -> None:
    """The mass centre is on the other side of the pin; of a hole in a disk that is held at its edge it is not."""
    wheel = """
title: Disk with a hole
plane: vertical
given: {R: 300 mm, r_h: 60 mm, s: 180 mm, m_d: 90 kg, m_h: 4 kg}
points: {O: [0, 0], C: [CENTRE, 0], A: [s, 0]}
bodies: {wheel: {parts: [{disk: C, radius: R, mass: m_d}, {disk: A, radius: r_h, mass: -m_h}], points: [O]}}
joints: [{pin: {at: O, between: [wheel, ground]}}]
instant: [at rest]
find: {alpha: alpha(wheel)}
"""
    assert "x_G = m_2 s/m = -4 · 0.18 / 86" in page_of_text(tmp_path, wheel.replace("CENTRE", "0"))
    assert "OG = (m_2 s + m_d R)/m" in page_of_text(tmp_path, wheel.replace("CENTRE", "R"))


def test_a_coordinate_that_all_parts_share_is_that_letter() -> None:
    text = page_of_file("unbalanced-wheel")
    assert "y_G" not in text
    assert "0.3 - 0.3" not in text
    assert "F_C/N_C = 5.5015/96.03 = 0.05729 no slipping while |F_C| ≤ μ N_C" in text
    assert "= [R α - x_G ω², -x_G α]" in text
    assert "= m R α → at G, m x_G α ↓ at G, m x_G ω² ← at G, I α ↻" in text


ARM = """
title: Driven arm with a ball
plane: vertical
given: {l: 2 ft, R: 3 in}
points: {O: [1 ft, 1 ft], B: {from: O, distance: l, angle: 60 deg}, C: {from: O, distance: l + R, angle: 60 deg}}
bodies: {arm: {parts: [{rod: [B, O], mass: 4 lb}, {sphere: C, radius: R, mass: 10 lb}], points: [O, B, C]}}
joints: [{pin: {at: O, between: [ground, arm]}}]
unknowns: {M: lbf*ft}
loads: [{torque: {body: arm, moment: M}}]
instant: [omega(arm) = 3 rad/s cw, alpha(arm) = 2 rad/s^2]
find: {M: M}
"""


def test_a_pin_away_from_the_origin(tmp_path: Path) -> None:
    """OG = (4 · 1 + 10 · 2.25)/14 ft = 1.893 ft, by the letters of the file and not by those of places."""
    text = page_of_text(tmp_path, ARM)
    assert "OG = (1/2 m_1 l + m_2 (l + R))/m" in text
    assert "ΣM_O: M - 1/2 m g OG = I_O α" in text
    assert "x_1" not in text
