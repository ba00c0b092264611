"""Masses and moments of inertia of parts, however they are given: the same by `solve` and by `simulate`."""

from __future__ import annotations

import pytest

from planar_cli.problem.structure import load_text
from planar_cli.simulate.run import Settings, follow
from planar_cli.solve.run import solve_problem

HAMMER = """
title: Hammer of two parts
plane: vertical
points: {O: [0, 0], A: [1 m, 0], B: [1.2 m, 0]}
bodies:
  hammer:
    parts:
      - {rod: [O, A], %s}
      - {disk: B, radius: 0.2 m, %s, %s}
joints:
  - pin: {at: O, between: [ground, hammer]}
"""
INSTANT = "instant: [at rest]\nfind: {alpha: alpha(hammer)}\n"
MOTION = "states: {1: [t = 0, at rest], 2: [t = 0.01 s]}\n"
PARTS = [
    ("mass: 2 kg", "mass: 1 kg", "radius_of_gyration: 0.1 m"),
    ("weight: 19.62 N", "weight: 9.81 N", "radius_of_gyration: 0.1 m"),
    ("mass: 2 kg", "weight: 9.81 N", "inertia: 0.01 kg*m^2"),
]
# 2 kg m²/3 + 0.01 + 1.2² about O; moments 9.81 (2/2 + 1.2).
ALPHA = -9.81 * 2.2 / (2 / 3 + 0.01 + 1.44)


@pytest.mark.parametrize("parts", PARTS)
def test_parts_by_mass_or_weight_and_by_inertia_or_radius(parts: tuple[str, str, str]) -> None:
    problem, wrong = load_text(HAMMER % parts + INSTANT)
    assert problem is not None, wrong
    (value,) = solve_problem(problem).parts[0].found[0].values or ()
    assert float(value) == pytest.approx(ALPHA, rel=1e-12)


@pytest.mark.parametrize("parts", PARTS)
def test_the_same_in_motion(parts: tuple[str, str, str]) -> None:
    problem, wrong = load_text(HAMMER % parts + MOTION)
    assert problem is not None, wrong
    (segment,) = follow(problem, Settings()).trajectory.segments
    rates = segment.regime.rates(segment.t0, segment.start)
    assert rates[-1] == pytest.approx(ALPHA, rel=1e-12)
