"""Problem files solved once and kept, for the tests that look at solutions; and golden files."""

from __future__ import annotations

import os
import re
from dataclasses import dataclass
from functools import cache
from pathlib import Path

from conftest import PROBLEMS, ROOT

from planar_cli.formats.terminal import Terminal
from planar_cli.homework.checking import read, solve_and_compare
from planar_cli.homework.verdict import Verdict
from planar_cli.report.narrate import narrate
from planar_cli.solve.solved_problem import Solution

GOLDEN = ROOT / "tests" / "golden"


@dataclass(frozen=True, slots=True)
class Worked:
    """A solution with its verdicts, or why there is none."""

    solution: Solution | None
    verdicts: tuple[Verdict, ...]
    error: Exception | None


@cache
def _worked(path: Path) -> Worked:
    try:
        return Worked(*solve_and_compare(read(str(path.relative_to(ROOT)))), None)
    except Exception as error:
        return Worked(None, (), error)


def worked(path: Path) -> tuple[Solution, tuple[Verdict, ...]]:
    """The solution of a file of problems/; what kept it from being solved is raised in every test that asks."""
    result = _worked(path)
    if result.solution is None:
        assert result.error is not None
        # Without the frames of the solver: pytest would write out their arguments, whole scenes, for minutes.
        raise result.error.with_traceback(None) from None
    return result.solution, result.verdicts


def page_of_file(stem: str) -> str:
    """The printed solution of a file of problems/ by its name, in one line."""
    (path,) = (p for p in PROBLEMS if p.stem == stem)
    return re.sub(r"\s+", " ", Terminal(200).render(narrate(worked(path)[0])))


def page_of_text(folder: Path, text: str) -> str:
    """The printed solution of a file with this text, in one line."""
    path = folder / "problem.yaml"
    path.write_text(text, encoding="utf-8")
    return re.sub(r"\s+", " ", Terminal(200).render(narrate(solve_and_compare(read(str(path)))[0])))


def name_of(path: Path) -> str:
    """folder-file, as golden files and test ids are called."""
    return f"{path.parent.name}-{path.stem}"


def assert_golden(name: str, text: str) -> None:
    """Compare with tests/golden/NAME; PLANAR_UPDATE=1 writes it anew."""
    golden = GOLDEN / name
    if os.environ.get("PLANAR_UPDATE"):
        golden.parent.mkdir(exist_ok=True)
        golden.write_text(text, encoding="utf-8")
    assert text == golden.read_text(encoding="utf-8")
