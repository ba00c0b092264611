"""Equilibrium beside what `motion` drives: what nothing drives stays where it is, seen from there."""

from __future__ import annotations

from math import atan, hypot, pi, sqrt, tan

import pytest
import sympy as sp
from answered import number, solve

from planar_cli.errors import FileProblem, NoSolution

HUNG = """
title: Rod hung in a carriage that is driven
plane: vertical
{data}
coordinates: {{theta: deg, s: m}}
points: {{A: [s, 0 m], B: {{from: A, distance: L, angle: -90 deg - theta}}}}
bodies: {{car: {{particle: A}}, rod: {{rod: [A, B], mass: m}}}}
joints:
  - guide: {{point: A, along: 0 deg}}
  - pin: {{at: A, between: [car, rod]}}
motion: [a(car).x = a]
instant: [s = 0 m, equilibrium{chosen}]
find: {{theta: theta, pull: reaction(A/rod).x}}
"""
NUMBERS = "given: {m: 5 kg, L: 0.8 m, a: 3 m/s^2}"
LETTERS = "symbols: {m: kg, L: m, a: m/s^2}"
US = "given: {m: 5 lb, L: 2 ft, a: -10 ft/s^2}"
BOB = """
title: Bob on a string in a car
plane: vertical
given: {m: 2 kg, L: 1 m, a: 4 m/s^2}
unknowns: {phi: deg}
points: {A: [0, 0], B: {from: A, distance: L, angle: -90 deg - phi}}
bodies: {car: {points: [A]}, ball: {particle: B, mass: m}}
joints:
  - guide: {body: car, along: 0 deg}
  - rope: {path: [A, B], name: cord}
motion: [a(car).x = a]
instant: [equilibrium]
find: {phi: phi, S: tension(cord)}
"""
WEDGE = """
title: Block on a wedge that stays on it
plane: vertical
given: {m: 2 kg, M: 8 kg, beta: 30 deg}
unknowns: {a: m/s^2}
points: {A: [0, 0], P: [0.2 m, 0.1 m]}
surfaces: {face: {through: P, angle: -beta, body: wedge}}
bodies: {wedge: {points: [A], mass: M}, block: {particle: P, mass: m}}
joints:
  - guide: {body: wedge, along: 0 deg}
  - contact: {between: [block, face], at: P, mu: 0}
motion: [a(wedge).x = a]
instant: [equilibrium]
find: {a: a}
"""
SLOPE = """
title: Rod in a car that runs down a slope
plane: vertical
given: {{m: 5 kg, L: 0.8 m, beta: 20 deg}}
coordinates: {{theta: deg, s: m}}
points: {{O: [0, 0], A: {{from: O, distance: s, angle: -beta}}, B: {{from: A, distance: L, angle: theta - 90 deg}}}}
bodies: {{car: {{particle: A, mass: 20 kg}}, rod: {{rod: [A, B], mass: m}}}}
joints:
  - guide: {{point: A, along: -beta}}
  - pin: {{at: A, between: [car, rod]}}
instant: [s = 1 m, at rest, alpha(rod) = 0{chosen}]
find: {{theta: theta}}
"""
BLOCK = """
title: Rod on a block that is accelerated on a smooth table
plane: horizontal
{data}
coordinates: {{theta: deg, s: m}}
points: {{A: [s, 0], G: {{from: A, distance: r, angle: theta}}}}
bodies:
  block: {{particle: A}}
  rod: {{points: [A], center: G, mass: m, radius_of_gyration: k_A, about: A}}
joints:
  - guide: {{point: A, along: 0 deg}}
  - pin: {{at: A, between: [block, rod]}}
motion: [a(block).x = a]
states:
  1: [t = 0, theta = 0, s = 0, at rest]
  2: [theta = 90 deg]
find: {{omega: omega(rod) @ 2}}
"""


@pytest.mark.parametrize(
    ("data", "chosen", "theta", "pull"),
    [
        (NUMBERS, ", theta > 0 deg", atan(3 / 9.81), 15),
        (NUMBERS, ", theta < 0 deg", atan(3 / 9.81) - pi, 15),
        (US, ", theta > -90 deg, theta < 90 deg", -atan(3.048 / 9.81), -50 / 32.174049),
    ],
)
def test_a_rod_in_a_carriage_stays_where_the_forces_balance(data: str, chosen: str, theta: float, pull: float) -> None:
    found = solve(HUNG.format(data=data, chosen=chosen))
    assert float(number(found["theta"])) == pytest.approx(theta, rel=1e-4)
    assert float(number(found["pull"])) == pytest.approx(pull, rel=1e-5)


def test_it_is_a_formula_in_letters() -> None:
    found = solve(HUNG.format(data=LETTERS, chosen=", theta > 0 deg, theta < 90 deg"))
    (theta,) = found["theta"].expressions or ()
    assert str(theta) == "atan(a/g)"


@pytest.mark.parametrize("text", [HUNG.format(data=NUMBERS, chosen=""), SLOPE.format(chosen="")])
def test_of_two_places_the_file_chooses(text: str) -> None:
    """Hanging or upright: at -20 or at 160 degrees of the rod in a car that runs down a slope of 20 degrees."""
    with pytest.raises(NoSolution) as refused:
        solve(text)
    assert refused.value.diagnostics[0].code == "PL635"


def test_a_car_that_runs_down_a_slope() -> None:
    assert float(number(solve(SLOPE.format(chosen=", theta < 0 deg"))["theta"])) == pytest.approx(-pi / 9)


def test_a_free_bob_goes_along_with_the_car() -> None:
    found = solve(BOB)
    assert float(number(found["phi"])) == pytest.approx(atan(4 / 9.81))
    assert float(number(found["S"])) == pytest.approx(2 * hypot(9.81, 4))


def test_a_block_goes_along_with_its_wedge() -> None:
    """It does not slide down: a = g tan β, and not what the wedge would do alone."""
    assert float(number(solve(WEDGE)["a"])) == pytest.approx(9.81 * tan(pi / 6))


def test_a_relative_equilibrium_is_left_at_a_touch() -> None:
    numbers = BLOCK.format(data="given: {m: 2 kg, r: 0.3 m, k_A: 0.35 m, a: 3 m/s^2}")
    assert float(number(solve(numbers)["omega"])) == pytest.approx(sqrt(2 * 3 * 0.3) / 0.35)
    found = solve(BLOCK.format(data="symbols: {m: kg, r: m, k_A: m, a: m/s^2}"))
    (omega,) = found["omega"].expressions or ()
    assert sp.simplify(omega**2 - sp.sympify("2*a*r/k_A**2").xreplace(_named(omega))) == 0


def _named(expr: sp.Expr) -> dict[sp.Symbol, sp.Symbol]:
    """The letters of a formula by their plain names."""
    return {sp.Symbol(s.name): s for s in expr.free_symbols}


def test_no_body_has_less_inertia_about_a_point_than_its_distance_makes() -> None:
    with pytest.raises(FileProblem) as refused:
        solve(BLOCK.format(data="given: {m: 2 kg, r: 0.3 m, k_A: 0.2 m, a: 3 m/s^2}"))
    (told,) = refused.value.diagnostics
    assert (told.code, told.mark.line) == ("PL544", 9)
