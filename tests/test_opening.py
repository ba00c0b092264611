"""The head of a page: what is given as its author wrote it, what is asked, and the principles that the page uses."""

from __future__ import annotations

import re

import pytest
from conftest import PROBLEMS, ROOT
from worked import worked

from planar_cli.formats.terminal import Terminal
from planar_cli.problem.structure import load_text
from planar_cli.report.document.blocks import Heading, Name, Note
from planar_cli.report.page.narrate import narrate
from planar_cli.solve.run import solve_problem

FILES = {p.stem: p for p in PROBLEMS}


def _notes(stem: str) -> dict[str, str]:
    document = narrate(worked(FILES[stem])[0])
    head = [b for b in document.blocks if isinstance(b, Note)]
    page = Terminal(200).render(document).splitlines()
    return {b.kind: next(row for row in page if row.startswith(b.kind)) for b in head}


def test_numbers_as_they_were_written() -> None:
    """Units of the file, and a formula with its value."""
    notes = _notes("ex-4-10")
    assert "m = 10 kg, l = 0.4 m, k = 800 N/m, l_0 = (0.2 √2) m = 0.2828 m" in notes["Given"]
    assert notes["Find"].endswith(" ω")


def test_a_negative_number_stands_once() -> None:
    problem, wrong = load_text("""
title: Arm
given: {d: 400 mm, w: -2 rad/s}
points: {C: [0, 0], B: [0, d]}
bodies: {arm: {rod: [C, B]}}
joints: [pin: {at: C, between: [ground, arm]}]
instant: [omega(arm) = w]
find: {v: v(B).mag}
""")
    assert problem is not None, wrong
    page = Terminal(200).render(narrate(solve_problem(problem)))
    assert "d = 400 mm, w = -2 rad/s; C(0, 0)" in page


def test_letters_of_a_problem_in_letters() -> None:
    assert _notes("ex-4-04")["Given"].split()[1:4] == ["m,", "L,", "g;"]


@pytest.mark.parametrize(
    ("stem", "rows"),
    [
        ("ex-4-13", ["m = 12 kg", "A(0, 0), B(0, -2) m, S(0, -1.5) m", "J = 1000 N · 0.03 s", "1: at rest"]),
        ("ex-1-02", ["r, l", "OA = r at 60°, AB = l at 0°, OA2 = r at -30°, A2B2 = l at 0°"]),
        ("ladder-sliding", ["A(l cos β, 0), B(0, l sin β)", "μ_A = 0.2, μ_B = 0.1"]),
        ("pucks-at-an-angle", ["1: |v_A| = 5 m/s, direction of v_A = 0°, |v_B| = 2 m/s, direction of v_B = 150°"]),
        ("collar-on-rotating-rod", ["v_P/rod along OA = 0.6 m/s, a_P/rod along OA = -0.2 m/s²"]),
        ("leaking-bucket", ["m = M - q t, speed of what leaves, relative to the body = 0"]),
        ("jet-against-a-hinged-plate", ["= 5.400 kg/s"]),
        ("ex-1-08", ["r, g; ", "let_go: θ = 0, θ̇ = 0"]),
        ("ex-1-11", ["parallel: v_y = -3/4 v_x", "B: y = -3/4 x"]),
        ("ex-1-13", ["track: y = x²/(2 m)"]),
        ("ex-1-14", ["OB at θ", "P at y = 500 mm on the line through O at θ", "θ = π/2 + π/6 sin(1.5 rad/s · t)"]),
        ("ex-4-10", ["1: at rest", "2: y_A = 0"]),
        ("ex-4-11", ["2: y_D smallest"]),
        ("wind-felt-by-a-cyclist", ["fast: v_cyclist,x = 24 km/h, v_cyclist,y = 0"]),
        ("pipe-bend", ["v_A = 4 q/(ρ π d_A²) = 3.183 m/s"]),
    ],
)
def test_data_without_letters(stem: str, rows: list[str]) -> None:
    """Numbers of bodies, points, joints and loads, and the first state, in the words of the page."""
    given = _given(stem)
    for row in rows:
        assert row in given


