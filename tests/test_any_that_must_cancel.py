"""`inertia: any`: the answer does not rest on it; a mode in which it does is not the one that is meant."""

from __future__ import annotations

import pytest
from answered import solve

from planar_cli.errors import NoSolution

CAR = """
title: Car with rear-wheel drive
plane: vertical
symbols: {m: kg, L: m, b: m, h: m, mu: 1}
MORE
unknowns: {P: N}
points: {F: [0, 0], R: [-(SIDE)*L, 0], G: [-(SIDE)*b, h]}
surfaces: {road: {through: F, angle: 0 deg}}
bodies: {car: {points: [F, R], center: G, mass: m, inertia: any}}
joints:
  - contact: {between: [car, road], at: F, mu: 0}
  - REAR
loads:
  - force: {body: car, at: R, magnitude: P, angle: 90 deg - (SIDE)*90 deg}
instant: [NOW]
find: {a: (SIDE)*a(car).x, N_F: N(F)}
"""
GUIDE = "guide: {point: R, along: 0 deg, name: rear}"
CONTACT = "contact: {between: [car, road], at: R, mu: 0, name: rear}"


def written(now: str, side: str = "1", more: str = "", rear: str = GUIDE) -> str:
    return CAR.replace("NOW", now).replace("SIDE", side).replace("MORE", more).replace("REAR", rear)


@pytest.mark.parametrize("more", ["", "assume: [L > b + mu*h]"])
@pytest.mark.parametrize(
    ("now", "side"), [("at rest", "1"), ("at rest, alpha(car) = 0", "1"), ("omega(car) = 0", "-1")]
)
@pytest.mark.parametrize("rear", [GUIDE, CONTACT])
def test_the_greatest_acceleration_of_a_car(now: str, side: str, more: str, rear: str) -> None:
    """N_R = m g b/(L - μ h), a = μ N_R/m."""
    found = solve(written(f"{now}, P = mu*N(rear)", side, more, rear))
    a, front = (found[n].expressions[0] for n in ("a", "N_F"))
    numbers = {"m": 1200, "L": 3, "b": 1, "h": 0.5, "mu": 0.8, "g": 10}
    values = [float(e.subs({s: numbers[s.name] for s in e.free_symbols})) for e in (a, front)]
    assert values == pytest.approx([0.8 * 10 / 2.6, 12000 * (1 - 1 / 2.6)])


def test_where_it_lifts_off_the_inertia_is_asked_for() -> None:
    with pytest.raises(NoSolution) as error:
        solve(written("at rest, mode(F) = apart, P = mu*N(rear)"))
    assert error.value.diagnostics[0].code == "PL614"
