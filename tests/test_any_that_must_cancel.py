"""`inertia: any`: the answer does not rest on it; a mode in which it does is not the one that is meant."""

from __future__ import annotations

import pytest
from answered import first, solve

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


BIKE = """
title: Motorcycle that raises its front wheel
plane: vertical
given: {W: 500 lbf, L: 55 in, b: 24 in, h: 28 in, g: 32.2 ft/s^2}
unknowns: {F: lbf}
points: {R: [0, 0], Q: [(SIDE)*L, 0], G: [(SIDE)*b, h]}
surfaces: {road: {through: R, angle: 0 deg}}
bodies: {bike: {points: [R, Q], center: G, weight: W, inertia: INERTIA}}
joints:
  - contact: {between: [bike, road], at: R, mu: 0}
  - contact: {between: [bike, road], at: Q, mu: 0}
loads:
  - force: {body: bike, at: R, magnitude: F, angle: 90 deg - (SIDE)*90 deg}
instant: [(SIDE)*v(bike).x = 20 ft/s, NOW]
find: {a: (SIDE)*a(bike).x in ft/s^2, mu_needed: F/N(R)}
"""


@pytest.mark.parametrize("inertia", ["any", "30 slug*ft^2"])
@pytest.mark.parametrize("side", ["1", "-1"])
@pytest.mark.parametrize("now", ["N(Q) = 0", "omega(bike) = 0, N(Q) = 0", "N(Q) = 0, alpha(bike) = 0"])
def test_a_wheel_that_only_just_lifts(now: str, side: str, inertia: str) -> None:
    """F h = W b, so that a = g b/h; with the wheel apart nothing would tell F."""
    found = solve(BIKE.replace("NOW", now).replace("SIDE", side).replace("INERTIA", inertia))
    assert first(found["a"]) == pytest.approx(32.2 * 24 / 28)
    assert first(found["mu_needed"]) == pytest.approx(24 / 28)


def test_what_lifts_off_rests_on_its_inertia() -> None:
    text = BIKE.replace(", mu_needed: F/N(R)", "")
    with pytest.raises(NoSolution) as error:
        solve(text.replace("NOW", "F = 0.9*N(R)").replace("SIDE", "1").replace("INERTIA", "any"))
    (told,) = error.value.diagnostics
    assert "`any`" in (told.hint or "") or told.code == "PL614"


PINNED = """
title: Rod that a torque turns
plane: vertical
points: {O: [0, 0], A: {from: O, distance: 1 m, angle: -30 deg}, G: {midpoint: [O, A]}}
bodies: {d: BODY}
joints:
  - pin: {at: O, between: [ground, d]}
loads:
  - torque: {body: d, moment: 3 N*m}
states: {1: [t = 0, at rest], 2: [t = 0.2 s]}
find: {w: omega(d) @ 2}
"""
THROWN = """
title: Ball with drag
plane: vertical
bodies: {d: {particle: [0, 0], mass: any}}
loads:
  - drag: {body: d, magnitude: 0.1 kg/m * v(d).mag^2}
states: {1: [t = 0, v(d).x = 5 m/s, v(d).y = 8 m/s], 2: [v(d).y = 0]}
find: {h: y(d) @ 2}
"""


@pytest.mark.parametrize(
    ("text", "what"),
    [
        (PINNED.replace("BODY", "{rod: [O, A], mass: any}"), "the mass of d"),
        (PINNED.replace("BODY", "{rod: [O, A], mass: 2 kg, inertia: any}"), "the moment of inertia of d"),
        (PINNED.replace("BODY", "{points: [O, A], center: G, mass: 3 kg}"), "the moment of inertia of d"),
        (THROWN, "the mass of d"),
    ],
)
def test_a_motion_that_was_followed_rests_on_it(text: str, what: str) -> None:
    with pytest.raises(NoSolution) as error:
        solve(text)
    (told,) = error.value.diagnostics
    assert (told.code, told.message) == (
        "PL614",
        f"the motion depends on {what}, which is not given and does not cancel",
    )
