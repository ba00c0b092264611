"""Where a motion is followed in numbers, mistakes are known by following it without an effect."""

from __future__ import annotations

import math
from pathlib import Path

import pytest

from planar_cli.errors import Mark
from planar_cli.homework.homework import prepared
from planar_cli.homework.set_file import SetProblem

# A wind that rises and falls with the place: there is no closed form over time.
SLED = """
plane: horizontal
given: {m: 2 kg, v_0: 6 m/s}
points: {A: [0, 0]}
bodies: {sled: {particle: A, mass: m}}
joints:
  - guide: {point: A, along: 0 deg, name: rail}
loads:
  - spring: {between: [A, [0 - 1 m, 0]], stiffness: 3 N/m, natural_length: 1 m}
  - force: {body: sled, at: A, magnitude: 0.4 N * (1 + sin(x(sled)/(1 m))), angle: 180 deg, name: wind}
states:
  1: [x(A) = 0, v(sled).x = v_0]
  2: [t = 0.5 s]
find: {x_2: x(A) @ 2, v_2: v(sled).x @ 2}
"""


def test_a_spring_left_out_is_known(tmp_path: Path) -> None:
    path = tmp_path / "sled.yaml"
    path.write_text(SLED)
    made = prepared(SetProblem("sled", str(path), Mark("sled", 1, 1)), 0, 1)
    found = {e.find: {m.name: m.values[0] for m in e.mistakes} for e in made.tasks[0].expected}
    assert {"spring-left-out"} <= set(found["x_2"])

    def without(t: float, steps: int = 20_000) -> float:
        x, v, h = 0.0, 6.0, t / steps
        for _ in range(steps):
            v -= 0.2 * (1 + math.sin(x)) * h
            x += v * h
        return x

    assert found["x_2"]["spring-left-out"] == pytest.approx(without(0.5), rel=1e-4)
