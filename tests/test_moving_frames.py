"""Angular momentum and energy about points that move: the mass centre of all, a body whose motion is prescribed."""

from __future__ import annotations

import math
import re

import pytest
from answered import first

from planar_cli.formats.terminal import Terminal
from planar_cli.problem.structure import load_text
from planar_cli.report.narrate import narrate
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
