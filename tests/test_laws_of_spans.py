"""What laws tell a motion: size and direction of a velocity, laws of one span, letters that are only assumed about."""

from __future__ import annotations

import math
import re

import pytest
import sympy as sp
from answered import assert_close, first, solve

from planar_cli.formats.terminal import Terminal
from planar_cli.problem.structure import load_text
from planar_cli.report.page.narrate import narrate
from planar_cli.solve.run import solve_problem
from planar_cli.solve.solution import Found

PURSUIT = """
title: A dog runs straight at a cyclist
given: {{u: 5 m/s, v_c: 3 m/s, d: 60 m}}
bodies:
  cyclist: {{particle: [0, 0]}}
  dog: {{particle: [0, -d]}}
motion: [v(cyclist).x = v_c, v(cyclist).y = 0, {laws}]
states:
  1: [t = 0, v(dog).y > 0]
  2: [r(dog/cyclist).mag = 20 m]
find: {{T: t @ 2, y: y(dog) @ 2}}
"""
TRUCK = """
title: Crate on a braking truck
plane: vertical
given: {m: 200 kg, v_0: 20 m/s, s: 50 m, mu: 0.3, M: 8000 kg}
unknowns: {b: m/s^2}
points: {A: [0, 0], C: [0, 1 m]}
surfaces: {bed: {through: C, angle: 0 deg, body: truck}}
bodies:
  truck: {particle: A, mass: M}
  crate: {particle: C, mass: m}
joints:
  - guide: {body: truck, along: 0 deg}
  - contact: {between: [crate, bed], at: C, mu: mu, name: K}
motion: ["a(truck).x = -b during 1->2", "v(truck).x = 0 during 2->3"]
states:
  1: [t = 0, v(truck).x = v_0, v(crate).x = v_0]
  2: [v(truck).x = 0, x(truck) = s]
  3: [mode(K) = stick]
"""
ROCKET = """
title: Rocket in letters
plane: vertical
symbols: {M: kg, q: kg/s, u: m/s, g: m/s^2}
assume: [M*g < q*u]
points: {A: [0, 0]}
bodies: {rocket: {particle: A, mass: M - q*t}}
joints:
  - guide: {body: rocket, along: 90 deg}
loads:
  - stream: {body: rocket, rate: q, leaves: {at: A, speed: u, angle: -90 deg}}
states:
  1: [t = 0, at rest]
  2: [t = M/(2*q)]
find: {v: v(rocket).y @ 2, a: a(rocket).y @ 1}
"""
FADING = """
title: Push that fades along the way
plane: vertical
symbols: {m: kg, F_0: N, L: m, mu: 1, g: m/s^2}
assume: [2*mu*m*g < F_0]
points: {B: [0, 0]}
surfaces: {floor: {through: B, angle: 0 deg}}
bodies: {block: {particle: B, mass: m}}
joints:
  - contact: {between: [block, floor], at: B, mu: mu, name: C}
loads:
  - force: {body: block, magnitude: F_0*(1 - x(block)/L), angle: 0 deg, during: 1->2}
states:
  1: [at rest]
  2: [x(block) = L]
  3: [at rest]
find: {s: x(block) @ 3 - x(block) @ 2}
"""
STOPS = """
title: Cart that is braked and then held
plane: vertical
points: {A: [0, 0], B: [1 m, 0]}
bodies: {cart: {particle: A, mass: 2 kg}, other: {particle: B, mass: 1 kg}}
joints:
  - guide: {point: A, along: 0 deg}
  - guide: {point: B, along: 0 deg}
motion: ["v(cart).x = 3 m/s during 1->2", "v(cart).x = 0 during 2->3"]
states:
  1: [t = 0, v(other).x = 1 m/s]
  2: [t = 4 s]
  3: [t = 6 s]
find: {x: x(cart) @ 3, gap: x(other/cart) @ 3}
"""


def formula(found: Found) -> sp.Expr:
    """The only formula of a find."""
    assert found.expressions is not None
    (expr,) = found.expressions
    return sp.sympify(expr)


# The distance z and its part w along the road: dz/dt = v w/z - u, dw/dt = v - u w/z; so u z + v w goes by v² - u².
@pytest.mark.parametrize(
    "laws",
    [
        "v(dog).mag = u, v(dog).across(dog/cyclist) = 0",
        "v(dog).mag = u, v(dog).angle = r(cyclist/dog).angle",
        "v(dog).along(cyclist/dog) = u, v(dog).across(dog/cyclist) = 0",
    ],
)
def test_size_and_direction_of_a_velocity(laws: str) -> None:
    found = solve(PURSUIT.format(laws=laws))
    ahead = math.sqrt(20**2 - first(found["y"]) ** 2)
    assert_close(found["T"], (5 * 60 - 5 * 20 - 3 * ahead) / 16, digits=8)


