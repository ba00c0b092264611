"""The way that a point has gone tells a state: along a curve, its place."""

from __future__ import annotations

from math import asinh, sqrt

import pytest
from answered import first, solve

from planar_cli.errors import NoSolution, Undecided

PARABOLA = """
title: Bead at a constant speed along a parabola
given: {c: 0.05 1/m}
points: {P: [0, 0]}
surfaces: {track: {y: c*x^2}}
bodies: {bead: {particle: P}}
joints:
  - guide: {body: bead, along: track}
motion: [v(bead).mag = 6 m/s]
states:
  1: [t = 0, v(bead).x > 0]
  2: [path_length(bead) @ 1->2 = 12 m]
find: {x: x(bead) @ 2, t: t @ 2}
"""


def way(x: float) -> float:
    """Along y = c x² from its vertex, with c = 0.05 1/m."""
    slope = 0.1 * x
    return 5 * (slope * sqrt(1 + slope**2) + asinh(slope))


def test_a_place_on_a_curve() -> None:
    found = solve(PARABOLA)
    assert way(first(found["x"])) == pytest.approx(12)
    assert first(found["t"]) == pytest.approx(2)


SLIDE = """
title: Bead that slides down a parabola
plane: vertical
given: {c: 0.05 1/m}
points: {P: [-10 m, 5 m]}
surfaces: {track: {y: c*x^2}}
bodies: {bead: {particle: P, mass: 1 kg}}
joints:
  - guide: {body: bead, along: track}
states:
  1: [at rest]
  2: [path_length(bead) @ 1->2 = 8 m]
find: {x: x(bead) @ 2, v: v(bead).mag @ 2}
"""


def test_a_way_that_no_formula_dates() -> None:
    """v² = 2 g h at the place to which the way leads."""
    found = solve(SLIDE)
    x = first(found["x"])
    assert way(10) - way(-x) == pytest.approx(8)
    assert first(found["v"]) == pytest.approx(sqrt(2 * 9.81 * (5 - 0.05 * x**2)))


def test_a_way_that_comes_to_an_end() -> None:
    """16 m of 20 m."""
    text = """
title: Sledge that a drag of a fixed size stops
plane: horizontal
bodies: {sledge: {particle: [0, 0], mass: 60 kg}}
loads:
  - drag: {body: sledge, magnitude: 30 N}
states:
  1: [v(sledge).x = 4 m/s, v(sledge).y = 0]
  2: [path_length(sledge) @ 1->2 = 20 m]
find: {v: v(sledge).x @ 2}
"""
    with pytest.raises(NoSolution) as error:
        solve(text)
    (told,) = error.value.diagnostics
    assert (told.code, told.mark.line) == ("PL621", 9)
    assert "the way comes to 80 % of that" in (told.hint or "")


def test_a_speed_that_grows_from_rest_begins_nothing_step_by_step() -> None:
    """At rest the size of a velocity has no rate of its own: that nothing moves is not said."""
    text = PARABOLA.replace("v(bead).mag = 6 m/s", "dot(v(bead).mag) = 1.5 m/s^2")
    with pytest.raises(Undecided):
        solve(text.replace("v(bead).x > 0", "at rest"))
