"""A body that only its weight moves is in free flight, without a diagram; each state has one heading."""

from __future__ import annotations

from pathlib import Path

import sympy as sp
from worked import page_of_file, page_of_text

from planar_cli.report.document.blocks import Equation, Math, Paragraph, line
from planar_cli.report.equations.put_into import by_shorter, put_into
from planar_cli.report.page.heads_of_states import with_states_headed_once
from planar_cli.solve.between.trace.trace import Result

X, Y, T, U, V, G = sp.symbols("x y t u v g", real=True)

PUCK = """\
title: Puck that is held back
plane: horizontal
given: {k: 2 m/s^2, v_0: 5 m/s}
bodies: {puck: {particle: [0, 0], mass: any}}
loads:
  - force: {body: puck, magnitude: k*mass(puck), angle: -90 deg}
states:
  1: [t = 0, v(puck).x = v_0, v(puck).y = v_0]
  2: [v(puck).y = 0]
find: {x: x(puck) @ 2}
"""


def test_a_throw_is_a_free_flight() -> None:
    page = page_of_file("ex-1-11")
    assert "STEP 1 Free flight a_x = 0 a_y = -g = -9.81 m/s² only the weight acts" in page
    assert "Newton" not in page


def test_a_body_whose_mass_is_given_has_its_diagram() -> None:
    assert "ball: m g ↓ = m a" in page_of_file("ball-bouncing-twice")


def test_a_force_that_grows_with_the_mass_is_no_weight(tmp_path: Path) -> None:
    page = page_of_text(tmp_path, PUCK)
    assert "puck: m k ↓ = m a_x →, m a_y ↑" in page
    assert "Free flight" not in page


def test_a_distance_along_a_given_line_is_a_multiple_of_one_coordinate() -> None:
    assert "d = √(x_B² + y_B²) = 5 x_B/4 = 5 · 17.84 / 4 = 22.30 m" in page_of_file("ex-1-11")


def test_what_is_put_in_stands_as_it_comes() -> None:
    formulas = {X: V * T, Y: U * T - G * T**2 / 2}
    assert put_into(Y + 3 * X / 4, formulas, T) == (U * T - G * T**2 / 2, -3 * V * T / 4)
    # A height alone on one side says as much sorted.
    assert put_into(Y + 5, formulas, T) is None


def test_the_shorter_equation_gives_the_second_place() -> None:
    one = sp.S.One
    others = ((0, Result(X, V * T, one)), (1, Result(Y, U * T - G * T**2 / 2, one)))
    assert by_shorter(others, 2, Y + 3 * X / 4, {X, Y, T})[1] == (2, Result(Y, -3 * X / 4, one))
    assert by_shorter(others, 2, Y + 5, {X, Y, T}) == others


def test_one_heading_of_a_state() -> None:
    vx, vy = (Math(sp.Symbol(f"v_{axis}__launch")) for axis in "xy")
    at = line("At launch:")
    one, other = Equation((vx, Math(V)), None, at), Equation((vy, Math(U)), None, at)
    told = [Paragraph(at), Equation((vx, Math(V))), Equation((vy, Math(U)))]
    assert with_states_headed_once([one, other]) == told
    assert with_states_headed_once([other, one]) == told
    assert with_states_headed_once([one]) == [one]
    condition = Paragraph(line("At launch, v = u:"))
    assert with_states_headed_once([Paragraph(at), told[1], condition, told[2]]) == [condition, *told[1:]]


def test_bodies_without_forces_have_no_diagram() -> None:
    page = page_of_file("rope-that-jerks-taut")
    assert "STEP 1 Motion without forces From 1 to 2 no force acts on A and B: A stays at rest and B keeps" in page
    assert "so that a_" not in page


TURNING = """\
title: Disk that is pushed for a while
plane: horizontal
given: {m: 3 kg, F: 3 N}
points: {G: [0, 0]}
bodies: {wheel: {disk: G, radius: 0.5 m, mass: m}}
loads:
  - force: {body: wheel, at: G, magnitude: F, angle: 30 deg, during: 2->3}
states:
  1: [v(wheel) = 0, omega(wheel) = 4 rad/s]
  2: [t = 0.5 s]
  3: [t = 2 s]
  4: [t = 3 s]
find: {theta: theta(wheel) @ 4, x: x(wheel) @ 4, a: a(wheel).mag @ 1, b: a(wheel).mag @ 4}
"""


def test_a_body_that_turns_is_not_at_rest(tmp_path: Path) -> None:
    page = page_of_text(tmp_path, TURNING)
    assert "rest" not in page.partition("MOTION")[2].partition("MOTION")[0]
    assert "no force acts on the wheel: the wheel keeps its velocity and its angular velocity." in page


def test_all_stretches_without_forces_are_named(tmp_path: Path) -> None:
    assert "From 1 to 2 and from 3 to 4 no force acts on the wheel" in page_of_text(tmp_path, TURNING)
