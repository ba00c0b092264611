"""Where one surface ends and another begins: a corner is rounded, and anything else that changes a speed is a blow."""

from __future__ import annotations

from decimal import Decimal
from math import cos, radians, sin
from types import SimpleNamespace
from typing import Any

import pytest
import sympy as sp
from answered import first, solve

from planar_cli.equation.values.exact import Valuation
from planar_cli.errors import NOWHERE, NoSolution
from planar_cli.formats.terminal import Terminal
from planar_cli.problem.structure import load_text
from planar_cli.report.page.narrate import narrate
from planar_cli.solve.between.branches.agreement import demand_fulfilled
from planar_cli.solve.instant.verify import Disagreement
from planar_cli.solve.regimes.equations import Equation
from planar_cli.solve.run import solve_problem

G, BETA = 9.81, radians(20)
SLEDGE = """
title: Sledge down a slope and out over level snow
plane: vertical
given: {beta: 20 deg, L: 30 m, mu: 0.1}
points: {E: [0, 0], P: {from: E, distance: L, angle: 180 deg - beta}}
surfaces:
  slope: {through: E, angle: -beta}
  level: {through: E, angle: 0 deg}
bodies: {sledge: {particle: P, mass: 60 kg}}
joints:
  - contact: {between: [sledge, slope], mu: mu, during: 1->2}
  - contact: {between: [sledge, level], mu: mu, during: 2->3}
states: {1: [t = 0, at rest], 2: [x(sledge) = 0], 3: [v(sledge) = 0]}
find: {v: v(sledge).mag @ 2, d: x(sledge) @ 3}
"""
BLOW = (
    SLEDGE.replace("during: 2->3", "during: 2->4")
    .replace("3: [v(sledge) = 0]", "3: [just after 2], 4: [v(sledge) = 0]")
    .replace("x(sledge) @ 3", "x(sledge) @ 4")
)
UP = """
title: Block that runs up a ramp
plane: vertical
given: {beta: 30 deg, mu: 0.2}
points: {E: [0, 0], P: [-2 m, 0]}
surfaces: {floor: {through: E, angle: 0 deg}, ramp: {through: E, angle: beta}}
bodies: {block: {particle: P, mass: 3 kg}}
joints:
  - contact: {between: [block, floor], mu: mu, during: 1->2}
  - contact: {between: [block, ramp], mu: mu, during: 2->3}
states: {1: [t = 0, v(block).x = 6 m/s], 2: [x(block) = 0], 3: [v(block) = 0]}
find: {h: y(block) @ 3}
"""
BOWL = """
title: Particle down a bowl and out over a floor
plane: vertical
given: {R: 1 m}
points: {O: [0, R], P: [-R, R], E: [0, 0]}
surfaces:
  bowl: {center: O, radius: R}
  floor: {through: E, angle: 0 deg}
bodies: {P: {particle: P, mass: 1 kg}}
joints:
  - contact: {between: [P, bowl], mu: 0, during: 1->2}
  - contact: {between: [P, floor], mu: 0.2, during: 2->3}
states: {1: [t = 0, at rest], 2: [x(P) = 0], 3: [v(P) = 0]}
find: {v: v(P).x @ 2, d: x(P) @ 3}
"""
CAUGHT = """
title: Ball caught by a cord
plane: vertical
given: {L: 1 m}
points: {O: [0, 0], P: [0.5 m, 0]}
bodies: {ball: {particle: P, mass: 1 kg}}
joints:
  - rope: {path: [O, P], during: 2->3}
states: {1: [t = 0, at rest], 2: [r(P/O).mag = L], 3: [x(ball) = 0]}
find: {v: v(ball).mag @ 3}
"""
SAID = "At 2 the corner is rounded and smooth: the speed is kept."


def page(text: str) -> str:
    problem, _ = load_text(text)
    assert problem is not None
    return Terminal().render(narrate(solve_problem(problem)))


