"""Ends of rods and corners of plates that stand on a line or on the ground, where the file does not name the point."""

from __future__ import annotations

import pytest
from answered import assert_close, solve

from planar_cli.errors import FileProblem

LADDER = """
title: Ladder that slides
plane: vertical
points: {A: [0, 0], B: [-1.2 m, 1.6 m]}
surfaces: {floor: {through: [5 m, 0], angle: 0 deg}, wall: {through: [-1.2 m, 0], angle: 90 deg}}
bodies: {rod: {rod: [A, B], mass: 3 kg}}
joints:
  - contact: {between: [rod, floor], mu: 0}
  - contact: {between: [rod, wall], mu: 0}
instant: [at rest]
find: {value: alpha(rod)}
"""
FALLS = """
title: Rod that falls flat
plane: vertical
points: {A: [0, 0], B: {from: A, distance: 2 m, angle: 60 deg}}
bodies: {rod: {rod: [A, B], mass: 3 kg}}
joints:
  - contact: {between: [rod, ground], mu: 0}
states: {1: [at rest], 2: [theta(rod) = 0]}
find: {value: omega(rod) @ 2}
"""
CRATE = """
title: Crate on one corner
plane: vertical
points: {G: [0, 0.48 m]}
surfaces: {floor: {through: [1 m, 0], angle: 0 deg}}
bodies: {p: {plate: G, width: 0.8 m, height: 0.6 m, angle: atan(3/4), mass: 6 kg}}
joints:
  - contact: {between: [p, floor], mu: 0}
instant: [at rest]
find: {value: N(p)}
"""
LETTERS = """
title: Box on a corner
plane: vertical
symbols: {b: m, m: kg}
points: {C: [0, 0], G: [b/2, b/2]}
surfaces: {slope: {through: C, angle: -30 deg}}
bodies: {p: {plate: G, width: b, height: b, mass: m}}
joints:
  - contact: {between: [p, slope], mu: 0}
instant: [at rest]
find: {value: N(p)/(m*g)}
"""


@pytest.mark.parametrize(
    ("text", "value"),
    [
        (LADDER, 1.5 * 9.81 * 0.6 / 2),
        # 1/2 (m L²/4 + m L²/12) ω² = m g L/2 sin 60°
        (FALLS, -((1.5 * 9.81 * 3**0.5 / 2) ** 0.5)),
        # N = m g/(1 + m c²/I), c = 0.14 m beside the centre
        (CRATE, 6 * 9.81 / (1 + 6 * 0.14**2 / 0.5)),
        (CRATE.replace("[p, floor]", "[p, ground]"), 6 * 9.81 / (1 + 6 * 0.14**2 / 0.5)),
        # N = m g cos 30°/(1 + 12 c²/(2 b²)), c = b (√3 - 1)/4
        (LETTERS, 3**0.5 / 2 / (1 + 6 * ((3**0.5 - 1) / 4) ** 2)),
    ],
)
def test_that_which_stands_there(text: str, value: float) -> None:
    assert_close(solve(text)["value"], value, 9)


@pytest.mark.parametrize(
    ("text", "told"),
    [
        (LADDER.replace("[-1.2 m, 1.6 m]", "[-1.2 m, 0]"), "both ends of rod are on floor"),
        (LADDER.replace("A: [0, 0]", "A: [0, 1 m]"), "neither end of rod is on floor"),
        (FALLS.replace("angle: 60", "angle: 0"), "both ends of rod are on the ground"),
    ],
)
def test_where_it_is_open(text: str, told: str) -> None:
    with pytest.raises(FileProblem) as refused:
        solve(text)
    assert (refused.value.diagnostics[0].code, refused.value.diagnostics[0].message) == ("PL535", told)
