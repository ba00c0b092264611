"""What is the same all the time has one letter with one number, and what follows over time is told in that letter."""

from __future__ import annotations

from unicodedata import normalize

from conftest import ROOT
from worked import worked

from planar_cli.formats.terminal import Terminal
from planar_cli.problem.structure import load_text
from planar_cli.report.page.narrate import narrate
from planar_cli.solve.run import solve_problem


def page(name: str) -> str:
    """The printed solution of a file."""
    solution, _ = worked(ROOT / "problems" / f"{name}.yaml")
    return Terminal().render(narrate(solution))


def test_an_acceleration_is_told_once_in_numbers() -> None:
    text = page("textbook/ex-1-10")
    assert "α = a_A/r_h = 0.05/0.3 = 0.1667 rad/s²" in text
    assert text.count("= 0.1667 rad/s²") == 1
    assert "ω_2 = ω_1 + α t_2 = 0.3333 + 0.1667 · 2 = 0.6667 rad/s" in text
    assert "θ_2 = ω_1 t_2 + 1/2 α t_2² = " in text


def test_what_is_asked_is_told_in_it() -> None:
    text = page("textbook/ex-1-10")
    assert "a_t = R α = 0.6 · 0.1667 = 0.1 m/s²" in text
    assert "a_Bx,2 = -a_t sin θ_2 - a_n cos θ_2 = -0.1 sin 57.30° - 0.2667 cos 57.30° = -0.2282 m/s²" in text


def test_an_angular_velocity_is_a_letter_too() -> None:
    text = page("textbook/ex-1-09")
    assert "v_E = r_h ω = v = 0.1 m/s" in text
    assert "v_Bx,2 = 0.2 cos 128.2°" in text


def test_a_rate_with_several_numbers_is_named_after_the_states() -> None:
    text = page("motion/car-three-phases")
    assert "̈ = a_start = 2 m/s²" in text
    assert "From brake to stop, constant acceleration of the car along x, ẍ = a_brake = -2.5 m/s²:" in normalize(
        "NFC", text
    )
    assert "t_brake - v_brake/a_brake = 60 - 25/(-2.5) = 70 s" in text


def test_times_are_counted_forward() -> None:
    text = page("energy/flywheel-of-a-punch-press")
    assert "ω_3 = ω_2 + α_2 dt" in text
    assert "dt = (ω_3 - ω_2)/α_2 =" in text


def test_what_varies_elsewhere_is_no_letter() -> None:
    """The jumper falls freely, a_P = g; on the rope a_P is another one at every place."""
    assert "a_low = (m g - k (s_low - l))/m" in page("energy/bungee-jump")


CAR = """
title: A car speeds up
bodies: {car: {particle: [0, 0]}}
given: {a: 2 m/s^2}
motion: [a(car).x = a, v(car).y = 0]
states:
  1: [v(car).x = 0]
  2: [t = 3 s]
find: {v: v(car).x @ 2}
"""


def test_a_name_of_the_file_stays() -> None:
    problem, _ = load_text(CAR)
    solution = solve_problem(problem)
    assert "̈ = a\n" in Terminal().render(narrate(solution))


def test_what_varies_has_its_letter_at_the_state() -> None:
    """The tension after one second by the acceleration then, and not by the law of the drum in numbers."""
    text = page("motion/body-hoist-starting-softly")
    assert "a_Ly,1 = R α_1 = 0.4 · 0.8330 = 0.3332 m/s²" in text
    assert "T_rope,1 = m (g + a_Ly,1) = 300 (9.81 + 0.3332) = 3043 N" in text
    assert "T_1 = T_rope,1 = 3043 N" in text


def test_what_follows_is_told_in_it() -> None:
    text = page("motion/hoist-after-three-seconds")
    assert "y_C,3 = (y_B,0 + 2 y_C,0 - y_B,3 - v_A t_3)/2" in text


def test_a_mass_that_cancels_leaves_numbers() -> None:
    text = page("motion/body-disk-down-a-slope")
    assert "(5):     α = -m g R sin β / (m R² + I_G) = -2 g sin β / (3 R) = -2 · 9.81 sin 20° / (3 · 0.25)" in text


def test_vectors_have_both_components() -> None:
    text = page("impact/dumbbell-hit-by-a-ball")
    assert "x_B,3 = " in text
    assert "y_B,3 = " in text