def test_the_speed_is_kept_at_a_corner() -> None:
    found = solve(SLEDGE)
    square = 2 * G * 30 * (sin(BETA) - 0.1 * cos(BETA))
    assert first(found["v"]) == pytest.approx(square**0.5)
    assert first(found["d"]) == pytest.approx(square / (2 * 0.1 * G))
    assert first(solve(UP)["h"]) == pytest.approx((36 - 2 * 0.2 * G * 2) / (2 * G) / (1 + 0.2 / 0.5773502691896257))


def test_it_is_said() -> None:
    assert SAID in page(SLEDGE)


def test_a_blow_at_a_corner_takes_what_runs_against_the_floor() -> None:
    v = (2 * G * 30 * (sin(BETA) - 0.1 * cos(BETA))) ** 0.5
    after = v * (cos(BETA) - 0.1 * sin(BETA))
    assert first(solve(BLOW)["d"]) == pytest.approx(after**2 / (2 * 0.1 * G))
    assert SAID not in page(BLOW)


def test_no_corner_where_one_surface_runs_out_into_the_next() -> None:
    """Both contacts are called by the same particle; the second one slips from the beginning."""
    found = solve(BOWL)
    assert first(found["v"]) == pytest.approx((2 * G) ** 0.5)
    assert first(found["d"]) == pytest.approx(1 / 0.2)
    assert SAID not in page(BOWL)


def test_a_cord_that_takes_hold_with_a_jerk_needs_a_state() -> None:
    with pytest.raises(NoSolution) as caught:
        solve(CAUGHT)
    assert [d.code for d in caught.value.diagnostics] == ["PL717"]
    told = CAUGHT.replace("2->3", "2->4").replace("3: [x(ball) = 0]", "3: [just after 2], 4: [x(ball) = 0]")
    # Only what runs across the cord stays: half of the speed of a fall through sqrt(3)/2 m.
    kept = 2 * G * 0.75**0.5 / 4
    assert first(solve(told.replace("@ 3", "@ 4"))["v"]) == pytest.approx((kept + 2 * G * (1 - 0.75**0.5)) ** 0.5)


def test_numbers_that_break_an_equation_are_a_fault() -> None:
    """What is followed and what is written can only differ by a fault of the program: nothing is printed then."""
    x = sp.Symbol("x_3")
    course: Any = SimpleNamespace(
        scene=SimpleNamespace(cancelling=()),
        problem=SimpleNamespace(bodies=(), motion=()),
        equations=(Equation(2 * x - 4, "motion", "the law of x", "3"),),
        stops={"3": SimpleNamespace(letters={x: x})},
        states=[SimpleNamespace(mark=NOWHERE)],
        ledger=SimpleNamespace(units={x: SimpleNamespace(dimension="length")}),
    )
    demand_fulfilled(course, Valuation({x: Decimal(2)}), {x})
    with pytest.raises(Disagreement, match="the law of x"):
        demand_fulfilled(course, Valuation({x: Decimal("2.01")}), {x})


ORBIT = """
title: Satellite launched parallel to the surface
plane: horizontal
given: {R: 6370 km, h: 500 km, v_0: 36900 km/h}
points: {O: [0, 0], S: [R + h, 0]}
bodies: {satellite: {particle: S, mass: 1 kg}}
loads:
  - force: {body: satellite, magnitude: (1 kg)*g*R^2/r(S/O).mag^2, towards: O}
states:
  1: [t = 0, v(satellite).x = 0, v(satellite).y = v_0]
  2: [r(S/O).mag is largest]
find: {r_2: r(S/O).mag @ 2}
"""


def test_a_condition_of_which_every_term_vanishes_is_measured_by_its_letters() -> None:
    """At the apogee x v_x + y v_y = 0, and so is each of the two products."""
    near, speed = 6870e3, 36900 / 3.6
    axis = 1 / (2 / near - speed**2 / (G * 6370e3**2))
    assert first(solve(ORBIT)["r_2"]) == pytest.approx(2 * axis - near, rel=1e-6)
