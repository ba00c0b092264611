"""A drag that does not vanish with the speed stops what it brakes; what else acts then moves it on, or does not."""

from __future__ import annotations

from math import sqrt

import pytest
from answered import first, solve

from planar_cli.errors import NoSolution
from planar_cli.problem.structure import load_text
from planar_cli.simulate.run import Settings, Simulation, simulate

SLEDGE = """
title: Sledge with a drag of a fixed size
plane: horizontal
given: {m: 60 kg, F: 30 N}
bodies: {sledge: {particle: [0, 0], mass: m}}
loads:
  - drag: {body: sledge, magnitude: F}
states:
  1: [t = 0, v(sledge).x = 4 m/s, v(sledge).y = 0]
  2: [WHEN]
find: {d: x(sledge) @ 2}
"""
BALL = """
title: Ball thrown up against a drag of a fixed size
plane: vertical
given: {m: 2 kg, F: SIZE}
bodies: {ball: {particle: [0, 0], mass: m}}
loads:
  - drag: {body: ball, magnitude: F}
states:
  1: [t = 0, v(ball).y = 10 m/s, v(ball).x = 0]
  2: [t = 3 s]
find: {y: y(ball) @ 2}
"""


def followed(text: str) -> Simulation:
    problem, _ = load_text(text)
    assert problem is not None
    return simulate(problem, Settings())


def test_a_place_beyond_the_stop_is_never_reached() -> None:
    """v²/(2 F/m) = 16 m, 4 m short."""
    with pytest.raises(NoSolution) as error:
        solve(SLEDGE.replace("WHEN", "x(sledge) = 20 m"))
    (told,) = error.value.diagnostics
    assert (told.code, told.mark.line) == ("PL621", 10)
    assert "is nearest at t = 8 s, where the sides differ by 4 m" in (told.hint or "")


def test_it_stays_where_it_has_stopped() -> None:
    run = followed(SLEDGE.replace("WHEN", "t = 10 s"))
    assert first_number(run) == pytest.approx(16)


def test_it_turns_round_where_more_acts() -> None:
    """Up with g + F/m = 12.31 m/s², down with 7.31 m/s²."""
    up = 10 / 12.31
    top = 5 * up
    down = 3 - up
    assert first_number(followed(BALL.replace("SIZE", "5 N"))) == pytest.approx(top - 7.31 * down**2 / 2)


def test_the_way_back_is_told() -> None:
    """The turn is found: v² = 2 · 7.31 m/s² · h on the way down."""
    text = BALL.replace("SIZE", "5 N").replace("[t = 3 s]", "[y(ball) = 0]")
    found = solve(text.replace("{y: y(ball) @ 2}", "{v: v(ball).y @ 2, t: t @ 2}"))
    up, top = 10 / 12.31, 50 / 12.31
    assert first(found["v"]) == pytest.approx(-sqrt(2 * 7.31 * top))
    assert first(found["t"]) == pytest.approx(up + sqrt(2 * top / 7.31))


def test_it_is_held_where_less_acts() -> None:
    """30 N hold 19.62 N."""
    outcome = followed(BALL.replace("SIZE", "30 N")).run.trajectory.outcome
    assert outcome.kind == "held"
    assert outcome.t == pytest.approx(10 / (9.81 + 15))


def first_number(run: Simulation) -> float:
    return next(iter(run.answers)).values[0]
