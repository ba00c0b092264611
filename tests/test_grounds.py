"""`ground` where a body touches it: a horizontal floor where it can be nothing else, and what is refused."""

from __future__ import annotations

import pytest
from answered import assert_close, solve

from planar_cli.errors import FileProblem
from planar_cli.problem.structure import load_text

WHEEL = """
title: Wheel pulled along the ground
plane: vertical
given: {R: 0.3 m, floor: 30 N}
points: {G: [0, R]}
bodies: {wheel: {disk: G, radius: R, mass: 10 kg}}
joints:
  - rolling: {between: [wheel, ground]}
loads:
  - force: {at: G, magnitude: floor, angle: 0 deg}
instant: [at rest]
find: {a: a(G).x, F: friction(wheel).x}
"""

BOX = """
title: Box on the ground
plane: vertical
points: {G: [0, 0.5 m], A: [-0.3 m, 0], B: [0.3 m, 0]}
bodies: {box: {plate: G, width: 0.6 m, height: 1 m, mass: 10 kg}}
joints:
  - contact: {between: [box, ground], at: A, mu: 0.4}
  - contact: {between: [box, ground], at: B, mu: 0.4}
loads:
  - force: {at: G, magnitude: 20 N, angle: 0 deg}
instant: [at rest]
find: {N: N(A)}
"""

BOUNCE = """
title: Ball that bounces where a crate stands
plane: vertical
bodies: {crate: {particle: [5 m, 0], mass: 1 kg}, ball: {particle: [0, 2 m], mass: 1 kg}}
joints:
  - contact: {between: [crate, ground], mu: 0.4}
  - impact: {between: [ball, ground], restitution: 0.5}
states: {1: [t = 0, at rest], 2: [y(ball) = 0], 3: [just after 2]}
find: {v: v(ball).y @ 3}
"""

LADDER = """
title: Ladder
plane: vertical
points: {A: [0, 0], B: [1 m, 2 m]}
bodies: {ladder: {rod: [A, B], mass: 3 kg}}
joints:
  - contact: {between: [ladder, ground], at: B, mu: 0}
  - guide: {point: A, along: 0 deg}
instant: [at rest]
find: {a: alpha(ladder)}
"""

CROSSING = """
title: Wheel whose floor has the wrong direction
plane: vertical
points: {G: [0, 0.5 m], C: {from: G, distance: 0.5 m, angle: -60 deg}}
surfaces: {slope: {through: C, angle: 0 deg}}
bodies: {wheel: {disk: G, radius: 0.5 m, mass: 3 kg}}
joints:
  - JOINT: {between: [slope, wheel], at: C}
instant: [v(G).x = 2 m/s]
find: {w: omega(wheel)}
"""


def test_a_wheel() -> None:
    found = solve(WHEEL)
    assert_close(found["a"], 2)
    assert_close(found["F"], -10)


def test_a_box_on_two_corners() -> None:
    assert_close(solve(BOX)["N"], (98.1 * 0.3 - 20 * 0.5) / 0.6, 9)


def test_the_same_ground_for_an_impact() -> None:
    assert_close(solve(BOUNCE)["v"], 0.5 * (2 * 9.81 * 2) ** 0.5, 9)


EDGE = """
title: Falling bar that strikes an edge
plane: vertical
points: {A: [0, 0], B: [1 m, 0], P: [0.25 m, 0]}
bodies: {bar: {rod: [A, B], mass: 2 kg}}
joints:
  - impact: {between: [bar, ground], at: P, normal: 90 deg, restitution: 0.5, during: 1->2}
states: {1: [v(bar).x = 0, v(bar).y = -3 m/s, omega(bar) = 0], 2: [just after 1]}
find: {w: omega(bar) @ 2}
"""


@pytest.mark.parametrize(
    ("text", "message"),
    [
        (
            WHEEL.replace("vertical", "horizontal"),
            "the rolling of wheel and the ground: in a horizontal plane the ground is no floor",
        ),
        (
            LADDER.replace(", at: B", "").replace("[A, B]", "[A, 60 deg], length: 2 m"),
            "the contact of ladder and the ground: the point where ladder touches it is open",
        ),
        (
            BOUNCE.replace("  - contact: {between: [crate, ground], mu: 0.4}\n", ""),
            "the impact of ball and the ground: the file does not say where the ground is",
        ),
        (
            EDGE,
            "the impact of bar and the ground: a fixed edge at P is written as a particle",
        ),
    ],
)
def test_ground_that_may_be_something_else(text: str, message: str) -> None:
    _, diagnostics = load_text(text)
    assert [(d.code, d.message) for d in diagnostics] == [("PL535", message)]


def test_a_body_below_the_ground() -> None:
    with pytest.raises(FileProblem, match="ladder is drawn below B, where it touches the ground"):
        solve(LADDER)


@pytest.mark.parametrize("joint", ["rolling", "contact"])
def test_a_rim_that_crosses(joint: str) -> None:
    text = CROSSING.replace("JOINT", joint)
    with pytest.raises(FileProblem, match="slope and wheel cross at C: their tangents there differ"):
        solve(text if joint == "rolling" else text.replace("at: C}", "at: C, mu: 0.2}"))
