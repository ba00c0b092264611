"""The curve of what flies freely is told by its start, whether or not the file speaks of time."""

from __future__ import annotations

import pytest

from planar_cli.formats.terminal import Terminal
from planar_cli.problem.structure import load_text
from planar_cli.report.page.narrate import narrate
from planar_cli.solve.run import solve_problem

THROW = """plane: vertical
bodies: {P: {particle: [0, 0], mass: 2 kg}}
states:
  0: [v(P).x = 3 m/s, v(P).y = 4 m/s]
  1: [y(P) = 0]
find: {curve: FIND}
"""


@pytest.mark.parametrize(("find", "told"), [("path(P)", "parabola"), ("hodograph(P)", "straight line, v_x = 3")])
def test_a_throw(find: str, told: str) -> None:
    problem, wrong = load_text(THROW.replace("FIND", find))
    assert problem is not None, wrong
    assert told in " ".join(Terminal(300).render(narrate(solve_problem(problem))).split())
