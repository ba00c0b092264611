"""The way that a point has gone tells a state: along a curve, its place."""

from __future__ import annotations

from math import asinh, sqrt

import pytest
from answered import first, solve

from planar_cli.errors import NoSolution

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


def test_a_speed_that_grows_from_rest() -> None:
    """1/2 a t² = 12 m."""
    text = PARABOLA.replace("v(bead).mag = 6 m/s", "dot(v(bead).mag) = 1.5 m/s^2")
    found = solve(text.replace("v(bead).x > 0", "at rest"))
    assert first(found["t"]) == pytest.approx(4)
    assert way(first(found["x"])) == pytest.approx(12)


PUSHED = """
title: Block that is pushed from rest on a rough floor
plane: vertical
points: {A: [0, 0]}
surfaces: {floor: {through: A, angle: 0 deg}}
bodies: {block: {particle: A, mass: 2 kg}}
joints:
  - contact: {between: [block, floor], at: A, mu: 0.2}
loads:
  - force: {name: push, body: block, magnitude: 20 N, angle: 0 deg}
states:
  1: [at rest]
  2: [work(push) @ 1->2 = 40 J]
find: {v: v(A).mag @ 2, d: x(A) @ 2}
"""


def test_a_work_from_rest_on_a_rough_floor() -> None:
    """F d = 40 J, and 1/2 m v² = (F - μ m g) d."""
    found = solve(PUSHED)
    assert first(found["d"]) == pytest.approx(2)
    assert first(found["v"]) == pytest.approx(sqrt(40 - 4 * 0.2 * 9.81))


SWINGS = """
title: Block on a spring and a rough floor
plane: vertical
coordinates: {x: m}
points: {A: [x, 0], W: [-1 m, 0], O: [0, 0]}
surfaces: {floor: {through: O, angle: 0 deg}}
bodies: {block: {particle: A, mass: 2 kg}}
joints:
  - contact: {between: [block, floor], at: A, mu: 0.1}
loads:
  - spring: {name: coil, between: [W, A], stiffness: 200 N/m, natural_length: 1 m}
states:
  1: [at rest, x = 0.3 m]
  2: [STATED]
find: {v: v(A).mag @ 2, x: x @ 2}
"""


def test_a_heat_that_two_ways_give() -> None:
    """It turns where 100 N/m (x² - 0.3²) is the heat so far, -0.3 m + 2 μ m g/k."""
    found = solve(SWINGS.replace("STATED", "heat(A) @ 1->2 = 1.5 J"))
    friction = 0.1 * 2 * 9.81
    turn = -0.3 + 2 * friction / 200
    x = turn + (1.5 / friction - (0.3 - turn))
    assert first(found["x"]) == pytest.approx(x)
    assert first(found["v"]) == pytest.approx(sqrt(9 - 1.5 - 100 * x**2))


def test_a_work_that_is_never_done() -> None:
    with pytest.raises(NoSolution) as error:
        solve(SWINGS.replace("STATED", "work(coil) @ 1->2 = 12 J"))
    (told,) = error.value.diagnostics
    assert (told.code, told.mark.line) == ("PL621", 14)
    assert "work(coil) @ 1->2 comes to 75 % of that" in (told.hint or "")
