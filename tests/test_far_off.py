"""By how much a point of contact is off the shape that it should be on."""

from __future__ import annotations

import pytest

from planar_cli.errors import FileProblem
from planar_cli.problem.structure import load_text
from planar_cli.solve.run import solve_problem

TEXT = """
plane: vertical
points: {{C: [0, 0], P: [0, {y} m]}}
surfaces: {{{surface}}}
bodies: {{b: {{{body}, mass: 2 kg}}}}
joints:
  - contact: {{between: [b, s], at: C, mu: 0}}
instant: [at rest]
find: {{a: a(b).x}}
"""
FLOOR = "s: {through: C, angle: 0 deg}"
PARTICLE = "particle: C"


@pytest.mark.parametrize(
    ("surface", "body", "y", "told"),
    [
        (FLOOR, "disk: P, radius: 0.2 m", "0.3", "the rim of b, but 0.1 m off"),
        (FLOOR, "plate: P, width: 1 m, height: 0.4 m", "0.3", "an edge of b, but 0 m from its centre along the width"),
        ("s: {center: P, radius: 2 m}", PARTICLE, "-2.25", "s as drawn, but 0.25 m off"),
        ("s: {y: x^2/(2 m) + 0.5 m}", PARTICLE, "1", "s as drawn, but 0.5 m off"),
    ],
)
def test_how_far(surface: str, body: str, y: str, told: str) -> None:
    problem, wrong = load_text(TEXT.format(surface=surface, body=body, y=y))
    assert problem is not None, wrong
    with pytest.raises(FileProblem) as refused:
        solve_problem(problem)
    assert told in refused.value.diagnostics[0].message
