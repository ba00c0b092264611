"""Problem files solved once and kept, for the tests that look at solutions; and golden files."""

from __future__ import annotations

import os
import re
from dataclasses import dataclass
from functools import cache
from pathlib import Path

from conftest import HELD, PROBLEMS, ROOT

from planar_cli.formats.terminal import Terminal
from planar_cli.homework.checking.checking import read, solve_and_compare
from planar_cli.homework.checking.verdict import Verdict
from planar_cli.report.page.narrate import narrate
from planar_cli.solve.solved_problem import Solution

GOLDEN = ROOT / "tests" / "golden"
UPDATE = "PLANAR_UPDATE"
SEVERAL_WORKERS = "PYTEST_XDIST_WORKER"
"""In the environment of each of the processes among which pytest shares out a run."""


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
    """The printed solution of a file of problems/ by its name or that of its folder with it, in one line.

    A run on several workers, such as the whole one, takes it from the golden file where another worker holds that to
    what is printed now: to solve each file on all workers is most of the time that such a run takes.
    """
    (path,) = (p for p in PROBLEMS if stem in (p.stem, f"{p.parent.name}/{p.stem}"))
    if SEVERAL_WORKERS in os.environ and UPDATE not in os.environ and path in HELD:
        return re.sub(r"\s+", " ", (GOLDEN / f"{name_of(path)}.solution.txt").read_text(encoding="utf-8"))
    return re.sub(r"\s+", " ", Terminal(200).render(narrate(worked(path)[0])))


def page_of_text(folder: Path, text: str, why: str | None = None) -> str:
    """The printed solution of a file with this text, in one line; `why`: of one find alone."""
    path = folder / "problem.yaml"
    path.write_text(text, encoding="utf-8")
    return re.sub(r"\s+", " ", Terminal(200).render(narrate(solve_and_compare(read(str(path)))[0], why=why)))


def name_of(path: Path) -> str:
    """folder-file, as golden files and test ids are called."""
    return f"{path.parent.name}-{path.stem}"


def assert_golden(name: str, text: str) -> None:
    """Compare with tests/golden/NAME; PLANAR_UPDATE=1 writes it anew."""
    golden = GOLDEN / name
    if os.environ.get(UPDATE):
        golden.parent.mkdir(exist_ok=True)
        golden.write_text(text, encoding="utf-8")
    assert text == golden.read_text(encoding="utf-8")
