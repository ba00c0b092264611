"""Springs, floors and slots of later states: stretched as they are there, as far as what slides comes."""

from __future__ import annotations

import math

import pytest
from test_figures import illustrated_page
from test_graphs import path_of

from planar_cli.figures.illustrated import figures_of
from planar_cli.formats._svg import papers_of
from planar_cli.report.document.marks import Coil, Figure, Hatched, Mark, Panel, Slot, Symbol


def scene(stem: str) -> tuple[Mark, ...]:
    return dict(figures_of(illustrated_page(path_of(stem))))["scene"].panels[0].marks


def test_a_spring_is_stretched_in_each_state() -> None:
    """A collar on a vertical slot 0.6 m beside C falls 0.45 m and farther: each time the spring goes from C to it."""
    marks = scene("collar-with-a-slanting-spring")
    coils = [m for m in marks if isinstance(m, Coil)]
    (now,) = [m for m in coils if not m.later]
    lengths = sorted(math.dist(m.start, m.end) for m in coils if m.later)
    assert len(lengths) == 2
    assert lengths[0] > math.dist(now.start, now.end)
    assert all(m.lane == 0 for m in coils)


def test_a_later_spring_in_the_line_of_the_first_is_not_drawn() -> None:
    """Beside that line it would be read as a further spring."""
    coils = [m for m in scene("block-hung-on-a-spring") if isinstance(m, Coil)]
    assert [m.later for m in coils] == [False]


def test_a_buffer_that_nothing_touches_is_drawn_once() -> None:
    coils = [m for m in scene("exercise-4-35") if isinstance(m, Coil)]
    assert [m.later for m in coils] == [False]


@pytest.mark.parametrize("stem", ["ex-4-10", "collar-with-a-slanting-spring"])
def test_a_slot_goes_as_far_as_what_slides(stem: str) -> None:
    marks = scene(stem)
    slots = [m for m in marks if isinstance(m, Slot)]
    assert all(m.fixed for m in slots)
    assert any(m.start != m.end for m in slots)
    for later in (m.at for m in marks if isinstance(m, Symbol) and m.kind == "place"):
        assert any(
            math.dist(m.start, later) + math.dist(later, m.end) < math.dist(m.start, m.end) + 1e-6 for m in slots
        )


def test_a_floor_goes_on_to_later_states() -> None:
    marks = scene("block-runs-into-a-spring")
    (floor,) = [m for m in marks if isinstance(m, Hatched)]
    low, high = (f(x for x, _ in floor.places) for f in (min, max))
    assert all(low < m.at[0] < high for m in marks if isinstance(m, Symbol) and m.kind in ("block", "later"))


def test_a_slot_in_a_body_lies_within_it_and_is_closed() -> None:
    (slot,) = [m for m in scene("slider-in-a-chord-of-a-disk") if isinstance(m, Slot)]
    assert not slot.fixed
    assert all(math.hypot(*end) < 0.4 for end in (slot.start, slot.end))
    (paper,) = papers_of(Figure((Panel((slot,)),), ""))
    (stroke,) = paper.strokes
    assert stroke.closed


def test_a_slot_ends_at_what_holds_the_body() -> None:
    (slot,) = [m for m in scene("block-in-a-slot-of-a-disk-that-starts") if isinstance(m, Slot)]
    assert 0 < min(slot.start[0], slot.end[0]) <= 0.1
