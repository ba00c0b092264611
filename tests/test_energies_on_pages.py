"""Energies between states as they are read: stretches of springs, heights and speeds each in a line of its own."""

from __future__ import annotations

import re

import pytest
import sympy as sp
from conftest import PROBLEMS
from worked import page_of_file

from planar_cli.formats.terminal import Terminal
from planar_cli.problem.structure import load_text
from planar_cli.report.notation.by_geometry import by_geometry
from planar_cli.report.page.narrate import narrate
from planar_cli.solve.run import solve_problem

FILES = {p.stem: p for p in PROBLEMS}


@pytest.mark.parametrize(("stem", "line"), [
    ("ex-4-17", "stretch of the spring OB, s_1 = (2 - √3) l = (2 - √3) · 0.5 = 0.1340 m"),
    ("ex-4-17", "U of the spring OB = 1/2 k (s_1² - s_2²) = 1/2 · 400 (0.13"),
    ("ex-4-17", "v_B,2 = 2 l θ̇_2 sin θ_2 = 0.5 θ̇_2"),
    ("ex-4-17", "1/2 m v_G,AB,2² + 1/2 I_AB θ̇_2²"),
    ("ex-4-10", "y_G,1 = √2 l/4 = √2 · 0.4 / 4 = 0.1414 m"),
    ("box-that-tips-over", "m g (y_G,2 - y_G,3) = 40 · 9.81 (0.5 - 0.5831) = -32.61 J"),
    ("box-that-tips-over", "T_2 = 1/2 I_C ω_2² = 9.067 ω_2²"),
    ("ex-4-10", "v_G,2 = 1/2 l ω_2 B is the instantaneous centre of AB"),
    ("two-hinged-bars-that-collapse", "v_G,BC,2 = 1/2 l θ̇_2 C is the instantaneous centre of BC"),
    ("toppling-pole-that-stops-pressing", "T_2 = 1/2 m v_G,2² + 1/2 I ω_2² = 1/6 m l² ω_2²"),
    ("collar-with-a-slanting-spring", "stretch of the spring coil, δ_2 = √(d² + s_2²) - l_0 = "),
])  # fmt: skip
def test_what_an_energy_is_made_of_has_a_line(stem: str, line: str) -> None:
    assert line in page_of_file(stem)


@pytest.mark.parametrize(("stem", "line"), [
    ("exercise-4-32", "W = M θ_2 = 0.4500 · 62.83 = 28.27 J"),
    ("crate-winched-up-a-slope", "F (s_2 - s_1) = 320 (5 - 0) = 1600 J"),
    ("spinning-wheel-set-down", "Q = ∫[t_1 → t_2] (-μ m g (v_G + R ω)) dt"),
])  # fmt: skip
def test_a_constant_force_times_its_way_is_no_integral(stem: str, line: str) -> None:
    assert line in page_of_file(stem)


def test_a_spring_at_its_own_length_needs_no_stretches() -> None:
    assert "U of the spring buffer = -1/2 k (s_deepest - a)²" in page_of_file("block-down-a-slope-onto-a-buffer")


@pytest.mark.parametrize(("stem", "lines"), [
    ("ex-4-13", "117.7 cos φ_max - 54.44 = 0 in J (2): cos φ_max = 54.4"),
    ("swing-from-which-the-cord-just-holds", "cos φ_0 = 1 - l φ̇_1²/(2 g) = 1 - 2 · 1.85"),
])  # fmt: skip
def test_an_angle_comes_from_its_sine(stem: str, lines: str) -> None:
    assert lines in page_of_file(stem)


def test_g_is_given_where_energies_are_in_numbers() -> None:
    assert "g = 9.81 m/s²" in page_of_file("ex-4-13")


def test_a_height_that_the_guide_keeps_is_none() -> None:
    """With 0 = r sin φ + l sin θ a slider does not rise, and the rod's centre rises with φ alone."""
    r, length, phi, theta = sp.symbols("r l phi theta", positive=True)
    guide = r * sp.sin(phi) + length * sp.sin(theta)
    assert by_geometry(3 * guide, [guide], [phi, theta]) == 0
    assert by_geometry(r * sp.sin(phi) + length * sp.sin(theta) / 2, [guide], [phi, theta]) in (
        r * sp.sin(phi) / 2,
        -length * sp.sin(theta) / 2,
    )


