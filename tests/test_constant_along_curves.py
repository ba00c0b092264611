"""A constant tangential acceleration on a curve y(x): v = v_0 + a t and v² = v_0² + 2 a s with the arc length s."""

from __future__ import annotations

from math import asinh, log, sqrt

import pytest
from answered import first, solve

TRACK = """
title: Bead that speeds up along a parabola
{a}
points: {{P: [0, 0]}}
surfaces: {{track: {{y: x^2/(2 m)}}}}
bodies: {{bead: {{particle: P}}}}
joints: [guide: {{point: P, along: track}}]
motion: [a(P).t = a_t]
states:
  1: [t = 0, v(P).x = 1 m/s]
  2: [{end}]
find: {{{find}}}
"""
LENGTH = sqrt(5) + asinh(2) / 2
"""∫ √(1 + x²) dx from 0 to 2."""


def test_of_a_place() -> None:
    found = solve(TRACK.format(a="given: {a_t: 1.5 m/s^2}", end="x(P) = 2 m", find="v: v(P).mag @ 2, t: t @ 2"))
    v = sqrt(1 + 3 * LENGTH)
    assert (first(found["v"]), first(found["t"])) == pytest.approx((v, (v - 1) / 1.5))


def test_of_a_time() -> None:
    end = sqrt(1 + 3 * LENGTH)
    text = TRACK.format(a="given: {a_t: 1.5 m/s^2}", end=f"t = {(end - 1) / 1.5:.12f} s", find="x: x(P) @ 2")
    assert first(solve(text)["x"]) == pytest.approx(2)


def test_of_a_rate_that_is_sought() -> None:
    text = TRACK.format(a="unknowns: {a_t: m/s^2}", end="x(P) = 2 m, v(P).mag = 3 m/s", find="a: a_t")
    assert first(solve(text)["a"]) == pytest.approx(8 / (2 * LENGTH))


def test_in_letters() -> None:
    text = TRACK.replace("v(P).x = 1 m/s", "at rest")
    (formula,) = solve(text.format(a="symbols: {a_t: m/s^2}", end="x(P) = 2 m", find="v: v(P).mag @ 2"))[
        "v"
    ].expressions
    (letter,) = formula.free_symbols
    assert float(formula.subs(letter, 1)) == pytest.approx(sqrt(2 * sqrt(5) + log(2 + sqrt(5))))
