"""What nothing joins has a balance of energy of its own: a rod swings up by it while the ball that struck it flies."""

from __future__ import annotations

import pytest
import sympy as sp
from answered import solve
from worked import page_of_file

from planar_cli.errors import NoSolution


@pytest.mark.parametrize(
    ("stem", "headings"),
    [
        ("ball-hits-a-hanging-rod", ["From 2 to 3, rod: work and kinetic energy; A_x, A_y (A is fixed) do no work"]),
        (
            "pendulum-that-rebounds-from-a-block",
            ["kinetic energy; S_cord (normal to the motion) does no work", "From 3 to 5, block: work and"],
        ),
        (
            "arrow-through-a-board",
            ["board: work and kinetic energy; N_board (normal to the motion) does no work"],
        ),
    ],
)
def test_each_group_has_its_own(stem: str, headings: list[str]) -> None:
    page = page_of_file(stem)
    for heading in headings:
        assert heading in page
    assert "∫" not in page.partition("Check")[0]


def test_nothing_that_does_work_leaves_it_to_momentum() -> None:
    page = page_of_file("three-carriages")
    assert "From 2 to 3, no resultant force acts on A along x:" in page
    assert "work and kinetic energy" not in page


def test_what_a_cord_joins_is_one_group() -> None:
    page = page_of_file("cylinder-down-a-slope-and-on-along-a-floor")
    assert "Check work and energy: U = " in page


TURNS_OVER = """
title: Ball that strikes a hanging rod at its end; least speed for which the rod turns over
plane: vertical
symbols: {m: kg, M: kg, L: m, e: 1}
unknowns: {v_0: m/s}
points: {O: [0, 0], B: [0, -L]}
bodies: {rod: {rod: [O, B], mass: M}, ball: {particle: B, mass: m}}
joints:
  - pin: {at: O, between: [ground, rod]}
  - impact: {between: [ball, rod], at: B, normal: 0 deg, restitution: e, during: 1->2}
states:
  1: [rod at rest, v(ball).x = v_0, v(ball).y = 0]
  2: [just after 1]
  3: [theta(rod) = 90 deg, omega(rod) = 0]
find: {v_0: v_0, omega_2: omega(rod) @ 2}
"""


def test_one_group_comes_to_a_top_while_the_other_flies_off() -> None:
    """ω² = 6 g/L; about the pin m v_0 (1 + e) = (M/3 + m) L ω. It takes endless time, so that nobody can say where the
    ball is then.
    """
    found = solve(TURNS_OVER)
    m, rod, length, e, g = sp.symbols("m M L e g", positive=True)
    asked = {"v_0": sp.sqrt(6 * g * length) * (rod + 3 * m) / (3 * m * (1 + e)), "omega_2": sp.sqrt(6 * g / length)}
    for name, right in asked.items():
        (told,) = found[name].expressions
        plain = told.subs({s: sp.Symbol(s.name, positive=True) for s in told.free_symbols})
        assert sp.simplify(plain / right) == 1
    assert sp.count_ops(found["v_0"].expressions[0]) <= 16, "what is the same above and below is cancelled"


@pytest.mark.slow
def test_where_the_other_is_asked_nothing_is_left_out() -> None:
    with pytest.raises(NoSolution):
        solve(TURNS_OVER.replace("omega_2: omega(rod) @ 2", "x: x(ball) @ 3"))