@pytest.mark.parametrize(("stem", "line"), [
    (
        "hoist-driven-by-a-belt",
        "S_1 = m (g + a_Ly,2) = m (2 g h + v_e²) / (2 h) = 150 (2 · 9.81 · 4 + 2²) / (2 · 4) = 1546.5 N",
    ),
    ("load-wound-up-against-axle-friction", "T_up = m (g + r α_1) = 12 (9.81 + 0.15 (-5.338)) = 108.1 N"),
])  # fmt: skip
def test_a_force_is_told_by_the_acceleration_that_is_known(stem: str, line: str) -> None:
    assert line in page_of_file(stem)


@pytest.mark.parametrize(("stem", "line"), [
    ("connecting-rod-on-a-knife-edge", "δ̈ + g (l - a) δ / (k_G² + (l - a)²) = 0"),
    ("connecting-rod-on-a-knife-edge", "I_B = m (l - a)² + I_G"),
    ("connecting-rod-on-a-knife-edge", "↺ ΣM_B: m g (l - a) sin θ = I_B α"),
    ("beam-on-two-ropes", "m g (l/2 - c) - T_A (l - c) = 0"),
    ("block-between-two-springs", "f = ω_0/(2 π) = 15.81/(2 π) = 2.516 Hz"),
])  # fmt: skip
def test_differences_are_positive_and_squares_are_squares(stem: str, line: str) -> None:
    assert line in page_of_file(stem)


@pytest.mark.parametrize(("stem", "line"), [
    ("slider-crank-with-a-spring", "W_spring = U of the spring coil, as above = 2.989 J"),
    ("leaking-bucket", "a_mean = (v_1 - v_0)/t_1 = (53.48 - 0)/12 = 4.457 m/s²"),
    ("leaking-bucket", "(1): a = F/(M - q t) - g"),
    ("leaking-bucket", "y_1 = F t_1/q - F (M - q t_1) ln(M/(M - q t_1)) / q² - 1/2 g t_1²"),
])  # fmt: skip
def test_what_is_known_is_put_in(stem: str, line: str) -> None:
    assert line in page_of_file(stem)


def test_a_law_that_the_equations_gave_is_not_told_again() -> None:
    assert "The law" not in page_of_file("ex-1-06")
    assert "The law" not in page_of_file("ex-1-07")


def test_the_root_of_a_time_by_the_start() -> None:
    assert "ω_0 t_stop = π the first such time after the start (4): t_stop = π √(m/k)" in page_of_file("ex-1-07")
    assert re.search(r"At stop, .{1,2} = 0: \(4\)", page_of_file("ex-1-07"))
    assert "the positive root: t_rest > 0" in page_of_file("turntable-run")
    # Where the velocity is known already, no root of a time is left to choose.
    assert "v_half = v0 - g t_half (4): t_half = (v0 - v_half)/g" in page_of_file("ex-1-06")


@pytest.mark.parametrize(("stem", "line"), [
    ("ex-4-17", "O_x, O_y (O is fixed), N_slider (normal to the motion) do no work, the internal forces"),
    ("ex-4-17", "the internal forces between the bodies no net work:"),
    ("ex-4-08", "N_C, F_C (the point of contact is at rest) do no work:"),
    ("ex-4-13", "A_x, A_y (A is fixed) do no work:"),
])  # fmt: skip
def test_a_force_between_two_bodies_does_work_on_each(stem: str, line: str) -> None:
    assert line in page_of_file(stem)


def test_what_follows_later_is_told_with_the_unknowns_of_the_equations() -> None:
    told = page_of_file("hoist-driven-by-a-belt")
    assert "7 unknowns: a_Ly, a_K, α_motor,disk, T_motor,disk, α_drum, T_rope,1, T_rope,2; in terms of M" in told


@pytest.mark.parametrize(("stem", "line"), [
    ("ex-4-10", "T_2: 1/2 k (s_1² - s_2²) + m g (y_G,1 - y_G,2) = 1/6 m l² ω_2² (1) in numbers: 13.87"),
    ("ex-4-13", "m g AG (cos φ_max - 1) + 1/2 I_A ω_2² = 0 (2) in numbers: 117.7 cos φ_max - 54.44 = 0 in J"),
    ("ex-4-17", "1/2 k (s_1² - s_2²) - m g l sin θ_2 ="),
])  # fmt: skip
def test_a_balance_is_in_letters_before_its_numbers(stem: str, line: str) -> None:
    assert line in page_of_file(stem)


def test_a_guide_lays_a_rod_level() -> None:
    assert "At 2, AB is horizontal: θ_2 = 0 From 1 to 2" in page_of_file("ex-4-10")


