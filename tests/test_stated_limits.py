"""What is largest or smallest where an inequality of the file is all that bounds it."""

from __future__ import annotations

import pytest
import sympy as sp
from answered import first, solve

from planar_cli.errors import NoSolution

BLOCK = """
title: Block that is pushed
plane: horizontal
unknowns: {F: N}
bodies: {b: {particle: [0, 0], mass: 2 kg}}
loads: [{force: {body: b, magnitude: F, angle: 0 deg}}]
instant: [at rest, a(b).x SIGN 4 m/s^2, F is EXTREME]
find: {F: F}
"""
WHIRLED = """
title: Stone on a cord
plane: horizontal
symbols: {T_0: N, m: kg, l: m}
unknowns: {w: rad/s}
points: {O: [0, 0], P: [l, 0]}
bodies: {b: {particle: P, mass: m}}
joints: [{rope: {path: [O, b]}}]
instant: [v(b).y = w*l, tension(O) <= T_0, w is largest]
find: {w: w}
"""
TWO_ROPES = """
title: Load on two ropes
plane: vertical
unknowns: {W: N}
points: {C: [0, 0], A: [-3 m, 4 m], B: [4 m, 3 m]}
bodies: {b: {particle: C, weight: W}}
joints: [{rope: {path: [A, b]}}, {rope: {path: [B, b]}}]
instant: [equilibrium, tension(A) <= FIRST, tension(B) <= SECOND, W is largest]
find: {W: W}
"""


def block(sign: str, extreme: str) -> str:
    return BLOCK.replace("SIGN", sign).replace("EXTREME", extreme)


@pytest.mark.parametrize(("sign", "extreme"), [("<=", "largest"), (">=", "smallest")])
def test_an_acceleration_bounds_a_force(sign: str, extreme: str) -> None:
    assert first(solve(block(sign, extreme))["F"]) == pytest.approx(8)


def test_the_other_end_is_open() -> None:
    with pytest.raises(NoSolution) as error:
        solve(block(">=", "largest"))
    assert error.value.diagnostics[0].code == "PL613"
    assert "may be larger still" in error.value.diagnostics[0].message


def test_a_limit_that_is_left_out() -> None:
    with pytest.raises(NoSolution) as error:
        solve(block("<", "largest"))
    assert "leaves its own limit out" in error.value.diagnostics[0].message
    assert "`a(b).x <= 4 m/s^2`" in (error.value.diagnostics[0].hint or "")


def test_a_rope_that_only_just_holds() -> None:
    """m l ω² = T_0."""
    (found,) = solve(WHIRLED)["w"].expressions or ()
    numbers = {"T_0": 12, "m": 3, "l": sp.Rational(1, 4)}
    assert found.subs({s: numbers[s.name] for s in found.free_symbols}) == 4


@pytest.mark.parametrize(("ropes", "load"), [(("100 N", "100 N"), 125), (("100 N", "60 N"), 100)])
def test_the_weaker_of_two_ropes_counts(ropes: tuple[str, str], load: float) -> None:
    """The ropes are at right angles: T_A = 0.8 W, T_B = 0.6 W."""
    text = TWO_ROPES.replace("FIRST", ropes[0]).replace("SECOND", ropes[1])
    assert first(solve(text)["W"]) == pytest.approx(load)


@pytest.mark.parametrize("limit", ["v(b).x <= 6 m/s, F is largest", "v(b).x = 6 m/s"])
def test_a_limit_of_a_later_state(limit: str) -> None:
    """F = m v_2/t."""
    motion = BLOCK.replace("instant: [at rest, a(b).x SIGN 4 m/s^2, F is EXTREME]", STATES)
    assert first(solve(motion.replace("LIMIT", limit))["F"]) == pytest.approx(4)


STATES = "states: {1: [at rest, t = 0], 2: [t = 3 s, LIMIT]}"
