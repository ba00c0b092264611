"""A mode that a state says is checked where the motion has come to that state."""

from __future__ import annotations

import pytest
from answered import first, solve

from planar_cli.errors import NoSolution

LADDER = """title: Rod that slides in a corner
plane: vertical
given: {m: 4 kg, l: 2 m}
coordinates: {beta: deg}
points: {A: [l*cos(beta), 0], B: [0, l*sin(beta)], O: [0, 0]}
surfaces: {floor: {through: O, angle: 0 deg}, wall: {through: O, angle: 90 deg}}
bodies: {rod: {rod: [A, B], mass: m}}
joints:
  - contact: {between: [rod, floor], at: A, mu: 0}
  - contact: {between: [rod, wall], at: B, mu: 0}
states:
  1: [beta = 70 deg, at rest]
  2: [beta = 20 deg MORE]
find: {w: omega(rod) @ 2}
"""


def text(more: str) -> str:
    return LADDER.replace(" MORE", more)


def test_an_end_that_lifts_off_before() -> None:
    with pytest.raises(NoSolution) as error:
        solve(text(", mode(B) = slip"))
    diagnostic = error.value.diagnostics[0]
    assert (diagnostic.code, diagnostic.mark.line) == ("PL617", 13)
    assert "`mode(B) = slip` does not hold at 2: there it is apart" in diagnostic.message


@pytest.mark.parametrize("more", ["", ", mode(B) = apart", ", mode(A) = slip"])
def test_what_is_so(more: str) -> None:
    assert abs(first(solve(text(more))["w"])) == pytest.approx(2.819, abs=1e-3)
