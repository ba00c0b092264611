"""Logarithmic decrement and damping ratio of small oscillations, asked for and stated."""

from __future__ import annotations

import math

import pytest
from answered import assert_close, solve

from planar_cli.errors import NoSolution

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
