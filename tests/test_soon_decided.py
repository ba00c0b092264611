"""What seems easy and once took minutes: states that are never reached, roots whose numbers are sines, far turns."""

from __future__ import annotations

from decimal import Decimal
from math import cos, radians, sin, sqrt

import pytest
import sympy as sp
from answered import first, solve

from planar_cli.equation.algebra.quadrature import breaks
from planar_cli.equation.values.exact import Valuation
from planar_cli.errors import Diagnostic, NoSolution, Undecided
from planar_cli.solve.instant.roots import real_roots

IN_SLOTS = """
title: Rod in two slots with a spring
plane: vertical
given: {m: 10 kg, l: 0.4 m, k: 800 N/m, l_0: 0.3 m}
points: {A: [0, l/sqrt(2)], B: [l/sqrt(2), 0], C: [l + l_0, 0]}
bodies: {AB: {rod: [A, B], mass: m}}
joints:
  - guide: {point: A, along: 90 deg}
  - guide: {point: B, along: 0 deg}
loads:
  - spring: {between: [C, B], stiffness: k, natural_length: l_0}
states:
  1: [at rest]
  2: [STATED]
find: {omega: omega(AB) @ 2}
"""
YOYO = """
title: Yo-yo
plane: vertical
given: {m: 0.5 kg, R: 60 mm, r: 10 mm, k_G: 40 mm, h: 0.8 m}
points: {G: [0, 0], T: [r, 0], A: [r, 0.3 m]}
bodies: {yoyo: {disk: G, radius: R, hub: r, mass: m, radius_of_gyration: k_G}}
joints:
  - rope: {path: [A, T on yoyo], name: thread}
states:
  1: [at rest]
  2: [y(G) = h]
find: {v: v(G).mag @ 2}
"""
ON_A_WEDGE = """
title: Block down a free wedge
plane: vertical
symbols: {M: kg, m: kg, h: m, alpha: deg}
points: {P: [0, h], Q: [h/tan(alpha), 0]}
surfaces: {face: {through: P, angle: -alpha, body: wedge}}
bodies:
  wedge: {points: [Q], center: [h/4, h/4], mass: M}
  block: {particle: P, mass: m}
joints:
  - guide: {body: wedge, along: 0 deg}
  - contact: {between: [block, face], at: P, mu: 0}
states:
  1: [t = 0, at rest]
  2: [y(wedge) = h]
find: {v: v(wedge).x @ 2}
"""


def why(text: str) -> Diagnostic:
    """Why there is no solution."""
    with pytest.raises(NoSolution) as refused:
        solve(text)
    return refused.value.diagnostics[0]


def test_what_holds_all_the_time_tells_no_instant() -> None:
    found = why(IN_SLOTS.replace("STATED", "y(B) = 0"))
    assert found.code == "PL621"
    assert found.hint.startswith("`y(B) = 0` holds all the time, and tells no instant")


def test_how_near_a_motion_comes_that_swings() -> None:
    found = why(IN_SLOTS.replace("STATED", "x(B) = 0.5 m"))
    assert found.code == "PL621"
    assert "`x(B) = 0.5 m` is nearest at t = " in found.hint


@pytest.mark.slow
@pytest.mark.parametrize("text", [YOYO, ON_A_WEDGE])
def test_a_motion_that_goes_on_without_end_never_gets_there(text: str) -> None:
    assert why(text).code == "PL621"


FREE_POST = """
title: String that winds up on a post that nothing holds
plane: horizontal
given: {a: 0.1 m, L: 1 m, v_0: 2 m/s}
points: {O: [0, 0], T: [0, a], P: [L, a]}
bodies:
  post: {disk: O, radius: a}
  puck: {particle: P, mass: 0.3 kg}
joints:
  - rope: {path: [P, T on post], name: string}
states:
  1: [t = 0, v(puck).x = 0, v(puck).y = -v_0]
  2: [r(puck).mag = sqrt(a^2 + (L/2)^2)]
find: {t_2: t @ 2}
"""
DRIVEN = """
title: Vibration in letters as the time goes on without end
plane: horizontal
symbols: {m: kg, k: N/m, c: N*s/m, F_0: N, w: rad/s}
coordinates: {x: m}
points: {W: [-1 m, 0], P: [x, 0]}
bodies: {block: {particle: P, mass: m}}
joints:
  - guide: {point: P, along: 0 deg}
loads:
  - spring: {between: [W, P], stiffness: k, natural_length: 1 m}
  - damper: {between: [W, P], coefficient: c}
  - force: {body: block, at: P, magnitude: F_0*sin(w*t), angle: 0 deg}
states:
  1: [t = 0, x = 0, at rest]
  2: [t = infinity]
find: {x_2: x @ 2}
"""


@pytest.mark.slow
def test_what_nothing_holds_is_open() -> None:
    found = why(FREE_POST)
    assert (found.code, found.hint) == ("PL623", "say in state 1 how it moves: `at rest`, or velocities")


@pytest.mark.slow
def test_a_vibration_that_goes_on_has_no_end() -> None:
    with pytest.raises(Undecided, match=r":17: x_2: as the time grows without end, no value was found"):
        solve(DRIVEN)


