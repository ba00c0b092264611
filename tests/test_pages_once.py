"""What a page says once, and in the form in which a person would: exercises of the book as new users wrote them."""

from __future__ import annotations

import re

import sympy as sp
from worked import page_of_file

from planar_cli.formats.terminal import Terminal
from planar_cli.problem.structure import load_text
from planar_cli.report.notation.spread import spread
from planar_cli.report.page.narrate import narrate
from planar_cli.solve.run import solve_problem

ON_A_CIRCLE = """
title: Ball pushed round a circle by an arm
source: An Introduction to Planar Dynamics, exercise 3.17
symbols: {r: m, omega: rad/s}
coordinates: {theta: deg}
points:
  O: [0, 0]
  P: {from: O, distance: 2*r*cos(theta), angle: theta}
bodies:
  arm: {rod: [O, theta]}
  ball: {particle: P}
joints:
  - pin: {at: O, between: [ground, arm]}
motion: [dot(theta) = omega]
find: {v_r: v(P/O).r, a: a(P).mag, a_t: a(P).t, a_n: a(P).n, a_theta: a(P/O).theta, radius: rho(P)}
"""


def test_an_equation_goes_on_with_its_numbers() -> None:
    page = page_of_file("exercise-4-46")
    assert "(4) v_Gx,2 = v_C + 1/2 b ω_2 = 0.5511 + 1/2 · 0.4 · 0.4862 = 0.6483 m/s" in page
    assert page.count("v_Gx,2 = v_C") == 1


def test_a_blow_without_an_impulse_has_no_integral() -> None:
    page = page_of_file("exercise-4-46")
    assert "The rope right is slack in the blow: its ends do not move apart, and it exerts no impulse." in page
    assert "0 = 0 N·s" not in page.replace("J_right = 0 N·s", "")
    assert "from state 1 to state 2:" not in page


def test_what_only_keeps_its_value_is_not_lost() -> None:
    assert "lost = 1/2 m v_A,arm,2² = 1/2 · 1.5 · 4.876² = 17.83 J" in page_of_file("exercise-4-44")


def test_a_common_denominator_is_taken_back() -> None:
    assert "w (m a² + 2/5 m R² + I_O) = (2/5 m R² + m (a + s_A,2)² + I_O) ω_arm,2" in page_of_file("exercise-4-44")
    m, a, radius, inertia, t = sp.symbols("m a R I t", positive=True)
    total = m * a**2 + sp.Rational(2, 5) * m * radius**2 + inertia
    assert spread(sp.factor(total * t)) == total * t
    halves = sp.Rational(1, 2) * (m * a**2 + inertia) * t
    assert spread(halves) == halves
    hidden = sp.Rational(1, 15) * t**2 * (15 - t)
    assert spread(hidden) == hidden


def test_a_string_to_a_fixed_point_of_a_turning_body() -> None:
    """The velocity is the absolute one: the point about which the block swings does not turn with the table."""
    page = page_of_file("exercise-3-38")
    assert "v_A,table" not in page
    assert "s_A: the way of A along its path" in page


def test_a_bob_swings_about_the_point_from_which_it_hangs() -> None:
    page = page_of_file("exercise-3-43")
    assert "φ_P: the angle of the radius to P from the x axis" in page
    assert "the negative root: it moves clockwise" in page
    assert "T = m g (1 + 2 (M + m) (1 - cos θ) / M)" in page
    assert "Discussion With θ = 0: v_wagon = 0; T = m g." in page


def test_natural_components_in_letters_have_their_lines() -> None:
    problem, wrong = load_text(ON_A_CIRCLE)
    assert problem is not None, wrong
    page = re.sub(r"\s+", " ", Terminal(200).render(narrate(solve_problem(problem))))
    assert ")/v_P = 0 a_Pn = |" in page
    assert "/v_P = 4 r ω² ρ_P = v_P²/a_Pn = r" in page


def test_a_cord_along_which_all_moves_has_no_normal_acceleration() -> None:
    page = page_of_file("exercise-3-30")
    assert "so that along it the accelerations of both ends agree" in page
    assert "v²/l" not in page
