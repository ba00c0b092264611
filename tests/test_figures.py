"""Figures: everything that a page names is drawn, inside the picture, and no two words overlap."""

from __future__ import annotations

import re
from pathlib import Path
from xml.etree import ElementTree as ET

import pytest
from conftest import PROBLEMS
from figure_demands import demand_figure, demand_forces, demand_inside
from worked import name_of, worked

from planar_cli.commands.draw import command
from planar_cli.figures.drawn import Drawn
from planar_cli.figures.illustrated import figures_of, illustrated
from planar_cli.figures.shapes import body_marks
from planar_cli.formats._svg import PRINT, panels, papers_of, svg
from planar_cli.formats.html import Html
from planar_cli.problem.structure import load_text
from planar_cli.report.document.blocks import Document, Drawing, Heading, Name, Paragraph, line
from planar_cli.report.document.marks import Arc, Arrow, Figure, Panel, Polyline, Tag, Turn
from planar_cli.report.page.narrate import narrate
from planar_cli.solve.run import solve_problem
from planar_cli.typeset import _Tree, pdf

EVERY = 24
"""Of so many problem files one is drawn in each run, all of them in the slow studies."""


def illustrated_page(path: Path) -> Document:
    solution = worked(path)[0]
    return illustrated(narrate(solution), solution)


def demand_whole(path: Path) -> None:
    """Every vector of a list stands in the diagram beside it; points, names and vectors lie within the picture."""
    demand_bodies(path)
    page = illustrated_page(path)
    figures = dict(figures_of(page))
    solution = worked(path)[0]
    demand_forces(page, solution, {repr(f): demand_figure(f) for f in figures.values()})
    if "scene" in figures:
        words = [m.words[0] for m in figures["scene"].panels[0].marks if isinstance(m, Tag)]
        tags = {w.name for w in words if isinstance(w, Name)}
        named = {p.name for p in solution.problem.points if not p.unnamed}
        scenes = [i.instant.scene for part in solution.parts for i in part.instants][:1]
        for name in named - tags:
            # Nothing tells where it is; of a motion that is followed in numbers alone all are drawn.
            assert [s.valuations[0].known(s.points[name].x) for s in scenes] == [None], name


def demand_bodies(path: Path) -> None:
    """Every body whose place is known is drawn, by itself or by its faces."""
    instant = next((i for part in worked(path)[0].parts for i in part.instants), None)
    if instant is None:
        return
    drawn = Drawn.as_in_the_file(instant)
    faced = {surface.body for surface in drawn.scene.problem.surfaces}
    for name, body in drawn.scene.bodies.items():
        if drawn.spot(body.center) is not None and drawn.number(body.theta) is not None and name not in faced:
            assert list(body_marks(drawn, body)), name


@pytest.mark.parametrize("path", PROBLEMS[::EVERY], ids=name_of)
def test_a_figure_shows_what_the_page_names(path: Path) -> None:
    demand_whole(path)


@pytest.mark.slow
@pytest.mark.parametrize("path", PROBLEMS, ids=name_of)
def test_every_figure_shows_what_the_page_names(path: Path) -> None:
    demand_whole(path)


HOSTILE = "<script>alert(1)</script>\"'&]]>$\\u202e"


def test_words_of_a_file_do_nothing() -> None:
    panel = Panel((Polyline(((0.0, 0.0), (1.0, 0.0)), "body"), Tag((0.0, 0.0), line(HOSTILE))), line(HOSTILE))
    figure = Figure((panel,), HOSTILE)
    drawn = svg(figure)
    assert "<script" not in drawn
    assert [e.tag for e in ET.fromstring(drawn).iter() if "script" in e.tag] == []
    page = Html().render(Document(HOSTILE, (Drawing(figure),)))
    assert "<script" not in page
    assert "default-src 'none'" in page.replace("&#x27;", "'")


def test_what_is_somewhere_only_later_covers_nothing() -> None:
    box = ((0.0, 0.0), (1.0, 0.0), (1.0, 1.0))
    marks = (Polyline(box, "body", closed=True), Polyline(box, "hidden", closed=True), Arc((0.0, 0.0), 1.0, "hidden"))
    kinds = [s.kind for s in papers_of(Figure((Panel(marks),), ""))[0].strokes]
    assert kinds == ["hidden", "hidden", "body area"]


def test_each_panel_by_itself_has_all_its_words() -> None:
    """As on a page, where they stand side by side or one below the other."""
    for stem in ("ex-4-05", "bullet-in-a-hanging-block"):
        page = illustrated_page(next(p for p in PROBLEMS if p.stem == stem))
        for block in (b for b in page.blocks if isinstance(b, Drawing)):
            for drawn in panels(block.figure):
                demand_inside(ET.fromstring(drawn))


def test_words_that_leave_the_picture_or_lie_over_others_are_found() -> None:
    figure = Figure((Panel((Polyline(((0.0, 0.0), (1.0, 0.0)), "body"), Tag((0.0, 0.0), line("a long name")))),), "")
    drawn = svg(figure)
    demand_figure(figure)
    left = ET.fromstring(drawn).attrib["viewBox"].split()[0]
    narrow = drawn.replace(f'viewBox="{left} ', f'viewBox="{float(left) + 20} ')
    (words,) = re.findall("(?s)<text.*?</text>", drawn)
    for wrong in (narrow, drawn.replace(words, words + words)):
        with pytest.raises(AssertionError):
            demand_inside(ET.fromstring(wrong))


