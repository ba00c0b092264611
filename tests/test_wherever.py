"""A coordinate on which nothing that is asked rests need not be told; where an answer rests on it, it must be."""

from __future__ import annotations

import math

import pytest
from answered import first, solve

from planar_cli.errors import NoSolution
from planar_cli.formats.terminal import Terminal
from planar_cli.problem.structure import load_text
from planar_cli.report.page.narrate import narrate
from planar_cli.solve.run import solve_problem

TABLE = """
title: Block on a table, and a load on a rope over a pulley
plane: vertical
given: {m: 2 kg, M: 5 kg, l: 3 m}
coordinates: {x: m}
points: {A: [-x, 0], D: [0, 0], B: [0, x - l]}
bodies: {block: {particle: A, mass: m}, load: {particle: B, mass: M}}
joints:
  - guide: {point: A, along: 0 deg}
  - guide: {point: B, along: 90 deg}
  - rope: {path: [A, over D, B]}
instant: [at rest]
find: {a: a(load).y, T: tension(A)}
"""
CART = """
title: Cart with a pendulum
plane: vertical
given: {m: 2 kg, M: 5 kg, l: 1 m}
coordinates: {x: m, phi: deg}
points: {C: [x, 0], P: {from: C, distance: l, angle: phi}}
bodies: {cart: {particle: C, mass: M}, bob: {particle: P, mass: m}}
joints:
  - guide: {point: C, along: 0 deg}
  - link: {between: [C, P]}
states:
  1: [phi = -30 deg, at rest]
  2: [phi = -90 deg]
find: {v: v(C).x @ 2, d: x(C) @ 2 - x(C) @ 1}
"""
SPRING = """
title: Cart on a spring
plane: horizontal
coordinates: {x: m}
points: {A: [x, 0], W: [0, 0]}
bodies: {cart: {particle: A, mass: 2 kg}}
joints:
  - guide: {point: A, along: 0 deg}
loads:
  - spring: {between: [W, A], stiffness: 20 N/m, natural_length: 0.5 m}
instant: [at rest]
find: {a: a(cart).x}
"""
DRIVEN = """
title: Pendulum at rest relative to a cart that is driven
plane: vertical
coordinates: {s: m, phi: deg}
points: {C: [s, 0], P: {from: C, distance: 1 m, angle: phi}}
bodies: {cart: {particle: C, mass: 5 kg}, bob: {particle: P, mass: 2 kg}}
joints:
  - guide: {point: C, along: 0 deg}
  - link: {between: [C, P]}
motion: [ddot(s) = 3 m/s^2]
instant: [ddot(phi) = 0, dot(phi) = 0, phi < 0, phi > -180 deg]
find: {phi: phi}
"""


def page(text: str) -> str:
    problem, _ = load_text(text)
    assert problem is not None
    return " ".join(Terminal(400).render(narrate(solve_problem(problem))).split())


def test_at_an_instant_the_place_of_a_block_does_not_matter() -> None:
    """a = -M g/(M + m), T = M m g/(M + m), wherever the block lies."""
    found = solve(TABLE)
    assert first(found["a"]) == pytest.approx(-5 * 9.81 / 7)
    assert first(found["T"]) == pytest.approx(10 * 9.81 / 7)
    assert "x = 1 m; the answers are the same in the other places that were tried" in page(TABLE)


def test_with_the_place_given_it_is_the_same() -> None:
    found = solve(TABLE.replace("[at rest]", "[x = 1 m, at rest]"))
    assert first(found["a"]) == pytest.approx(-5 * 9.81 / 7)


def test_over_time_the_place_where_a_cart_begins_does_not_matter() -> None:
    """The mass centre keeps its place: d = m l cos 30 deg/(M + m)."""
    found = solve(CART)
    assert first(found["d"]) == pytest.approx(2 * 0.8660254038 / 7)
    assert first(found["v"]) == pytest.approx((4 * 9.81 * 0.5 * 2 / (5 * 7)) ** 0.5)
    assert "x begins at 0; the answers are the same in the other places that were tried" in page(CART)


def test_where_an_answer_rests_on_it_it_must_be_told() -> None:
    with pytest.raises(NoSolution) as refused:
        solve(SPRING)
    assert refused.value.diagnostics[0].message.startswith("nothing tells x")
    with pytest.raises(NoSolution) as refused:
        solve(CART.replace("d: x(C) @ 2 - x(C) @ 1", "d: x(C) @ 2"))
    assert refused.value.diagnostics[0].code == "PL623"


def test_the_place_of_what_is_driven_need_not_be_told_where_an_angle_is_sought() -> None:
    """The link is along g - a, so that tan phi = -g/(-a): phi = -180 deg + arctan(g/a)."""
    assert first(solve(DRIVEN)["phi"]) == pytest.approx(math.atan(9.81 / 3) - math.pi)
    assert "s = 0; the answers are the same in the other places that were tried" in page(DRIVEN)
