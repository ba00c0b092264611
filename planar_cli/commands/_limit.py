"""Limits on the time and the memory that one problem may take."""

from __future__ import annotations

import signal
import threading
from collections.abc import Iterator
from contextlib import contextmanager
from types import FrameType

from planar_cli.errors import TimeIsUp, Undecided
from planar_cli.homework.tasks.memory import memory_limit, too_much

AGAIN = 1.0
FEWER = "it may help to give numbers for letters, or to ask for less at once"
FOLLOW = "it may help to end the motion earlier, or to ask for less; `planar simulate` follows it in numbers"
WORK = (
    ("solve.confirmation", "the answers were found, and their motion was being followed to confirm them", FOLLOW),
    ("solve.followed", "the motion was being followed step by step, to read the answers off", FOLLOW),
    ("commands.accuracy", "the motion was being followed at many tolerances", "--until ends it earlier"),
    ("commands.simulate", "the motion was being followed step by step", "--until or --stop end it earlier"),
    ("simulate", "the motion was being followed step by step", FOLLOW),
    (
        "solve.sought",
        "unknowns were being sought by following the motion",
        "give a state that tells them more directly",
    ),
    ("solve.following", "modes (stick, slip, apart, taut) and times were being sought in which states follow", FOLLOW),
    ("solve.diagnosis", "no solution was found so far, and the reason was being sought", FEWER),
    ("solve.between", "equations from state to state were being written and solved", FOLLOW),
    ("solve.impulsive", "the equations of an impact were being solved", FEWER),
    ("solve.regimes", "the equations of motion were being worked out", FEWER),
    ("solve.multibody", "the answers were found, and were being compared with a second road", FEWER),
    ("solve.instant", "the equations of an instant were being solved", FEWER),
    ("solve.curves", "formulas and curves that hold throughout were being worked out", FEWER),
    ("calculus", "a law was being integrated in closed form", FOLLOW),
    ("report", "the answers were found, and the page was being written", "--why NAME tells only of one"),
    ("solve", "the answers were being sought", FEWER),
    ("problem", "the file was being read", "it may help to split it"),
)
"""What goes on in which modules, and what usually helps; of nested ones the first in this list."""


@contextmanager
def limits(seconds: float) -> Iterator[None]:
    """Undecided from the block where it takes more time, or more memory than one problem may."""
    try:
        with memory_limit(), time_limit(seconds):
            yield
    except MemoryError as error:
        trace = error.__traceback__
        while trace is not None and trace.tb_next is not None:
            trace = trace.tb_next
        frame = None if trace is None else trace.tb_frame
        raise Undecided(f"{place_of(frame)}not decided, {too_much()} would be taken: {at_work(frame)}") from None


@contextmanager
def time_limit(seconds: float) -> Iterator[None]:
    """Undecided from the block as a whole after so many seconds; 0 is no limit.

    Works in the main thread where the system has interval timers. The timer repeats, lest a library's own bare
    `except` swallow the one shot.
    """
    if not seconds or not hasattr(signal, "setitimer") or threading.current_thread() is not threading.main_thread():
        yield
        return

    work: list[tuple[str, str]] = []

    def stop(number: int, frame: FrameType | None) -> None:
        work.append((place_of(frame), at_work(frame)))
        raise TimeIsUp

    before = signal.signal(signal.SIGALRM, stop)
    try:
        signal.setitimer(signal.ITIMER_REAL, seconds, AGAIN)
        yield
    except TimeIsUp:
        place, what = work[0]
        raise Undecided(f"{place}not decided within {seconds:g} s: {what}; --timeout allows more") from None
    finally:
        signal.setitimer(signal.ITIMER_REAL, 0)
        signal.signal(signal.SIGALRM, before)


def place_of(frame: FrameType | None) -> str:
    """The line of what is asked in the part of the file that a frame works on, "FILE:LINE: "; "": there is none yet."""
    from planar_cli.problem.scene.scene import Problem

    found = ""
    while frame is not None:
        problem = frame.f_locals.get("problem")
        if isinstance(problem, Problem):
            line = problem.find[0].mark.line if problem.find else 1
            found = f"{problem.file}:{line}: "
            if frame.f_globals.get("__name__") == "planar_cli.solve.run":
                return found
        frame = frame.f_back
    return found


def at_work(frame: FrameType | None) -> str:
    """What was being worked on where a frame is, of which case of the file, and what usually helps."""
    modules: set[str] = set()
    case = ""
    while frame is not None:
        name = frame.f_globals.get("__name__", "")
        modules.add(name.removeprefix("planar_cli."))
        if name == "planar_cli.solve.run":
            case = case or str(frame.f_locals.get("case") or "")
        frame = frame.f_back
    for prefix, words, hint in WORK:
        if any(module == prefix or module.startswith(f"{prefix}.") for module in modules):
            return f"{words}{f' (case {case})' if case else ''}; {hint}"
    return "the file was being worked on"
