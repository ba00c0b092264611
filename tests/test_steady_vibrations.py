"""What is largest at t = infinity: the steady vibration that a force or a shaken support keeps up."""

from __future__ import annotations

import math

import pytest
from answered import assert_close, solve

from planar_cli.errors import FileProblem, NoSolution

FORCED = """
title: Block driven by a harmonic force
plane: horizontal
given: {m: 2 kg, k: 200 N/m, c: 4 N*s/m, F: 5 N, w: 8 rad/s}
coordinates: {x: m}
points: {O: [-0.5 m, 0], M: [x, 0]}
bodies: {block: {particle: M, mass: m}}
joints:
  - guide: {point: block, along: 0 deg}
loads:
  - spring: {between: [O, block], stiffness: k, natural_length: 0.5 m, name: s}
  - damper: {between: [O, block], coefficient: c, name: d}
  - force: {body: block, magnitude: F*cos(w*t), angle: 0 deg}
states:
  1: [t = 0, x = 0, v(block).x = 0]
  crest: [t = infinity, x is largest]
  push: [t = infinity, tension(s) + tension(d) is largest]
find: {X: x @ crest, F_T: (tension(s) + tension(d)) @ push}
"""
BELOW = math.hypot(200 - 2 * 8**2, 4 * 8)


def test_the_amplitude_and_the_force_that_is_passed_on() -> None:
    """X = F/√((k - m w²)² + (c w)²), F_T = X √(k² + (c w)²)."""
    answers = solve(FORCED)
    assert_close(answers["X"], 5 / BELOW)
    assert_close(answers["F_T"], 5 / BELOW * math.hypot(200, 4 * 8))


def test_a_shaken_support() -> None:
    """X = b √(k² + (c w)²)/√((k - m w²)² + (c w)²)."""
    text = FORCED.replace("F: 5 N", "b: 10 mm").replace("{x: m}", "{x: m, y: m}").replace("O: [-0.5 m", "O: [y - 0.5 m")
    text = text.replace("bodies: {", "bodies: {base: {particle: O}, ").replace(
        "joints:", 'motion: ["y = b*sin(w*t)"]\njoints:'
    )
    text = text.replace("  - force: {body: block, magnitude: F*cos(w*t), angle: 0 deg}\n", "")
    text = text.replace("  push: [t = infinity, tension(s) + tension(d) is largest]\n", "")
    text = text.replace("[O, block]", "[base, block]").replace("F_T: (tension(s) + tension(d)) @ push", "")
    assert_close(solve(text.replace("crest, }", "crest}"))["X"], 0.01 / BELOW * math.hypot(200, 4 * 8))


@pytest.mark.parametrize("speed", ["8 rad/s", "5 rad/s"])
def test_without_damping_the_start_does_not_die_away(speed: str) -> None:
    """Nor where the whole motion repeats itself, as with half the natural frequency."""
    text = FORCED.replace("  - damper: {between: [O, block], coefficient: c, name: d}\n", "").replace(
        "c: 4 N*s/m, ", ""
    )
    text = text.replace("  push: [t = infinity, tension(s) + tension(d) is largest]\n", "").replace(
        "w: 8 rad/s", f"w: {speed}"
    )
    with pytest.raises(NoSolution, match="does not become steady") as told:
        solve(text.replace(", F_T: (tension(s) + tension(d)) @ push", ""))
    assert told.value.diagnostics[0].code == "PL724"


def test_letters_are_refused() -> None:
    text = FORCED.replace("F: 5 N, ", "").replace("coordinates:", "symbols: {F: N}\ncoordinates:")
    with pytest.raises((FileProblem, NoSolution), match="looked for in numbers"):
        solve(text)
