"""A largest value over time: the condition, the roots at which it is smallest, and the value in letters."""

from __future__ import annotations

from pathlib import Path

from conftest import PROBLEMS
from worked import page_of_file, page_of_text


def test_the_condition_of_a_largest_value_is_said() -> None:
    page = page_of_file("follower-with-cycloidal-lift")
    told = "a is largest, where its derivative is zero: (2) cos(2 π t_a/T) = 0"
    assert told in page


def test_the_other_roots_are_the_smallest_values() -> None:
    page = page_of_file("follower-with-cycloidal-lift")
    assert "not 3 T/4: there it would be smallest" in page
    assert "the first such time" not in page


def test_the_value_is_told_in_letters_of_the_file() -> None:
    page = page_of_file("follower-with-cycloidal-lift")
    assert "a_max = 2 π h sin(2 π t_a/T)/T² = 2 π h/T² = 2 π · 0.03 / 0.2² = 4.712 m/s²" in page
    assert "v_max = h (1 - cos(2 π t_v/T)) / T = 2 h/T = 2 · 0.03 / 0.2 = 0.3 m/s" in page


def test_a_place_that_the_file_gives_over_time_has_a_line() -> None:
    assert "lift = y_end = h = 0.03 m = 30 mm" in page_of_file("follower-with-cycloidal-lift")


def test_a_formula_that_stands_in_its_line_is_not_said_once_more() -> None:
    line = "a_max = 2 π h sin(2 π t_a/T)/T² = 2 π h/T² = 2 π · 0.03 / 0.2² = 4.712 m/s²"
    assert page_of_file("follower-with-cycloidal-lift").count(line) == 1


def test_an_equation_that_stands_solved_is_not_repeated_in_letters() -> None:
    assert page_of_file("wheel-pulled-uphill").count("a_B = R α") == 2


def test_where_the_motion_starts_it_is_so() -> None:
    assert "not 0°: there it is largest" in page_of_file("body-slider-crank-over-time")


def test_what_lies_after_the_last_state_needs_no_word() -> None:
    """The tension is smallest after 6 s; the drum was followed for 4 s."""
    page = page_of_file("body-hoist-starting-softly")
    assert "t_max = 2 s" in page
    assert "6 s" not in page
    # An angle is no time, however large it is.
    assert "not π - arctan(b/h): there it would be largest" in page_of_file("plate-let-go-at-a-corner")


def test_an_integral_told_with_numbers_has_its_function_of_time() -> None:
    page = page_of_file("body-hoist-starting-softly")
    assert page.count("y_L = 0.6 (t - 4 sin(π t/4)/π) in m") == 1
    assert "y_L,1 = 0.6 (1 - 4 sin 45° / π) = 0.05981 m" in page
    assert "α_1 = 3 π/8 sin 45° = 0.8330 rad/s²" in page
    assert "α_max = 3 π/8 = 1.178 rad/s²" in page
    assert "At any time: a_Ly = R α = 0.4712 sin(π t/4) in m/s²" in page
    assert "= m (g + a_Ly) = 2943 + 141.4 sin(π t/4) in N largest where sin(π t/4) = 1 At max" in page


def test_a_function_of_time_without_a_number_before_it_is_told_too(tmp_path: Path) -> None:
    """R ω = 0.5 m · 2 rad/s (1 - cos(π t/4)): 1 m/s hides in it, and 4 m = 4 is no step."""
    (text,) = (p.read_text() for p in PROBLEMS if p.stem == "body-hoist-starting-softly")
    other = text.partition("note:")[0].replace("R: 0.4 m", "R: 0.5 m").replace("1.5 rad/s)", "2 rad/s)")
    page = page_of_text(tmp_path, other)
    assert "= 1 - cos(π t/4) in m/s" in page
    assert "y_L = t - 4 sin(π t/4)/π in m (4) y_L,1 = 1 - 4 sin 45° / π = 0.09968 m" in page
    assert "(6) y_L,4 = 4 m" in page
