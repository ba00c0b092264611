"""`along` of a rope holds for all its parts: one that is drawn across is refused, not left out of the length."""

from __future__ import annotations

import pytest
from answered import solve

from planar_cli.errors import FileProblem

BLOCKS = """
title: Block on a table, block on a moving pulley
plane: vertical
given: {m_A: 100 kg, m_B: 300 kg}
points: {A: [0, 1 m], D: [2 m, 1 m], C: [CX, 0], F: [FX, 1 m]}
bodies:
  A: {particle: A, mass: m_A}
  B: {particle: C, mass: m_B}
joints:
  - guide: {point: A, along: 0 deg, name: table}
  - guide: {point: C, along: 90 deg, name: shaft}
  - rope: {path: [A, D, C, F]ALONG, name: cord}
instant: [at rest]
find: {a_A: a(A).x, T: tension(cord)}
"""


@pytest.mark.parametrize("angle", ["90 deg", "-90 deg"])
def test_a_part_across_the_direction_is_refused(angle: str) -> None:
    text = BLOCKS.replace("CX", "2.2 m").replace("FX", "2.4 m").replace("ALONG", f", along: {angle}")
    with pytest.raises(FileProblem) as refused:
        solve(text)
    why = refused.value.diagnostics[0]
    assert (why.code, why.mark.line) == ("PL539", 12)
    assert why.message == "cord: its part from A to D runs across its direction `along`"


def test_parallel_parts_that_are_drawn_parallel_are_enough() -> None:
    found = solve(BLOCKS.replace("CX", "2 m").replace("FX", "2 m").replace("ALONG", ""))["a_A"].values
    # By virtual work: A goes 2 for 1 of B, so that m_B g/2 moves m_A + m_B/4.
    assert found is not None
    assert float(found[0]) == pytest.approx(300 * 9.81 / 2 / (100 + 300 / 4))
