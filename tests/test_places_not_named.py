"""Places that are written where they are used, and points of contact that the shapes tell."""

from __future__ import annotations

import math

import pytest
from answered import assert_close, solve

from planar_cli.errors import FileProblem
from planar_cli.problem.structure import load_text

PLACES = """
title: Disk on a floor, every place written where it is used
plane: vertical
surfaces: {floor: {through: [0, 0], angle: 0 deg}}
bodies: {disk: {disk: [0, 0.3 m], radius: 0.3 m, mass: 2 kg}}
joints:
  - rolling: {between: [disk, floor], at: [0, 0]}
loads:
  - spring:
      between: [[1 m, 0.3 m], [0, 0.3 m]]
      stiffness: 3 N/m
      natural_length: 0.5 m
instant: [at rest]
find: {a: a(disk).x}
"""

BOWL = """
title: Disk in a bowl
plane: vertical
given: {R: 0.5 m, r: 0.1 m, m: 2 kg, P_1: 3 N}
surfaces: {bowl: {center: [0, 0], radius: R}}
bodies: {disk: {disk: {from: [0, 0], distance: R - r, angle: -60 deg}, radius: r, mass: m}}
joints:
  - rolling: {between: [disk, bowl]}
instant: [at rest]
find: {a: alpha(disk), N: N(disk)}
"""

GEARS = """
title: Two gears, the line of their centres slanted
plane: horizontal
given: {r: 0.1 m, s: 0.2 m, T: 3 N*m}
points: {G: [0, 0], H: {from: G, distance: r + s, angle: 77 deg}}
bodies: {one: {disk: G, radius: r, mass: 2 kg}, other: {disk: H, radius: s, mass: 3 kg}}
joints:
  - pin: {at: G, between: [ground, one]}
  - pin: {at: H, between: [ground, other]}
  - rolling: {between: [one, other]}
loads:
  - torque: {body: one, moment: T}
instant: [at rest]
find: {a: alpha(one), b: alpha(other)}
"""

PLANK = """
title: Plank on a drum, block on the plank's floor
plane: vertical
surfaces: {floor: {through: [0, 0], angle: 0 deg}}
bodies:
  plank: {rod: [[0, 0], {from: [0, 0], distance: 2 m, angle: 30 deg}], mass: 2 kg}
  drum: {disk: [1.25 m, 0], radius: 1.25 m * sin(30 deg), mass: 10 kg}
  block: {particle: [-1 m, 0], mass: 1 kg}
joints:
  - pin: {at: [0, 0], between: [ground, plank]}
  - pin: {at: [1.25 m, 0], between: [ground, drum]}
  - contact: {between: [plank, drum], mu: 0}
  - contact: {between: [block, floor], mu: 0.5}
loads:
  - force: {body: block, magnitude: 10 N, angle: 0 deg}
instant: [at rest]
find: {N: N(plank/drum), a: a(block).x}
"""

ROCKER = """
title: Half disk that is let go while it leans
plane: vertical
given: {R: 0.3 m}
surfaces: {floor: {through: [0, 0], angle: 0 deg}}
bodies: {rocker: {sector: [0, R], radius: R, span: 180 deg, angle: -60 deg, mass: any}}
joints:
  - rolling: {between: [rocker, floor]}
instant: [at rest]
find: {a: alpha(rocker)}
"""
REACH = 4 * 0.3 / (3 * math.pi)
SWING = 0.3**2 / 2 - REACH**2 + (0.3 - REACH * math.cos(math.pi / 6)) ** 2 + (REACH / 2) ** 2
"""About the point of contact, by mass: the mass centre lies REACH from the middle, 30 deg beside the vertical."""

UNBALANCED = """
title: Wheels whose mass centres are not in their middles
plane: vertical
given: {m: 20 kg, R: 0.4 m, e: 0.1 m, k: 0.25 m, m_P: 5 kg}
points: {O: [0, R], G: [e, R], Q: [2 m, R], P: [2 m + e, R]}
surfaces: {floor: {through: [0, 0], angle: 0 deg}}
bodies:
  wheel: {disk: O, radius: R, center: G, mass: m, radius_of_gyration: k}
  laden: {parts: [{disk: Q, radius: R, mass: m}, {particle: P, mass: m_P}]}
joints:
  - rolling: {between: [wheel, floor]}
  - rolling: {between: [laden, floor]}
instant: [omega(wheel) = -5 rad/s, omega(laden) = 0]
find: {a: alpha(wheel), b: alpha(laden)}
"""


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        (PLACES, {"a": 3 * 0.5 / (1.5 * 2)}),
        (BOWL, {"a": 32.7, "N": 2 * 9.81 * 3**0.5 / 2}),
        (GEARS, {"a": 3 / (0.01 + 0.015), "b": -3 / (0.01 + 0.015) / 2}),
        (PLANK, {"N": 2 * 9.81 / 1.25, "a": 10 - 0.5 * 9.81}),
        (ROCKER, {"a": -9.81 * REACH / 2 / SWING}),
        (
            UNBALANCED,
            {
                "a": -0.1 * (9.81 + 0.4 * 25) / (0.25**2 + 0.1**2 + 0.4**2),
                "b": -5 * 0.1 * 9.81 / (1.5 * 20 * 0.4**2 + 5 * (0.1**2 + 0.4**2)),
            },
        ),
    ],
    ids=["places", "inside a ring", "side by side", "edge and particle", "arc of a sector", "mass off the middle"],
)
def test_answers(text: str, expected: dict[str, float]) -> None:
    found = solve(text)
    for name, value in expected.items():
        assert_close(found[name], value)


def test_shapes_that_leave_it_open() -> None:
    """Of two rods that touch, either may stand on the other."""
    _, wrong = load_text(
        """
title: Rod that leans on another
plane: vertical
points: {A: [0, 0], B: [1 m, 1 m], C: [1 m, 0]}
bodies: {rod: {rod: [A, B], mass: 2 kg}, post: {rod: [C, B], mass: 2 kg}}
joints:
  - contact: {between: [rod, post], mu: 0.3}
instant: [at rest]
find: {a: alpha(rod)}
"""
    )
    assert [(d.code, d.message) for d in wrong] == [("PL311", "the contact needs the key 'at'")]


def test_the_arc_of_a_sector_has_its_radius() -> None:
    text = ROCKER.replace("sector: [0, R]", "sector: [0, 0.25 m]").replace(
        "[rocker, floor]", "[rocker, floor], at: [0, 0]"
    )
    with pytest.raises(FileProblem) as caught:
        solve(text)
    (diagnostic,) = caught.value.diagnostics
    assert (diagnostic.code, diagnostic.message) == ("PL522", "the point of contact is not on the arc of rocker")
