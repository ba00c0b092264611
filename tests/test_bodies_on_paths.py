"""What is told of bodies and particles that a path leads: which point has which acceleration, along which direction."""

from __future__ import annotations

from conftest import ROOT
from worked import worked

from planar_cli.formats.terminal import Terminal
from planar_cli.report.page.narrate import narrate


def _page(name: str) -> str:
    return Terminal(width=140).render(narrate(worked(ROOT / "problems" / f"{name}.yaml")[0]))


def test_only_the_led_point_of_a_turning_body_moves_along_the_path() -> None:
    page = _page("rigid-bodies/bar-on-two-slanting-cords")
    assert "a_A = a_At e_t = [" in page
    assert "a_G = a_A + α × r_G/A = [-1.307, -0.75462 + 0.6 (-11.319)] = [-1.307, -7.546] m/s²" in page
    assert "ρ" not in page, "at rest there is no normal acceleration"


def test_a_particle_in_a_turning_tube_is_summed_along_the_tube() -> None:
    page = _page("motion/ball-in-a-rotating-tube-in-letters")
    assert "m a_P,tube ↗,  2 m v_P,tube ω ↖,  m (r_0 + s_P) ω² ↙" in page, "one arrow for each part"
    assert "ball, along tube:" in page
    assert "0 = m a_P,tube - m (r_0 + s_P) ω²" in page


def test_a_bead_on_a_turning_hoop_is_summed_along_the_wire() -> None:
    page = _page("oscillations/bead-on-a-turning-hoop")
    assert "0 = m a_P,hoop,t + m R ω² sin φ" in page
    assert "m OP ω²" in page, "the distance from the pivot by its ends"


def test_a_block_on_a_free_smooth_wedge_is_summed_along_it() -> None:
    assert "-m g sin β = m a_P,wedge + m a_W cos β" in _page("particles/block-on-wedge")


def test_the_size_of_what_is_positive_is_itself() -> None:
    assert "/|" not in _page("kinematics/car-that-brakes-in-a-bend")


def test_about_a_point_of_contact_the_acceleration_of_the_mass_centre_has_a_moment() -> None:
    page = _page("textbook/ex-4-05")
    assert "spool rolls without slipping:   a_G = R α" in page
    assert "P (R + r) = m a_G R + I_G α" in page
    assert "3 equations, 3 unknowns: a_G, α, F_C" in page
    assert "(1) in (2):     α = P (R + r) / (m R² + I_G)" in page


def test_about_a_pivot_one_moment_of_inertia_is_enough() -> None:
    page = _page("textbook/ex-4-06")
    assert "rod turns about A:   a_G = 1/4 L α" in page
    assert "1/4 m g L = I_A α" in page


def test_a_point_on_a_taut_cord_is_told_to_move_across_it() -> None:
    assert "so that a_P has no component along it, only a_Pt perpendicular to it" in _page("textbook/ex-4-04")


def test_normal_parts_of_two_bodies_are_two_arrows() -> None:
    assert "1/2 m_AB b ω_AB² ↙ at G_AB,  m_AB a ω_OA² ↙ at G_AB" in _page("plans/four-bar-driven")


def test_an_angular_momentum_and_its_impulse_are_told_before_their_balance() -> None:
    page = _page("textbook/ex-4-12")
    assert "about C (C moves parallel to G), through which" in page
    assert "spool rolls without slipping" in page
    assert "H_C,2 = m v_G,2 R + I_G ω_2 = m (R² + k_G²) ω_2" in page
    assert "∫[0 → t_2] q (R + r) t dt = 1/2 q (R + r) t_2² = 187.5 N·m·s" in page


def test_the_speed_of_a_mass_centre_has_its_reason() -> None:
    page = _page("textbook/ex-4-17")
    assert page.count("OA turns about O") == 1, "AB does not turn about it"


def test_a_long_coefficient_that_is_simple_is_written_so() -> None:
    page = _page("systems/wheel-pulled-uphill")
    assert "a_B = R α" in page
    assert "T R - m g R sin β = m a_G R + I_wheel α" in page
    assert page.count("a_G = R α = 0.3 · 5.474 = 1.642 m/s²") == 1, "no line twice"


def test_a_spring_between_drawn_places_has_a_length() -> None:
    page = _page("particles/slider-spring-damper")
    assert "length of the spring coil:   l_coil = √(0.8² + 0.6²) = 1 m" in page
    assert "F_dashpot = -12/13 c_d v = -12/13 · 30 · 1.5 = -41.54 N" in page
    assert "F_s = k_s (l_coil - l_0) = 200 (1 - 0.7) = 60 N" in page


def test_what_the_velocities_tell_is_no_assumption() -> None:
    page = _page("friction/plate-sliding-on-table")
    assert "plate slides on ground, as the velocities tell" in page
    assert "Fails" not in page
    assert "the friction acts through its mass centre" in page


def test_a_belt_is_drawn_by_what_it_turns() -> None:
    page = _page("motion/hoist-driven-by-a-belt")
    assert "T_motor,disk r_1 ↺ by the belt" in page
    assert "at O1  " not in page.replace("O1_x → at O1", "").replace("O1_y ↑ at O1", "")


def test_streams_have_their_sentence() -> None:
    assert "Thrust: mass per second times its velocity relative to rocket, in the opposite direction" in _page(
        "momentum/rocket-up-and-along"
    )
    assert "no velocity relative to bucket: it does not push" in _page("momentum/leaking-bucket")
    assert "where it enters, it pushes plate in its own direction" in _page("momentum/jet-against-a-hinged-plate")


def test_a_time_without_a_value_is_not_told() -> None:
    assert "Answer" in _page("momentum/sand-on-a-conveyor-belt")


def test_numbers_of_places_keep_their_unit() -> None:
    page = _page("textbook/ex-1-14")
    assert "x_P = y_P/tan θ = 0.5 m/tan θ" in page
    assert "= -(0.5 m) " in page


def test_a_rope_tells_the_length_that_it_keeps() -> None:
    page = _page("particles/moving-pulley")
    assert "y_A + 2 y_B = const., differentiated twice:" in page
    assert "a_Ay = -2 a_By" in page


def test_a_ball_on_a_string_is_summed_across_it() -> None:
    page = _page("momentum/pendulum-on-a-wagon")
    assert "ball, perpendicular to the string:" in page
    assert "m g cos φ_ball = m a_O sin φ_ball - m a_ball,wagon,t" in page, "in the sense of its terms"


def test_a_momentum_by_the_speed_of_another_body_has_its_line() -> None:
    page = _page("textbook/ex-4-18")
    assert "ω_rear,2 = ω_front,2 = v/r" in page
    assert "rear and front roll without slipping" in page
    assert "ω_spool,2 = ω_2" not in _page("textbook/ex-4-12")
