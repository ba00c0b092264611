"""Lines of a page that would not hold: divisions by what is zero, roundings as numbers, derivatives, what is given."""

from __future__ import annotations

from worked import page_of_file

from planar_cli.formats.terminal import Terminal
from planar_cli.problem.structure import load_text
from planar_cli.report.page.narrate import narrate
from planar_cli.solve.run import solve_problem


def page(text: str) -> str:
    return Terminal(width=110).render(narrate(solve_problem(load_text(text)[0])))


CATCHER = """
title: Cart that rolls against a buffer spring
plane: vertical
given: {m: 10 kg, v: 1.2 m/s, k: 500 N/m}
points: {C: [1 m, 0], F: [6 m, 0]}
bodies: {cart: {particle: C, mass: m}}
joints: [guide: {body: cart, along: 0 deg, name: rails}]
loads: [spring: {between: [C, F], stiffness: k, natural_length: 2 m, acts: push}]
states:
  1: [t = 0, v(cart).x = v]
  2: [v(cart).x = 0]
find: {t_2: t @ 2}
"""


def test_nothing_is_divided_by_zero() -> None:
    """The cart meets the spring in its place of rest: arctan(v/((x - x_eq) ω_n)) has no number."""
    text = page(CATCHER)
    assert "(4 - 4)" not in text
    assert "arctan" not in text
    assert "= 1.2 cos(7.071 (t_2 - " in text


MISSILE = """
title: Missile launched upward and aside
plane: horizontal
given: {R: 6370 km, v_0: 6 km/s, phi: 60 deg, gs: 9.81 m/s^2, m: 1 kg}
points: {O: [0, 0], P: [0, R]}
bodies: {missile: {particle: P, mass: m}}
loads: [force: {body: missile, magnitude: m*gs*R^2/r(missile).mag^2, towards: O}]
states:
  start: [t = 0, v(missile).mag = v_0, v(missile).angle = phi]
  top: [r(missile).mag is largest]
find: {h: r(missile).mag @ top - R in km}
"""


def test_a_rounding_is_no_coefficient() -> None:
    text = page(MISSILE)
    assert "×10⁻⁶" not in text
    assert "0 = 6.37×10⁶ φ̇_missile,start + 3000   in m/s" in text


PEG = """
title: Peg in a cardioid slot
given: {v_P: 4 ft/s, a_P: 30 ft/s^2}
coordinates: {theta: deg}
points: {P: [0.5 ft * (1 - cos(theta))*cos(theta), 0.5 ft * (1 - cos(theta))*sin(theta)]}
bodies: {peg: {particle: P}}
instant: [theta = 180 deg, v(peg).mag = v_P, a(peg).mag = a_P, dot(theta) > 0, ddot(theta) > 0]
find: {theta_dot: dot(theta), theta_ddot: ddot(theta)}
"""


def test_a_place_is_differentiated_as_often_as_it_is() -> None:
    """Both levels are found together: the speeds are first derivatives, in ft/s."""
    rows = page(PEG).splitlines()
    first = next(i for i, row in enumerate(rows) if "v_y + θ̇ = 0" in row)
    assert rows[first].endswith("in ft/s")
    assert rows[first - 1].endswith(" differentiated:")
    second = next(i for i, row in enumerate(rows) if "θ̈ + a_y = 0" in row)
    assert rows[second].endswith("in ft/s²")
    assert rows[second - 1].endswith(" differentiated twice:")


DISK = """
title: Spinning disk caught at a point of its rim
plane: horizontal
symbols: {m: kg, r: m, w: rad/s}
points: {G: [0, 0], A: [r, 0]}
bodies: {disk: {disk: G, radius: r, mass: m, points: [A]}}
joints: [pin: {at: A, between: [ground, disk], during: 1->2}]
states:
  1: [v(G).x = 0, v(G).y = 0, omega(disk) = w]
  2: [just after 1]
find: {w_2: omega(disk) @ 2, kick: impulse(A).mag @ 1->2}
"""


def test_an_impulse_that_follows_is_not_given() -> None:
    text = page(DISK)
    assert "as given" not in text
    assert "J_Ax = 0" in text


def test_an_impulse_that_the_file_gives_is_given() -> None:
    assert "no impulse in the blow from 1 to 2, as given: J_Ay = 0" in page_of_file("where-a-bat-meets-the-ball")


BED = """
title: Dump bed raised by a hydraulic cylinder
points: {O: [0, 0], A: [1 m, -0.5 m], B: {from: O, distance: 1.5 m, angle: 30 deg}}
bodies: {bed: {rod: [O, B]}}
joints: [pin: {at: O, between: [ground, bed]}]
motion: [dot(r(B/A).mag) = 0.15 m/s]
find: {w: omega(bed), alpha: alpha(bed)}
"""


def test_a_number_that_hides_a_length_gives_no_unit() -> None:
    """The distance AB grows by 1.089 m for each radian: 1.089 α is not in 1/s²."""
    (row,) = (row for row in page(BED).splitlines() if "1.089 α = 0.20357 · 0.13776² = 0.003863" in row)
    assert row.endswith("0.003863")


def test_the_derivative_of_a_given_velocity_is_an_acceleration() -> None:
    assert "differentiated (2) -R α = 1/2 in m/s²" in page_of_file("body-wheel-rim-point")
