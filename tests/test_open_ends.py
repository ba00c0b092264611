"""Open ends of rods of given length, angles of rods as roots, and contacts at places that a coordinate tells."""

from __future__ import annotations

from math import cos, pi, radians, sin, sqrt

import pytest
import sympy as sp
from answered import first, solve

from planar_cli.equation.values.exact import Valuation
from planar_cli.problem.structure import load_text
from planar_cli.solve.instant.roots import real_roots

HUNG = """title: Rod on a pin
plane: vertical
given: {m: 2 kg, l: 2 m}
points: {A: [0, 0]}
bodies: {AB: {rod: [ENDS], length: l, mass: m}}
joints:
  - pin: {at: A, between: [ground, AB]}
"""
SLID = """title: Rod in two guides
given: {l: 2 m}
points: {A: [0, 0]}
bodies: {AB: {rod: [A, B], length: l}}
joints:
  - guide: {point: A, along: 90 deg}
  - guide: {point: B, along: 0 deg}
instant: [theta(AB) = -30 deg, v(A).y = -3 m/s]
find: {w: omega(AB), v: v(B).x}
"""
ON_THE_FLOOR = """title: Rod whose end lies on a floor
plane: vertical
given: {m: 2 kg, l: 2 m}
coordinates: {th: deg}
points: {A: [0, 0], B: {from: A, distance: l, angle: th}, W: [0, -1 m]}
surfaces: {floor: {through: W, angle: 0 deg}}
bodies: {AB: {rod: [A, B], mass: m}}
joints:
  - pin: {at: A, between: [ground, AB]}
  - contact: {between: [AB, floor], at: B, mu: 0}
"""


@pytest.mark.parametrize(("ends", "angle"), [("A, B", 30), ("B, A", -150)])
def test_the_angle_of_the_rod_is_told(ends: str, angle: int) -> None:
    asked = f"instant: [theta(AB) = {angle} deg, at rest]\nfind: {{alpha: alpha(AB), x: x(B), a: a(B).mag}}\n"
    found = solve(HUNG.replace("ENDS", ends) + asked)
    alpha = -1.5 * 9.81 / 2 * cos(radians(30))
    assert {n: first(f) for n, f in found.items()} == pytest.approx({"alpha": alpha, "x": sqrt(3), "a": -2 * alpha})


def test_the_place_of_the_end_is_told() -> None:
    asked = "instant: [y(B) = -1 m, x(B) > 0, omega(AB) = 1 rad/s]\nfind: {th: theta(AB)}\n"
    assert first(solve(HUNG.replace("ENDS", "A, B") + asked)["th"]) == pytest.approx(-pi / 6)


def test_it_swings_between_states() -> None:
    asked = "states: {1: [theta(AB) = 0, at rest], 2: [theta(AB) = -90 deg]}\nfind: {w: omega(AB) @ 2}\n"
    assert first(solve(HUNG.replace("ENDS", "A, B") + asked)["w"]) == pytest.approx(-sqrt(1.5 * 9.81))


def test_an_end_of_two_rods_is_placed_by_the_file() -> None:
    text = SLID.replace("bodies: {", "bodies: {CB: {rod: [A, B], length: 1 m}, ")
    _, wrong = load_text(text)
    assert "PL403" in [d.code for d in wrong]


def test_the_angle_of_a_rod_has_one_root() -> None:
    """At half a turn the angle jumps, and its sign changes there without a root."""
    found = solve(SLID)
    assert (first(found["w"]), first(found["v"])) == pytest.approx(
        (3 / (2 * cos(pi / 6)), 3 * sin(pi / 6) / cos(pi / 6))
    )


@pytest.mark.parametrize(("formula", "roots"), [("atan2(2*sin(x), 2*cos(x)) + pi/6", [-pi / 6]), ("1/x + 0*x", [])])
def test_no_root_where_a_function_jumps(formula: str, roots: list[float]) -> None:
    x = sp.Symbol("x", real=True)
    found = real_roots(sp.sympify(formula, {"x": x}), x, Valuation({}), False, True)
    assert [float(r.value) for r in found] == pytest.approx(roots)


def test_a_contact_where_the_first_state_tells_the_coordinate() -> None:
    asked = "states: {1: [at rest, th = -30 deg], 2: [t = 1 s]}\nfind: {alpha: alpha(AB) @ 2, N: N(B) @ 1}\n"
    found = {n: first(f) for n, f in solve(ON_THE_FLOOR + asked).items()}
    assert found == pytest.approx({"alpha": 0, "N": 9.81})


@pytest.mark.parametrize(
    ("instant", "told"),
    [
        ("instant: [at rest, y(B) = -1 m, x(B) > 0]", "only for some th"),
        ("instant: [at rest, th = 10 deg]", "1.347 m off"),
    ],
)
def test_a_contact_that_is_not_there(instant: str, told: str) -> None:
    with pytest.raises(Exception, match=told):
        solve(f"{ON_THE_FLOOR}{instant}\nfind: {{N: N(B)}}\n")


def test_a_rod_with_mass_needs_its_length() -> None:
    """Without it the weight would have no arm about its end."""
    _, wrong = load_text(HUNG.replace("ENDS", "A, 30 deg").replace("length: l, ", "") + "find: {alpha: alpha(AB)}\n")
    assert "PL311" in [d.code for d in wrong]


@pytest.mark.parametrize("asked", ["v(B).mag^2 @ 2", "mode(A) = stick @ 2"])
def test_a_state_stands_behind_the_quantity(asked: str) -> None:
    _, wrong = load_text(
        HUNG.replace("ENDS", "A, B") + f"states: {{1: [at rest], 2: [t = 1 s]}}\nfind: {{q: {asked}}}\n"
    )
    assert "PL212" in [d.code for d in wrong]
