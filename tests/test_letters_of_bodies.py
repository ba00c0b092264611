"""A letter of the file is not a body's ω or α as well; those of the only body that turns then have its name."""

from __future__ import annotations

from test_letters_apart import _page

ARM = """
title: Ball guided along a circle by an arm
plane: vertical
given: {m: 0.5 kg, R: 0.4 m, LETTER: 0.4 rad/s, theta_0: 30 deg}
points:
  O: [0, 0]
  Q: [R, 0]
  P: {from: O, distance: 2*R*cos(theta_0), angle: theta_0}
  C: {from: O, distance: 1 m, angle: theta_0}
surfaces: {path: {center: Q, radius: R}}
bodies:
  OC: {rod: [O, C]}
  ball: {particle: P, mass: m}
joints:
  - pin: {at: O, between: [ground, OC]}
  - guide: {point: P, along: OC, name: slot}
  - guide: {point: P, along: path, name: circle}
motion: [omega(OC) = LETTER]
find: {v_rel: v(P/OC).along(OC), N_circle: N(circle), a_cor: coriolis(P/OC).mag}
"""
SPOOL = """
title: Spool
plane: vertical
given: {m: 50 kg, k_G: 0.2 m, R: 0.45 m, P: 100 N, alpha: 20 deg}
points: {C: [0, 0], G: [0, R]}
surfaces: {floor: {through: C, angle: 0 deg}}
bodies: {spool: {disk: G, radius: R, mass: m, radius_of_gyration: k_G}}
joints:
  - rolling: {between: [spool, floor], at: C}
loads:
  - force: {body: spool, at: G, magnitude: P, angle: alpha}
instant: [at rest]
find: {a: a(G).x, F: friction(C).x}
"""


def test_given_letter_of_a_turning_body() -> None:
    page = _page(ARM.replace("LETTER", "omega"))
    assert "omega" not in page
    assert "ω′" not in page
    assert "; ω_OC = ω Find" in page
    assert "v_P = ω_OC × r_P/O + v_P/OC e" in page


def test_other_given_letter() -> None:
    page = _page(ARM.replace("LETTER", "omega_0"))
    assert "ω = ω_0 given" in page
    assert "ω_OC ×" not in page


def test_angle_called_as_an_angular_acceleration() -> None:
    page = _page(SPOOL)
    assert "alpha" not in page
    assert "a_G = R α_spool" in page
    assert "P R cos α = m a_G R + I_G α_spool" in page
    other = _page(SPOOL.replace("alpha", "beta"))
    assert "a_G = R α " in other
    assert "α_spool" not in other
