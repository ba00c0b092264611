"""Springs that are relaxed at the angle of a body, without a coordinate of the file."""

from __future__ import annotations

import math

import pytest
from answered import assert_close, number, solve

from planar_cli.errors import FileProblem

BAR = """
title: Bar held by a spring that is relaxed when the bar is slanted
plane: vertical
given: {m: 3 kg, L: 1 m, k: 50 N/m}
points: {O: [0, 0], B: [L, 0], C: [2*L, 0], W: [L, 1 m]}
bodies: {rod: {rod: [O, B], mass: m}, other: {rod: [B, C], mass: m}}
joints:
  - pin: {at: O, between: [ground, rod]}
  - weld: {at: B, between: [rod, other]}
loads:
  - spring: {between: [W, B], stiffness: k, relaxed_at: [theta(rod) = 30 deg], name: s}
states: {1: [at rest, t = 0], 2: [omega(rod) = 0]}
find: {F: force(s).mag @ 1, alpha: alpha(rod) @ 1, phi: theta(rod) @ 2}
"""
RELAXED = math.hypot(math.cos(math.pi / 6) - 1, 0.5 - 1)


@pytest.mark.slow
def test_a_bar_on_a_pin() -> None:
    """k (1 m - l_0) L - 2 m g L = (8/3) m L² α; and the energy is the same where the bar is at rest again."""
    found = solve(BAR)
    force = 50 * (1 - RELAXED)
    assert_close(found["F"], force)
    assert_close(found["alpha"], (force - 6 * 9.81) / 8)
    phi = float(number(found["phi"]))
    stretch = math.hypot(math.cos(phi) - 1, math.sin(phi) - 1) - RELAXED
    assert phi < -0.1
    gained = 25 * (stretch**2 - (1 - RELAXED) ** 2) + 6 * 9.81 * math.sin(phi)
    assert abs(gained) < 1e-9


@pytest.mark.parametrize(
    ("relation", "message", "write"),
    [
        (
            "theta(other) = 30 deg",
            "other does not turn about one pin of the ground: where it is at that angle is open",
            "`relaxed_at: [x = …]`, or give its `natural_length`",
        ),
        (
            "x(B) = 0.5 m",
            "a relaxed position is given by its coordinates, by the angle of a body or by that of a particle",
            "`[theta(b) =",
        ),
    ],
)
def test_what_leaves_it_open(relation: str, message: str, write: str) -> None:
    with pytest.raises(FileProblem) as caught:
        solve(BAR.replace("theta(rod) = 30 deg", relation))
    (diagnostic,) = caught.value.diagnostics
    assert (diagnostic.code, diagnostic.message) == ("PL542", message)
    assert write in diagnostic.hint


SLIDER = """
title: Block in a guide, held by a spring
plane: vertical
points: {W: [0, 1 m], B: [3 m, 0]}
bodies: {b: {particle: B, mass: 2 kg}}
joints:
  - GUIDE
loads:
  - spring: {between: [W, END], stiffness: 200 N/m, relaxed_at: [RELAXED], name: s}
instant: [at rest]
find: {F: force(s).mag}
"""
SLANTED = "guide: {point: B, along: 45 deg}"


@pytest.mark.parametrize("end", ["B", "b"])
@pytest.mark.parametrize(
    ("relaxed", "length"),
    [
        ("y(B) = -3 m", 4),
        ("r(b).x = 0 m", 4),
        ("x(b) = 1 m, y(b) = 1 m", 1),
        ("r(b/W).mag = 2 m", 2),
    ],
)
def test_a_particle_at_its_end(relaxed: str, length: float, end: str) -> None:
    """It is √10 m long as drawn."""
    text = SLIDER.replace("RELAXED", relaxed).replace("GUIDE", SLANTED).replace("END", end)
    assert_close(solve(text)["F"], 200 * abs(math.sqrt(10) - length))


@pytest.mark.parametrize(
    ("relaxed", "guide", "message"),
    [
        (
            "x(B) = 1 m",
            "guide: {point: B, along: 90 deg}",
            "where B is when the spring is relaxed is open: x(B) alone tells it on no guide",
        ),
        (
            "x(B) = 1 m, r(B/W).mag = 1 m",
            SLANTED,
            "a relaxed position is given in one way, by coordinates or by places",
        ),
    ],
)
def test_what_leaves_its_end_open(relaxed: str, guide: str, message: str) -> None:
    with pytest.raises(FileProblem) as caught:
        solve(SLIDER.replace("RELAXED", relaxed).replace("GUIDE", guide).replace("END", "B"))
    assert (caught.value.diagnostics[0].code, caught.value.diagnostics[0].message) == ("PL542", message)


def test_a_motion_from_a_spring_that_a_place_relaxes() -> None:
    """k s²/2 = m v²/2 with s = 0.2 m."""
    text = SLIDER.replace("RELAXED", "x(b) = 1 m").replace("GUIDE", "guide: {body: b, along: 0 deg}")
    text = text.replace("END", "b").replace("W: [0, 1 m], B: [3 m, 0]", "W: [0, 0], B: [1.2 m, 0]")
    text = text.replace("instant: [at rest]", "states: {1: [at rest], 2: [x(b) = 1 m]}")
    assert_close(solve(text.replace("F: force(s).mag", "v: v(b).x @ 2"))["v"], -2)
