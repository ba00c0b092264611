"""What a file says of its instant, its states and its motion stands in Given, in words that a student reads."""

from __future__ import annotations

import re

import pytest
from conftest import PROBLEMS
from worked import page_of_file

from planar_cli.formats.terminal import Terminal
from planar_cli.problem.language.expression import Relation
from planar_cli.problem.scene.scene import Problem
from planar_cli.problem.structure import load, load_text
from planar_cli.report.document.blocks import Line, Name, Text, Value
from planar_cli.report.given.given_states import laws_given, states_given
from planar_cli.report.notation.names import plain_name
from planar_cli.report.notation.numbers import quantity
from planar_cli.report.page.narrate import narrate
from planar_cli.solve.run import solve_problem

SYNTAX = re.compile(r"[@*^]|->|\.(?:x|y|mag|angle|along|across)\b|\bplace \d|\b[a-z_A-Z]+\([A-Za-z_]+(?:/\w+)?\)")
"""What only a file is written in."""


def _read(told: Line) -> str:
    return "".join(map(_piece, told))


def _piece(piece: object) -> str:
    match piece:
        case Text(text):
            return text
        case Name(name):
            return plain_name(name)
        case Value(number, unit):
            return quantity(number, unit)
    raise AssertionError(piece)


def _rows(problem: Problem) -> list[str]:
    return [", ".join(map(_read, row)) for row in states_given(problem, 4)]


@pytest.mark.parametrize("path", PROBLEMS, ids=lambda p: p.stem)
def test_everything_is_told(path: object) -> None:
    """As many data as statements, but for the beginning of the clock and pairs of bounds; and none in the language of
    a file.
    """
    problem = load(str(path))[0]
    assert problem is not None
    for part in (problem, *(case.problem for case in problem.cases)):
        stated = [s.relations for s in part.states] if part.states else [part.instant or ()]
        for state, row in zip(stated, states_given(part, 4), strict=True):
            clock = [r for r in state if isinstance(r, Relation) and r.text.startswith("t = 0") and state is stated[0]]
            bounds = sum("<" in _read(told).partition("<")[2] or "≤" in _read(told).partition("≤")[2] for told in row)
            assert len(row) == len(set(state)) - len(clock) - bounds
        laws = [_read(told) for told in laws_given(part, 4)]
        assert len(laws) == len(part.motion)
        for told in (*_rows(part), *laws):
            assert not SYNTAX.search(told), told


SCENE = """
title: Two bodies that are spoken of
plane: horizontal
given: {d: 2 m, w: 3 rad/s, mu: 0.2}
symbols: {phi: deg, e: 1}
unknowns: {u: m/s}
points: {O: [0, 0], A: [1 m, 0], B: [2 m, 0]}
bodies:
  rod: {rod: [O, A], mass: 2 kg}
  cart: {particle: B, mass: 1 kg}
joints:
  - pin: {at: O, between: [ground, rod]}
  - flat: {between: [cart, ground], mu: mu, name: seat}
loads:
  - force: {name: push, body: cart, magnitude: 1 N, angle: 0 deg}
states:
  1: [t = 0, v(cart).x = u]
  2: [RELATION]
find: {v: v(cart).mag @ 2}
"""


@pytest.mark.parametrize(
    ("relation", "told"),
    [
        ("theta(rod) - theta(rod) @ 1 = 50 rev cw", "rod has turned 50 rev clockwise since 1"),
        ("theta(rod) @ 2 = theta(rod) @ 1 + phi", "rod has turned φ counterclockwise since 1"),
        ("theta(rod) = theta(rod) @ 1 - 2*pi", "rod has turned 2 π clockwise since 1"),
        ("theta(rod) - theta(rod) @ 1 = phi - 20 deg", "θ_rod - θ_rod,1 = φ - 20°"),
        ("x(cart) - x(cart) @ 1 = d", "x_cart - x_cart,1 = d"),
        ("t = t @ 1 + 3 s", "t = t_1 + 3 s"),
        ("(x(cart) + y(cart)) @ 1 = d", "x_cart,1 + y_cart,1 = d"),
        ("r(B/A).mag = d", "the distance of B from A = d"),
        ("r(B/A).x = d", "x_B - x_A = d"),
        ("v(cart).x = w*r(B/A).x", "v_cart,x = w (x_B - x_A)"),
        ("r(B/A).mag is largest", "the distance of B from A largest"),
        ("v(cart).r = 0", "v_cart,r = 0"),
        ("v(cart).across(cart/O) = 0", "v_cart across O–cart = 0"),
        ("mode(seat) = slip", "slipping at seat"),
        ("friction(seat).mag = mu*N(seat)", "the friction at seat = μ N_seat"),
        ("work(push) @ 1->2 = 3 J", "the work of push from 1 to 2 = 3 J"),
        ("u > 0, u < 3 m/s", "0 < u < 3 m/s"),
        ("u is smallest", "u smallest"),
        ("just after 1", "just after 1"),
        ("equilibrium", "in equilibrium"),
    ],
)
def test_words_of_a_state(relation: str, told: str) -> None:
    problem, wrong = load_text(SCENE.replace("RELATION", relation), "scene.yaml")
    assert problem is not None, wrong
    assert _rows(problem)[1] == f"2: {told}"


@pytest.mark.parametrize(
    ("stem", "told"),
    [
        ("least-speed-to-a-target", "window: x = 40 m, y = 12 m, v_0 smallest"),
        ("racing-car-from-rest-on-a-circle", "a_car,t = a_t; start: at rest"),
        ("ex-4-13", "1: at rest; 2: just after 1; 3: ω_rod = 0"),
    ],
)
def test_as_the_file_says_it(stem: str, told: str) -> None:
    """And not as it is solved: what is tangential is across the radius."""
    assert told in page_of_file(stem)


SATELLITE = """
title: Satellite between its nearest and its farthest point
plane: horizontal
given: {r_A: 6809 km, r_B: 8754 km, GM: 398600 km^3/s^2}
unknowns: {v_A: km/s}
points: {O: [0, 0]}
bodies: {satellite: {particle: [r_A, 0], mass: any}}
loads:
  - force: {body: satellite, magnitude: GM*mass(satellite)/r(satellite).mag^2, towards: O, name: gravity}
states:
  A: [t = 0, v(satellite).x = 0, v(satellite).y = v_A, v_A > 0]
  B: [r(satellite).mag is largest, r(satellite).mag = r_B]
find: {v_A: v_A in km/s}
"""


def test_a_largest_value_that_is_given() -> None:
    """Not its rate, which is zero there, though that is what is solved."""
    problem, wrong = load_text(SATELLITE, "scene.yaml")
    assert problem is not None, wrong
    page = " ".join(Terminal(width=200).render(narrate(solve_problem(problem))).split())
    assert "v_satellite,y = v_A, v_A > 0" in page
    assert "B: |r_satellite| largest, |r_satellite| = r_B Find" in page
    assert "e_r along O–satellite" in page
