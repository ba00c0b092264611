"""What no reader of a page needs is not on it."""

from __future__ import annotations

from dataclasses import replace

import pytest
import sympy as sp
from worked import PROBLEMS, page_of_file

from planar_cli.formats.terminal import Terminal
from planar_cli.problem.structure import load_text
from planar_cli.report.document.blocks import Equation, Forces, Math, Paragraph, line
from planar_cli.report.page.idle_lines import without_idle_lines
from planar_cli.report.page.narrate import narrate
from planar_cli.solve.run import solve_problem

v, t_2, t_3, theta_1, theta_2 = sp.symbols("v t__2 t__3 theta__1 theta__2")
BALL, ROD = (Forces(body, line("m g ↓"), line("m a ↑")) for body in ("ball", "rod"))
SUM = Equation((Math(v), Math(2 * v)), 1)
ROOT = Paragraph(line("the positive root: ", "v > 0"))


def test_a_dropped_ball_has_no_sideways_velocity() -> None:
    """It is nought, nothing changes it and nobody asks; the time just after a blow is that just before it."""
    page = page_of_file("ball-bouncing-twice")
    assert "v_x" not in page
    assert "takes no time" not in page
    assert "(t_4 - t_1)" in page


def test_a_blow_without_a_balance_of_momentum_has_no_diagram() -> None:
    """Of the second bounce restitution alone is used; nobody asks for its impulse."""
    page = page_of_file("ball-bouncing-twice")
    assert "Just after 4, restitution between ball and floor, along the common normal: (9) v_5 = -e v_4" in page
    assert page.count("momentum before + impulses") == 1
    assert "loss = m g (h_0 - y_6)" in page


def test_what_is_given_is_not_said_again() -> None:
    page = page_of_file("ex-1-09")
    assert "2: t = 2 s" in page
    assert "t_2 = 2 s" not in page.replace("2: t = 2 s", "")


def test_a_body_that_is_drawn_alone_is_named_once() -> None:
    assert without_idle_lines([BALL, Paragraph(line("ball:")), SUM]) == [BALL, SUM]
    two = [ROD, BALL, Paragraph(line("ball:")), SUM]
    assert without_idle_lines(two) == two


def test_a_line_is_not_printed_twice() -> None:
    told = Equation((Math(v), Math(t_2)))
    assert without_idle_lines([told, told]) == [told]


def test_the_time_of_a_blow_has_one_letter() -> None:
    same = Equation((Math(t_3), Math(t_2)), None, line("At 3:"), line("a blow takes no time"))
    assert without_idle_lines([same, Equation((Math(v), Math(2 * t_3)))]) == [Equation((Math(v), Math(2 * t_2)))]


@pytest.mark.parametrize("used", [False, True])
def test_a_place_that_a_blow_keeps_is_told_where_it_is_used(used: bool) -> None:
    same = Equation((Math(theta_2), Math(theta_1)), None, line("At 2:"), line("nothing moves during a blow"))
    later = Equation((Math(v), Math(theta_2 if used else theta_1)))
    assert without_idle_lines([same, later]) == ([same, later] if used else [later])


def test_the_reason_of_a_root_stands_beside_it() -> None:
    solved = Equation((Math(v), Math(t_2)), None, line("(1):"))
    first, second = without_idle_lines([SUM, solved, ROOT])
    assert first == SUM
    assert isinstance(second, Equation)
    assert second.note == ROOT.line


def test_a_phase_is_chosen_where_it_stands() -> None:
    phase = Equation((Math(2 * t_2), Math(sp.pi)))
    date = Equation((Math(t_2), Math(sp.pi / 2)), None, line("(1):"))
    remark = Paragraph(line("the first such time after ", "the start"))
    assert without_idle_lines([SUM, phase, date, remark]) == [SUM, replace(phase, note=remark.line), date]


def test_a_root_that_is_a_state_before_stands_beside_the_equation() -> None:
    solved = Equation((Math(v), Math(t_2)), None, line("(1):"))
    remark = Paragraph(line(Math(v), " = 0 is state 1", " itself"))
    first, second = without_idle_lines([SUM, solved, remark])
    assert isinstance(first, Equation)
    assert first.note == remark.line
    assert second == solved


def test_an_answer_is_not_called_what_another_state_has() -> None:
    """State 1 is at rest: ω_1 = ω_2, by the name that the file gives to what is asked, would be false there."""
    text = (
        next(p for p in PROBLEMS if p.stem == "ex-4-13")
        .read_text(encoding="utf-8")
        .split("answers:")[0]
        .replace("omega_2: omega", "omega_1: omega")
    )
    problem, wrong = load_text(text)
    assert problem is not None, wrong
    page = " ".join(Terminal(200).render(narrate(solve_problem(problem))).split())
    assert "Answer ω_2 = 2.8125 rad/s counterclockwise (asked for as ω_1)" in page


def test_impulses_that_meet_at_a_point_of_the_file_need_no_other() -> None:
    page = page_of_file("ball-that-grips-a-rough-floor")
    assert "angular momentum about C, through which J_N and J_F pass: (2) ↻ H_C:" in page


def test_a_check_does_not_use_a_letter_of_the_file() -> None:
    """u is the speed of the ball before the blow."""
    told = page_of_file("ex-4-14").partition("Check")[2]
    assert "J (c + c′)/2 = 7.5 (-10 + 8.75)/2" in told
    assert "c, c′: velocity at which the two points part" in told