def test_equations_that_are_counted_are_those_that_are_named() -> None:
    """Not `3 equations` below four numbers."""
    assert "(5), (6), (8), 3 unknowns: N_C, α_AB, A_y" in page_of_file("two-rods-falling-flat")
    assert "3 equations, 3 unknowns: a_G, α, F_C" in page_of_file("ex-4-05")


@pytest.mark.parametrize(("stem", "line"), [
    ("exercise-4-32", "M = 1/3 m l² θ̈ = 1/3 · 5 · 1.5² · 0.1200 = 0.4500 N·m"),
])  # fmt: skip
def test_an_acceleration_that_speeds_tell_comes_before_its_force(stem: str, line: str) -> None:
    assert line in page_of_file(stem)


@pytest.mark.parametrize(("stem", "line"), [
    ("hoist-driven-by-a-belt", "t_2 = ω_motor,disk,2/θ̈_motor,disk = 2 h/v_e = 2 · 4 / 2 = 4 s"),
    ("hoist-driven-by-a-belt", "α_drum,2 = r_1 θ̈_motor,disk/r_2 = 0.1 · 10 / 0.4 = 2.5 rad/s²"),
])  # fmt: skip
def test_an_acceleration_that_was_told_is_used_by_its_letter(stem: str, line: str) -> None:
    assert line in page_of_file(stem)


@pytest.mark.parametrize(("stem", "line"), [
    ("rod-falling-on-a-smooth-floor", "From 1 to 3, rod: conservation of momentum: (8) → 0 = m "),
    ("ladder-leaving-the-wall", "From 2 to 3, ladder: conservation of momentum"),
])  # fmt: skip
def test_energy_and_momentum_come_before_an_integrating_factor(stem: str, line: str) -> None:
    assert line in page_of_file(stem)
    assert "integrating factor" not in page_of_file(stem)


@pytest.mark.parametrize(("stem", "line"), [
    ("ball-bouncing-twice", "the negative root: it moves downward"),
    ("bob-whose-cord-catches-on-a-nail", "= -6.264 m/s the negative root: it moves to the left"),
])  # fmt: skip
def test_a_root_is_told_by_the_way_in_which_a_body_slides(stem: str, line: str) -> None:
    assert line in page_of_file(stem)


@pytest.mark.parametrize("stem", [
    "car-on-a-circle-in-letters",
    "racing-car-from-rest-on-a-circle",
    "sledge-down-a-slope-and-out-over-level-snow",
])  # fmt: skip
def test_that_a_speed_is_positive_needs_no_word(stem: str) -> None:
    assert "the positive root: it" not in page_of_file(stem)


@pytest.mark.parametrize(("stem", "line"), [
    ("block-fading-force", "20 - 4 t_fast = 0 (2): t_fast = 20/4 = 5 s"),
    ("turntable-run", "2 - t_fastest/2 = 0 (3): t_fastest = 2/0.5 = 4 s"),
    ("there-and-back", "6 t_slowest - 12 = 0 (3): t_slowest = 12/6 = 2 s"),
])  # fmt: skip
def test_a_derivative_that_vanishes_is_told_before_its_time(stem: str, line: str) -> None:
    assert line in page_of_file(stem)


@pytest.mark.parametrize(("stem", "line"), [
    ("block-runs-into-a-spring", "From meets to leaves, simple harmonic motion, x of P:"),
    ("disk-held-by-a-spring", "From 1 on, simple harmonic motion:"),
])  # fmt: skip
def test_a_vibration_is_told_up_to_the_end_of_its_regime(stem: str, line: str) -> None:
    assert line in page_of_file(stem)


def test_no_heading_of_a_rest_that_is_not_integrated() -> None:
    told = page_of_file("block-coming-to-rest-by-dry-friction")
    assert "From stops_2 to end P stays where it is: (10) x_end = x_stops_2 = 0.00228 m" in told
    # A spring that grows stiffer has no half swings of equal times.
    text = FILES["block-coming-to-rest-by-dry-friction"].read_text(encoding="utf-8").partition("find:")[0]
    text = text.replace("k: 200 N/m,", "k: 200 N/m, c: 900 N/m^3,")
    force = "  - force: {body: block, magnitude: -c*x(block)^3, angle: 0 deg}\nstates:"
    find = "  stop: [mode(P) = stick]\nfind: {t_stop: t @ stop}\n"
    problem, wrong = load_text(text.replace("states:", force) + find)
    assert problem is not None, wrong
    told = " ".join(Terminal(400).render(narrate(solve_problem(problem))).split())
    one_way = "from start to fast, from fast to turn_1, from turn_2 to stops: a = (μ m g - c x³ - k x)/m"
    other = "from turn_1 to turn_2, from stops to stops_2: a = -(μ m g + c x³ + k x)/m"
    assert f"{one_way} {other} At stop: t_stop = 1.245 s" in told


