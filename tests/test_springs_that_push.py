"""A spring that is compressed at the one instant is drawn pushing, and the letter of its force is its push."""

from __future__ import annotations

import re

import pytest

from planar_cli.formats.terminal import Terminal
from planar_cli.problem.structure import load_text
from planar_cli.report.page.narrate import narrate
from planar_cli.solve.run import solve_problem

RING = """
title: Ring on a rod with a slanting spring
plane: vertical
given: {{m: 2 kg, k: 500 N/m, l_0: {natural}, b: 0.3 m, h: 0.4 m}}
points: {{O: [0, 0], P: [b, h]}}
bodies: {{ring: {{particle: P, mass: m}}}}
joints:
  - guide: {{point: P, along: 0 deg}}
loads:
  - spring: {{name: coil, between: [O, P], stiffness: k, natural_length: l_0}}
instant: [at rest]
find: {{a: a(ring).x, S: tension(coil)}}
"""


def page(natural: str) -> str:
    problem, wrong = load_text(RING.format(natural=natural))
    assert problem is not None, wrong
    return re.sub(r"\s+", " ", Terminal(200).render(narrate(solve_problem(problem))))


@pytest.mark.parametrize(
    ("natural", "lines"),
    [
        ("0.6 m", ("F_coil ↗", "push of the spring coil: F_coil = k (l_0 - √(b² + h²)) =", "= 50 N", "S = -50 N")),
        ("0.4 m", ("F_coil ↙", "pull of the spring coil: F_coil = k (√(b² + h²) - l_0) =", "= 50 N", "S = 50 N")),
    ],
)
def test_the_sense_that_it_has(natural: str, lines: tuple[str, ...]) -> None:
    told = page(natural)
    for words in lines:
        assert words in told.replace("S = -F_coil", "S").replace("S = F_coil", "S")
