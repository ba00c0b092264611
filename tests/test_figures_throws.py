"""What is thrown or falls: where it comes from, the ground on which it lands, the edges that it strikes."""

from __future__ import annotations

import math

import pytest
from test_figures_states import marks_of, named
from worked import worked

from planar_cli.figures.illustrated import figures_of, illustrated
from planar_cli.report.document.marks import Dimension, Hatched, Symbol
from planar_cli.report.page.narrate import narrate


def test_a_throw_against_a_wall_lands_on_the_ground() -> None:
    """Its height is dimensioned though the ball is at no point of the file; how far the wall is, once."""
    marks = marks_of("ball-off-a-smooth-wall")
    (ground,) = [m.places for m in marks if isinstance(m, Hatched) and m.places[0][1] == m.places[-1][1]]
    assert ground[0][1] == 0.0
    level = [m for m in marks if isinstance(m, Dimension)]
    heights = [abs(m.end[1] - m.start[1]) for m in level]
    assert heights.count(1.5) == 1
    assert [abs(m.end[0] - m.start[0]) for m in level].count(pytest.approx(6)) == 1


@pytest.mark.parametrize("stem", ["level-rod-caught-by-an-edge", "falling-bar-strikes-a-ledge"])
def test_a_fixed_particle_that_is_struck_is_an_edge(stem: str) -> None:
    """With its ground below, as what strikes it comes from above."""
    marks = marks_of(stem)
    (edge,) = [m for m in marks if isinstance(m, Symbol) and m.kind == "edge"]
    assert edge.at == (0.0, 0.0)
    assert math.cos(edge.angle) == pytest.approx(1)
    assert not any(isinstance(m, Symbol) and m.kind in ("particle", "weld") for m in marks)


def test_what_hangs_aslant_has_its_support_above() -> None:
    """A plate that a jet holds at 60° from the upright in the second case."""
    solution = worked(named("jet-against-a-hinged-plate"))[0]
    figures = [f for name, f in figures_of(illustrated(narrate(solution), solution)) if name.startswith("scene")]
    supports = [
        m.angle for f in figures for p in f.panels for m in p.marks if isinstance(m, Symbol) and m.kind == "support"
    ]
    assert supports == [math.pi] * 2
