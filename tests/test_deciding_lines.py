"""What an exercise in friction turns on is a line of its solution: what is needed beside the most there can be."""

from __future__ import annotations

from worked import page_of_file

from planar_cli.report.notation.latex import words


def test_whether_it_slips_is_decided_by_a_line() -> None:
    page = page_of_file("crate-pulled")
    assert "|F_A| = 108.8 N < μ_s N_A = 0.4 · 341.7 = 136.7 N crate at A does not slip" in page
    assert "it would need |F_A| = P cos 25° = 200 cos 25° = 181.3 N > μ_s N_A = 0.4 · 307.9 = 123.2 N" in page
    assert "state_120: it stays at rest (it does not slip)" in page
    assert "state_200: it slides to the right" in page


def test_which_limit_comes_first_is_told() -> None:
    page = page_of_file("crate-that-slips-or-tips")
    assert "N_C ↑ at x to the right of C" in page
    assert (
        "↺ ΣM_C: N_C x - P y = 0 x = P y/N_C = 235.4 · 0.5 / 588.6 = 0.2 m < b/2 = 0.3 m it slips before it tips"
        in page
    )
    assert "|F_C| = P = 176.6 N < μ N_C = 0.4 · 588.6 = 235.4 N it tips before it slips" in page


def test_friction_that_only_a_parting_contact_leaves_open_has_its_line() -> None:
    page = page_of_file("crate-on-cart")
    assert "|F_A| = m a_K = 20 · 3.924 = 78.48 N < μ N_A = 0.6 · 196.2 = 117.7 N it tips before it slips" in page


def test_what_an_equation_puts_at_its_limit_is_not_checked_against_it() -> None:
    assert "≤ μ N_A = 51.50 N" not in page_of_file("crate-on-cart")


def test_a_blow_without_sliding_tells_its_impulses_in_letters() -> None:
    page = page_of_file("ball-that-grips-a-rough-floor")
    assert "J_F = m (v_x - v_Gx,2) = 2/7 m v_x J_N = m (v_Gy,2 + v_y) = (1 + e) m v_y" in page
    assert "as |J_F| < μ J_N: 2/7 m v_x < μ (1 + e) m v_y" in page


def test_shared_friction_that_does_not_suffice_is_compared_at_its_best() -> None:
    page = page_of_file("ladder-slips")
    assert "no reactions satisfy" not in page
    assert "91.70 N; it would need |F_A| = N_B = 31.99 N > μ N_A = 0.2 · 91.70 = 18.34 N Instead" in page


def test_why_the_second_contact_slips_too_is_told() -> None:
    page = page_of_file("stacked-blocks")
    first = "N_A = m_A g = 5 · 9.81 = 49.05 N, N_B = m_B g + N_A = 8 · 9.81 + 49.05 = 127.5 N; it would need |F_B| = P"
    assert page.count(first) == 2
    second = (
        "Assume lower slides on the floor; upper does not slide on lower Fails then a_B = (P - μ_B N_B)/(m_A + m_B) ="
    )
    assert second in page


def test_the_sign_of_a_comparison_is_one_of_mathematics() -> None:
    assert words(" < ") == r" \lt "
    assert words(" ≥ ") == r" \ge "


def test_two_contacts_of_one_body_that_slip_alike_are_told_once() -> None:
    page = page_of_file("crate-on-cart").partition("CASE")[2]
    assert "Assume crate does not slip at A or B STEP" in page
    limit = "At the largest F: friction at A and B reaches its limit, it is about to slip:"
    assert f"{limit} (1) F_B = μ N_B (2) F_A = μ N_A crate" in page


def test_inner_forces_that_would_only_be_added_again_stay_inside() -> None:
    """Both frictions are known; the sum over cart and crate needs neither."""
    page = page_of_file("crate-on-cart").partition("CASE")[2]
    assert "cart, crate: (6) → ΣF_x: F = (M + m) a_K" in page
    assert "(6): F = (M + m) a_K = (60 + 20) · 2.943 = 235.4 N" in page


def test_the_answer_says_what_begins_at_the_limit() -> None:
    page = page_of_file("crate-that-slips-or-tips")
    assert "P_low = P = 235.4 N; beyond it the crate slips" in page
    assert "P_high = P = 176.6 N; beyond it the crate tips about its right edge" in page
    assert "(assumed)" not in page
    assert page.count("free-body diagram; ΣF = 0, ΣM = 0") == 2
    assert "F_max = F = 313.9 N; beyond it the crate tips about A" in page_of_file("crate-on-cart")
    assert "beyond" not in page_of_file("falling-pole")


def test_normal_forces_stand_before_what_rests_on_them() -> None:
    page = page_of_file("stacked-blocks-joined-over-a-pulley")
    assert "Fails N_A = W_A = 30 lbf, N_B = N_A + W_B = 30 + 50 = 80 lbf; even with |F_A| = μ_1 N_A = 4.5 lbf:" in page
    assert "N_A = m g - μ N_B = 10 · 9.81 - 0.2 · 31.99 = 91.70 N; it would need" in page_of_file("ladder-slips")


def test_friction_is_drawn_as_it_acts_and_a_spool_turns_as_it_is_pulled() -> None:
    page = page_of_file("spool-rolls-or-slips")
    assert "α is counted clockwise, the way in which the loads turn the spool about C. (1)" in page
    assert "↻ ΣM_C: P (R - r_h) = m a_G R + I_G α" in page
    assert "F_C = P - m a_G = 50 - 20 · 0.8989 = 32.02 N" in page
    assert "friction_50 = F_C = 32.02 N to the left" in page


def test_a_trial_that_fails_is_worked_with_positive_numbers() -> None:
    page = page_of_file("spool-rolls-or-slips")
    assert "= 5.393 rad/s² clockwise; it would need |F_C| = P - m R α = 120 - 20 · 0.4 · 5.3933 = 76.85 N >" in page


def test_a_wheel_that_others_hang_on_counts_the_way_its_centre_is_asked() -> None:
    page = page_of_file("rod-on-a-rolling-disk")
    assert "α_disk is counted clockwise, the way in which the disk rolls along a_G." in page
    assert "↻ ΣM_G: F_C R = I_disk α_disk" in page
