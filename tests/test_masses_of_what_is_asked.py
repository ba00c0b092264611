"""A mass on which a find rests is no datum that is left over, though no force of the page needs it."""

from __future__ import annotations

import pytest

from planar_cli.formats.terminal import Terminal
from planar_cli.problem.structure import load_text
from planar_cli.report.page.narrate import narrate
from planar_cli.solve.run import solve_problem

PLATE = """bodies: {w: {plate: [0, 0], width: 1 m, height: 2 m, mass: 3 kg}}
find: {FIND}
"""


@pytest.mark.parametrize("find", ["I: I(w)", "m: mass(w)"])
def test_a_mass_that_is_asked_about(find: str) -> None:
    problem, wrong = load_text(PLATE.replace("FIND", find))
    assert problem is not None, wrong
    assert "not needed" not in Terminal(300).render(narrate(solve_problem(problem)))
