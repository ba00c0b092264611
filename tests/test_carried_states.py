"""States without times, led there from the drawing; equilibrium; formulas from one state on; sought constants."""

from __future__ import annotations

import mpmath
import pytest
from answered import FOUR_BAR, assert_close, solve

from planar_cli.errors import NoSolution, PlanarError


@pytest.mark.parametrize("speeds", ["", ", omega(AB) = 2 rad/s"], ids=["places", "speeds"])
@pytest.mark.parametrize(("side", "sign"), [("above", 1), ("below", -1)])
def test_a_four_bar_is_led_to_its_state(side: str, sign: int, speeds: str) -> None:
    """Not answered as drawn, and on the branch that is drawn: C above or below of the line BD."""
    states = f"states:\n  1: [theta(AB) = 60 deg{speeds}]\n  2: [theta(AB) = 135 deg{speeds}]\n"
    found = solve(f"{FOUR_BAR.format(side=side)}{states}find: {{x_C: x(C) @ 2, y_C: y(C) @ 2}}\n")
    x, y = -0.2 / mpmath.sqrt(2), 0.2 / mpmath.sqrt(2)
    across, down = 0.6 - x, -y
    d = mpmath.hypot(across, down)
    along = (0.25 - 0.16 + d**2) / (2 * d)
    off = sign * mpmath.sqrt(0.25 - along**2)
    assert_close(found["x_C"], str(x + (along * across - off * down) / d), 12)
    assert_close(found["y_C"], str(y + (along * down + off * across) / d), 12)


def test_a_state_that_the_linkage_cannot_have() -> None:
    states = "states:\n  1: [theta(AB) = 60 deg]\n  2: [x(B) = 0.3 m]\n"
    with pytest.raises(PlanarError):
        solve(f"{FOUR_BAR.format(side='above')}{states}find: {{y_B: y(B) @ 2}}\n")


SPRING = """
title: Block on a spring
plane: horizontal
{more}
coordinates: {{x: m}}
points: {{W: [-3 m, 0], P: [x, 0]}}
bodies: {{b: {{particle: P, mass: m}}}}
joints:
  - guide: {{point: P, along: 0 deg}}
loads:
  - spring: {{between: [W, P], stiffness: 2 N/m, relaxed_at: [x = 0]}}
"""


@pytest.mark.parametrize("end", ["", ", end: [t = infinity]"])
def test_a_formula_from_the_only_state_on(end: str) -> None:
    damper = "  - damper: {between: [W, P], coefficient: 2 N*s/m}\n"
    text = SPRING.format(more="given: {m: 1 kg}") + damper
    found = solve(f"{text}states: {{1: [t = 0, x = 1 m, at rest]{end}}}\nfind: {{x_t: x}}\n")["x_t"]
    assert found.expressions is not None
    assert {s.name for s in found.expressions[0].free_symbols} <= {"t", "m", "k", "c"}
    assert found.expressions[0].has(next(s for s in found.expressions[0].free_symbols if s.name == "t"))


@pytest.mark.slow
def test_the_first_instant_fixes_a_mass() -> None:
    """Lighter blocks are at x = 0 after 1 s as well, but for the second, third, … time."""
    text = SPRING.format(more="unknowns: {m: kg}")
    found = solve(f"{text}states: {{1: [t = 0, x = 1 m, at rest], 2: [t = 1 s, x = 0]}}\nfind: {{mass: m}}\n")
    assert_close(found["mass"], str(8 / mpmath.pi**2), 12)


def test_a_free_rotation_is_named() -> None:
    with pytest.raises(NoSolution, match="angle of b"):
        solve("""
title: To and fro
given: {w: 1 rad/s, a: 1 m}
coordinates: {x: m}
points: {P: [x, 0]}
bodies: {b: {points: [P], center: P}}
motion: [x = a*sin(w*t)^2]
states: {start: [t = 0], end: [t = (2*pi) s]}
find: {s: path_length(P) @ start->end}
""")


def test_a_flat_square_in_time_is_a_change_point() -> None:
    with pytest.raises(NoSolution, match="change point"):
        solve("""
title: Flat square
points: {A: [0, 0], D: [1 m, 0], B: [1 m, 0], C: [2 m, 0]}
bodies: {AB: {rod: [A, B]}, BC: {rod: [B, C]}, DC: {rod: [D, C]}}
joints:
  - pin: {at: A, between: [ground, AB]}
  - pin: {at: B, between: [AB, BC]}
  - pin: {at: C, between: [BC, DC]}
  - pin: {at: D, between: [ground, DC]}
motion: [omega(AB) = 1 rad/s]
states: {start: [t = 0], after: [t = 0.5 s]}
find: {w: omega(DC) @ after}
""")


def test_an_angle_that_no_regime_kept_is_read_from_the_place() -> None:
    """A ball on a cord swings up, flies with the cord slack and jerks it taut: the parabola that leaves a circle at θ
    from the top comes back to it at 3θ on the other side, where only the speed along the circle is left.
    """
    found = solve("""
title: Ball on a cord
plane: vertical
given: {l: 1 m, v_0: 5.5 m/s}
points: {O: [0, 0], P: [0, -l]}
bodies: {ball: {particle: P, mass: 1 kg}}
joints:
  - rope: {path: [O, P], name: cord}
states:
  start: [t = 0, v(ball).x = v_0, v(ball).y = 0]
  slack: [tension(cord) = 0]
  jerk: [r(ball).mag = l]
  after: [just after jerk]
find: {x: x(ball) @ jerk, y: y(ball) @ jerk, v: v(ball).mag @ after}
""")
    g = mpmath.mpf("9.81")
    theta = mpmath.acos((mpmath.mpf("5.5") ** 2 / g - 2) / 3)
    x, y = -mpmath.sin(3 * theta), mpmath.cos(3 * theta)
    v = mpmath.sqrt(g * mpmath.cos(theta))
    across, down = v * mpmath.cos(theta), mpmath.sqrt((v * mpmath.sin(theta)) ** 2 + 2 * g * (mpmath.cos(theta) - y))
    assert_close(found["x"], str(x), 10)
    assert_close(found["y"], str(y), 10)
    assert_close(found["v"], str(abs(y * across - x * down)), 10)


def test_a_floor_through_a_point_of_a_body_stays_where_it_is_drawn() -> None:
    """Two crates slide on it, each to its own end."""
    found = solve("""
title: Two crates on one floor
plane: vertical
given: {mu: 0.2}
points: {A: [0, 0], B: [1 m, 0]}
surfaces: {floor: {through: A, angle: 0 deg}}
bodies: {A: {particle: A, mass: 2 kg}, B: {particle: B, mass: 3 kg}}
joints:
  - contact: {between: [A, floor], at: A, mu: mu, name: under_A}
  - contact: {between: [B, floor], at: B, mu: mu, name: under_B}
states:
  start: [t = 0, v(A).x = -2 m/s, v(B).x = 3 m/s]
  A_stops: [v(A).x = 0]
  B_stops: [v(B).x = 0]
find: {x_A: x(A) @ A_stops, x_B: x(B) @ B_stops}
""")
    assert_close(found["x_A"], str(-4 / (0.4 * mpmath.mpf("9.81"))), 10)
    assert_close(found["x_B"], str(1 + 9 / (0.4 * mpmath.mpf("9.81"))), 10)
