"""A coordinate that is given in time is driven where nothing else moves: the drive does work through it alone."""

from __future__ import annotations

from math import atan, cos, radians, sin

import pytest
from answered import assert_close, solve

ROD = """
title: Rod that hangs from a support with a given acceleration
plane: vertical
coordinates: {s: m, theta: deg}
given: {L: 1 m}
points: {A: [s, 0], B: {from: A, distance: L, angle: theta - 90 deg}}
bodies: {rod: {rod: [A, B], mass: 2 kg}}
joints:
  - guide: {point: A, along: 0 deg}
motion: [DRIVEN = 3 m/s^2]
"""
STEADY = (
    ROD + "instant: [alpha(rod) = 0, omega(rod) = 0, theta < 90 deg, theta > -90 deg]\nfind: {value: theta in deg}\n"
)
STARTS = ROD + "instant: [at rest, theta = 0]\nfind: {value: alpha(rod)}\n"


@pytest.mark.parametrize("driven", ["ddot(s)", "a(A).x"])
def test_the_support_is_pushed_and_not_the_middle(driven: str) -> None:
    """tan theta = -a/g; m L²/3 alpha = -m a L/2."""
    assert_close(solve(STEADY.replace("DRIVEN", driven))["value"], -atan(3 / 9.81), 9)
    assert_close(solve(STARTS.replace("DRIVEN", driven))["value"], -4.5, 9)


CART = """
title: Bob on a cart that is driven
plane: vertical
coordinates: {s: m, phi: deg}
points: {A: [s, 0], B: {from: A, distance: 1 m, angle: phi}}
bodies: {BODIES}
joints:
  - guide: {point: A, along: 0 deg}
  - link: {between: [A, B], name: link}
motion: [ddot(s) = 3 m/s^2]
instant: [s = 0, dot(s) = 0, phi = -120 deg, dot(phi) = 0]
find: {value: ddot(phi), S: tension(link)}
"""
BOB, SLIDER = "bob: {particle: B, mass: 2 kg}", "cart: {particle: A, mass: 1 kg}"


@pytest.mark.parametrize("bodies", [f"{SLIDER}, {BOB}", f"{BOB}, {SLIDER}"])
def test_the_cart_is_pushed_whichever_stands_first(bodies: str) -> None:
    """l phi'' = a sin phi - g cos phi, phi from +x."""
    found = solve(CART.replace("BODIES", bodies))
    assert_close(found["value"], 3 * sin(radians(-120)) - 9.81 * cos(radians(-120)), 9)
    # m (a cos phi) = -S - m g sin phi along the link.
    assert_close(found["S"], -2 * (3 * cos(radians(-120)) + 9.81 * sin(radians(-120))), 9)


ARM = """
title: Two arms, and a motor between them
plane: horizontal
given: {L: 1 m, m: 3 kg}
coordinates: {p: deg, q: deg}
points: {O: [0, 0], A: {from: O, distance: L, angle: p}, B: {from: A, distance: L, angle: p + q}}
bodies: {BODIES}
joints:
  - pin: {at: O, between: [ground, upper]}
  - pin: {at: A, between: [upper, fore]}
motion: [ddot(q) = 2 rad/s^2]
instant: [p = 0, q = 90 deg, dot(p) = 0, dot(q) = 0]
find: {value: ddot(p)}
"""
FORE, UPPER = "fore: {rod: [A, B], mass: m}", "upper: {rod: [O, A], mass: m}"


@pytest.mark.parametrize("bodies", [f"{FORE}, {UPPER}", f"{UPPER}, {FORE}"])
def test_a_motor_between_two_bodies_turns_both(bodies: str) -> None:
    """H_O stays zero: (I_O + m L² + m L²/4 + I_G) p'' + (m L²/4 + I_G) q'' = 0 at right angles."""
    assert_close(solve(ARM.replace("BODIES", bodies))["value"], -0.4, 9)
