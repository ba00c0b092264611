"""A time is told by its own integral, t = ∫ dv/a, a speed as the root of its line, roots as one would write them."""

from __future__ import annotations

import pytest
import sympy as sp
from worked import page_of_file

from planar_cli.formats.terminal import Terminal
from planar_cli.problem.structure import load_text
from planar_cli.report.notation.notation import plain
from planar_cli.report.page.narrate import narrate
from planar_cli.solve.run import solve_problem

A, B, C, G, K, M, R, V = sp.symbols("a b c g k m R v_0", positive=True)


def test_a_time_follows_from_the_integral_over_the_speed() -> None:
    page = page_of_file("ball-up-with-drag")
    assert "From hand to top, dv/a = dt:" in page
    assert "terminal speed: v_t = √(m g/c) = √(0.15 · 9.81 / 0.0012) = 35.02 m/s" in page
    assert "t_top = [-v_t arctan(ṡ/v_t)/g] from ṡ = ṡ_hand to 0 (3) t_top = v_t arctan(ṡ_hand/v_t)/g" in page
    assert "with v_t: s̈ = -g (1 + ṡ²/v_t²)" in page
    assert "tan(t_top" not in page


def test_a_time_follows_from_a_velocity_that_is_asked() -> None:
    page = page_of_file("ball-up-with-drag")
    assert page.index("ṡ_back = v_t √(") < page.index("(3) t_back = v_t artanh(ṡ_back/v_t)/g + t_up")


def test_a_speed_is_the_root_of_its_own_line() -> None:
    page = page_of_file("ball-up-with-drag")
    assert "∫[0 → ṡ_back] (v_t² ṡ / (g (v_t² - ṡ²))) dṡ = ∫[0 → h] ds h = [-v_t² ln(v_t² - ṡ²) / (2 g)] from" in page
    assert "ṡ_back² = v_t² - v_t² exp(-2 g h/v_t²)" in page
    assert "ṡ_back = v_t √(1 - exp(-2 g h/v_t²))" in page


def test_a_terminal_speed_of_an_earlier_case_is_told_by_its_value() -> None:
    page = page_of_file("ball-up-with-drag")
    assert "As before: v_t = 35.02 m/s." in page
    assert page.count("terminal speed") == 1


def test_a_time_by_the_place_where_the_speed_is_given_by_it() -> None:
    page = page_of_file("speed-falls-with-place")
    assert "From bridge to mill, dx/v = dt, x of raft:" in page
    assert "solved for x" not in page


def test_a_constant_velocity_beside_it_is_plainer() -> None:
    page = page_of_file("body-ladder-drawn-away")
    assert "t_2 = (x_A,2 - x_A,1)/v_A" in page
    assert "dθ/ω" not in page


def test_a_place_at_a_time_is_no_matter_of_the_time_by_the_place() -> None:
    page = page_of_file("body-ladder-point-in-time")
    assert "x_A,later = x_A,start + u t_later" in page


def test_an_integral_that_only_numbers_close_stands_once_and_says_so() -> None:
    page = page_of_file("pendulum-swinging-far")
    assert page.count("∫") == 3
    assert "(5), by trial values: θ_later = " in page
    assert "= 0.5106 s by numerical integration" in page


def test_what_an_integral_is_over_stands_in_letters() -> None:
    page = page_of_file("parachutist")
    assert "∫[0 → t_after_5] v_t tanh(g t/v_t) dt" in page


def test_logarithms_of_numbers_stand_as_one() -> None:
    assert "t_third = ln(w/φ̇_third)/k = ln(3/2)/k" in page_of_file("flywheel-slowing")


