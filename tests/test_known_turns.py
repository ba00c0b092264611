"""What is known to turn clockwise is counted so on the page; answers and their signs stay as they are."""

from __future__ import annotations

from pathlib import Path

import pytest
from conftest import ROOT
from worked import page_of_text, worked

from planar_cli.formats.terminal import Terminal
from planar_cli.problem.structure import load_text
from planar_cli.report.page.json_document import solution_data
from planar_cli.report.page.narrate import narrate
from planar_cli.solve.run import solve_problem


def _page(stem: str) -> str:
    return " ".join(Terminal(400).render(narrate(worked(ROOT / f"problems/{stem}.yaml")[0])).split())


@pytest.mark.parametrize(("stem", "lines"), [
    ("textbook/ex-4-05", [
        "α is counted clockwise, the way in which the loads turn the spool about C.",
        "spool rolls without slipping: a_G = R α",
        "m a_G → at G, I_G α ↻",
        "↻ ΣM_C: P (R + r) = m a_G R + I_G α",
        "Answer α = 6.186 rad/s² clockwise",
    ]),
    ("textbook/ex-4-08", [
        "θ: the angle by which the spool has turned, clockwise",
        "R θ_2 = d",
        "v_G,2 = R ω_2",
        "Answer ω = 7.415 rad/s clockwise",
    ]),
    ("textbook/ex-4-12", [
        "ω is counted clockwise, the way in which the loads turn the spool about C.",
        "↻ H_C: 1/2 q (R + r) t_2² = m (R² + k_G²) ω_2",
        "Answer ω = 15.46 rad/s clockwise",
    ]),
    ("rigid-bodies/half-cylinder-let-go-on-its-side", ["a_G = α × r_G/C", "m R α → at G, 4 m R α/(3 π) ↓ at G, I α ↻"]),
    ("rigid-bodies/ring-on-a-pin", [
        "↻ ΣM_O: m g R = I_O α",
        "a_B = α × r_B/O",
        "a_B = -2 R α = -g along y",
        "α = g/(2 R) clockwise",
    ]),
])  # fmt: skip
def test_a_body_that_begins_to_turn_clockwise_is_counted_so(stem: str, lines: list[str]) -> None:
    page = _page(stem)
    assert [x for x in lines if x not in page] == []


@pytest.mark.parametrize("stem", ["rigid-bodies/spool-hauled-up-a-slope", "textbook/ex-4-06"])
def test_where_the_sense_is_open_it_is_counterclockwise(stem: str) -> None:
    """Two loads that turn it either way; or it turns that way anyhow."""
    page = _page(stem)
    assert "↻" not in page
    assert "clockwise, the way" not in page


def test_the_answer_itself_counts_counterclockwise() -> None:
    found = worked(ROOT / "problems/textbook/ex-4-05.yaml")[0].parts[0].found
    assert float(next(f for f in found if f.name == "alpha").values[0]) == pytest.approx(-6.18557, rel=1e-5)


def test_a_document_says_what_counts_clockwise() -> None:
    steps = solution_data(*worked(ROOT / "problems/textbook/ex-4-05.yaml"), 4, None)["steps"]
    solved = next(s for s in steps if s.get("symbol") == "alpha" and s["kind"] == "solved")
    assert (solved["counts"], float(solved["value"])) == ("clockwise", pytest.approx(6.18557, rel=1e-5))


def test_what_is_asked_downward_counts_downward() -> None:
    page = _page("textbook/ex-4-16")
    assert "block, bar: (5) ↑ ΣF_y: N_B - (m + m_A) g = m a_Gy - m_A a_A" in page, "no moments with all their arms"
    for told in ("a_A = √2/2 L α", "= m_A a_A ↓ at A", "Answer a_A = 8.175 m/s² downward"):
        assert told in page
    assert "in the sense" not in page


def test_a_speed_that_counts_against_an_axis_is_said_to() -> None:
    """Asked along -90°, the acceleration of the end that slides down a wall counts downward."""
    page = _page("textbook/ex-4-16")
    assert "a_A is counted downward." in page


def test_a_case_counts_as_the_file_did_where_its_own_sense_is_open() -> None:
    """The place of the push is sought; that the ball turns clockwise was told. As more is asked, it is found anew."""
    text = (ROOT / "problems/rigid-bodies/ball-pushed-without-friction.yaml").read_text()
    problem, wrong = load_text(text.replace("a_best: a(G).x", "pressed: N(C)").replace(", a_best: F/m", ""))
    assert problem is not None
    assert not wrong
    page = " ".join(Terminal(400).render(narrate(solve_problem(problem))).split())
    assert "↺" not in page
    assert "↻ ΣM_G: F (h - R) = I_G α" in page.split("CASE")[1]