# --- a mass that is not given ----------------------------------------------------------------------------------------

FAR_SWING = """
title: Pendulum let go almost upright
plane: vertical
given: {l: 0.9 m, phi_0: 170 deg}
points: {O: [0, 0], P: {from: O, distance: l, angle: phi_0 - 90 deg}}
bodies: {ball: {particle: P, mass: any}}
joints:
  - link: {between: [O, P], name: bar}
states:
  1: [at rest]
  2: [t = 2 s]
find: {FIND}
"""


def test_a_far_swing_without_a_mass() -> None:
    found = solve(FAR_SWING.replace("FIND", "v: v(ball).mag @ 2, y: y(ball) @ 2"))
    # By energy, v^2 = 2 g (l cos 10 deg - y).
    v, y = first(found["v"]), first(found["y"])
    assert v * v == pytest.approx(2 * 9.81 * (0.9 * cos(radians(10)) - y))
    # From the integral of the pendulum's law by Runge's method with 20,000 steps.
    assert v == pytest.approx(0.653206, rel=1e-5)


def test_a_tension_that_rests_on_the_mass() -> None:
    found = why(FAR_SWING.replace("FIND", "S: tension(bar) @ 2"))
    assert (found.code, found.mark.line) == ("PL614", 6)


# --- a rope ----------------------------------------------------------------------------------------------------------

OFF_ITS_CIRCLE = """
title: Bob that leaves its circle, until its string is tight again
plane: vertical
given: {L: 1 m}
points: {O: [0, 0], P: [0, -L]}
bodies: {bob: {particle: P, mass: 0.5 kg}}
joints:
  - rope: {path: [O, P], name: string}
states:
  1: [t = 0, v(bob).x = 6 m/s, v(bob).y = 0]
  2: [mode(string) = slack]
  3: [mode(string) = taut]
find: {y_2: y(bob) @ 2, v_2: v(bob).mag @ 2, x_3: x(bob) @ 3, y_3: y(bob) @ 3}
"""


def test_a_string_that_is_tight_again() -> None:
    found = {name: first(value) for name, value in solve(OFF_ITS_CIRCLE).items()}
    # At the height h the pull ends, m v^2/L = m g h/L, and v^2 = v_0^2 - 2 g (L + h).
    h = (36 - 2 * 9.81) / (3 * 9.81)
    assert (found["y_2"], found["v_2"]) == pytest.approx((h, sqrt(9.81 * h)))
    # Then it is thrown along the tangent; the rest is a parabola that comes back to the circle.
    lift, way = sqrt(9.81 * h) * sqrt(1 - h * h), sqrt(9.81 * h) * h
    t = 4 * lift / 9.81
    assert (found["x_3"], found["y_3"]) == pytest.approx((sqrt(1 - h * h) - way * t, h + lift * t - 9.81 / 2 * t * t))
    assert found["x_3"] ** 2 + found["y_3"] ** 2 == pytest.approx(1)


# --- roots -----------------------------------------------------------------------------------------------------------


def roots_of(expr: sp.Expr, x: sp.Symbol) -> list[float]:
    """All roots of an angle [rad]."""
    return [float(root.value) for root in real_roots(expr, x, Valuation({}), False, True)]


def test_a_way_that_takes_no_time_ends_where_it_begins() -> None:
    x, y = sp.symbols("x y", real=True)
    time = 2 * sp.Integral(1 / sp.sqrt(sp.cos(y) - sp.Rational(1, 2)), (y, sp.Rational(1, 3), x))
    assert [root.expression for root in real_roots(time, x, Valuation({}), False, False)] == [sp.Rational(1, 3)]


def test_roots_with_sines_of_any_angle() -> None:
    x = sp.Symbol("x", real=True)
    off = sp.pi * sp.Rational(963, 1800)
    found = roots_of(sp.sin(x) * sp.cos(x - off) - sp.cos(x) / 5 - sp.Rational(1, 7), x)
    assert len(found) == 2
    for v in found:
        assert sin(v) * cos(v - radians(96.3)) - cos(v) / 5 == pytest.approx(1 / 7)


def test_a_root_that_is_there_twice() -> None:
    x = sp.Symbol("x", real=True)
    found = roots_of(sp.expand((sp.sin(x) * sp.cos(x) - sp.sqrt(3) / 4) ** 2), x)
    assert sorted(round(v * 180 / float(sp.pi)) for v in found) == [-150, -120, 30, 60]


@pytest.mark.parametrize(
    ("switch", "place"),
    [
        (lambda x: x * x - 2, Decimal(2).sqrt()),
        (lambda x: (x - 1) ** 3 + x - 1, Decimal(1)),
        (lambda x: (x * x - 2) ** 5, Decimal(2).sqrt()),
        (lambda x: Decimal(1) if 3 * x > 1 else Decimal(-5), Decimal(1) / 3),
        (lambda x: x - Decimal("1e-20"), Decimal("1e-20")),
    ],
)
def test_where_an_integrand_changes(switch: object, place: Decimal) -> None:
    found = breaks([switch], Decimal(0), Decimal("3.1"))
    assert abs(found[1] - place) <= Decimal("1e-55")
