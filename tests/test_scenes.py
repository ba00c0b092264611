"""The scene in all positions that are told, and once more in each case in which it looks different."""

from __future__ import annotations

import math

from conftest import PROBLEMS
from worked import worked

from planar_cli.figures.illustrated import figures_of, illustrated
from planar_cli.formats._paper import runs_of
from planar_cli.report.document.blocks import Document, Drawing, Heading, Line
from planar_cli.report.document.marks import Mark, Polyline, Symbol, Tag
from planar_cli.report.page.narrate import narrate


def page(stem: str) -> Document:
    solution = worked(next(p for p in PROBLEMS if p.stem == stem))[0]
    return illustrated(narrate(solution), solution)


def marks(stem: str) -> tuple[Mark, ...]:
    return dict(figures_of(page(stem)))["scene"].panels[0].marks


def told(words: Line) -> str:
    return "".join(("_" if run.index else "") + run.text for run in runs_of(words))


def test_states_without_a_motion_in_between_are_drawn_over_each_other() -> None:
    """The crank at 30 degrees, and dashed at 90 degrees."""
    found = marks("slider-crank-two-positions")
    hidden = [m for m in found if isinstance(m, Polyline) and m.style == "hidden"]
    ends = {(round(x, 6), round(y, 6)) for m in hidden for x, y in m.places}
    assert {(0.0, 0.0), (0.0, 0.08), (round(math.sqrt(0.24**2 - 0.08**2), 6), 0.0)} <= ends
    assert {"1", "2"} <= {told(m.words) for m in found if isinstance(m, Tag)}


def test_a_point_of_a_wheel_is_drawn_where_it_is_asked_for_later() -> None:
    (tag,) = (m for m in marks("ex-1-09") if isinstance(m, Tag) and told(m.words) == "B_2")
    assert math.dist(tag.at, (0.4715323565, 0.3710218818)) < 1e-6


def test_a_case_that_changes_the_scene_has_its_own() -> None:
    """With the cord that is cut in the second case; a scene that looks the same is not drawn again."""
    blocks = page("bar-when-one-of-its-cords-is-cut").blocks
    heads = [i for i, b in enumerate(blocks) if isinstance(b, Heading) and b.label == "CASE"]
    scenes = [i for i, b in enumerate(blocks) if isinstance(b, Drawing) and b.figure.name == "scene"]
    assert scenes[0] < heads[0]
    assert scenes[1:] == [heads[1] + 1]
    walls = [
        sum(isinstance(m, Symbol) and m.kind == "wall" for m in b.figure.panels[0].marks)
        for i in scenes
        if isinstance(b := blocks[i], Drawing)
    ]
    assert walls == [2, 1]
    assert [name for name, _ in figures_of(page("crate-on-cart")) if name.startswith("scene")] == ["scene"]
