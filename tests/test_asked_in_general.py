"""What is asked of a point at states has its vector equation and components in the general position."""

from __future__ import annotations

from worked import page_of_file

from planar_cli.report.words.origins import kept


def test_a_point_of_a_body_has_its_vector_equation_and_components() -> None:
    page = page_of_file("body-ladder-drawn-away")
    assert "v_By = l ω cos θ = v_A/tan θ" in page
    assert "a_M = α × r_M/A - ω² r_M/A r_M/A = [1/2 l cos θ, 1/2 l sin θ]" in page
    assert "a_Mx = -1/2 l α sin θ - 1/2 l ω² cos θ = 0" in page
    assert "a_My,2 = -v_A²/(2 l sin³ θ_2) = -0.5² / (2 · 4 sin³ 135°) = -0.08839 m/s²" in page


def test_what_holds_at_one_state_is_not_said_of_all() -> None:
    page = page_of_file("body-arm-driven-by-its-angle")
    assert "a_Ax = -l α sin φ - l ω² cos φ a_Ay" in page


def test_a_stated_speed_stands_in_the_letter_that_drives() -> None:
    assert "At 3, v_By = -1 m/s: v_A/tan θ_3 = -1 m/s" in page_of_file("body-ladder-drawn-away")


def test_a_point_that_a_line_leads_stays_on_it() -> None:
    assert kept("wall: place of B across its line") == "B stays on the line wall"
    assert kept("B: place of B across its line") == "B stays on its line"
    assert "At 2, B stays on the line wall: (3) x_A,2 = -l cos θ_2 = -4 cos 135° = 2.828 m" in page_of_file(
        "body-ladder-drawn-away"
    )
