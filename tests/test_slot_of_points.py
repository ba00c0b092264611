"""A slot in a body that is drawn by points alone: its direction is told, or refused, never taken by silence."""

from __future__ import annotations

import math

import pytest
import sympy as sp
from answered import solve

from planar_cli.errors import FileProblem

GENEVA = """
title: Geneva mechanism
given: {R: 50 mm, l: R*sqrt(2), phi: 150 deg}
points: {O: [0, 0], B: [l, 0], P: {from: B, distance: R, angle: phi}}
bodies:
  D: {disk: B, radius: R, points: [P]}
  S: {WHEEL}
joints:
  - pin: {at: O, between: [ground, S]}
  - pin: {at: B, between: [ground, D]}
  - guide: {point: P, along: S}
motion: [omega(D) = 10 rad/s]
find: {omega_S: omega(S)}
"""

CART = """
title: Block on a cart drawn by two points
plane: vertical
points: {A: [0, 0], B: [1 m, HEIGHT], G: [0.4 m, 0.5 m]}
bodies:
  cart: {points: [A, B], mass: any}
  block: {plate: G, width: 0.2 m, height: 0.2 m, mass: 4 kg}
joints:
  - guide: {body: cart, along: 0 deg, name: rails}
  - guide: {body: block, along: cart, mu: 0.2}
motion: [a(A).x = 1 m/s^2]
instant: [at rest]
find: {a: a(block).x}
"""


@pytest.mark.parametrize("wheel", ["points: [O, P]", "points: [O]", "points: [O], center: O"])
def test_a_slot_that_would_not_go_through_the_points_is_refused(wheel: str) -> None:
    with pytest.raises(FileProblem) as refused:
        solve(GENEVA.replace("WHEEL", wheel))
    why = refused.value.diagnostics[0]
    assert (why.code, why.mark.line) == ("PL538", 11)
    assert why.message == "S is drawn by points, so that its slot lies at 0 deg, and not along O/P"


def test_a_rod_or_a_line_fixed_to_the_body_tells_the_direction() -> None:
    line = "surfaces: {slot: {through: P, angle: atan(R*sin(phi)/(l + R*cos(phi))), body: S}}\nbodies:"
    fixed = GENEVA.replace("WHEEL", "points: [O]").replace("along: S", "along: slot").replace("bodies:", line)
    for text in (GENEVA.replace("WHEEL", "rod: [O, P]"), fixed):
        found = solve(text)["omega_S"].values
        assert found is not None
        # In polar coordinates about O: the velocity of P across OP over the distance OP.
        x, y = 50 * 2**0.5 + 50 * math.cos(math.radians(150)), 25.0
        across = x * 500 * math.cos(math.radians(150)) - y * -500 * math.sin(math.radians(150))
        assert float(found[0]) == pytest.approx(across / (x**2 + y**2))


def test_points_on_the_slot_tell_it_as_drawn() -> None:
    level = GENEVA.replace("phi: 150 deg", "phi: 180 deg").replace("WHEEL", "points: [O, P]")
    found = solve(level)["omega_S"].values
    assert found is not None
    assert float(found[0]) == pytest.approx(-10 / (2**0.5 - 1))


def test_a_block_slides_on_a_level_cart_and_not_on_one_whose_points_slope() -> None:
    found = solve(CART.replace("HEIGHT", "0 m"))["a"].values
    assert found is not None
    assert float(found[0]) == pytest.approx(1)
    with pytest.raises(FileProblem, match="not along A/B"):
        solve(CART.replace("HEIGHT", "0.2 m"))


def test_a_disk_whose_pin_is_written_with_a_coordinate_turns_with_it() -> None:
    text = """
title: Geneva drive with a disk and a slotted rod that ends at the pin
symbols: {R: m, l: m, w: rad/s}
assume: [l > R]
coordinates: {phi: deg}
points: {O: [0, 0], B: [l, 0], P: {from: B, distance: R, angle: phi}}
bodies:
  D: {disk: B, radius: R, points: [P]}
  S: {rod: [O, P]}
joints:
  - pin: {at: O, between: [ground, S]}
  - pin: {at: B, between: [ground, D]}
  - guide: {point: P, along: S}
motion: [omega(D) = w]
find: {omega_S: omega(S)}
"""
    formula = solve(text)["omega_S"].expressions
    assert formula is not None
    r, far, w, phi = (next(s for s in formula[0].free_symbols if s.name == n) for n in ("R", "l", "w", "phi"))
    place = sp.atan2(r * sp.sin(phi), far + r * sp.cos(phi))
    assert sp.simplify(formula[0] - sp.diff(place, phi) * w) == 0
