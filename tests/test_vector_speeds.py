"""Relations that give the size or the direction of a velocity: linear where they can be, else every root."""

from __future__ import annotations

from pathlib import Path

import pytest

from planar_cli.errors import NoSolution
from planar_cli.homework.checking.checking import read
from planar_cli.solve.run import solve_problem

TRIANGLE = """
title: Boat in a stream
unknowns: {{m: m/s}}
bodies: {{water: {{particle: [0, 0]}}, boat: {{particle: [0, 0]}}}}
instant: [v(water).mag = 8 m/s, v(water).angle = 0 deg, v(boat).mag = m, v(boat).angle = {angle} deg, {more}]
find: {{m: m}}
"""
TWO_DIRECTIONS = """
title: Stream and boat of unknown directions
unknowns: {{beta: deg, gamma: deg}}
bodies: {{water: {{particle: [0, 0]}}, boat: {{particle: [0, 0]}}}}
instant:
  - v(water).mag = 3 m/s
  - v(water).angle = beta
  - v(boat/water).mag = 4 m/s
  - v(boat/water).angle = gamma
  - v(boat).x = 5 m/s
  - v(boat).y = 0
  - v(water).y {sign} 0
find: {{beta: beta, gamma: gamma}}
"""
TWO_SIZES = """
title: Two sizes and no direction
bodies: {A: {particle: [0, 0]}, B: {particle: [0, 0]}}
instant: [v(A).x = 6 m/s, v(A).y = 0, v(B).mag = 5 m/s, v(B/A).mag = 5 m/s, v(B).y < 0]
find: {v: v(B)}
"""
ONE_DIRECTION = """
title: A direction alone
bodies: {{A: {{particle: [0, 0]}}}}
instant: [v(A).angle = {angle} deg, v(A).x = {x} m/s]
find: {{v: v(A).y}}
"""
SLIDER = """
title: A size alone
points: {{A: [0, 0]}}
bodies: {{A: {{particle: A}}}}
joints:
  - guide: {{point: A, along: 0 deg}}
instant: [v(A).mag = 3 m/s{more}]
find: {{v: v(A).x}}
"""
LASTING = """
title: Speed that is kept along a parabola
points: {P: [0, 0]}
surfaces: {track: {y: x^2/(2 m)}}
bodies: {P: {particle: P}}
joints:
  - guide: {point: P, along: track}
motion: [v(P).mag = 2 m/s]
states: {1: [t = 0], 2: [x(P) = 1 m]}
find: {v: v(P) @ 2, a: a(P) @ 2, t: t @ 2}
"""


def solved(tmp_path: Path, text: str) -> dict[str, list[float]]:
    path = tmp_path / "problem.yaml"
    path.write_text(text, encoding="utf-8")
    solution = solve_problem(read(str(path)))
    return {f.name: [float(v) for v in f.values or ()] for part in solution.parts for f in part.found}


@pytest.mark.parametrize(
    ("angle", "more", "speed"),
    [
        (30, "v(boat/water).mag = 5 m/s", 3.9282032302755),
        (30, "v(boat/water).mag = 5 m/s, m > 5 m/s", 9.9282032302755),
        (30, "v(boat/water).mag = 4 m/s", 6.9282032302755),
        (120, "v(boat/water).mag = 10 m/s", 52**0.5 - 4),
    ],
)
def test_law_of_cosines(tmp_path: Path, angle: int, more: str, speed: float) -> None:
    assert solved(tmp_path, TRIANGLE.format(angle=angle, more=more))["m"] == pytest.approx([speed])


@pytest.mark.parametrize(("angle", "speed"), [(30, 3), (150, 5)])
def test_no_triangle(tmp_path: Path, angle: int, speed: int) -> None:
    """The boat is too slow, or the roots would mean that it goes backwards along its line."""
    with pytest.raises(NoSolution):
        solved(tmp_path, TRIANGLE.format(angle=angle, more=f"v(boat/water).mag = {speed} m/s"))


@pytest.mark.parametrize(("sign", "way"), [(">", 1), ("<", -1)])
def test_two_unknown_directions(tmp_path: Path, sign: str, way: int) -> None:
    found = solved(tmp_path, TWO_DIRECTIONS.format(sign=sign))
    assert found["beta"] == pytest.approx([way * 0.9272952180016])
    assert found["gamma"] == pytest.approx([-way * 0.6435011087933])


def test_two_sizes(tmp_path: Path) -> None:
    assert solved(tmp_path, TWO_SIZES)["v"] == pytest.approx([3, -4])


def test_a_direction_is_linear_and_has_a_sense(tmp_path: Path) -> None:
    assert solved(tmp_path, ONE_DIRECTION.format(angle=45, x=2))["v"] == pytest.approx([2])
    with pytest.raises(NoSolution, match="opposite direction"):
        solved(tmp_path, ONE_DIRECTION.format(angle=45, x=-2))


@pytest.mark.parametrize(("more", "speed"), [(", v(A).x > 0", 3), (", v(A).x < 0", -3)])
def test_both_signs_of_a_size(tmp_path: Path, more: str, speed: float) -> None:
    assert solved(tmp_path, SLIDER.format(more=more))["v"] == pytest.approx([speed])


def test_a_size_alone_has_two_signs(tmp_path: Path) -> None:
    with pytest.raises(NoSolution, match="holds both ways"):
        solved(tmp_path, SLIDER.format(more=""))


def test_a_lasting_speed_goes_towards_growing_coordinate(tmp_path: Path) -> None:
    """y' = x: v = 2 (1, x)/√(1 + x²), κ = (1 + x²)^(-3/2), and the arc length to x = 1 is (√2 + arsinh 1)/2."""
    found = solved(tmp_path, LASTING)
    assert found["v"] == pytest.approx([2**0.5, 2**0.5])
    assert found["a"] == pytest.approx([-1, 1])
    assert found["t"] == pytest.approx([(2**0.5 + 0.881373587019543) / 4])
