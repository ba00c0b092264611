"""A rod that slides over a fixed point: through a sleeve that swivels there, or over a peg in its slot."""

from __future__ import annotations

import math

import pytest
from answered import assert_close, solve

from planar_cli.errors import FileProblem, NoSolution

CRANK = """
title: Crank with a rod through a swivelling sleeve
points:
  O: [0, 0]
  A: {from: O, distance: 100 mm, angle: 120 deg}
  C: [250 mm, 0]
  B: {from: A, towards: C, distance: 400 mm}
bodies: {crank: {rod: [O, A]}, AB: {rod: [A, B]}}
joints:
  - pin: {at: O, between: [ground, crank]}
  - pin: {at: A, between: [crank, AB]}
  - guide: {point: C, along: AB, name: sleeve}
motion: [omega(crank) = 8 rad/s]
find: {omega: omega(AB), alpha: alpha(AB), slide: v(C/AB).mag, a_cor: coriolis(C/AB).mag, v: v(B).mag, a: a(B).mag}
"""

LEANING = """
title: Rod through a rough sleeve
plane: {plane}
points:
  A: [0, 0]
  C: {{from: A, distance: 0.5 m, angle: -50 deg}}
  B: {{from: A, distance: 2 m, angle: -50 deg}}
bodies: {{rod: {{rod: [A, B], mass: 2 kg}}}}
joints:
  - guide: {{point: A, along: 90 deg, name: wall}}
  - guide: {{point: C, along: rod, mu: 0.2, name: sleeve}}
{loads}
instant: [{now}]
find: {{N: N(sleeve), F: friction(sleeve).along(-50 deg), a: a(A).y, R: reaction(sleeve).mag}}
"""
PUSH = "loads: [{force: {body: rod, at: A, magnitude: 60 N, angle: -90 deg}}]"


def test_a_rod_through_a_swivelling_sleeve() -> None:
    # With C at the distance s from A: s² = r² + c² - 2 r c cos φ, and B moves with A + 0.4 of the direction to C.
    truth = {"omega": 24 / 13, "alpha": 7.652453272099182, "slide": 0.5547001962252291, "a_cor": 2.0481238014470002}
    truth |= {"v": 0.5778722761611139, "a": 3.5280359843799665}
    found = solve(CRANK)
    for name, value in truth.items():
        assert_close(found[name], value, 10)


@pytest.mark.parametrize(
    ("plane", "loads", "now", "normal", "friction", "a"),
    [
        ("vertical", "", "at rest", 25.222985804099807, -4.447492931289389, 0.0),
        ("horizontal", PUSH, "v(A).y = -1 m/s", 79.0144870417028, -15.80289740834056, -13.5360235877281),
    ],
    ids=["held", "sliding"],
)
def test_forces_at_a_sleeve_are_those_on_the_rod(
    plane: str, loads: str, now: str, normal: float, friction: float, a: float
) -> None:
    found = solve(LEANING.format(plane=plane, loads=loads, now=now))
    assert_close(found["N"], normal, 9)
    assert_close(found["F"], friction, 9)
    assert_close(found["a"], a, 9)
    assert_close(found["R"], math.hypot(normal, friction), 9)


@pytest.mark.parametrize(
    ("guide", "said"),
    [("point: C, along: 0 deg", "no body has the point C"), ("point: B, along: AB", "B belongs to no body")],
)
def test_what_does_not_slide_at_all(guide: str, said: str) -> None:
    with pytest.raises((FileProblem, NoSolution), match=said):
        solve(CRANK.replace("point: C, along: AB, name", f"{guide}, name"))