def test_two_diagrams_of_a_page_can_stand_below_each_other() -> None:
    page = Html().render(illustrated_page(next(p for p in PROBLEMS if p.stem == "ex-4-05")))
    assert re.search('(?s)<figure class="panels"><svg.*?</svg>\\s*<span class="between">=</span><svg', page)


def test_what_folds_is_a_step_with_all_that_is_under_it() -> None:
    """The part of a motion stands over several of them."""
    heads = (Heading("MOTION", "from 1 to 2"), Heading("STEP 1", "Kinetics", "states 1, 2"), Heading("STEP 2", "Work"))
    page = Html().render(Document("t", (heads[0], Paragraph(line("a")), *heads[1:], Paragraph(line("b")))))
    assert '<h2 class="part">Motion: from 1 to 2</h2>\n<p>a</p>\n<details' in page
    assert '<summary><h2>Step 1. Kinetics</h2><span class="aside">states 1, 2</span></summary>\n</details>' in page


def test_the_same_input_gives_the_same_bytes() -> None:
    path = next(p for p in PROBLEMS if p.stem == "ex-4-05")
    once, again = ([svg(f) for _, f in figures_of(illustrated_page(path))] for _ in range(2))
    assert once == again


def test_the_command_writes_a_file_for_each_figure(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    path = next(p for p in PROBLEMS if p.stem == "ex-4-05")
    assert command.callback is not None
    for form, begins in (("svg", b"<svg"), ("png", b"\x89PNG")):
        assert command.callback((str(path),), str(tmp_path), form, 60.0) == 0
        named = [tmp_path / f"ex-4-05-{what}.{form}" for what in ("scene", "spool")]
        assert capsys.readouterr().out.split() == [str(p) for p in named]
        assert all(p.read_bytes().startswith(begins) for p in named)


def test_a_page_on_paper(tmp_path: Path) -> None:
    """The same bytes each time; words of a file are no commands of typst."""
    page = Html().render(Document('#read("/etc/passwd") $x$ _a_', (Paragraph(line(HOSTILE + " #pagebreak()")),)))
    assert pdf(page, PRINT) == pdf(page, PRINT)
    solved = Html().render(illustrated_page(next(p for p in PROBLEMS if p.stem == "ex-4-16")))
    made = pdf(solved, PRINT)
    assert made.startswith(b"%PDF")
    assert made == pdf(solved, PRINT)


def test_spaces_on_paper() -> None:
    """A wide one stands between two equations; that between two lines of the source would be an empty paragraph."""
    tree = _Tree("")
    tree.feed("<body>\n<p>a <b>b</b> c\N{EM SPACE}\nd</p>\n<p>e</p>\n</body>")
    (first, second) = tree.body()["kids"]
    assert first["kids"] == ["a ", {"tag": "b", "kids": ["b"]}, " c\N{EM SPACE}\nd"]
    assert second["kids"] == ["e"]


HIDING = """
title: Disk turned by a wire
plane: horizontal
points: {O: [0, 0], Q: [0.1 m, 0]}
bodies: {disk: {disk: O, radius: 0.2 m, mass: 2 kg}}
joints:
  - pin: {at: O, between: [ground, disk]}
loads:
  - torque: {body: disk, moment: -(3 N*m)*theta(disk)}
states:
  1: [t = 0, theta(disk) = 20 deg, at rest]
  2: [theta(disk) = 0]
find: {w: omega(disk) @ 2}
figure: {hide: [Q, disk]}
"""


@pytest.mark.parametrize(("stem", "x"), [("crate-pushed-too-hard", 0.3), ("crate-on-a-truck-that-starts", -0.45)])
def test_a_normal_force_beside_the_middle_of_its_face_is_drawn_there(stem: str, x: float) -> None:
    """N ↑ at x to the right of C: a crate with nothing under it would be no free body."""
    path = next(p for p in PROBLEMS if p.stem == stem)
    demand_whole(path)
    diagrams = [b.figure for b in illustrated_page(path).blocks if isinstance(b, Drawing)]
    normals = [m for f in diagrams for p in f.panels for m in p.marks if isinstance(m, Arrow) and "N_" in str(m.words)]
    assert any(m.at == pytest.approx((x, 0)) for m in normals), normals


def test_a_force_that_is_zero_in_the_position_that_is_drawn_has_an_arrow() -> None:
    """The spring of a pendulum in its equilibrium, for a small deviation from it."""
    demand_whole(next(p for p in PROBLEMS if p.stem == "inverted-pendulum"))


def test_hidden_names_and_a_moment_that_goes_with_the_motion() -> None:
    problem, wrong = load_text(HIDING)
    assert problem is not None, wrong
    solution = solve_problem(problem)
    scene = dict(figures_of(illustrated(narrate(solution), solution)))["scene"]
    tags = [m.words[0] for m in scene.panels[0].marks if isinstance(m, Tag)]
    assert tags == [Name("O")]
    assert any(isinstance(m, Turn) for m in scene.panels[0].marks)
