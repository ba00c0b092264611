"""Friction that redundant contacts share: what rests, rests as long as some distribution of the forces holds it."""

from __future__ import annotations

import pytest
from answered import first, solve

from planar_cli.errors import NoSolution
from planar_cli.motion.regime.sharing import best_share

BLOCKS = """
title: Two blocks on a floor with a rope and a pulley
plane: vertical
GIVEN
points: {A: [0, 0], B: [1 m, 0], W: [10 m, 0]}
surfaces: {floor: {through: A, angle: 0 deg}}
bodies:
  block_A: {particle: A, mass: 1 kg}
  block_B: {particle: B, mass: 2 kg}
joints:
  - contact: {between: [block_A, floor], at: A, mu: mu}
  - contact: {between: [block_B, floor], at: B, mu: mu}
  - rope: {path: [B, A, W], along: 0 deg, name: rope}
loads:
  - force: {body: block_B, magnitude: F, angle: 0 deg}
states:
  1: [t = 0, at rest]
"""
FAR = """
  2: [x(block_B) = 1 m + d]
find: {v: v(block_B).x @ 2}
"""
GROOVE = """
title: Disk in a groove
plane: vertical
given: {m: 2 kg, R: 0.1 m, mu: 0.3}
points:
  G: [0, 0]
  A: {from: G, distance: R, angle: -45 deg}
  B: {from: G, distance: R, angle: -135 deg}
surfaces: {right: {through: A, angle: 45 deg}, left: {through: B, angle: -45 deg}}
bodies: {disk: {disk: G, radius: R, mass: m}}
joints:
  - contact: {between: [disk, right], at: A, mu: mu}
  - contact: {between: [disk, left], at: B, mu: mu}
loads:
  - torque: {body: disk, moment: MOMENT}
"""


def _blocks(force: str) -> str:
    return BLOCKS.replace("GIVEN", f"given: {{mu: 0.5, F: {force}, d: 2 m}}")


@pytest.mark.parametrize("force", ["5 N", "10 N", "12.2 N"])
def test_a_force_that_friction_can_hold_moves_nothing(force: str) -> None:
    """From 9.81 N on friction at B alone does not hold it, up to 12.2625 N that at A helps through the rope."""
    with pytest.raises(NoSolution) as refused:
        solve(_blocks(force) + FAR)
    (told,) = refused.value.diagnostics
    assert told.code == "PL621"
    assert "state 2 is never reached" in told.message
    assert "stays as far off: the sides differ by 2 m" in (told.hint or "")


def test_a_force_that_it_can_not_hold() -> None:
    """(m_B + m_A/4) a = F - (m_B + m_A/2) mu g."""
    a = (12.3 - 2.5 * 0.5 * 9.81) / 2.25
    assert first(solve(_blocks("12.3 N") + FAR)["v"]) == pytest.approx((2 * a * 2) ** 0.5)


def test_in_letters_it_is_told_that_no_size_gets_there() -> None:
    letters = "symbols: {F: N, mu: 1, d: m}\nassume: ['F < (2.5 kg)*mu*g']"
    with pytest.raises(NoSolution) as refused:
        solve(BLOCKS.replace("GIVEN", letters) + FAR)
    (told,) = refused.value.diagnostics
    assert told.code == "PL621"
    assert (told.hint or "").startswith("with none of the sizes that were tried for the letters")


def test_a_force_that_grows_moves_them_once_no_distribution_is_left() -> None:
    """F = (2 N/s) t reaches 12.2625 N at 6.13125 s; v = (t - t_2)² (2 N/s)/(2 · 2.25 kg) from there on."""
    text = BLOCKS.replace("GIVEN", "given: {mu: 0.5, c: 2 N, s: 1 s}").replace("magnitude: F", "magnitude: c*t/s")
    found = solve(text + "  2: [mode(B) = slip]\n  3: [t = 10 s]\nfind: {t: t @ 2, v: v(block_B).x @ 3}\n")
    start = 1.25 * 9.81 / 2
    assert first(found["t"]) == pytest.approx(start)
    assert first(found["v"]) == pytest.approx((10 - start) ** 2 / 2.25)


def test_a_disk_in_a_groove_turns_under_the_moment_that_is_the_largest_at_rest() -> None:
    """Four forces, three equations: M (1 + mu²) = sqrt(2) mu m g R where friction is at its limit on both sides."""
    grows = GROOVE.replace("MOMENT", "(0.1 N*m)*t/(1 s)")
    found = solve(grows + "states: {1: [t = 0, at rest], 2: [mode(A) = slip]}\nfind: {t: t @ 2}\n")
    largest = 2**0.5 * 0.3 * 2 * 9.81 * 0.1 / (1 + 0.3**2)
    assert first(found["t"]) == pytest.approx(largest / 0.1)
    asked = GROOVE.replace("MOMENT", "M") + "unknowns: {M: N*m}\n"
    asked += "instant: [at rest, mode(A) = stick, mode(B) = stick, M is largest]\nfind: {M: M}\n"
    assert first(solve(asked)["M"]) == pytest.approx(largest)


@pytest.mark.parametrize(
    ("values", "slopes", "least"),
    [
        ([-1.0, 0.5], [[1.0], [-1.0]], -0.25),  # the mean of both
        ([-0.25, 0.5], [[1.0], [-1.0]], 0.125),
        ([-3.0], [[2.0]], 1.0),  # nothing bounds it
        ([-1.0, 0.5, 0.2], [[1.0, 1.0], [-1.0, -1.0], [0.0, 0.0]], -0.25),  # the same direction twice
        ([0.0, 0.0, 0.3], [[1.0, 0.0], [0.0, 1.0], [-1.0, -1.0]], 0.1),
    ],
)
def test_the_least_condition_is_as_large_as_can_be(
    values: list[float], slopes: list[list[float]], least: float
) -> None:
    share = best_share(values, slopes)
    assert share is not None
    now = [v + sum(s * z for s, z in zip(row, share, strict=True)) for v, row in zip(values, slopes, strict=True)]
    assert min(x for x, row in zip(now, slopes, strict=True) if any(row)) == pytest.approx(least)


def test_conditions_that_no_share_changes() -> None:
    assert best_share([-1.0], [[0.0]]) is None
    assert best_share([-1.0], [[]]) is None