@pytest.mark.parametrize(
    ("stem", "times"), [("double-pulley", 1), ("mine-hoist-us-units", 1), ("ex-4-04", 0), ("four-bar", 0)]
)
def test_gravity_where_its_number_is_used(stem: str, times: int) -> None:
    """Once, also where the file gives it."""
    assert len(re.findall(r"\bg = ", _given(stem))) == times


def test_gravity_in_letters_is_given_once() -> None:
    assert _given("bar-hanging-from-a-pushed-collar").startswith("M, m, l, F, g;")


def test_a_drive_on_which_no_answer_rests_is_given() -> None:
    path = ROOT / "problems" / "hard" / "slider-crank-of-equal-links.yaml"
    assert "; ω_OA = 1 rad/s" in Terminal(200).render(narrate(worked(path)[0]))


def test_what_no_equation_uses_is_not_given() -> None:
    """The mass of a pipe that stands still on level ground, and its mass centre."""
    assert "60 kg" not in _given("pipe-bend")
    assert "G(" not in _given("pipe-bend")


def test_places_on_which_no_line_rests_are_not_given() -> None:
    """The place of the air, and the length of an arm of which only the direction counts."""
    assert "air(" not in _given("wind-felt-by-a-cyclist")
    assert "650" not in _given("ex-1-14")


def test_data_of_a_case_stand_at_its_head() -> None:
    blocks = narrate(worked(FILES["bob-on-a-thread-that-goes-slack"])[0]).blocks
    at = next(i for i, b in enumerate(blocks) if isinstance(b, Heading) and b.label == "CASE")
    after = blocks[at + 1]
    assert isinstance(after, Note)
    assert after.kind == "Given"
    assert Name("v_0") in after.line


def _given(stem: str) -> str:
    """All rows of what is given, one after the other."""
    page = Terminal(200).render(narrate(worked(FILES[stem])[0])).splitlines()
    first = next(i for i, row in enumerate(page) if row.startswith("Given"))
    last = next(i for i, row in enumerate(page) if i > first and not row.startswith(" "))
    return " | ".join(row.removeprefix("Given").strip() for row in page[first:last])


@pytest.mark.parametrize(
    ("stem", "words"),
    [
        ("ex-4-10", "Work and energy"),
        ("ex-4-05", "Newton's second law"),
        ("ex-2-09", "2 ω × v_rel"),
        ("ex-4-13", "across the blow"),
        ("four-bar", "v_B = v_A + ω × r_B/A"),
        ("two-blocks-joined-by-a-cord", "Newton's second law"),
        ("ex-1-02", "Position vectors: r_B = r_A + r_B/A."),
        ("ex-1-07", "Simple harmonic motion."),
        ("ex-1-10", "Constant angular acceleration."),
        ("ex-1-13", "Path coordinates: a = v̇ e_t + v²/ρ e_n."),
        ("ex-1-14", "Polar coordinates"),
        ("ex-4-07", "Kinetic energy of each body"),
        ("wind-felt-by-a-cyclist", "Relative motion"),
    ],
)
def test_the_principle_that_is_used(stem: str, words: str) -> None:
    """Also where all forces are summed in slanting directions."""
    assert words in _notes(stem)["Principle"]


def test_polar_coordinates_about_a_fixed_point_are_no_relative_motion() -> None:
    assert "elative" not in _notes("ex-1-14")["Principle"]


def test_one_answer_alone_has_its_principle() -> None:
    """What is printed for `--why` has no data, and begins with the principle of the chain to the answer."""
    document = narrate(worked(FILES["ex-2-09"])[0], why="a_cor")
    assert [b.kind for b in document.blocks if isinstance(b, Note)][:1] == ["Principle"]
    assert not [b for b in document.blocks if isinstance(b, Note) and b.kind in ("Given", "Find")]


def test_data_of_a_state_of_a_case_have_its_name() -> None:
    page = Terminal(200).render(narrate(worked(FILES["ball-off-a-smooth-wall"])[0]))
    assert "Given       land: x = 0" in page
