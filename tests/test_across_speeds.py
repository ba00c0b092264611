"""At states at which what goes round a point moves across the radius, its speed stands in the equations, not φ̇."""

from __future__ import annotations

from pathlib import Path

import pytest
from worked import page_of_file

from planar_cli.formats.terminal import Terminal
from planar_cli.homework.checking.checking import read, solve_and_compare
from planar_cli.report.page.narrate import narrate

ROUND = """
title: Satellite that is farthest on the other side
plane: horizontal
given: {K: 398600 km^3/s^2, m: 500 kg, r_1: 7000 km, v_1: 9000 m/s}
points: {O: [0, 0], S: [r_1, 0]}
bodies: {sat: {particle: S, mass: m}}
loads:
  - force: {body: sat, at: S, towards: O, magnitude: m*K/r(S/O).mag^2, name: attraction}
states:
  1: [t = 0, v(sat).x = 0, v(sat).y = v_1]
  far: [r(S/O).mag is largest]
find: {a_far: a(sat).mag @ far}
"""


@pytest.mark.parametrize(
    ("stem", "lines"),
    [
        (
            "satellite-perigee-apogee",
            [
                "v_A, v_B: the speeds at A and B",
                "m v_A r_A = m v_B r_B",
                "v_B = R √(2 g r_A / (r_B (r_A + r_B)))",
                "v_A = v_B r_B/r_A = 6308 · 8.754×10⁶ / (6.809×10⁶) = 8110 m/s",
                "v_B = 6308 m/s H_O",
            ],
        ),
        ("satellite-launched-level", ["(1) v_1 = v_0 = 10250 m/s", "m v_1 r_1 = m v_2 r_2"]),
        ("puck-tied-to-a-spring", ["m v_1 l_0 = m v_2 r_2", "v_2 = v_1 l_0/r_2 = 3 · 0.5 / 0.8930 = 1.680 m/s"]),
    ],
)
def test_speeds_across_the_radius(stem: str, lines: list[str]) -> None:
    page = page_of_file(stem)
    assert [told for told in lines if told not in page] == []


@pytest.mark.parametrize("stem", ["ball-on-a-cord-that-goes-slack", "burn-into-a-round-orbit"])
def test_rates_of_angles_where_other_states_need_them(stem: str) -> None:
    assert "perpendicular to the radius" not in page_of_file(stem)


def test_rates_of_angles_where_accelerations_are_asked(tmp_path: Path) -> None:
    file = tmp_path / "round.yaml"
    file.write_text(ROUND)
    solution, _ = solve_and_compare(read(str(file)), None)
    assert "perpendicular to the radius" not in Terminal(200).render(narrate(solution))
