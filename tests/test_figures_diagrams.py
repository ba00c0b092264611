"""What a diagram shows beside its forces: the points about which moments are taken."""

from __future__ import annotations

import pytest
from conftest import PROBLEMS
from test_figures import illustrated_page

from planar_cli.report.blocks import Drawing, Forces, Name, line
from planar_cli.report.marks import Figure, Polyline, Tag


def diagrams(stem: str) -> list[Figure]:
    page = illustrated_page(next(p for p in PROBLEMS if p.stem == stem))
    pairs = zip(page.blocks, page.blocks[1:], strict=False)
    return [b.figure for before, b in pairs if isinstance(before, Forces) and isinstance(b, Drawing)]


@pytest.mark.parametrize(
    ("stem", "dashed"),
    [
        ("ex-4-16", ([1, 0], [2, 0])),
        ("ladder-leaving-the-wall", ([2, 0], [1, 1])),
        ("ladder-sliding", ([2, 0],)),
    ],
)
def test_the_point_of_moments_is_in_both_diagrams_with_the_lines_that_meet_there(
    stem: str, dashed: tuple[list[int], ...]
) -> None:
    """Of each body of the group; of a normal force with its friction it is the line of the total reaction."""
    found = diagrams(stem)
    assert all(
        sum(isinstance(m, Tag) and m.words == line(Name("C")) for m in p.marks) == 1 for f in found for p in f.panels
    )
    ways = [[sum(isinstance(m, Polyline) and m.style == "way" for m in p.marks) for p in f.panels] for f in found]
    assert ways == [*dashed]


def test_a_point_of_the_file_about_which_moments_are_taken_stands_in_both() -> None:
    (free, kinetic) = diagrams("toppling-pole-whose-foot-slips")[0].panels
    assert all(any(isinstance(m, Tag) and m.words == line(Name("A")) for m in p.marks) for p in (free, kinetic))
