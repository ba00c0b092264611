"""What homework costs, as ratios in one run: grading beside reading and parsing, variants beside solving once.

.venv/bin/python tests/homework_speed.py [SUBMISSIONS] [VARIANTS]
"""

from __future__ import annotations

import gc
import sys
import tempfile
import time
from collections.abc import Callable
from concurrent.futures import ProcessPoolExecutor
from multiprocessing import get_context
from pathlib import Path

from homework_class import written

from planar_cli.homework.grading.grading_made import grading_of
from planar_cli.homework.grading.what_mistakes_give import with_mistakes
from planar_cli.homework.homework import made_ready
from planar_cli.homework.sets.set_file import read_set
from planar_cli.homework.submissions.submissions import contents, submission_files, submissions
from planar_cli.homework.variants.variants import columns, variants_of
from planar_cli.homework.variants.worked_problem import base_expected, read_and_solve
from planar_cli.later import CLUTTER

SET = Path(__file__).parent / "homework" / "set.yaml"
AGAIN = 3
# As on the command line, in the processes too that are started here.
gc.set_threshold(CLUTTER, 20, 20)


def timed(function: Callable[[], object]) -> float:
    """The shortest of some runs, s."""
    best = float("inf")
    for _ in range(AGAIN):
        began = time.perf_counter()
        function()
        best = min(best, time.perf_counter() - began)
    return best


def grading(number: int) -> None:
    """Reading, parsing and grading in one process, as each worker does it."""
    homework_set = read_set(str(SET))
    homework = made_ready(homework_set, 2, 120, None, lambda total, what: lambda done: None)
    with tempfile.TemporaryDirectory() as folder:
        written(Path(folder), homework.papers, number)
        paths = list(submission_files([folder]))
        make = grading_of(homework_set, homework)
        read = timed(lambda: [submissions(contents(p)) for p in paths])

        def all_graded() -> None:
            # A new one each time: it remembers what was typed before.
            grade = make()
            for path in paths:
                for submission in submissions(contents(path)):
                    grade(submission)

        graded = timed(all_graded)
    each = 1000 / number
    print(f"{number} submissions of {sum(len(t.expected) for t in homework.papers[0].tasks)} answers")
    print(f"read and parsed    {read * each:7.3f} ms each")
    print(f"read and graded    {graded * each:7.3f} ms each    {graded / read:.2f} times that")


def variants(number: int) -> None:
    """A problem with variants beside the problem solved once, each in processes that have solved nothing before."""
    path = Path(__file__).parent / "homework" / "slope.yaml"
    text = (
        path.read_text()
        .replace("step: 0.5 kg", "step: 0.01 kg")
        .replace("[25 deg, 30 deg, 35 deg]", "{from: 22 deg, to: 38 deg, step: 1 deg}")
    )
    with tempfile.TemporaryDirectory() as folder:
        varied = Path(folder) / "slope.yaml"
        varied.write_text(text)
        with ProcessPoolExecutor(1, get_context("spawn"), max_tasks_per_child=1) as fresh:
            once = min(fresh.submit(made, str(varied), 0).result() for _ in range(AGAIN))
            many = min(fresh.submit(made, str(varied), number).result() for _ in range(AGAIN))
    print(f"solved once        {once:7.3f} s")
    print(f"solved, with {number} variants and what mistakes give   {many:7.3f} s    {many / once:.2f} times that")


def made(path: str, number: int) -> float:
    """How long a problem and so many variants take, s."""
    began = time.perf_counter()
    one = read_and_solve(path, "p")
    base_expected(one)
    if number:
        found = variants_of(one, number, 1)
        assert len(found.taken) == number
        with_mistakes(one, [v.expected for v in found.taken], columns(one, [v.draw for v in found.taken]))
    return time.perf_counter() - began


if __name__ == "__main__":
    grading(int(sys.argv[1]) if len(sys.argv) > 1 else 10_000)
    variants(int(sys.argv[2]) if len(sys.argv) > 2 else 1000)