def test_what_the_next_part_starts_from_is_told_at_its_state() -> None:
    told = page_of_file("ball-leaving-a-dome")
    assert "At 2: (7) v_Py,2 = -v_P,2 cos φ_P,2 = -3.719 cos 44.82° = -2.638 m/s" in told
    assert "(9) v_Px,2 = v_P,2 sin φ_P,2 = 3.719 sin 44.82° = 2.621 m/s" in told
    assert told.index("(10) x_P,2 = R cos φ_P,2") < told.index("MOTION from 2 to 3")
    assert "the same motion" not in told


@pytest.mark.parametrize(("stem", "line"), [
    (
        "ball-rolling-round-a-loop",
        "v_G,2 = (R - r) φ̇_2 ω_ball,2 = -(R - r) φ̇_2 / r ball rolls without slipping",
    ),
    ("disk-rolling-in-a-trough", "v_G,2 = (R - r) φ̇_2 ω_disk,2 = -(R - r) φ̇_2 / r disk rolls without slipping"),
    ("pendulum-against-a-wall", "v_hit = l φ̇_hit E_k,hit"),
])  # fmt: skip
def test_rolling_is_why_a_ball_turns_and_a_speed_has_the_sign_of_its_rate(stem: str, line: str) -> None:
    """A mass centre with a coordinate of its own moves as that tells, whether its body rolls or not."""
    assert line in page_of_file(stem)


def test_a_speed_that_is_no_product_has_a_place() -> None:
    """x_G and y_G, and their rates, before v_G; each height before the weight falls from it."""
    told = page_of_file("ex-4-17")
    place = "x_G,AB = -3/2 l cos θ, y_G,AB = 1/2 l sin θ "
    assert told.index(place) < told.index("v_G,AB,2 = 1/2 l") < told.index("y_G,OA,2 = 1/2 l sin θ_2")
    assert "y_G,1 - y_G,2 = x_max/2" in page_of_file("ex-4-11")


def test_the_sum_from_which_a_line_goes_on_stands_before_it() -> None:
    told = page_of_file("ex-4-17")
    assert told.index("-1.22625 - 1.22625 + 3.5898 = 1.137 = 0.7708 θ̇_2²") < told.index("√(1.137/0.7708)")


def test_the_root_of_a_speed_that_is_the_state_before_itself() -> None:
    told = page_of_file("bob-whose-cord-catches-on-a-nail")
    assert "not ±6.264 m/s: that is state 2 itself; it goes on in the same sense" in told
    assert "At 2, x_bob = 0. At 2: (3) x_P,2 = 0 m (4) y_P,2 = -l = -2 m" in told


def test_a_size_in_letters_holds_its_unit() -> None:
    assert "|a| = (0.08944/m) v²" in page_of_file("ex-1-13")


def test_another_root_that_is_an_earlier_state() -> None:
    # The flight that begins there.
    assert "= 1.187 s as t_3 ≠ t_1" in page_of_file("ball-bouncing-down-a-slope")


def test_the_energy_of_all_is_not_that_of_the_group_that_was_told() -> None:
    """The balance of the block alone has called its energy T_3 as well."""
    text = FILES["pendulum-that-rebounds-from-a-block"].read_text(encoding="utf-8").partition("answers:")[0]
    problem, wrong = load_text(text.replace("find: {", "find: {share: 1 - KE(all) @ 3 / KE(all) @ 2, "))
    assert problem is not None, wrong
    told = " ".join(Terminal(400).render(narrate(solve_problem(problem))).split())
    assert "T_3 = 1/2 m_A v_A,3² + 1/2 m_B v_B,3² = 1/2 · 1 · 0.8957² + 1/2 · 2.5 · 1.7307² = 4.145 J" in told


def test_an_energy_is_made_of_velocities_that_are_asked() -> None:
    page = page_of_file("rope-that-jerks-taut")
    assert "v_Bx,3 = v_Ax,3 - v_B/A,3 sin β = 1.4313 - 2.1651 sin 34.341° = 0.2099 m/s" in page
    assert "loss = 1/2 m_B (v_Bx,2² + v_By,2²) - 1/2 m_A (v_Ax,3² + v_Ay,3²) - 1/2 m_B (v_Bx,3² + v_By,3²) =" in page
    assert "v_B = [v_Bx,3, v_By,3] = [0.2099, 2.766] m/s" in page
