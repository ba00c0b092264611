"""Ways that are sampled look smooth, however often they turn; a circle gone round again is drawn once."""

from __future__ import annotations

import math
from itertools import pairwise
from pathlib import Path

import pytest

from planar_cli.figures.illustrated import figures_of, illustrated
from planar_cli.figures.smooth import MOST, TURN, smooth
from planar_cli.homework.checking.checking import read, solve_and_compare
from planar_cli.report.document.blocks import Name, line
from planar_cli.report.document.marks import Polyline, Spot, Tag
from planar_cli.report.page.narrate import narrate

SPINNING = """\
title: Block lowered onto a turning table
plane: horizontal
given: {omega: 18 rad/s, R: 0.5 m, m: 2 kg, mu: 0.2}
points: {O: [0, 0], A: [R, 0]}
bodies:
  table: {disk: O, radius: 0.7 m}
  block: {particle: A, mass: m}
joints:
  - pin: {at: O, between: [ground, table]}
  - rope: {path: [O, A], name: string}
  - flat: {between: [block, table], mu_k: mu, during: start->stop}
motion: [omega(table) = omega]
states:
  start: [t = 0, block at rest]
  stop: [v(block/table).mag = 0]
find: {s: path_length(A) @ start->stop}
"""
SPIRAL = """\
title: Collar on a spiral
given: {b: 0.1 m/s, w: 4 rad/s}
points: {O: [0, 0]}
bodies: {A: {particle: free, mass: 1 kg}}
motion: [r(A/O).mag = b*t, r(A/O).angle = w*t]
instant: [t = 8 s]
find: {v: v(A).mag}
"""


def sharpest(way: tuple[Spot, ...]) -> float:
    """The greatest turn from piece to piece, rad."""
    pieces = [complex(b[0] - a[0], b[1] - a[1]) for a, b in pairwise(way)]
    turns = [other * one.conjugate() for one, other in pairwise(pieces)]
    return max(abs(math.atan2(t.imag, t.real)) for t in turns)


def on_circle(turns: float) -> tuple[Spot, ...]:
    return smooth(lambda s: (math.cos(2 * math.pi * turns * s), math.sin(2 * math.pi * turns * s)), 32)


@pytest.mark.parametrize("turns", [0.4, 1.0, 4.3, 16, 31.7, 32, 33])
def test_a_circle_is_gone_round_once(turns: float) -> None:
    way = on_circle(turns)
    assert sharpest(way) <= TURN
    assert len(way) <= 100
    end = (math.cos(2 * math.pi * turns), math.sin(2 * math.pi * turns))
    assert math.dist(way[-1], end) < 1e-6
    assert (math.dist(way[0], way[-1]) < 1e-6) == (turns >= 1)


@pytest.mark.parametrize("turns", [0.5, 5, 20, 32, 45])
def test_spirals_and_epicycloids_are_smooth(turns: float) -> None:
    def spiral(s: float) -> Spot:
        w = 2 * math.pi * turns * s
        return ((1 + s) * math.cos(w), (1 + s) * math.sin(w))

    def epitrochoid(s: float) -> Spot:
        w = 2 * math.pi * s
        return (math.cos(w) + 0.3 * math.cos(turns * w), math.sin(w) + 0.3 * math.sin(turns * w))

    for place in (spiral, epitrochoid):
        way = smooth(place, 32)
        assert way[0] == place(0.0)
        assert way[-1] == place(1.0)
        assert sharpest(way) <= TURN


def test_corners_and_ways_along_a_line_need_no_more_places() -> None:
    assert len(smooth(lambda s: (s, 0.0), 32)) == 33
    assert len(smooth(lambda s: (math.sin(20 * s), 0.0), 32)) == 33
    assert len(smooth(lambda s: (s, abs(s - 0.51)), 32)) < 60


def test_what_turns_too_often_is_not_drawn() -> None:
    assert not smooth(lambda s: ((1 + s) * math.cos(MOST * s), (1 + s) * math.sin(MOST * s)), 32)


@pytest.mark.parametrize("text", [SPINNING, SPIRAL], ids=["circle", "spiral"])
def test_ways_of_scenes_are_smooth(text: str, tmp_path: Path) -> None:
    path = tmp_path / "round.yaml"
    path.write_text(text)
    solution, _ = solve_and_compare(read(str(path)))
    scenes = [f for name, f in figures_of(illustrated(narrate(solution), solution)) if name.startswith("scene")]
    marks = [m for f in scenes for p in f.panels for m in p.marks]
    ways = [m.places for m in marks if isinstance(m, Polyline) and m.style == "way" and len(m.places) > 2]
    assert ways
    assert max(map(sharpest, ways)) <= TURN
    if text == SPINNING:
        (tag,) = [m for m in marks if isinstance(m, Tag) and m.words == line(Name("s"))]
        assert math.hypot(*tag.at) == pytest.approx(0.5)