@pytest.mark.parametrize("stem", ["textbook/ex-4-06", "rigid-bodies/half-disk-swinging"])
def test_a_mass_centre_that_swings_down_counts_downward(stem: str) -> None:
    """From rest its weight alone moves it."""
    page = _page(stem)
    assert "= m a_G ↓ at G" in page
    assert "↓ ΣF_y: m g - " in page


@pytest.mark.parametrize(("stem", "lines"), [
    ("rigid-bodies/wheel-with-its-mass-centre-off-the-middle", [
        "ω_wheel = 3 rad/s clockwise",
        "ω and α are counted clockwise, the way in which the wheel turns.",
        "ω = 3 rad/s given",
        "a_O = R α ↘",
        "F ↖ at C (assumed)",
        "F = m (e ω² + g sin β - R α)",
        "Answer α = 15.60 rad/s² clockwise F = 2.621 N up the slope",
    ]),
    ("systems/wheel-pulled-uphill", [
        "α is counted clockwise, the way in which the wheel rolls along a_G.",
        "The cord keeps its length, a_B = a_G, with (1): (2) a_B = R α",
        "m_B a_B ↓",
        "↓ ΣF_y: m_B g - T = m_B a_B",
        "↻ ΣM_C: T R - m g R sin β = m a_G R + I_wheel α",
        "a_G = R α = 0.3 · 5.474 = 1.642 m/s²",
    ]),
    ("momentum/bicycle-driven-and-braked", [
        "α_rear, α_front are counted clockwise, the way in which the rear rolls along a_A, the front along a_B.",
    ]),
    ("systems/gear-pair", ["At C gear_A and gear_B have the same tangential acceleration: (1) r_A α_A = -r_B α_B"]),
])  # fmt: skip
def test_what_is_asked_or_stated_counts_in_its_sense(stem: str, lines: list[str]) -> None:
    """A wheel rolls as its centre is asked, `cw` counts clockwise, a falling weight falls."""
    page = _page(stem)
    assert [x for x in lines if x not in page] == []


def test_wheels_that_roll_as_a_velocity_is_asked() -> None:
    """From rest, over time: v to the right is asked, so that the wheels count clockwise."""
    page = _page("textbook/ex-4-18")
    for told in (
        "the angle by which the rear has turned, clockwise",
        "↻ H_O,A: M t_2 - J_F,A r = I_r v/r",
        "ω_rear,2 = ω_front,2 = v/r",
    ):
        assert told in page


def test_a_sum_of_moments_has_its_terms_on_their_own_sides() -> None:
    """Weight and m a both turn the crate clockwise about its rear edge."""
    first, second = _page("friction/crate-on-cart").split("CASE")
    assert "↻ ΣM_A: 1/2 m g b = 1/2 m a_K h" in first
    assert "↻ ΣM_A: 1/2 m g b - N_B b = 1/2 m a_K h" in second


STEPPED = """\
title: Stepped cylinder between two blocks
plane: vertical
given: {m: 3 kg, r: 0.1 m, R: 0.2 m, m_A: 2 kg, m_B: 1 kg}
points:
  C: [0, 0]
  G: [0, R]
  H: [0, R + r]
  T: [0, 2*R]
  D: [2 m, R + r]
  E: [-2 m, 2*R]
bodies:
  cylinder: {disk: G, radius: R, hub: r, mass: m}
  a: {particle: [2 m, -2 m], mass: m_A}
  b: {particle: [-2 m, -1 m], mass: m_B}
surfaces: {floor: {through: C, angle: 0 deg}}
joints:
  - rolling: {between: [cylinder, floor], at: C}
  - rope: {path: [H on cylinder, D, a], name: p}
  - rope: {path: [T on cylinder, E, b], name: q}
states:
  start: [t = 0, at rest]
  end: [t = 1 s]
find: {v_a: v(a).y @ end, v_b: v(b).y @ end}
"""


def test_loads_on_ropes_tell_no_sense(tmp_path: Path) -> None:
    """That their velocities are asked upward says nothing of how the wheel rolls."""
    assert "clockwise, the way" not in page_of_text(tmp_path, STEPPED)
