"""A long free stretch is drawn shorter where nothing could be read otherwise, and nowhere else."""

from __future__ import annotations

import math
from dataclasses import replace

import pytest
from conftest import PROBLEMS
from figure_demands import demand_figure

from planar_cli.commands.draw import _page
from planar_cli.figures.broken import broken, scene
from planar_cli.figures.illustrated import figures_of
from planar_cli.report.document.blocks import line
from planar_cli.report.document.marks import (
    Arc,
    Dimension,
    Figure,
    Hatched,
    Mark,
    Panel,
    Polyline,
    Spot,
    Symbol,
    Tag,
)

WHEEL = Arc((0.0, 30.0), 0.2, "body")
ROPE = Polyline(((0.2, 30.0), (0.2, 0.0)), "rope")
HEIGHT = Dimension((0.2, 0.0), (0.2, 30.0), line("30 m"), level=True)
HOIST: tuple[Mark, ...] = (WHEEL, ROPE, HEIGHT, Symbol("particle", (0.2, 0.0)), Tag((0.2, 0.0), line("A")))
TURN = math.radians(-25)


def _turned(spot: Spot) -> Spot:
    x, y = spot
    return x * math.cos(TURN) - y * math.sin(TURN), x * math.sin(TURN) + y * math.cos(TURN)


def test_a_long_rope() -> None:
    """The wheel is as it was, the load hangs below the same place of it, and both lines are broken."""
    wheel, rope, height, load, name, *signs = broken(HOIST)
    assert isinstance(wheel, Arc)
    assert isinstance(rope, Polyline)
    assert isinstance(height, Dimension)
    assert isinstance(load, Symbol)
    assert isinstance(name, Tag)
    assert wheel.radius == WHEEL.radius
    (x, top), (x_, bottom) = rope.places
    assert x == pytest.approx(x_) == pytest.approx(wheel.center[0] + 0.2)
    assert top == pytest.approx(wheel.center[1])
    assert load.at == name.at == rope.places[1]
    assert 0.2 < top - bottom < 2.0
    assert height.broken
    assert height.words == HEIGHT.words
    assert math.dist(height.start, height.end) == pytest.approx(top - bottom)
    (sign,) = signs
    assert isinstance(sign, Symbol)
    assert sign.kind == "break"
    assert bottom < sign.at[1] < top
    assert sign.at[0] == pytest.approx(x)


def test_it_is_told() -> None:
    told = scene(Panel(HOIST), "Hoist")
    assert told.note == line("not to scale along the broken lines")
    assert not scene(Panel((replace(WHEEL, radius=5.0), ROPE)), "Hoist").note
    assert "A" in {w.text for w in demand_figure(told)}


def test_along_a_slope() -> None:
    """The angle of the slope stays, and what stands on it does so still; what only goes on has no sign."""
    ends = tuple(map(_turned, ((-40.0, 0.0), (100.0, 0.0))))
    balls = [Arc(_turned((x, 0.3)), 0.3, "body") for x in (0.0, 60.0)]
    ground, *after = broken((Hatched(ends), *balls))
    assert isinstance(ground, Hatched)
    (x, y), (x_, y_) = ground.places
    assert math.atan2(y_ - y, x_ - x) == pytest.approx(TURN)
    assert math.dist(*ground.places) < 20.0
    first, second, sign = after
    assert isinstance(first, Arc)
    assert isinstance(second, Arc)
    assert isinstance(sign, Symbol)
    for ball in (first, second):
        aside = (ball.center[1] - y) * math.cos(TURN) - (ball.center[0] - x) * math.sin(TURN)
        assert aside == pytest.approx(0.3)


@pytest.mark.parametrize(
    "more",
    [
        Polyline(((0.2, 30.0), (5.0, 0.0)), "rope"),
        Polyline(((1.0, 30.0), (1.0, 0.0)), "body"),
        Polyline(((2.0, 30.0), (1.0, 15.0), (2.0, 0.0)), "way"),
    ],
)
def test_nothing_is_bent_or_shortened(more: Mark) -> None:
    """Where a rope goes aslant, a body lies along, or a way is curved, all stays to scale."""
    assert broken((*HOIST, more)) == (*HOIST, more)


def test_a_later_rope() -> None:
    """It is broken as the rope itself, and keeps its look."""
    later = Polyline(((0.2, 30.0), (0.2, 20.0)), "hidden")
    found = broken((*HOIST, later, Symbol("place", (0.2, 20.0))))
    after = found[len(HOIST)]
    assert isinstance(after, Polyline)
    assert after.style == "hidden"
    assert math.dist(*after.places) < 1.0


@pytest.mark.parametrize("stem", ["hoist-with-gears-in-us-units", "ex-4-09", "roller-onto-a-spring"])
def test_scenes_of_files(stem: str) -> None:
    """Each wheel of the scene is so large on paper that its letters have room within."""
    found = dict(figures_of(_page(str(next(p for p in PROBLEMS if p.stem == stem)))))["scene"]
    assert found.note
    demand_figure(found)
    assert _smallest_wheel(found) > 0.1


def _smallest_wheel(figure: Figure) -> float:
    """The radius of the smallest wheel in parts of the height of all."""
    marks = figure.panels[0].marks
    wheels = [m for m in marks if isinstance(m, Arc) and m.style == "body"]
    heights = [y for m in wheels for y in (m.center[1] - m.radius, m.center[1] + m.radius)]
    heights += [m.at[1] for m in marks if isinstance(m, Symbol)]
    return min(m.radius for m in wheels) / (max(heights) - min(heights))
