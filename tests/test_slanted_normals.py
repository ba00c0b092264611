"""The end of a rod that meets an edge leaves the direction of the blow open: what the file says of it counts."""

from __future__ import annotations

from math import cos, radians, sin

import pytest
from answered import first, solve

from planar_cli.problem.structure import load_text
from planar_cli.simulate.run import Settings, simulate

CAUGHT = """title: Level rod caught by an edge
plane: vertical
points: {A: [0, 0], B: [2 m, 0]}
bodies: {rod: {rod: [A, B], mass: 3 kg}, edge: {particle: A}}
joints:
  - weld: {at: A, between: [edge, ground], name: fixed}
  - impact: {between: [rod, edge], normal: NORMAL deg, restitution: 0.5, name: blow}
states:
  1: [v(rod).x = 0, v(rod).y = -4 m/s, omega(rod) = 0]
  2: [just after 1]
find: {omega: omega(rod) @ 2, v_G: v(rod).y @ 2}
"""


def after(normal: float) -> tuple[float, float]:
    """Angular velocity and velocity upward after the blow along this normal, by hand: J = 6 m v c / (1 + 3 c²)."""
    c = sin(radians(normal))
    impulse = 3.0 * 1.5 * 4.0 * c / (cos(radians(normal)) ** 2 + 4 * c * c)
    return -impulse * c * 1.0 / (3.0 * 2.0**2 / 12), -4.0 + impulse * c / 3.0


@pytest.mark.parametrize("normal", [90, -90, 96.3, 60, 150, 186])
def test_along_the_normal_that_is_said(normal: float) -> None:
    text = CAUGHT.replace("NORMAL", f"{normal}")
    found = solve(text)
    assert [first(found[n]) for n in ("omega", "v_G")] == pytest.approx(after(normal), rel=1e-6)
    problem, wrong = load_text(text)
    assert problem is not None, wrong
    followed = {a.name: a.values[0] for a in simulate(problem, Settings()).answers}
    assert [followed[n] for n in ("omega", "v_G")] == pytest.approx(after(normal), rel=1e-9)
