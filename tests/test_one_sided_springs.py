"""Springs that only push or only pull: whether they act is an assumption, tested like that of a contact."""

from __future__ import annotations

from math import acos, pi, sqrt
from pathlib import Path

import pytest
from answered import BUFFER, CORD

from planar_cli.homework.checking.checking import read
from planar_cli.solve.run import solve_problem

STANDING = """
title: Spring at an instant
points: {{O: [0, 0], P: [{x} m, 0]}}
bodies: {{block: {{particle: P, mass: 2 kg}}}}
plane: horizontal
joints:
  - guide: {{point: P, along: 0 deg}}
loads:
  - spring: {{between: [O, P], stiffness: 100 N/m, natural_length: 1 m, acts: {acts}}}
instant: [at rest]
find: {{a: a(P).x}}
"""


def solved(tmp_path: Path, text: str) -> dict[str, list[float]]:
    path = tmp_path / "problem.yaml"
    path.write_text(text, encoding="utf-8")
    solution = solve_problem(read(str(path)))
    return {f.name: [float(v) for v in f.values or ()] for part in solution.parts for f in part.found}


@pytest.mark.parametrize(
    ("x", "acts", "a"), [(1.2, "pull", -10), (0.8, "pull", 0), (1.2, "push", 0), (0.8, "push", 10), (1, "push", 0)]
)
def test_at_an_instant(tmp_path: Path, x: float, acts: str, a: float) -> None:
    assert solved(tmp_path, STANDING.format(x=x, acts=acts))["a"] == pytest.approx([a])


def test_a_spring_that_is_met_on_the_way(tmp_path: Path) -> None:
    """0.4 s to the spring, a quarter and another quarter of a period at 20 rad/s, and 0.4 s back."""
    found = solved(tmp_path, BUFFER)
    assert found["x"] == pytest.approx([1.2 + 3 / 20])
    assert found["t_1"] == pytest.approx([0.4 + pi / 40])
    assert found["v"] == pytest.approx([-3])
    assert found["t_2"] == pytest.approx([0.8 + pi / 20])


def test_a_cord_that_becomes_taut(tmp_path: Path) -> None:
    """Energy: 2 g (1 + s) = 100 s²; the time from the free fall and the oscillation about m g/k below its length."""
    found = solved(tmp_path, CORD)
    weight, sag = 2 * 9.81, 2 * 9.81 / 200
    s = (weight + sqrt(weight**2 + 400 * weight)) / 200
    assert found["y"] == pytest.approx([-2 - s])
    assert found["t"] == pytest.approx([sqrt(2 / 9.81) + (pi - acos(sag / (s - sag))) / 10])
