"""Curves that move and turn with a body: cams, slots and wires."""

from __future__ import annotations

from math import atan, cos, pi, sin, sqrt, tan
from pathlib import Path

import pytest

from planar_cli.homework.checking.checking import read
from planar_cli.solve.run import solve_problem

CAM = """
title: Cam that turns about a point beside the pole of its profile
given: {R: 0.3 m, e: 0.1 m}
points: {O: [0.05 m, 0], P: [0, R]}
surfaces: {profile: {r: R + e*cos(theta), body: cam}}
bodies: {cam: {points: [O], center: O}, follower: {particle: P}}
joints:
  - pin: {at: O, between: [ground, cam]}
  - guide: {point: P, along: 90 deg, name: stem}
  - guide: {point: P, along: profile, name: track}
motion: [omega(cam) = 2 rad/s]
states: {1: [t = 0], 2: [t = 0.3 s]}
find: {y: y(P) @ 2, v: v(P).y @ 2}
"""
SLOT = """
title: Straight slot given as a curve, away from the pivot
given: {h: 0.3}
points: {O: [0.2 m, 0.1 m], P: [0.5 m, 0]}
surfaces: {slot: {y: h*(x - 0.5 m), body: plate}}
bodies: {plate: {points: [O], center: O}, pin_P: {particle: P}}
joints:
  - pin: {at: O, between: [ground, plate]}
  - guide: {point: P, along: 90 deg, name: stem}
  - guide: {point: P, along: slot, name: track}
motion: [omega(plate) = 0.5 rad/s]
states: {1: [t = 0], 2: [t = 0.4 s]}
find: {y: y(P) @ 2, v: v(P).y @ 2, a: a(P).y @ 2}
"""
WIRE = """
title: Bead thrown along a turning wire, seen from the wire
points: {O: [0, 0], P: [1 m, 0.5 m]}
surfaces: {wire: {y: x^2/(2 m), body: frame}}
bodies: {frame: {points: [O], center: O}, bead: {particle: P}}
joints:
  - pin: {at: O, between: [ground, frame]}
  - guide: {point: P, along: wire}
motion: [omega(frame) = 3 rad/s, v(P/frame).along(frame) = 0.4 m/s]
states: {1: [t = 0], 2: [t = 0.5 s]}
find: {r: r(P) @ 2, v: v(P) @ 2, a: a(P) @ 2}
"""


def solved(tmp_path: Path, text: str) -> dict[str, list[float]]:
    path = tmp_path / "problem.yaml"
    path.write_text(text, encoding="utf-8")
    solution = solve_problem(read(str(path)))
    return {f.name: [float(v) for v in f.values or ()] for part in solution.parts for f in part.found}


def slopes(f, t: float, h: float = 1e-4):
    """Value, rate and second rate by differences."""
    a, b, c = f(t - h), f(t), f(t + h)
    return b, (c - a) / (2 * h), (c - 2 * b + a) / h**2


def test_cam_about_another_point(tmp_path: Path) -> None:
    def height(t: float) -> float:
        """The point of the profile above the origin, by bisection along the y axis."""
        c, s = cos(2 * t), sin(2 * t)

        def off(y: float) -> float:
            x = -0.05
            own = complex(0.05 + c * x + s * y, c * y - s * x)
            angle = atan(own.imag / own.real) if own.real > 0 else atan(own.imag / own.real) + pi
            return abs(own) - 0.3 - 0.1 * cos(angle)

        low, high = 0.1, 0.6
        for _ in range(80):
            middle = (low + high) / 2
            low, high = (middle, high) if off(middle) < 0 else (low, middle)
        return low

    found = solved(tmp_path, CAM)
    y, v, _ = slopes(height, 0.3)
    assert found["y"] == pytest.approx([y])
    assert found["v"] == pytest.approx([v], rel=1e-6)


def test_slot_away_from_the_pivot(tmp_path: Path) -> None:
    def height(t: float) -> float:
        turn = 0.5 * t
        x = 0.2 + 0.3 * cos(turn) + 0.1 * sin(turn)
        y = 0.1 + 0.3 * sin(turn) - 0.1 * cos(turn)
        return y + (0.5 - x) * tan(atan(0.3) + turn)

    found = solved(tmp_path, SLOT)
    y, v, a = slopes(height, 0.4)
    assert found["y"] == pytest.approx([y])
    assert found["v"] == pytest.approx([v], rel=1e-6)
    assert found["a"] == pytest.approx([a], rel=1e-5)


def test_bead_on_a_turning_wire(tmp_path: Path) -> None:
    """A part along a turning direction of a velocity seen from the body that turns."""

    def place(t: float) -> complex:
        x = 1 + 0.4 * t
        return complex(x, x * x / 2) * complex(cos(3 * t), sin(3 * t))

    found = solved(tmp_path, WIRE)
    for name, value, near in zip("rva", slopes(place, 0.5), (1e-9, 1e-6, 1e-5), strict=True):
        assert found[name] == pytest.approx([value.real, value.imag], rel=near)
    assert sqrt(sum(v * v for v in found["a"])) == pytest.approx(14.23056, rel=1e-5)
