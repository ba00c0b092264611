"""A first state that what moves in time dates: its time is sought, and the motion is followed from there."""

from __future__ import annotations

import pytest
from answered import first, solve

from planar_cli.errors import NoSolution
from planar_cli.problem.structure import load_text
from planar_cli.solve.run import solve_problem

CRANK = """title: Crank that turns in time
given: {w: 2 rad/s}
coordinates: {phi: deg}
points: {O: [0, 0], A: {from: O, distance: 1 m, angle: phi}}
bodies: {crank: {rod: [O, A]}}
joints:
  - pin: {at: O, between: [crank, ground]}
motion: [theta(crank) = w*t]
states:
  1: [FIRST]
find: {v: v(A).x @ 1, T: t @ 1}
"""
SLIDE = """title: Slide that moves in time
points: {O: [0, 0], A: [0, 0]}
bodies: {P: {particle: A}}
joints:
  - guide: {point: A, along: 0 deg}
motion: [LAW]
WHEN
find: {f: ASKED}
"""
SPEED, PLACE = "v(P).x = 2 m/s + 3 m/s^2 * t", "x(P) = 3 m/s^2 * t^2"


@pytest.mark.parametrize("more", ["", "t > 0, "])
def test_the_time_of_the_first_state(more: str) -> None:
    found = solve(CRANK.replace("FIRST", f"{more}phi = 40 deg"))
    assert first(found["v"]) == pytest.approx(-1.28557522)
    assert first(found["T"]) == pytest.approx(0.34906585)


@pytest.mark.parametrize(
    ("law", "said", "asked", "value"),
    [
        (SPEED, "v(P).x = 12 m/s", "t @ 1", 10 / 3),
        (SPEED, "v(P).x = 12 m/s", "a(P).x @ 1", 3),
        (PLACE, "x(P) = 12 m", "t @ 1", 2),
        (PLACE, "v(P).x = 12 m/s", "x(P) @ 1", 12),
    ],
)
def test_a_first_state_that_a_law_dates(law: str, said: str, asked: str, value: float) -> None:
    text = SLIDE.replace("LAW", law).replace("ASKED", asked).replace("WHEN", f"states: {{1: [t > 0, {said}]}}")
    assert first(solve(text)["f"]) == pytest.approx(value)


def test_it_passes_there_at_zero_too() -> None:
    """t > 0 leaves t = 2 s, and not the beginning of the clock."""
    text = SLIDE.replace("LAW", "x(P) = 2 m/s^2 * t^2 - 4 m/s * t").replace("ASKED", "v(P).x @ 1")
    assert first(solve(text.replace("WHEN", "states: {1: [t > 0, x(P) = 0], 2: [x(P) = 6 m]}"))["f"]) == 4


def test_nothing_asks_for_the_time() -> None:
    text = SLIDE.replace("LAW", PLACE).replace("ASKED", "a(P).x").replace("WHEN", "instant: [t > 0]")
    assert first(solve(text)["f"]) == pytest.approx(6)


@pytest.mark.parametrize(
    ("law", "when", "asked", "place", "code", "words"),
    [
        (SPEED, "states: {1: [t > 0]}", "t @ 1", (7, 14), "PL617", "`t > 0` does not hold: the sides are equal"),
        (SPEED, "states: {1: [t > 0, x(P) = 12 m]}", "t @ 1", (7, 21), "PL609", "`x(P) = 12 m` does not hold in the"),
        (PLACE, "instant: [t > 0]", "v(P).x", (8, 8), "PL623", "the time and x of A are open"),
    ],
)
def test_what_is_said_of_it(law: str, when: str, asked: str, place: tuple[int, int], code: str, words: str) -> None:
    problem, wrong = load_text(SLIDE.replace("LAW", law).replace("ASKED", asked).replace("WHEN", when))
    assert problem is not None, wrong
    with pytest.raises(NoSolution) as error:
        solve_problem(problem)
    diagnostic = error.value.diagnostics[0]
    assert (diagnostic.code, (diagnostic.mark.line, diagnostic.mark.column)) == (code, place)
    assert words in diagnostic.message


def test_a_rod_between_points_of_which_one_is_told_by_the_time() -> None:
    """Its length and its ends say the same twice; that the time has no value yet is no fault."""
    text = """title: Slider-crank driven in time
plane: horizontal
coordinates: {phi: deg, x: m}
points: {O: [0, 0], A: {from: O, distance: 0.2 m, angle: phi}, B: [x, 0]}
bodies: {crank: {rod: [O, A]}, rod: {rod: [A, B], mass: 2 kg, length: 0.6 m}}
joints:
  - pin: {at: O, between: [ground, crank]}
  - pin: {at: A, between: [crank, rod]}
  - guide: {point: B, along: 0 deg}
motion: [phi = 6 rad/s * t]
instant: [t = 0.1 s, x > 0]
find: {v: v(B).x}
"""
    problem, wrong = load_text(text)
    assert problem is not None, wrong
    with pytest.raises(NoSolution) as error:
        solve_problem(problem)
    assert [d.code for d in error.value.diagnostics] == ["PL615"]
