"""A place that no statement tells is asked for; it is not solved for from the laws of motion of some assumed mode."""

from __future__ import annotations

from math import cos, sin

import pytest
from answered import first, solve

from planar_cli.errors import NoSolution

NUMBERS, LETTERS = "given: {m: 3 kg, L: 2 m, P: 10 N}", "symbols: {m: kg, L: m, P: N}"
LADDER = """
title: Ladder
plane: vertical
DATA
coordinates: {theta: deg}
points: {A: [0, L*sin(theta)], B: [(SIDE)*L*cos(theta), 0]}
surfaces: {floor: {through: [0, 0], angle: 0 deg}, wall: {through: [0, 0], angle: 90 deg}}
bodies: {ladder: {rod: [A, B], mass: m}}
joints:
  - contact: {between: [ladder, wall], at: A, mu: 0}
  - contact: {between: [ladder, floor], at: B, mu: MU}
loads:
  - force: {body: ladder, at: B, magnitude: P, angle: 90 deg - (SIDE)*90 deg}
instant: [NOW]
find: {alpha: alpha(ladder), N_A: N(A), N_B: N(B)}
"""
SLOTS = """
title: Trammel rod
plane: vertical
DATA
coordinates: {theta: deg}
points: {A: [0, L*sin(theta)], B: [(SIDE)*L*cos(theta), 0]}
bodies: {ladder: {rod: [A, B], mass: m}}
joints:
  - guide: {point: A, along: 90 deg}
  - guide: {point: B, along: 0 deg, mu: MU}
loads:
  - force: {body: ladder, at: B, magnitude: P, angle: 90 deg - (SIDE)*90 deg}
instant: [NOW]
find: {alpha: alpha(ladder), N_B: N(B)}
"""
DOME = """
title: Ball on a dome
plane: vertical
symbols: {m: kg, R: m, v_0: m/s}
coordinates: {theta: deg}
points: {O: [0, 0], P: [R*sin(theta), R*cos(theta)]}
surfaces: {dome: {center: O, radius: R}}
bodies: {ball: {particle: P, mass: m}}
joints:
  - contact: {between: [ball, dome], mu: 0}
instant: [v(ball).mag = v_0]
find: {N: N(ball)}
"""
CORD = """
title: Pendulum on a cord
plane: vertical
given: {m: 2 kg, L: 1 m}
coordinates: {theta: deg}
points: {O: [0, 0], P: [L*sin(theta), -L*cos(theta)]}
bodies: {bob: {particle: P, mass: m}}
joints:
  - rope: {path: [O, P], name: cord}
instant: [at rest]
find: {T: tension(cord), a: a(bob)}
"""
SLOPE = """
title: Crate on a slope
plane: vertical
given: {m: 2 kg, mu: 0.3}
unknowns: {theta: deg}
points: {P: [0, 0]}
surfaces: {slope: {through: P, angle: theta}}
bodies: {crate: {particle: P, mass: m}}
joints:
  - contact: {between: [crate, slope], at: P, mu: mu}
instant: [NOW]
find: {a: a(crate).mag, theta: theta in deg}
"""


def refused(text: str) -> tuple[str, str, str]:
    """The code, the message and the hint."""
    with pytest.raises(NoSolution) as error:
        solve(text)
    (told,) = error.value.diagnostics
    return told.code, told.message, told.hint or ""


def written(text: str, data: str = NUMBERS, now: str = "at rest", side: str = "1", mu: str = "0") -> str:
    return text.replace("DATA", data).replace("NOW", now).replace("SIDE", side).replace("MU", mu)


@pytest.mark.parametrize("text", [LADDER, SLOTS])
@pytest.mark.parametrize("data", [NUMBERS, LETTERS])
@pytest.mark.parametrize(
    ("now", "mu"), [("at rest", "0"), ("omega(ladder) = -1 rad/s", "0"), ("at rest, theta > 30 deg", "0.2")]
)
def test_of_a_rod_on_two_supports(text: str, data: str, now: str, mu: str) -> None:
    code, message, hint = refused(written(text, data, now, mu=mu))
    assert code == "PL606"
    assert message.startswith("nothing tells theta")
    assert "`theta = 50 deg`" in hint
    assert "`symbols: {theta: deg}`" in hint


@pytest.mark.parametrize(
    "text",
    [
        written(LADDER, side="-1"),
        written(LADDER, now="at rest, mode(B) = slip", mu="0.2"),
        written(LADDER).replace("coordinates", "unknowns"),
        DOME,
        CORD,
        written(SLOPE),
    ],
)
def test_of_others(text: str) -> None:
    code, message, _ = refused(text)
    assert (code, message.split(":")[0]) == ("PL606", "nothing tells theta")


def test_what_is_stated_of_accelerations_tells_it() -> None:
    """g (sin θ - μ cos θ) = 2 m/s²."""
    found = solve(written(SLOPE, now="at rest, a(crate).mag = 2 m/s^2, theta > 0"))
    theta = first(found["theta"])
    assert 9.81 * (sin(theta) - 0.3 * cos(theta)) == pytest.approx(2, rel=1e-9)


def test_a_reaction_that_vanishes_tells_it() -> None:
    """Of a smooth ladder without a push the floor carries a quarter of the weight where the wall carries nothing."""
    text = written(LADDER, now="omega(ladder) = 2 rad/s, N(A) = 0").replace("magnitude: P", "magnitude: 0 N")
    found = solve(text)
    assert first(found["N_B"]) == pytest.approx(3 * 9.81 / 4, rel=1e-9)


def test_a_height_that_a_reaction_tells() -> None:
    """A car with locked wheels is about to lift its rear where μ h = c; with them apart N(A) = 0 would say nothing."""
    found = solve("""
title: Car
plane: vertical
given: {m: 1400 kg, mu: 0.7}
unknowns: {h: m}
points: {A: [0, 0], B: [2.6 m, 0], G: [1.4 m, h]}
surfaces: {road: {through: A, angle: 0 deg}}
bodies: {car: {points: [A, B], center: G, mass: m, radius_of_gyration: 1.2 m}}
joints:
  - contact: {between: [car, road], at: A, mu: mu}
  - contact: {between: [car, road], at: B, mu: mu}
instant: [v(G).x = 20 m/s, omega(car) = 0, N(A) = 0]
find: {h: h}
""")
    assert first(found["h"]) == pytest.approx(1.2 / 0.7)
