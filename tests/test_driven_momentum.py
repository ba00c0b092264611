"""Momentum of scenes in which something is driven: what drives enters a law only where its force does."""

from __future__ import annotations

import math
from decimal import Decimal

import pytest
from answered import assert_close, solve

from planar_cli.formats.terminal import Terminal
from planar_cli.problem.structure import load_text
from planar_cli.report.page.narrate import narrate
from planar_cli.solve.run import solve_problem

TURNTABLE = """
title: Man who walks inward on a turntable
plane: horizontal
points: {O: [0, 0]}
bodies: {table: {disk: O, radius: 2 m, mass: 200 kg}, man: {particle: [2 m, 0], mass: 70 kg}}
surfaces: {way: {through: O, angle: 0 deg, body: table}}
joints:
  - pin: {at: O, between: [ground, table]}
  - guide: {point: man, along: way}
motion: [dot(r(man).mag) = -0.5 m/s]
states: {1: [t = 0, omega(table) = 1 rad/s], 2: [r(man).mag = 0.5 m]}
find: {omega: omega(table) @ 2}
"""
"""What keeps him walking acts along the radius: it has no moment about O."""

TURNED = (
    TURNTABLE.replace("dot(r(man).mag) = -0.5 m/s", "omega(table) = 1 rad/s")
    .replace("omega(table) = 1 rad/s], 2", "v(man/table).mag = 0], 2")
    .replace("r(man).mag = 0.5 m", "t = 1 s")
    .replace("omega: omega(table) @ 2", "H: H(all/O) @ 2 - H(all/O) @ 1")
)
"""A motor keeps the table turning: it changes the angular momentum."""


def page(text: str) -> str:
    problem, wrong = load_text(text)
    assert problem is not None
    assert not wrong
    return Terminal().render(narrate(solve_problem(problem)))


def test_a_drive_without_a_moment_leaves_the_angular_momentum() -> None:
    assert_close(solve(TURNTABLE)["omega"], Decimal(680) / Decimal("417.5"))
    assert "table, man: conservation of angular momentum about O" in page(TURNTABLE)


def test_a_motor_does_not() -> None:
    assert "conservation of angular momentum" not in page(TURNED)


ON_A_CART = """
title: Angular momentum of a rod about its moving pin
plane: vertical
given: {M: 6 kg, m: 3 kg, l: 0.8 m, F: 40 N}
points: {A: [0, 0], B: {from: A, distance: l, angle: -60 deg}}
bodies: {cart: {particle: A, mass: M}, rod: {rod: [A, B], mass: m}}
joints:
  - guide: {body: cart, along: 0 deg, name: rail}
  - pin: {at: A, between: [cart, rod]}
loads:
  - force: {body: cart, magnitude: F, angle: 0 deg}
instant: [v(cart).x = 2 m/s, omega(rod) = 3 rad/s]
find:
  dH_A: dot(H(rod/A))
  dH_G: dot(H(rod/rod))
  dp: dot(momentum(all)).x
  alpha: alpha(rod)
"""


def test_rates_of_momenta_at_an_instant() -> None:
    """dH_A/dt = M_A - v_A × m v_G about a point that moves; dH_G/dt = I_G α; dp/dt = Σ F."""
    found = {name: float(f.values[0]) for name, f in solve(ON_A_CART).items() if f.values}
    moment, v_gy = -3 * 9.81 * 0.4 * math.cos(math.radians(60)), 3 * 0.4 * math.cos(math.radians(60))
    assert found["dH_A"] == pytest.approx(moment - 2 * 3 * v_gy)
    assert found["dH_G"] == pytest.approx(3 * 0.8**2 / 12 * found["alpha"])
    assert found["dp"] == pytest.approx(40)


def test_an_angular_impulse_has_its_unit_and_sense() -> None:
    text = ON_A_CART.replace("instant: [v", "states:\n  1: [t = 0, v").replace("3 rad/s]", "3 rad/s]\n  2: [t = 0.2 s]")
    text = text[: text.index("find:")] + "find: {M_imp: impulse(rod/A) @ 1->2, H: H(rod/A) @ 2}\n"
    problem, _ = load_text(text)
    assert problem is not None
    page = Terminal(120).render(narrate(solve_problem(problem)))
    assert "M_imp = 1.478 N·m·s clockwise" in page
    assert "H = 2.276 kg·m²/s counterclockwise" in page
