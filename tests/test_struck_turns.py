"""What a blow turns clockwise counts so through the whole motion: equations, diagrams, roots and answers."""

from __future__ import annotations

import pytest
from conftest import ROOT
from worked import worked

from planar_cli.formats.terminal import Terminal
from planar_cli.problem.structure import load_text
from planar_cli.report.page.narrate import narrate
from planar_cli.solve.run import solve_problem

BALL = """\
title: Ball that is struck
plane: vertical
symbols: {m: kg, R: m, J: N*s, mu: 1}
points: {C: [0, 0], G: [0, R]}
surfaces: {table: {through: C, angle: 0 deg}}
bodies: {ball: {sphere: G, radius: R, mass: m}}
joints:
  - contact: {between: [ball, table], at: C, mu: mu}
loads:
  - impulse: {body: ball, at: G, magnitude: J, angle: WAY, during: 1->2}
states:
  1: [t = 0, at rest]
  2: [just after 1]
  3: ["v(G).x = -omega(ball)*R"]
find: {omega: omega(ball) @ 3}
"""


def _page(stem: str) -> str:
    return " ".join(Terminal(400).render(narrate(worked(ROOT / f"problems/{stem}.yaml")[0])).split())


@pytest.mark.parametrize(("stem", "lines"), [
    ("impact/billiard-ball", [
        "ω is counted clockwise, the way in which the ball turns.",
        "v_G,2 = R ω_2",
        "↻ H_G: J (h - R) = I_G ω_2",
        "ω = J/(m R) clockwise",
        "↻ ΣM_G: μ N_C R = I_G α",
    ]),
    ("impact/box-that-tips-over", [
        "ω is counted clockwise, the way in which the box turns.",
        "ω_2 = √(32.61/9.067) = 1.896 rad/s",
        "m CG ω_2 ↗ at G, I_G ω_2 ↻",
        "↻ H_C: 1/2 m v_0 h = I_C ω_2",
        "ω_2 = 1.896 rad/s clockwise",
    ]),
    ("impact/ball-that-grips-a-rough-floor", [
        "v_Gx,2 = r ω_2",
        "↻ H_C: m v_x r = m v_Gx,2 r + I_G ω_2",
        "ω = 5 v_x/(7 r) clockwise",
    ]),
    ("impact/wheel-over-a-kerb", ["At 1: ω_1 = v_0/R", "↻ H_K: m v_0 (R - h) + I_G ω_1 = I_K ω_2"]),
])  # fmt: skip
def test_what_a_blow_turns_clockwise_is_counted_so(stem: str, lines: list[str]) -> None:
    page = _page(stem)
    assert [x for x in lines if x not in page] == []
    assert "the negative root: it turns" not in page


def test_an_angle_of_which_nothing_speaks_is_not_explained() -> None:
    assert "θ" not in _page("impact/box-that-tips-over")


@pytest.mark.parametrize(("way", "sign"), [("0 deg", -1), ("180 deg", 1)])
def test_answers_keep_their_sign(way: str, sign: int) -> None:
    """The page counts a rotation as the body is struck; what is found counts counterclockwise."""
    problem, wrong = load_text(BALL.replace("WAY", way))
    assert problem is not None, wrong
    solution = solve_problem(problem)
    assert ("ω is counted clockwise" in Terminal(400).render(narrate(solution))) == (sign < 0)
    (formula,) = solution.parts[0].found[0].expressions or ()
    assert formula.could_extract_minus_sign() == (sign < 0)


def test_that_a_motion_just_succeeds_is_said_where_its_last_state_is_spoken_of() -> None:
    page = _page("impact/box-that-tips-over")
    limit = "The limit: the box comes to rest at 3 in equilibrium; with a little more speed it passes on, with less"
    assert f"At 3, x_G = 0. {limit} it never gets there. From 2 to 3" in page
    assert "the last state is one" not in page


def test_a_line_solved_already_is_not_printed_again() -> None:
    """(7) ω_3 = 5 μ g t_3/(2 R) gives the angular velocity as it stands."""
    assert _page("impact/billiard-ball").count("ω_3 = 5 μ g t_3/(2 R)") == 1


def test_why_friction_is_at_its_limit_in_a_blow_is_said() -> None:
    said = "Ball and slope slide throughout the blow: friction acts against the sliding, and is at its limit."
    assert f"{said} ball: m v_2 ↓, J_N ↗, μ J_N ↖" in _page("impact/ball-on-a-rough-slope")


def test_what_is_put_into_a_moment_counts_in_its_sense() -> None:
    page = _page("impact/ball-that-grips-a-rough-floor")
    assert "(1) in (2): m v_x r = m v_Gx,2 r + I_G v_Gx,2/r" in page


def test_a_ball_struck_low_turns_the_other_way_at_first() -> None:
    """ω counts as the ball rolls in the end; that it turns so from the start would be false."""
    low = BALL.replace("WAY", "0 deg").replace("at: G, magnitude", "at: S, magnitude").replace("mu: 1}", "mu: 1, h: m}")
    low = low.replace("G: [0, R]}", "G: [0, R], S: [0, h]}").replace("title:", "assume: [h < R]\ntitle:")
    page = " ".join(Terminal(400).render(narrate(solve_problem(load_text(low)[0]))).split())
    assert "ω is counted clockwise. " in page
