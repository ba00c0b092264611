"""What is largest is so in time where it is the same whatever the sought constant is; a product is zero with each of
its factors.
"""

from __future__ import annotations

from math import pi

import pytest
from answered import first, solve

from planar_cli.errors import NoSolution
from planar_cli.formats.terminal import Terminal
from planar_cli.problem.structure import load_text
from planar_cli.report.page.narrate import narrate
from planar_cli.solve.run import solve_problem

SHAKER = """
title: Largest amplitude of a shaker on which a block stays
plane: vertical
{data}
unknowns: {{A: mm}}
points: {{P: [0, 0]}}
surfaces: {{top: {{through: P, angle: 0 deg, body: table}}}}
bodies:
  table: {{points: [P]}}
  block: {{particle: P, mass: any}}
joints:
  - guide: {{body: table, along: 90 deg, name: column}}
  - contact: {{between: [block, top], at: P, mu: 0.3, name: face}}
motion: ["y(table) = {motion}"]
states:
  1: [t = 0]
  highest: [{highest}]
find: {{A_max: A in mm}}
"""
NUMBERS, LETTERS = "given: {f: 5 Hz}", "symbols: {f: Hz}"
SINE = "A*sin(2*pi*f*t)"
LIMIT = 9.81 / (10 * pi) ** 2
"""The block falls freely there: A (2 pi f)^2 = g."""


@pytest.mark.slow
@pytest.mark.parametrize("motion", [SINE, "-A*cos(2*pi*f*t)"])
@pytest.mark.parametrize(
    "highest",
    [
        "y(table) is largest, N(face) = 0",
        "N(face) = 0, y(table) is largest",
        "a(table).y is smallest, N(face) = 0",
        "v(table).y = 0, N(face) = 0",
        "N(face) = 0, v(table).y = 0",
    ],
)
def test_block_only_just_stays(motion: str, highest: str) -> None:
    found = solve(SHAKER.format(data=NUMBERS, motion=motion, highest=highest))
    assert first(found["A_max"]) == pytest.approx(LIMIT)


@pytest.mark.slow
def test_smallest_is_not_told_by_what_is_largest() -> None:
    """Where the table is lowest it presses most."""
    with pytest.raises(NoSolution):
        solve(SHAKER.format(data=NUMBERS, motion=SINE, highest="y(table) is smallest, N(face) = 0"))


def test_in_letters_with_the_page() -> None:
    problem = SHAKER.format(data=LETTERS, motion=SINE, highest="y(table) is largest, N(face) = 0")
    page = Terminal().render(narrate(solve_problem(load_text(problem)[0])))
    assert "where its derivative is zero" in page
    assert "g/(4 π² f²)" in page
    assert "equilibrium" not in page


TABLE = """
title: Friction needed on a table that vibrates sideways
plane: vertical
given: {{f: 5 Hz, A: 5 mm}}
unknowns: {{mu_s: 1}}
points: {{P: [0, 0]}}
surfaces: {{top: {{through: P, angle: 0 deg, body: table}}}}
bodies:
  table: {{points: [P]}}
  block: {{particle: P, mass: any}}
joints:
  - guide: {{body: table, along: 0 deg, name: way}}
  - contact: {{between: [block, top], at: P, mu_s: mu_s, name: face}}
motion: ["x(table) = A*sin(2*pi*f*t)"]
states: {{1: [t = 0], 2: [t = 0.05 s, mode(face) = stick, {limit}]}}
find: {{mu_min: mu_s}}
"""


def test_limit_of_friction_that_the_hint_names() -> None:
    """mu g = A (2 pi f)^2 at the end of the stroke."""
    with pytest.raises(NoSolution) as error:
        solve(TABLE.format(limit="mu_s is smallest"))
    (why,) = error.value.diagnostics
    limit = next(text for text in (why.hint or "").split("`") if text.startswith("friction("))
    assert first(solve(TABLE.format(limit=limit))["mu_min"]) == pytest.approx(0.005 * (10 * pi) ** 2 / 9.81)
