"""Logarithmic decrement and damping ratio of small oscillations, asked for and stated; numbers in shares."""

from __future__ import annotations

import math
import re
from pathlib import Path

import pytest
from answered import assert_close, solve

from planar_cli.errors import NoSolution
from planar_cli.formats.terminal import Terminal
from planar_cli.homework.checking.checking import read
from planar_cli.problem.structure import load_text
from planar_cli.report.page.narrate import narrate
from planar_cli.solve.run import solve_problem

ROOT = Path(__file__).parents[1]

BLOCK = """
title: Block between a spring and a damper
plane: horizontal
{names}
coordinates: {{x: m}}
points: {{W: [-1 m, 0], P: [x, 0]}}
bodies: {{block: {{particle: P, mass: m}}}}
joints:
  - guide: {{point: P, along: 0 deg}}
loads:
  - spring: {{between: [W, P], stiffness: k, relaxed_at: [x = 0]}}
  - damper: {{between: [W, P], coefficient: c}}
states: {{rest: [equilibrium, x = 0{said}]}}
find: {find}
"""
GIVEN = "given: {{m: 2 kg, k: 200 N/m, c: {c} N*s/m}}"


def block(find: str, c: float, said: str = "") -> str:
    return BLOCK.format(names=GIVEN.format(c=c), said=said, find=find)


def test_they_follow_from_mass_spring_and_damper() -> None:
    """zeta = c/(2 sqrt(k m)), delta = 2 pi zeta/sqrt(1 - zeta^2)."""
    found = solve(block("{d: decrement(rest), z: damping_ratio(rest)}", 8))
    assert_close(found["z"], 0.2)
    assert_close(found["d"], 2 * math.pi * 0.2 / math.sqrt(1 - 0.04))


def test_too_strong_a_damping_has_a_ratio_and_no_decrement() -> None:
    assert_close(solve(block("{z: damping_ratio(rest)}", 60))["z"], 1.5)
    with pytest.raises(NoSolution) as caught:
        solve(block("{d: decrement(rest)}", 60))
    assert "overdamped" in caught.value.diagnostics[0].message


@pytest.mark.parametrize("rate", ["period(rest) = 0.4 s", "frequency(rest) = 2.5 Hz"])
@pytest.mark.parametrize("damping", ["decrement(rest) = 0.5", "damping_ratio(rest) = 0.5/sqrt(4*pi^2 + 0.25)"])
def test_a_record_tells_stiffness_and_damping(rate: str, damping: str) -> None:
    """c = 2 m delta/T, k = m (4 pi^2 + delta^2)/T^2."""
    names = "given: {m: 2 kg}\nunknowns: {k: N/m, c: N*s/m}"
    found = solve(BLOCK.format(names=names, said=f", {rate}, {damping}", find="{k: k, c: c}"))
    assert_close(found["c"], 2 * 2 * 0.5 / 0.4)
    assert_close(found["k"], 2 * (4 * math.pi**2 + 0.25) / 0.16)


@pytest.mark.parametrize(
    ("name", "line"),
    [
        ("oscillations/stiffness-and-damping-from-a-record", "c = 2 m ln(1.6)/T = 2 · 2 ln(1.6) / 0.4 = 4.700 N·s/m"),
        (
            "oscillations/stiffness-and-damping-from-a-record",
            "ζ = ln(1.6)/(T ω_0) = ln(1.6) / (0.4 · 15.752) = 0.07459",
        ),
        ("oscillations/bar-with-spring-and-dashpot-in-us-units", "  ω_d = 38.45 rad/s"),
        ("oscillations/bar-with-spring-and-dashpot-in-us-units", "δ = 3 π c g d²/(W L² ω_d)"),
    ],
)
def test_they_are_told_by_the_frequency(name: str, line: str) -> None:
    """Logarithms of numbers stand as one, and what the file calls as the page does is not told twice."""
    page = Terminal(width=120).render(narrate(solve_problem(read(str(ROOT / "problems" / f"{name}.yaml")))))
    assert line in page


STRUCK = """
title: Block that rebounds
plane: vertical
bodies: {ball: {particle: [0, 2 m], mass: any}}
surfaces: {floor: {through: [0, 0], angle: 0 deg}}
joints:
  - impact: {between: [ball, floor], restitution: 0.6, during: 2->3}
states:
  1: [at rest]
  2: [y(ball) = 0]
  3: [just after 2]
find: {loss: (KE(ball) @ 2 - KE(ball) @ 3)/KE(ball) @ 2}
"""


def test_a_share_from_which_the_mass_cancels_has_its_numbers() -> None:
    problem, _ = load_text(STRUCK)
    assert problem is not None
    (line,) = re.findall(r"loss = 1 - .*", Terminal(width=120).render(narrate(solve_problem(problem))))
    assert line.endswith("= 0.64")
