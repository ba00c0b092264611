"""Later states that are drawn nearer than they are."""

from __future__ import annotations

import math

import pytest
from test_figures_bodies import drawings

from planar_cli.figures.uncrowded import MANY, uncrowded
from planar_cli.report.document.blocks import Name, line
from planar_cli.report.document.marks import Angle, Arc, Dimension, Hatched, Mark, Polyline, Tag, spots_of


def marks_of(stem: str) -> tuple[Mark, ...]:
    return drawings(stem)["scene"].panels[0].marks


def test_what_goes_a_little_stays_where_it_is_beside_what_goes_far() -> None:
    """A gun that recoils on its rails, beside its shell, which is brought near."""
    gun = marks_of("gun-on-rails")
    ground = next(m for m in gun if isinstance(m, Hatched)).places[0][1]
    later = [s for m in gun if isinstance(m, Polyline) and m.style == "hidden" for s in spots_of(m)]
    assert later
    assert min(y for _, y in later) >= ground - 1e-6


def test_what_is_brought_near_is_close_by() -> None:
    """A bicycle, and where it is much farther along its road."""
    spots = [s for m in marks_of("ex-4-18") if isinstance(m, Arc) for s in spots_of(m)]
    assert max(x for x, _ in spots) - min(x for x, _ in spots) < 8.0


def test_an_angle_between_two_states_that_is_asked_is_drawn_at_the_pin() -> None:
    (angle,) = [m for m in marks_of("ex-4-13") if isinstance(m, Angle) and m.words == line(Name("phi_max"))]
    assert angle.vertex == (0.0, 0.0)
    assert math.degrees(angle.start) == pytest.approx(-90)
    assert math.degrees(angle.sweep) == pytest.approx(62.46, abs=0.01)


def test_where_too_much_is_told_the_lengths_are_left_to_the_page() -> None:
    words = [Tag((float(i), 0.0), line(f"{i}")) for i in range(MANY - 1)]
    length = Dimension((0.0, 0.0), (1.0, 0.0), line("l"))
    angles = [Angle((0.0, 0.0), 0.0, 1.0, line(Name(n))) for n in ("beta", "phi")]
    assert uncrowded([*words, length], ()) == [*words, length]
    assert uncrowded([*words, length, angles[0]], ()) == [*words, angles[0]]
    assert uncrowded([*words, length, *angles], ("phi",)) == [*words, angles[1]]


def test_the_origin_is_in_the_middle_of_a_circle_about_it() -> None:
    for panel in drawings("ex-1-12")["vectors of P"].panels:
        assert [m.at for m in panel.marks if isinstance(m, Tag) and m.words == line(Name("O"))] == [(0.0, 0.0)]