@pytest.mark.parametrize(
    ("expr", "text"),
    [
        (-A * sp.sqrt(2 * K / (3 * M)), "-a √(2 k/(3 m))"),
        (sp.sqrt(1 / (2 * C * B)), "√(1/(2 c b))"),
        (2 * sp.pi * sp.sqrt(7 * R / (5 * G)), "2 π √(7 R/(5 g))"),
        (sp.sqrt((2 * C**3 * V**2 - B * A**4) / (2 * C**3)), "√((2 c³ v_0² - a⁴ b) / (2 c³))"),
        ((2 * C**3 * V**2 / B) ** sp.Rational(1, 4), "(2 c³ v_0²/b)^(1/4)"),
        (sp.sqrt(3) * A / 2, "√3 a/2"),
        (A * sp.sqrt(2 / K) / 4, "1/4 a √(2/k)"),
        (A ** sp.Rational(3, 2) / 3, "a^(3/2)/3"),
    ],
)
def test_a_number_that_a_root_shares_with_the_denominator_stands_once(expr: sp.Expr, text: str) -> None:
    assert plain(expr) == text


def test_a_free_vibration_is_told_over_time_before_what_it_is_at_a_state() -> None:
    page = page_of_file("damped-block-three-ways")
    motion = "From 1 on, under-damped, ζ < 1: x = x_0 exp(-ζ ω_n t) (ζ ω_n sin(ω_d t)/ω_d + cos(ω_d t))"
    assert page.index(motion) < page.index("At cross: (2) ζ ω_n sin(ω_d t_cross)/ω_d + cos(ω_d t_cross) = 0")
    assert "At turn: (4) sin(ω_d t_turn) = 0" in page
    assert page.count("under-damped") == 1


def test_the_impulse_of_a_force_in_numbers_is_an_integral() -> None:
    page = page_of_file("block-fading-force")
    assert "impulse = ∫[0 → t_fast] (20 - 4 t) dt = 50 N·s" in page
    assert "impulse = ∫[0 → t_stop] (20 - 4 t) dt = 20 t_stop - 2 t_stop² in N·s" in page
    assert "v_fast = 50/5 = 10 m/s" in page


def test_a_relation_that_says_a_number_stands_once() -> None:
    page = page_of_file("block-fading-force")
    assert "where its derivative is zero: (2) 20 - 4 t_fast = 0 (2): t_fast = 20/4 = 5 s" in page


def test_the_impulse_of_a_tabulated_force_is_an_integral_of_its_letter() -> None:
    page = page_of_file("block-force-table")
    assert "impulse = ∫[0 → t_1] F_carriage dt = 50 N·s" in page
    assert "impulse = ∫[0 → t_fast] F_carriage dt = 50 t_fast - 50 in N·s" in page
    assert "solved numerically" not in page


def test_a_line_does_not_say_its_last_side_twice() -> None:
    page = page_of_file("rod-hung-off-its-centre")
    assert page.count("I_O = m d² + I = m (d² + l²/12)") == 2
    assert "= m (d² + l²/12) = m (d² + l²/12)" not in page


def test_a_long_root_of_a_quadratic_is_left_to_its_equation_in_numbers() -> None:
    page = page_of_file("weight-dropped-on-nested-springs")
    assert "(3) in numbers: 860 y_P,3 - 570 - 300 y_P,3² = 0 in lbf·ft (3): y_P,3 = 1.040 ft" in page


PUSHED_ROUND = """
title: Drum that a force turns, at a point of it
plane: vertical
given: {m: 10 kg, R: 0.3 m, F: 20 N}
points: {O: [0, 0], A: [0.2 m, 0]}
bodies: {drum: {disk: O, radius: R, mass: m, points: [A]}}
joints:
  - pin: {at: O, between: [ground, drum]}
loads:
  - force: {body: drum, at: A, magnitude: F, angle: 90 deg}
states:
  1: [at rest]
  2: [theta(drum) = 60 deg]
find: {t_2: t @ 2}
"""


def test_an_angle_over_which_is_integrated_has_no_number() -> None:
    problem, _ = load_text(PUSHED_ROUND)
    assert problem is not None
    page = Terminal(200).render(narrate(solve_problem(problem)))
    assert "= ∫[0 → 1.047] 1/2 · 0.3 √(5 · 10 / (20 sin θ)) dθ" in page
