"""The end of a rod that meets an edge leaves the direction of the blow open: what the file says of it counts."""

from __future__ import annotations

from math import cos, radians, sin

import pytest
from answered import first, solve

from planar_cli.errors import FileProblem
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


SWUNG = """title: Rod swings onto a ball
plane: vertical
points: {A: [0, 0], B: {from: A, distance: 2 m, angle: 30 deg}, P: [0, -1.5 m]}
bodies: {rod: {rod: [A, B], mass: 3 kg}, ball: {particle: P, mass: 1 kg}}
joints:
  - pin: {at: A, between: [rod, ground]}
  - impact: {between: [rod, ball], NORMALrestitution: 0.5, name: blow}
  - weld: {at: P, between: [ball, ground], during: 0->1}
states:
  0: [at rest]
  1: [theta(rod) = -90 deg]
  2: [just after 1]
find: {omega: omega(rod) @ 2, v: v(ball).x @ 2}
"""


@pytest.mark.parametrize("normal", ["theta(rod) + 90 deg", "90 deg + theta(rod)", "theta(rod) - 90 deg"])
def test_a_normal_that_turns_with_a_body(normal: str) -> None:
    text = SWUNG.replace("NORMAL", f"normal: {normal}, ")
    found, plain = solve(text), solve(SWUNG.replace("NORMAL", ""))
    assert [first(found[n]) for n in ("omega", "v")] == pytest.approx([first(plain[n]) for n in ("omega", "v")])
    problem, wrong = load_text(text)
    assert problem is not None, wrong
    followed = {a.name: a.values[0] for a in simulate(problem, Settings()).answers}
    assert followed["omega"] == pytest.approx(first(found["omega"]), rel=1e-8)


def test_a_normal_that_turns_is_checked() -> None:
    with pytest.raises(FileProblem) as error:
        solve(SWUNG.replace("NORMAL", "normal: theta(rod) + 70 deg, "))
    assert "the common normal of rod and ball is at 0 deg" in str(error.value)


def test_a_normal_is_counted_from_one_angle() -> None:
    _, wrong = load_text(SWUNG.replace("NORMAL", "normal: 2*theta(rod), "))
    assert [(d.code, d.message) for d in wrong] == [("PL413", "normal of the impact cannot use theta(…)")]
    assert "`theta(b) + 90 deg`" in wrong[0].hint
