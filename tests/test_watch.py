"""`planar watch`: after each change the page is made anew; a file with mistakes leaves the last good one."""

from __future__ import annotations

import io
import os
import sys
from collections.abc import Callable, Iterator
from pathlib import Path

import pytest

from planar_cli import cli
from planar_cli.commands import watch

GOOD = "title: A point\npoints: {A: [1 m, 0]}\nfind: {x: x(A)}\n"
BAD = "title: A point\npoint: {A: [1 m, 0]}\nfind: {x: 3 m}\n"


def after(steps: list[Callable[[], None]]) -> Callable[[float], None]:
    """Instead of waiting something happens to the file; at the end Ctrl-C."""

    def waits(_: float) -> None:
        if not steps:
            raise KeyboardInterrupt
        steps.pop(0)()

    return waits


def test_the_last_good_page_is_kept(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    file, page = tmp_path / "p.yaml", tmp_path / "p.md"
    file.write_text(GOOD)
    seen: list[str] = []

    def saved(text: str) -> None:
        file.write_text(text)
        os.utime(file, ns=(len(seen), len(seen)))
        seen.append(page.read_text())

    texts = [BAD, GOOD.replace("1 m", "2 m"), BAD]
    steps: list[Callable[[], None]] = [lambda t=t: saved(t) for t in texts]
    monkeypatch.setattr(watch.time, "sleep", after([*steps, lambda: seen.append(page.read_text())]))
    assert cli.run(["watch", str(file), "-o", str(page), "--format", "markdown"]) == cli.INTERRUPTED
    assert ["1" in seen[0], seen[1] == seen[0], "2" in seen[2], seen[3] == seen[2]] == [True] * 4
    told = capsys.readouterr().err
    assert told.count("planar: solved") == 2
    assert told.count("is as before") == 2


def test_pages_of_each_format_are_watched(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    file, page = tmp_path / "p.yaml", tmp_path / "p.tex"
    file.write_text(GOOD)
    monkeypatch.setattr(watch.time, "sleep", after([]))
    assert cli.run(["watch", str(file), "-o", str(page), "--format", "latex"]) == cli.INTERRUPTED
    assert "\\begin{document}" in page.read_text()


def test_a_file_that_is_not_there(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert cli.run(["watch", str(tmp_path / "none.yaml")]) == cli.BAD
    assert "there is no such file" in capsys.readouterr().err


def test_a_file_that_is_replaced_is_waited_for(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    file = tmp_path / "p.yaml"
    file.write_text(GOOD)

    def back() -> None:
        file.write_text(BAD)
        os.utime(file, ns=(5, 5))

    monkeypatch.setattr(watch.time, "sleep", after([file.unlink, lambda: None, back]))
    found: Iterator[watch.Stamp] = watch.changes(str(file))
    assert next(found) != next(found)


class Screen(io.StringIO):
    """A terminal."""

    def isatty(self) -> bool:
        return True


CLEARED = "\x1b[2J\x1b[1;1H"


def watched(words: list[str], file: Path, texts: list[str], monkeypatch: pytest.MonkeyPatch) -> list[str]:
    """What stands on the screen, or in the file that is written, as each further text is saved and at the end."""
    seen: list[str] = []
    screen = Screen()

    def saw() -> None:
        seen.append(Path(words[-1]).read_text() if "-o" in words else screen.getvalue().split(CLEARED)[-1])

    def saved(text: str) -> None:
        saw()
        file.write_text(text)
        os.utime(file, ns=(len(seen), len(seen)))

    steps: list[Callable[[], None]] = [lambda t=t: saved(t) for t in texts]
    monkeypatch.setattr(watch.time, "sleep", after([*steps, saw]))
    monkeypatch.setenv("NO_COLOR", "1")
    monkeypatch.setattr(sys, "stdout", screen)
    monkeypatch.setattr(sys, "stderr", screen)
    assert cli.run(["watch", str(file), *words]) == cli.INTERRUPTED
    saw()
    return seen


def test_a_mistake_leaves_the_page_on_the_screen(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    file = tmp_path / "p.yaml"
    file.write_text(BAD)
    none, first, kept, second, _ = watched([], file, [GOOD, BAD, GOOD.replace("1 m", "2 m")], monkeypatch)
    assert "Answer" not in none
    assert "did you mean" in none
    assert "x = 1 m" in first
    assert (
        kept.index("x = 1 m") < kept.index("did you mean") < kept.index("planar: not solved; the last good page stays;")
    )
    assert "stays" not in none
    assert "x = 2 m" in second
    assert "did you mean" not in second


def test_a_page_in_a_browser_loads_itself_again_while_it_is_watched(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    file, page = tmp_path / "p.yaml", tmp_path / "p.html"
    file.write_text(GOOD)
    first, kept, end = watched(["-o", str(page)], file, [BAD.replace("point:", "<point>:")], monkeypatch)
    assert first.count('http-equiv="refresh"') == kept.count('http-equiv="refresh"') == 1
    assert 'role="status"' not in first
    assert "&lt;point&gt;" in kept.partition('role="status"')[2]
    assert "<script" not in kept
    assert end == first.replace('<meta http-equiv="refresh" content="1">\n', "")
