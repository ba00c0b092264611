"""Angular momentum and energy about points that move: the mass centre of all, a body whose motion is prescribed."""

from __future__ import annotations

import math
import re

import pytest
from answered import first, solve

from planar_cli.formats.terminal import Terminal
from planar_cli.problem.structure import load_text
from planar_cli.report.page.narrate import narrate
from planar_cli.solve.run import solve_problem

BEAD = """
title: Bead that slides out on a free rod
plane: horizontal
given: {m: 0.5 kg, M: 2 kg, l: 1.2 m, w: 6 rad/s}
points: {A: [-l/2, 0], B: [l/2, 0], P: [0.1 m, 0]}
bodies: {rod: {rod: [A, B], mass: M}, bead: {particle: P, mass: m}}
joints:
  - guide: {point: bead, along: rod, mu: 0}
states:
  1: [omega(rod) = w, v(rod) = 0, v(bead/rod) = 0]
  2: [r(bead/A).mag = l]
find: {w2: omega(rod) @ 2, u: v(bead/rod).mag @ 2}
"""
CARRIAGE = """
title: Rod on a carriage that speeds up, looked at from above
plane: horizontal
given: {M: 2 kg, l: 1.2 m, a0: 3 m/s^2}
points: {A: [0, 0], B: [l, 0]}
bodies: {carriage: {particle: A}, rod: {rod: [A, B], mass: M}}
joints:
  - pin: {at: A, between: [carriage, rod]}
  - guide: {body: carriage, along: 90 deg}
motion: [a(carriage).y = a0]
states:
  1: [at rest, v(carriage).y = 0]
  2: [theta(rod) = -90 deg]
find: {w2: omega(rod) @ 2}
"""
STEADY = """
title: Bead in a tube that is pinned to a carriage in steady motion
plane: horizontal
given: {m: 0.5 kg, M: 2 kg, l: 1.2 m, w: 6 rad/s, u: 3 m/s}
points: {A: [0, 0], B: [l, 0], P: [0.1 m, 0]}
bodies: {carriage: {particle: A}, tube: {rod: [A, B], mass: M}, bead: {particle: P, mass: m}}
joints:
  - pin: {at: A, between: [carriage, tube]}
  - guide: {body: carriage, along: 0 deg}
  - guide: {point: bead, along: tube, mu: 0}
motion: [v(carriage).x = u]
states:
  1: [omega(tube) = w, v(bead/tube) = 0]
  2: [r(bead/A).mag = l]
find: {w2: omega(tube) @ 2, u2: v(bead/tube).mag @ 2}
"""
ABOUT = "conservation of angular momentum about"


@pytest.mark.parametrize(
    ("text", "truth", "words"),
    [
        # (1/12 M l² + μ x²) ω is kept with μ = M m/(M + m), and so is the energy seen from G.
        (
            BEAD,
            {"w2": 3.8125, "u": math.sqrt((0.244 * 6**2 - 0.384 * 3.8125**2) / 0.4)},
            (f"{ABOUT} G, the mass centre of all", "moves with G"),
        ),
        # ω² = 3 a0/l, as if a weight pulled backwards.
        (CARRIAGE, {"w2": -2.7386127875}, ("moves with A", "U' of the forces of inertia")),
        # (M l²/3 + m x²) ω is kept about A.
        (
            STEADY,
            {"w2": 5.79 / 1.68, "u2": math.sqrt((0.965 * 6**2 - 5.79**2 / 1.68) / 0.5)},
            (f"{ABOUT} A", "moves with A"),
        ),
    ],
)
def test_seen_from_a_point_that_moves(text: str, truth: dict[str, float], words: tuple[str, ...]) -> None:
    problem, wrong = load_text(text)
    assert problem is not None, wrong
    solution = solve_problem(problem)
    found = {f.name: f for part in solution.parts for f in part.found}
    for name, value in truth.items():
        assert first(found[name]) == pytest.approx(value, rel=1e-5)
    page = re.sub(r"\s+", " ", Terminal(width=110).render(narrate(solution)))
    assert all(w in page for w in words)
    assert "numerical" not in page


BOWL = """
title: Bead let go at the rim of a bowl on a cart that is free to move
plane: vertical
given: {m: 1 kg, M: 3 kg, R: 0.5 m}
points: {O: [0, R], P: [R, R], G: [0, 0]}
surfaces: {bowl: {center: O, radius: R, body: cart}, floor: {through: [0, 0], angle: 0 deg}}
bodies: {cart: {points: [O], center: G, mass: M}, bead: {particle: P, mass: m}}
joints:
  - guide: {body: cart, along: floor}
  - contact: {between: [bead, bowl], at: P, mu: 0}
states: {1: [at rest], 2: [y(bead) = 0]}
find: {w: v(bead/cart).mag @ 2, N: N(P) @ 2}
"""
FIXED = """
title: Bead let go at the rim of a bowl
plane: vertical
given: {m: 1 kg, R: 0.5 m}
points: {O: [0, R], P: [R, R]}
surfaces: {bowl: {center: O, radius: R}}
bodies: {bead: {particle: P, mass: m}}
joints:
  - contact: {between: [bead, bowl], at: P, mu: 0}
states: {1: [at rest], 2: [y(bead) is smallest]}
find: {w: v(bead).mag @ 2, N: N(P) @ 2}
"""


@pytest.mark.parametrize(
    ("text", "w2"),
    [
        # w² = 2 g R (M + m)/M, and N = m g + m w²/R, as the cart has no acceleration there.
        (BOWL, 2 * 9.81 * 0.5 * 4 / 3),
        (FIXED, 2 * 9.81 * 0.5),
    ],
)
def test_from_the_height_of_the_centre_it_presses_inside(text: str, w2: float) -> None:
    answers = solve(text)
    assert first(answers["w"]) == pytest.approx(math.sqrt(w2))
    assert first(answers["N"]) == pytest.approx(9.81 + w2 / 0.5)