def test_a_body_that_a_law_holds_stays_where_it_came_to() -> None:
    found = solve(STOPS)
    assert_close(found["x"], 12)
    assert_close(found["gap"], -5)


SLOWLY = ["b: b, ", "b: b, Q: heat(K) @ 1->3, "]


@pytest.mark.slow
@pytest.mark.parametrize("asked", ["", *(pytest.param(a, marks=pytest.mark.slow) for a in SLOWLY)])
def test_what_slides_is_not_held_because_a_constant_is_sought(asked: str) -> None:
    found = solve(f"{TRUCK}find: {{{asked}x: x(truck) @ 3, c: x(crate) @ 3}}\n")
    assert_close(found["x"], 50)
    assert_close(found["c"], 20**2 / (2 * 0.3 * 9.81))


def test_letters_of_which_something_is_assumed_are_the_same_at_every_state() -> None:
    found = solve(ROCKET)
    M, q, u, g = (sp.Symbol(n, positive=True) for n in ("M", "q", "u", "g"))
    assert sp.simplify(formula(found["v"]) - (u * sp.log(2) - g * M / (2 * q))) == 0
    assert sp.simplify(formula(found["a"]) - (q * u / M - g)) == 0


def test_letters_of_a_way_on_which_a_force_ends() -> None:
    s = formula(solve(FADING)["s"])
    m, F, L, mu, g = (sp.Symbol(n, positive=True) for n in ("m", "F_0", "L", "mu", "g"))
    assert sp.simplify(s - (F * L / (2 * mu * m * g) - L)) == 0


POWER = """
title: Car pulled by an engine of constant power
plane: horizontal
given: {m: 900 kg, P: 45 kW, c: 0.5 N*s^2/m^2}
bodies: {car: {particle: [0, 0], mass: m}}
joints:
  - guide: {body: car, along: 0 deg}
loads:
  - force: {body: car, magnitude: P/v(car).mag, angle: 0 deg, name: engine}
  - drag: {body: car, magnitude: c*v(car).mag^2, name: air}
states:
  1: [t = 0, v(car).x = 5 m/s]
  2: [v(car).x = 25 m/s]
find: {T: t @ 2, W: work(air) @ 1->2}
"""


def test_a_force_without_a_size_at_rest_tells_no_scale_of_time() -> None:
    """P t + W_air = ½ m (v_2² - v_1²)."""
    found = solve(POWER)
    assert_close(found["W"], 0.5 * 900 * (25**2 - 5**2) - 45e3 * first(found["T"]), digits=8)


TWO_GEARS = """
title: Two gears run up from rest
plane: vertical
points: {G1: [0, 0], G2: [0.4 m, 0]}
bodies:
  pinion: {disk: G1, radius: 0.1 m, mass: 4 kg}
  gear: {disk: G2, radius: 0.3 m, mass: 12 kg}
joints:
  - pin: {at: G1, between: [ground, pinion]}
  - pin: {at: G2, between: [ground, gear]}
  - rolling: {between: [pinion, gear]}
loads:
  - torque: {body: pinion, moment: 2 N*m}
states:
  1: [at rest]
  2: [omega(pinion) = 10 rad/s]
find: {turned: theta(pinion) @ 2 - theta(pinion) @ 1}
"""
HANDED_ON = """
title: Blow that is handed on, in letters
plane: horizontal
symbols: {m: kg, v_0: m/s, e: 1, d: m}
assume: [e < 1]
bodies: {A: {particle: [0, 0], mass: 4*m}, B: {particle: [d, 0], mass: 2*m}}
joints:
  - impact: {between: [A, B], normal: 0 deg, restitution: e}
states:
  1: [t = 0, v(A).x = v_0, v(A).y = 0, v(B).mag = 0]
  2: [x(A) = x(B)]
  3: [just after 2]
find: {v_B: v(B).x @ 3, t_2: t @ 2}
"""


def test_gears_that_roll_on_each_other_start_from_rest() -> None:
    """M φ = ½ (I_1 + I_2 (R_1/R_2)²) ω²: what cancels between the accelerations of the rims is no contradiction."""
    assert_close(solve(TWO_GEARS)["turned"], 0.5 * (0.02 + 0.54 / 9) * 10**2 / 2)


def test_no_drawn_number_of_a_letter_is_printed() -> None:
    problem, wrong = load_text(HANDED_ON)
    assert not wrong
    page = Terminal().render(narrate(solve_problem(problem)))
    assert "(1):   t_2 = d/v_0\n" in page
    assert not re.search(r"\d\.\d", page)
