"""An impulse in a direction that is counted from the angle of a body which no coordinate places."""

from __future__ import annotations

from math import cos, radians, sin

import pytest
from answered import first, solve

from planar_cli.problem.structure import load_text
from planar_cli.simulate.run import Settings, simulate

SPINNING = """title: Free rod that turns and is struck across itself
plane: horizontal
points: {A: [0, 0], B: [2 m, 0]}
bodies: {rod: {rod: [A, B], mass: 3 kg}}
loads:
  - impulse: {body: rod, at: B, magnitude: 6 N*s, angle: theta(rod) + 90 deg, during: 2->3}
states:
  1: [t = 0, v(rod) = 0, omega(rod) = 2 rad/s]
  2: [WHEN]
  3: [just after 2]
find: {omega: omega(rod) @ 3, x: v(rod).x @ 3, y: v(rod).y @ 3}
"""


@pytest.mark.parametrize(("when", "angle"), [("theta(rod) = 60 deg", 60.0), ("t = 2 s", 720 / 3.141592653589793)])
def test_across_a_free_rod(when: str, angle: float) -> None:
    """I = 1 kg·m²: Δω = 6 rad/s; Δv = 2 m/s across the rod. Both roads agree."""
    text = SPINNING.replace("WHEN", when)
    truth = [8.0, -2 * sin(radians(angle)), 2 * cos(radians(angle))]
    found = solve(text)
    assert [first(found[n]) for n in ("omega", "x", "y")] == pytest.approx(truth)
    problem, wrong = load_text(text)
    assert problem is not None, wrong
    followed = {a.name: a.values[0] for a in simulate(problem, Settings()).answers}
    assert [followed[n] for n in ("omega", "x", "y")] == pytest.approx(truth, rel=1e-8)


def test_another_quantity_is_no_direction() -> None:
    _, wrong = load_text(SPINNING.replace("theta(rod) + 90 deg", "2*theta(rod)").replace("WHEN", "t = 2 s"))
    assert [(d.code, d.message) for d in wrong] == [("PL413", "angle of the impulse cannot use theta(…)")]
    assert "`theta(b) + 90 deg`" in wrong[0].hint
