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


DRUM = """
plane: vertical
given: {I: 0.06 kg*m^2, R: 0.2 m, m: 2 kg}
points: {O: [0, 0], T: [R, 0], A: [R, -1 m]}
bodies: {drum: {disk: O, radius: R, inertia: I}, block: {particle: A, mass: m}}
joints: [pin: {at: O, between: [ground, drum]}, rope: {path: [T on drum, A], name: cord}]
instant: [at rest]
find: {a: a(A).mag}
"""


def test_an_inertia_that_is_a_letter_is_left_out_as_a_number_is(tmp_path: Path) -> None:
    """Without the drum the block falls freely; a thousandth of its inertia is no better explanation."""
    for text in (DRUM, DRUM.replace("I: 0.06 kg*m^2, ", "").replace("inertia: I", "inertia: 0.06 kg*m^2")):
        (one,) = mistakes_of(tmp_path, text)
        free = [(m.name, m.feedback) for m in one.mistakes if m.values[0] == pytest.approx(9.81, rel=1e-3)]
        assert [name for name, _ in free] == ["rotational-inertia-left-out"]
        assert free[0][1].startswith("this is the result without the moment of inertia")
