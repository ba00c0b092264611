"""In a terminal: plots in letters, tables and lines in its width."""

from __future__ import annotations

from collections import Counter

import pytest
from conftest import ROOT
from test_figures import illustrated_page
from test_graphs import path_of

from planar_cli import cli
from planar_cli.figures.illustrated import figures_of
from planar_cli.formats._canvas import Canvas
from planar_cli.formats._drawn_small import _text, small_drawing
from planar_cli.formats._small_plot import small_plot
from planar_cli.formats._svg import unlabelled
from planar_cli.plain_letters import in_plain
from planar_cli.report.document.blocks import Name, line
from planar_cli.report.document.graphs import Curve, Graph, Scaled
from planar_cli.simulate.columns import in_width, wrapped


def test_a_stroke_in_dots() -> None:
    canvas = Canvas(4, 1)
    canvas.stroke((0, 0), (7, 0))
    canvas.put(1, 0, "x")
    assert canvas.lines() == ["⠉x⠉⠉"]
    with in_plain(True):
        assert canvas.lines() == ["'x''"]
    assert not canvas.is_free(0, 0, 1)


def test_a_wide_table_goes_on_below() -> None:
    heads, rows = ("t", "first", "second"), [("0", "1.25", "12.5"), ("1", "2", "3")]
    assert in_width(heads, rows, 1, 80) == ["  t  first  second", "  0   1.25    12.5", "  1      2       3"]
    assert in_width(heads, rows, 1, 10) == ["t first", "0  1.25", "1     2", "", "t second", "0   12.5", "1      3"]


def test_a_long_line_goes_on_to_the_right() -> None:
    assert list(wrapped(["  one two three", "", "short"], 10)) == ["  one two", "    three", "", "short"]


@pytest.mark.parametrize("width", range(40, 90, 7))
@pytest.mark.parametrize("plain", [False, True])
@pytest.mark.parametrize("end", [1e-4, 0.1, 2.5])
def test_a_plot_has_room_for_what_stands_at_its_axes(width: int, plain: bool, end: float) -> None:
    """Also for a power of ten, and for the last number."""
    across, up = Scaled(line(Name("t")), "s", 0.0, end), Scaled(line(Name("v")), "m/s", 0.0, 3.0)
    with in_plain(plain):
        told = small_plot(Graph(across, up, (Curve((((0.0, 0.0), (end, 3.0)),)),)), width)
    assert max(map(len, told)) <= width
    assert ("in 10" in "".join(told)) == (end < 1e-3)


@pytest.mark.parametrize("width", [80, 40])
@pytest.mark.parametrize("plain", [False, True])
def test_what_simulate_prints_has_room(
    width: int, plain: bool, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setenv("COLUMNS", str(width))
    monkeypatch.delenv("PYTHONIOENCODING", raising=False)
    monkeypatch.delenv("PYTHONUTF8", raising=False)
    monkeypatch.setenv("LC_ALL", "C" if plain else "C.UTF-8")
    assert cli.run(["simulate", str(path_of("block-that-rocks"))]) == 0
    told = capsys.readouterr().out
    assert max(map(len, told.splitlines())) <= width
    assert told.isascii() == plain
    assert ("theta_block in deg" if plain else "θ_block in °") in told
    assert told.count("hit, after") == 3


@pytest.mark.parametrize("width", [80, 40])
def test_what_accuracy_prints_has_room(
    width: int, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setenv("COLUMNS", str(width))
    args = ["accuracy", str(path_of("ball-that-comes-to-rest")), "--tolerance", "1e-6", "--step", "0.01 s"]
    assert cli.run(args) == 0
    told = capsys.readouterr().out
    assert max(map(len, told.splitlines())) <= width
    assert "evaluations" in told


SPOOL = ROOT / "problems" / "textbook" / "ex-4-05.yaml"


DRAWN_SMALL = (
    "ex-4-05",
    "slider-crank-with-a-spring",
    "load-on-four-strands",
    "hoist-with-gears-in-us-units",
    "block-between-two-springs",
    "four-bar-free",
    "watts-sun-and-planet-gear",
)


@pytest.mark.parametrize("plain", [False, True])
@pytest.mark.parametrize("stem", DRAWN_SMALL)
def test_a_drawing_in_letters_names_what_it_shows(stem: str, plain: bool) -> None:
    """All words are there, each as often as in the figure, none cut and none over another, in any width."""
    for figure in dict(figures_of(illustrated_page(path_of(stem)))).values():
        with in_plain(plain):
            told = Counter(_text(w.runs) for paper in unlabelled(figure, 100.0, 100.0) for w in paper.words)
            for width in (110, 80, 40):
                lines = small_drawing(figure, width)
                drawn = "\n".join(lines)
                for text, times in sorted(told.items(), key=lambda one: -len(one[0])):
                    assert drawn.count(text) >= times, (text, width, drawn)
                    drawn = drawn.replace(text, "\0", times)
                assert max(map(len, lines)) <= width, drawn


def test_the_terminal_draws_where_it_is_asked(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.delenv("LC_ALL", raising=False)
    assert cli.run(["draw", "--format", "terminal", str(SPOOL)]) == 0
    drawn = capsys.readouterr().out
    assert "free-body diagram" in drawn
    assert any(0x2800 < ord(c) < 0x2900 for c in drawn)
    assert cli.run(["solve", str(SPOOL)]) == 0
    page = capsys.readouterr().out
    assert cli.run(["solve", "--drawing", str(SPOOL)]) == 0
    with_drawings = capsys.readouterr().out
    assert not any(0x2800 < ord(c) < 0x2900 for c in page)
    # What is told stays as it is.
    rest = iter(with_drawings.splitlines())
    assert all(any(line == other for other in rest) for line in page.splitlines() if line)
    monkeypatch.setenv("LC_ALL", "C")
    monkeypatch.delenv("PYTHONIOENCODING", raising=False)
    monkeypatch.delenv("PYTHONUTF8", raising=False)
    assert cli.run(["draw", "--format", "text", str(SPOOL)]) == 0
    assert capsys.readouterr().out.isascii()


@pytest.mark.parametrize(
    "args", [["draw", "--format", "terminal", "-o", "out"], ["solve", "--drawing", "--format", "markdown"]]
)
def test_drawings_in_letters_are_printed(args: list[str], capsys: pytest.CaptureFixture[str]) -> None:
    assert cli.run([*args, str(SPOOL)]) == 2
    assert capsys.readouterr().err
