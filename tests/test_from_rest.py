"""A speed that grows from rest has no direction before: it goes the positive way along its track."""

from __future__ import annotations

import pytest
from answered import assert_close, solve

TRACK = """
title: Car that starts
points: {O: [0, 0], S: [300 m, 0]}
surfaces:
  circle: {center: O, radius: 300 m}
  street: {through: S, angle: 60 deg}
bodies: {car: {particle: S}}
joints:
  - guide: {point: car, along: ALONG}
motion: [LAW = 2 m/s^2]
states:
  start: [t = 0, START]
  end: [t = 4 s]
find: {v: v(car).mag @ end, s: path_length(car) @ start->end, up: y(car) @ end}
"""


@pytest.mark.parametrize("start", ["at rest", "car at rest", "v(car).mag = 0"])
@pytest.mark.parametrize("law", ["a(car).t", "dot(v(car).mag)"])
def test_on_a_circle(law: str, start: str) -> None:
    answers = solve(TRACK.replace("ALONG", "circle").replace("LAW", law).replace("START", start))
    assert_close(answers["v"], 8)
    assert_close(answers["s"], 16)


@pytest.mark.parametrize("along", ["street", "60 deg"])
def test_on_a_line(along: str) -> None:
    answers = solve(TRACK.replace("ALONG", along).replace("LAW", "a(S).t").replace("START", "at rest"))
    assert_close(answers["s"], 16)
    assert_close(answers["up"], 8 * 3**0.5)


def test_what_moves_keeps_its_way() -> None:
    """Clockwise, as its first speed says."""
    answers = solve(TRACK.replace("ALONG", "circle").replace("LAW", "a(car).t").replace("START", "v(car).y = -1 m/s"))
    assert_close(answers["v"], 9)
    assert (answers["up"].values or [0])[0] < 0
