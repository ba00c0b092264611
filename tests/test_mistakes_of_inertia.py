"""Mistakes with the moment of inertia about a pin: without its own part, and without m d²; at rest and in an energy."""

from __future__ import annotations

from pathlib import Path

import pytest
from homework_made import mistakes_of

ROD = """
plane: vertical
given: {m: 7 kg, l: 1.6 m}
points: {O: [0, 0], B: [l, 0]}
bodies: {rod: {rod: [O, B], mass: m}}
joints: [pin: {at: O, between: [ground, rod]}]
"""
AT_REST = f"{ROD}instant: [at rest]\nfind: {{alpha: alpha(rod)}}\n"
AT_AN_ANGLE = """
plane: vertical
given: {m: 2 kg, l: 1 m}
unknowns: {beta: deg}
points: {O: [0, 0], B: [l*cos(beta), -l*sin(beta)]}
bodies: {rod: {rod: [O, B], mass: m}}
joints: [pin: {at: O, between: [ground, rod]}]
instant: [at rest, alpha(rod) = -5 rad/s^2]
find: {cosine: cos(beta)}
"""
SWINGS = f"{ROD}states: {{1: [at rest], 2: [theta(rod) = -90 deg]}}\nfind: {{omega: omega(rod) @ 2}}\n"


def ratios(folder: Path, text: str) -> dict[str, float]:
    """By mistake, its result by the right one."""
    (one,) = mistakes_of(folder, text)
    return {m.name: m.values[0] / one.values[0] for m in one.mistakes}


def test_of_i_o_one_part_is_missing(tmp_path: Path) -> None:
    """α = M/I_O: I_O = m l²/3 is four times I_G, and 4/3 of m d²."""
    found = ratios(tmp_path, AT_REST)
    assert found["parallel-axis-left-out"] == pytest.approx(4)
    assert found["rotational-inertia-left-out"] == pytest.approx(4 / 3)


def test_at_an_unknown_angle_the_weight_stays(tmp_path: Path) -> None:
    """cos β = 2 I_O |α|/(m g l)."""
    found = ratios(tmp_path, AT_AN_ANGLE)
    assert found["parallel-axis-left-out"] == pytest.approx(1 / 4)


def test_of_an_energy_one_part_is_missing(tmp_path: Path) -> None:
    found = ratios(tmp_path, SWINGS)
    assert found["parallel-axis-left-out"] == pytest.approx(2)
    assert found["rotational-inertia-left-out"] == pytest.approx((4 / 3) ** 0.5)
