"""A body whose points are written with an angle turns with it: ω = θ̇, in every position."""

from __future__ import annotations

import pytest
from answered import first, solve
from sympy import Expr, Symbol, asin, pi

from planar_cli.formats.terminal import Terminal
from planar_cli.problem.structure import load_text
from planar_cli.report.notation.trigonometric_numbers import right_angles
from planar_cli.report.page.narrate import narrate
from planar_cli.solve.run import solve_problem

THETA, LENGTH = Symbol("theta", positive=True), Symbol("s", positive=True)
ROD = """
title: Rod swinging about a point off its centre
plane: vertical
symbols: {m: kg, l: m, d: m}
coordinates: {theta: deg}
points:
  O: [0, 0]
  G: {from: O, distance: d, angle: theta - 90 deg}
  A: {from: G, distance: l/2, angle: theta + 90 deg}
  B: {from: G, distance: l/2, angle: theta - 90 deg}
bodies: {rod: {rod: [A, B], mass: m, points: [O]}}
joints: [{pin: {at: O, between: [ground, rod]}}]
find: {eom: ddot(theta)}
"""
DISK = """
title: Disk whose rim point is told by a length
plane: vertical
given: {R: 0.2 m, k: 300 N/m, m: 10 kg}
coordinates: {x: m}
points:
  W: [-1 m, R]
  C: [x, 0]
  G: [x, R]
  S: {from: G, distance: R, angle: (pi/2) rad - x/R}
surfaces: {floor: {through: C, angle: 0 deg}}
bodies: {disk: {disk: G, radius: R, mass: m, points: [S]}}
joints: [{rolling: {between: [disk, floor], at: C}}]
loads: [{spring: {between: [W, G], stiffness: k, relaxed_at: [x = 0]}}]
states: {1: [t = 0, x = 0.15 m, disk at rest], 2: [x = 0]}
find: {omega: omega(disk) @ 2, t: t @ 2}
"""


def page(text: str) -> str:
    problem, _ = load_text(text)
    assert problem is not None
    return Terminal().render(narrate(solve_problem(problem)))


def test_the_angle_is_differentiated_not_a_place() -> None:
    told = page(ROD)
    assert "Angle of rod:\n    (1)        θ̈ = α\n" in told
    assert "differentiated" not in told


def test_a_speed_that_nothing_tells_is_not_left_out() -> None:
    """No answer rests on ω, and the acceleration of G has its part all the same."""
    assert "a_G,rod = α × r_G,rod/O - ω² r_G,rod/O" in page(ROD)


def test_a_disk_turns_as_its_rim_point_is_written() -> None:
    found = solve(DISK)
    assert first(found["omega"]) == pytest.approx(0.15 * (2 * 300 / (3 * 10)) ** 0.5 / 0.2)


def test_small_oscillations_are_told_in_their_order() -> None:
    """The highest derivative first, the frequency, then the period by it, under the name that the file gives it."""
    small = ROD.replace("find: {eom: ddot(theta)}", "states: {low: [theta = 0, equilibrium]}\nfind: {T_0: period(low)}")
    told = page(small)
    assert "δ̈ + 12 g d δ / (12 d² + l²) = 0" in told
    assert "T_0 = 2 π/ω_0 = π √((12 d² + l²) / (3 g d))" in told
    assert told.count("T_0 =") == 2


BAR = """
title: Bar let go from an angle with the downward vertical
plane: vertical
given: {L: 1.2 m, phi: 70 deg}
points: {O: [0, 0], P: {from: O, distance: L, angle: -90 deg - phi}}
bodies: {bar: {rod: [O, P], mass: 4 kg}}
joints: [{pin: {at: O, between: [ground, bar]}}]
states: {1: [at rest], 2: [x(P) = 0]}
find: {omega: omega(bar) @ 2}
"""


def test_degrees_and_radians_do_not_stand_in_one_sum() -> None:
    assert "= -(π/2 + φ) = -90° - 70° = -160°\n" in page(BAR)


@pytest.mark.parametrize(
    ("formula", "told", "texts"),
    [
        (pi / 2 - THETA, {THETA: "20°"}, {"90°"}),
        (-(pi + THETA), {THETA: "20°"}, {"180°"}),
        (pi - asin(LENGTH), {LENGTH: "0.4"}, {"180°"}),
        (pi / 2 + LENGTH, {LENGTH: "0.4"}, set()),
        (pi / 2 + THETA + LENGTH, {THETA: "20°", LENGTH: "0.4"}, set()),
    ],
)
def test_multiples_of_pi_are_in_degrees_beside_degrees_alone(
    formula: Expr, told: dict[Symbol, str], texts: set[str]
) -> None:
    assert set(right_angles(formula, told)[1].values()) == texts
