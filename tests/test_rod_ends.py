"""A rod touches a line with the end that stands there, by its name or by its place; `at` need not say it."""

from __future__ import annotations

import pytest
from answered import first, solve

from planar_cli.errors import FileProblem
from planar_cli.problem.structure import load_text

LADDER = """
title: Smooth ladder that slides down
plane: vertical
given: {m: 20 kg, l: 4 m, beta: 60 deg}
points: {A: [0, 0], B: {from: A, distance: l, angle: beta}}
surfaces: {floor: {through: A, angle: 0 deg}, wall: {through: B, angle: 90 deg}}
bodies: {ladder: {rod: [A, B], mass: m}}
joints:
  - contact: {between: [ladder, floor], mu: 0}
  - contact: {between: [wall, ladder], mu: 0}
instant: [at rest]
find: {alpha: alpha(ladder), N: N(A)}
"""


@pytest.mark.parametrize(
    ("floor", "wall"),
    [("A", "B"), ("[0, 0]", "B"), ("[-1 m, 0]", "[2 m, 5 m]"), ("[3 m, 0]", "[l*cos(beta), 0]")],
)
def test_the_end_that_stands_there_is_meant(floor: str, wall: str) -> None:
    """alpha = -3 g cos beta/(2 l), as for every rod that slides between a floor and a wall at right angles."""
    text = LADDER.replace("through: A", f"through: {floor}").replace("through: B", f"through: {wall}")
    found = solve(text)
    assert first(found["alpha"]) == pytest.approx(-3 * 9.81 / 4 / 4)
    # The mass centre comes down with alpha l cos(beta)/2.
    assert first(found["N"]) == pytest.approx(20 * (9.81 - 3 * 9.81 / 16 * 4 / 4))


@pytest.mark.parametrize("floor", ["[0, 1 m]", "[0, -1 m]"])
def test_where_no_end_stands_the_point_is_asked_for(floor: str) -> None:
    with pytest.raises(FileProblem) as refused:
        solve(LADDER.replace("through: A", f"through: {floor}").replace("N(A)", "alpha(ladder)"))
    assert refused.value.diagnostics[0].message == "neither end of ladder is on floor"


def test_a_length_at_the_end_of_a_long_chain_is_refused() -> None:
    """Where the end is must not be asked of a chain of names before its length is known."""
    chain = ", ".join(["k0: 4 m", *(f"k{i}: k{i - 1}" for i in range(1, 3001)), "l: k3000"])
    _, wrong = load_text(LADDER.replace("l: 4 m", chain))
    assert [d.code for d in wrong] == ["PL207"]
