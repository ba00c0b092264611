"""HTML pages as the command writes them: they open in a browser without a word on its console, with their formulas and
figures.
"""

from __future__ import annotations

import re
import shutil
import subprocess
from pathlib import Path

import pytest
from conftest import PROBLEMS, ROOT
from worked import name_of, worked

from planar_cli import cli
from planar_cli.figures.illustrated import illustrated
from planar_cli.formats.html import Html
from planar_cli.report.document.blocks import Document, Drawing, Equation, Paragraph, line
from planar_cli.report.document.stated_text import with_task
from planar_cli.report.page.narrate import narrate

BROWSER = shutil.which("chromium") or shutil.which("chromium-browser") or shutil.which("google-chrome")
QUIET = (
    "--headless --no-sandbox --disable-gpu --disable-quic --no-first-run --disable-background-networking "
    "--disable-component-update --disable-sync --enable-logging=stderr --dump-dom"
)
EVERY = 160
"""Every so many problem files are opened in each run, all of them in the slow studies."""
needs_browser = pytest.mark.skipif(BROWSER is None, reason="no Chromium is installed (Debian's package chromium)")


def opened(page: str, folder: Path) -> tuple[str, list[str]]:
    """What the browser makes of a page, and what it says of it."""
    path = folder / "page.html"
    path.write_text(page, encoding="utf-8")
    command = [BROWSER or "", *QUIET.split(), f"--user-data-dir={folder / 'profile'}", path.as_uri()]
    ran = subprocess.run(command, capture_output=True, text=True, check=True, timeout=120)
    return ran.stdout, [row for row in ran.stderr.splitlines() if "CONSOLE" in row]


def written(path: Path, folder: Path) -> tuple[str, Document]:
    """The page of a file as the command writes it, and what it is made from."""
    solution = worked(path)[0]
    page = folder / "written.html"
    assert cli.run(["solve", str(path.relative_to(ROOT)), "--format", "html", "-o", str(page)]) == cli.SOLVED
    return page.read_text(encoding="utf-8"), illustrated(with_task(narrate(solution), solution.problem), solution)


@pytest.mark.parametrize("path", PROBLEMS[1::EVERY], ids=name_of)
def test_nothing_is_escaped_on_the_way(path: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Neither the spaces of formulas, nor what a file says."""
    monkeypatch.chdir(ROOT)
    page, document = written(path, tmp_path)
    assert page == Html().render(document)
    assert not re.search(r"\\[xuU][0-9a-f]{2}", page)


def demand_shown(path: Path, folder: Path) -> None:
    page, document = written(path, folder)
    shown, said = opened(page, folder)
    assert said == []
    assert "<script" not in shown
    assert shown.count("<svg") == sum(len(b.figure.panels) for b in document.blocks if isinstance(b, Drawing))
    displays = sum(isinstance(b, Equation) for b in document.blocks)
    assert len(re.findall('class="equation"', shown)) == displays


@needs_browser
@pytest.mark.parametrize("path", PROBLEMS[::EVERY], ids=name_of)
def test_a_page_opens(path: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(ROOT)
    demand_shown(path, tmp_path)


@needs_browser
@pytest.mark.slow
@pytest.mark.parametrize("path", PROBLEMS, ids=name_of)
def test_every_page_opens(path: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(ROOT)
    demand_shown(path, tmp_path)


@needs_browser
def test_words_of_a_file_do_nothing(tmp_path: Path) -> None:
    hostile = "<img src=x onerror=alert(1)><script>alert(2)</script>"
    shown, said = opened(Html().render(Document(hostile, (Paragraph(line(hostile)),))), tmp_path)
    assert said == []
    assert "<script>" not in shown
    assert "<img" not in shown
