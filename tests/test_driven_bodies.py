"""A prescribed acceleration is a driver, wherever it is written and whether or not the body has mass."""

from __future__ import annotations

import math

import pytest
from answered import solve

from planar_cli.errors import NoSolution

ON_A_LORRY = """
title: A crate slides back on the bed of a lorry
plane: vertical
given: {m: 50 kg, mu: 0.3}
points: {A: [0, 1 m], P: [2 m, 1 m]}
surfaces: {bed: {through: A, angle: 0 deg, body: lorry}}
bodies:
  lorry: {points: [A], center: A}
  crate: {particle: P, mass: m}
joints:
  - guide: {body: lorry, along: 0 deg}
  - contact: {between: [crate, bed], at: P, mu: mu}
motion: [a(A).x = 4 m/s^2]
states:
  1: [t = 0, at rest]
  2: [x(P) - x(A) = 0]
find: {t: t @ 2, v: v(crate).x @ 2}
"""

ON_A_CART = """
title: A bar hangs from a cart that is accelerated
plane: vertical
given: {l: 1.2 m, m: 3 kg, a: 3 m/s^2}
coordinates: {theta: deg}
points: {A: [0, 0], B: {from: A, distance: l, angle: theta}}
bodies:
  cart: {points: [A], center: A}
  bar: {rod: [A, B], mass: m}
joints:
  - guide: {body: cart, along: 0 deg}
  - pin: {at: A, between: [cart, bar]}
instant: [theta = -90 deg, at rest, a(A).x = a]
find: {alpha: alpha(bar), A_x: reaction(A/bar).x}
"""

ON_A_MOTOR = """
title: An arm that turns steadily on a motor that falls
plane: vertical
given: {e: 0.1 m, w: 10 rad/s}
coordinates: {y: m, phi: rad}
points: {O: [0, y], E: {from: O, distance: e, angle: phi}}
bodies:
  motor: {particle: OMASS}
  arm: {rod: [O, E], mass: 1 kg}
joints:
  - guide: {point: O, along: 90 deg}
  - pin: {at: O, between: [motor, arm]}
motion: [phi = w*t]
states:
  1: [t = 0, y = 0, dot(y) = 0]
  2: [t = 2 s]
find: {y: y @ 2}
"""

AT_REST = ON_A_MOTOR.replace("coordinates: {y: m, phi: rad}\n", "").replace("[0, y]", "[0, 0]")
AT_REST = AT_REST.replace("angle: phi", "angle: 0 deg").replace("phi = w*t", "theta(arm) = w*t")
AT_REST = AT_REST.replace("y = 0, dot(y) = 0", "at rest").replace("y @ 2", "y(motor) @ 2")


def test_beside_what_is_driven_a_body_that_can_be_at_rest_is() -> None:
    found = solve(AT_REST.replace("MASS", ", mass: 10 kg"))
    assert float(found["y"].values[0]) == pytest.approx(0.05 * (20 - math.sin(20)) / 11 - 9.81 * 2)


@pytest.mark.parametrize(("mass", "kilograms"), [("", 0.0), (", mass: 10 kg", 10.0)])
def test_a_coordinate_that_motion_gives_in_time_beside_one_that_is_free(mass: str, kilograms: float) -> None:
    found = solve(ON_A_MOTOR.replace("MASS", mass))
    along_arm = 0.05 * (10 * 2 - math.sin(20)) / (kilograms + 1)
    assert float(found["y"].values[0]) == pytest.approx(along_arm - 9.81 * 2)


@pytest.mark.parametrize("mass", ["", ", mass: 2000 kg"])
def test_a_crate_slides_on_a_driven_lorry(mass: str) -> None:
    found = solve(ON_A_LORRY.replace("center: A}", f"center: A{mass}}}"))
    t = math.sqrt(2 * 2 / (4 - 0.3 * 9.81))
    assert float(found["t"].values[0]) == pytest.approx(t)
    assert float(found["v"].values[0]) == pytest.approx(0.3 * 9.81 * t)


def test_an_acceleration_of_a_light_body_at_one_instant() -> None:
    found = solve(ON_A_CART)
    assert float(found["alpha"].values[0]) == pytest.approx(-3.75)
    assert float(found["A_x"].values[0]) == pytest.approx(2.25)


def test_an_acceleration_of_a_heavy_body_has_to_agree_with_its_forces() -> None:
    with pytest.raises(NoSolution) as raised:
        solve(ON_A_CART.replace("center: A}", "center: A, mass: 2 kg}"))
    assert [d.code for d in raised.value.diagnostics] == ["PL608"]
