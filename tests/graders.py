"""Functions that grade submissions as they are told to by an answer: the fakes of the tests of batches."""

from __future__ import annotations

import os
import sys
import time
from collections.abc import Callable

from planar_cli.homework.sets.paper import RIGHT, UNGRADABLE, WRONG, Graded, Result, Submission


def grader() -> Callable[[Submission], Result]:
    """What is called once in each worker."""
    return grade


def no_grader() -> Callable[[Submission], Result]:
    """A key that cannot be used."""
    raise ValueError("no key")


def grade(submission: Submission) -> Result:
    """The answer `5 N` is right; some others are followed."""
    if submission.student == "always":
        os._exit(4)
    graded = tuple(_graded(*answer) for answer in submission.answers)
    if not graded:
        graded = (Graded("p", "a", "", UNGRADABLE, 0.0, 1.0),)
    return Result(submission.student, submission.variant, graded, submission.source, submission.wrong)


def _graded(problem: str, find: str, typed: str) -> Graded:
    match typed:
        case "hang":
            time.sleep(60)
        case "power":
            # The interpreter is held all the while: no thread and no timer of the process runs.
            _ = 9**9**9
        case "eat":
            _ = bytearray(64 * 1024**3)
        case "exit":
            os._exit(7)
        case "kill":
            os.kill(os.getpid(), 9)
        case "raise":
            raise ValueError("the key is 5 N")
        case "recursion":
            _endless(0)
        case "once":
            _once(typed)
    right = typed == "5 N"
    return Graded(problem, find, typed, RIGHT if right else WRONG, float(right), 1.0, mistakes=("m",))


def _endless(depth: int) -> int:
    return _endless(depth + 1) + 1


def _once(typed: str) -> None:
    """The first worker that meets it ends; the others do not."""
    flag = os.environ["GRADED_ONCE"]
    if not os.path.exists(flag):
        with open(flag, "w", encoding="ascii"):
            sys.stdout.flush()
        os._exit(3)
