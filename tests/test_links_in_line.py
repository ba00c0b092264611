"""The extreme positions of a mechanism: crank and rod in one line, with the reason; places in lengths alone."""

from __future__ import annotations

import pytest
from conftest import PROBLEMS
from worked import page_of_file

from planar_cli.formats.terminal import Terminal
from planar_cli.problem.structure import load_text
from planar_cli.report.page.narrate import narrate
from planar_cli.solve.run import solve_problem

FILES = {p.stem: p for p in PROBLEMS}


@pytest.fixture(scope="module")
def page() -> str:
    return page_of_file("body-offset-slider-crank-strokes")


@pytest.mark.parametrize(
    "told",
    [
        "B rests for a moment: A then moves perpendicularly to AB and to OA, so that OA and AB lie in one line",
        "At 2, v_slider,x = 0, OA and AB lie in one line, stretched, inclined at φ_2:",
        "(l - r_c) sin φ_1 = e",
        "From 1 to 2 the crank turns, at its constant rate, through: Δθ_2 = θ_2 - θ_1 = π + φ_1 - φ_2 = 180° + 23.58°",
        "Δθ_2 = θ_2 - θ_1 = π + φ_1 - φ_2 = 180° + 23.58° - 11.54° = 192.0° = 3.352 rad",
        "Folded, OA points away from B; its angle, counterclockwise from the x axis: θ_1 = π - φ_1",
        "Stretched, OA points to B; its angle, counterclockwise from the x axis: θ_2 = 2 π - φ_2",
        "From θ_0 = 0° on, OA comes to θ_1 first, then to θ_2",
        "first_way + second_way = 0.3352 + 0.2931 = 0.6283 s, one turn: 2 π/ω_crank = 2 π/10 = 0.6283 s",
        "folded as one turn before; from 2 to 3 the crank turns, at its constant rate, through: Δθ_3 = 2 π - Δθ_2",
        "x_1 = √((l - r_c)² - e²)",
        "stroke = x_2 - x_1",
        "first_way = Δθ_2/ω_crank",
        "ratio = Δθ_2/Δθ_3",
    ],
)
def test_told(page: str, told: str) -> None:
    assert told in page


def test_no_velocities(page: str) -> None:
    """Geometry tells the positions: no equation of velocities is needed for them."""
    assert "ω_AB" not in page
    assert "θ_AB" not in page
    assert "B_2" not in page


@pytest.mark.parametrize(
    ("own", "other", "told"),
    [
        ("first_way: t @ 2 - t @ 1", "first_way: t @ 2", "first_way = t_2 = 0.6082 s"),
        ("= 10 rad/s", "= -10 rad/s", "first_way = t_2 - t_1 = 0.3553 - 0.02014 = 0.3352 s"),
        ("= 10 rad/s", "= -10 rad/s", "(3) (l - r_c) sin θ_crank,2 = e"),
        ("= 10 rad/s", "= -10 rad/s", "Not 23.58°: there AB would point to the left"),
        ("= 10 rad/s", "= -10 rad/s", "At 3, v_slider,x = 0, stretched as at 1, one turn later:"),
    ],
)
def test_a_time_from_the_start_and_a_crank_that_turns_clockwise(own: str, other: str, told: str) -> None:
    """The first dead position has a time of its own where more than times between such positions are asked."""
    text = FILES["body-offset-slider-crank-strokes"].read_text().partition("note:")[0]
    page = Terminal(300).render(narrate(solve_problem(load_text(text.replace(own, other))[0])))
    assert told in " ".join(page.split())


def test_a_crank_that_starts_anywhere() -> None:
    text = FILES["body-offset-slider-crank-strokes"].read_text().partition("note:")[0]
    text = text.replace("A: [r_c, 0]", "A: {from: O, distance: r_c, angle: 30 deg}")
    page = " ".join(Terminal(300).render(narrate(solve_problem(load_text(text)[0]))).split())
    assert "From θ_0 = 30° on, OA comes to θ_1 first, then to θ_2" in page
    assert "first_way = Δθ_2/ω_crank" in page


def test_a_line_above_the_crank_has_the_opposite_in_its_triangle() -> None:
    """The offset of the file is negative there."""
    text = FILES["body-offset-slider-crank-strokes"].read_text().replace("e: 80 mm", "e: -80 mm")
    problem, wrong = load_text(text[: text.index("answers:")])
    assert problem is not None, wrong
    page = " ".join(Terminal(200).render(narrate(solve_problem(problem))).split())
    assert "(1) (l + r_c) sin φ_1 = -e" in page
    assert "(2) (l - r_c) sin φ_2 = -e" in page
