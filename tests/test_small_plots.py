"""In a terminal: plots in letters, tables and lines in its width."""

from __future__ import annotations

import pytest
from test_graphs import path_of

from planar_cli import cli
from planar_cli.formats._canvas import Canvas
from planar_cli.plain_letters import in_plain
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
