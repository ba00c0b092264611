"""A smooth wedge of no mass that is driven from under a block, or against it: with letters the condition is told."""

from __future__ import annotations

import pytest

from planar_cli.formats.terminal import Terminal
from planar_cli.problem.structure import load_text
from planar_cli.report.page.narrate import narrate
from planar_cli.solve.run import solve_problem

WEDGE = """
title: Block on a driven wedge
plane: vertical
symbols: {m: kg, beta: deg, a0: m/s^2}
points: {P: [0, 0], W: [0.5 m, 0]}
surfaces: {face: {through: P, angle: beta, body: wedge}}
bodies: {wedge: {points: [W], center: W}, b: {particle: P, mass: m}}
joints:
  - guide: {body: wedge, along: 0 deg}
  - contact: {between: [b, face], mu: 0}
motion: [a(wedge).x = a0]
instant: [at rest]
find: {N: N(b)}
"""


@pytest.mark.parametrize(
    ("text", "told"),
    [
        (WEDGE, ("a0 sin β > g cos β", "N_b presses", "N = 0 N")),
        (WEDGE + "assume: [a0 < g*cos(beta)/sin(beta)]\n", ("N = N_b = m (g cos β - a0 sin β)",)),
        (WEDGE.replace("x = a0", "x = -a0"), ("N = N_b = m (g cos β + a0 sin β)",)),
    ],
)
def test_what_the_page_says(text: str, told: tuple[str, ...]) -> None:
    problem, wrong = load_text(text)
    assert problem is not None, wrong
    page = Terminal(110).render(narrate(solve_problem(problem)))
    assert [line for line in told if line not in page] == []
    assert "no solution" not in page
