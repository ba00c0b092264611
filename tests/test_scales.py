"""No number without a scale: a watch and a ship give the same decisions.

Whole files are put into worlds with another metre, kilogram and second; every answer changes by its own dimension.
"""

from __future__ import annotations

from decimal import Decimal
from pathlib import Path

import pytest
from answered import first, solve
from conftest import PROBLEMS, ROOT
from scaled import World, factor_of, scaled

from planar_cli.homework.checking.checking import read
from planar_cli.problem.scene.ordinary import scales_of
from planar_cli.problem.scene.scene import Problem
from planar_cli.problem.structure import load_text
from planar_cli.solve.run import solve_problem
from planar_cli.solve.solution import Found

WORLDS: tuple[World, ...] = ((-6, 3, 5), (6, -6, -6))
SAMPLE = (
    "energy/crate-winched-up-a-slope",
    "energy/ladder-leaving-the-wall",
    "impact/carriages-that-collide",
    "impact/bullet-in-a-hanging-block",
    "momentum/ball-with-backspin",
    "motion/crate-that-stops",
    "motion/throw-up-a-slope",
)
AGREE = Decimal("1e-9")
Answers = dict[tuple[str, str], Found]


def answers(problem: Problem) -> Answers:
    return {(part.case, f.name): f for part in solve_problem(problem).parts for f in part.found}


def assert_scaled(path: Path, world: World) -> None:
    problem = read(str(path))
    want, got = answers(problem), answers(scaled(problem, world))
    assert list(got) == list(want)
    for name, found in want.items():
        other = got[name]
        assert other.word == found.word, name
        assert (other.values is None) == (found.values is None), name
        size = max((abs(v) for v in found.values or ()), default=Decimal(0))
        for a, b in zip(other.values or (), found.values or (), strict=True):
            assert abs(a / factor_of(found.unit.dimension, world) - b) <= AGREE * size, name


@pytest.mark.parametrize("world", WORLDS)
@pytest.mark.parametrize("name", SAMPLE)
def test_a_sample_in_other_worlds(name: str, world: World) -> None:
    assert_scaled(ROOT / "problems" / f"{name}.yaml", world)


@pytest.mark.parametrize(
    ("name", "world"),
    [
        # What is left of two loads that cancel, over a small mass, is no acceleration.
        ("car-of-constant-power", (-6, -6, -6)),
        # A law of motion with the square of a small speed.
        ("dog-that-runs-at-a-cyclist", (-6, 3, 5)),
        # The hyperbolic cosine of fifteen thousand times a root of the time.
        ("sledge-up-a-slope-in-air", (-6, -6, -6)),
    ],
)
def test_numbers_that_only_other_worlds_have(name: str, world: World) -> None:
    assert_scaled(ROOT / "problems" / "motion" / f"{name}.yaml", world)


@pytest.mark.slow
@pytest.mark.parametrize("world", [(-6, 3, 5), (6, -6, -6), (-6, -6, -6), (6, 6, 6), (0, 0, 6), (0, 0, -6)])
@pytest.mark.parametrize("path", PROBLEMS, ids=lambda p: f"{p.parent.name}-{p.stem}")
def test_all_files_in_other_worlds(path: Path, world: World) -> None:
    assert_scaled(path, world)


CRATE = """
title: Crate that slides to rest
plane: vertical
points: {A: [0, 0]}
surfaces: {floor: {through: A, angle: 0 deg}}
bodies: {crate: {particle: A, mass: 1 kg}}
joints:
  - contact: {between: [crate, floor], at: A, mu: 0.2}
states:
  1: [t = 0, v(crate).x = %s m/s]
  2: [v(crate).x = 0]
find: {d: x(crate) @ 2, t: t @ 2}
"""


@pytest.mark.parametrize("speed", [4e-12, 4e-10, 4e-6, 4, 4e6])
def test_a_crate_of_any_speed(speed: float) -> None:
    """v²/(2 mu g) and v/(mu g)."""
    found = solve(CRATE % f"{speed:g}")
    assert first(found["d"]) == pytest.approx(speed**2 / (2 * 0.2 * 9.81), rel=1e-12, abs=0)
    assert first(found["t"]) == pytest.approx(speed / (0.2 * 9.81), rel=1e-12, abs=0)


def test_scales_change_as_the_world_does() -> None:
    problem, _ = load_text(CRATE % "4")
    assert problem is not None
    here, there = scales_of(problem), scales_of(scaled(problem, (-3, 2, 5)))
    assert there.length == pytest.approx(here.length * 1e-3, rel=1e-12, abs=0)
    assert there.mass == pytest.approx(here.mass * 1e2, rel=1e-12, abs=0)
    assert there.time == pytest.approx(here.time * 1e5, rel=1e-12, abs=0)
