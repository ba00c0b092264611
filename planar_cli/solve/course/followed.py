"""What comes of following a motion in numbers: the states that are reached, and what ends it on the way."""

from __future__ import annotations

from dataclasses import dataclass, field

import sympy as sp

from planar_cli.records import record
from planar_cli.solve.course.events import Leg, State


@record
class Ends:
    """A stretch ends before its state: `expr` vanishes at `time`; `words` say what ends. `again`: what had parted meets
    again.
    """

    stretch: int
    time: float
    expr: sp.Expr
    words: str
    state: State
    again: bool = False


@dataclass(slots=True)
class Followed:
    """What came of following a course. `values`: letters of the states that were reached. `ends`: an assumption that
    ended first; `misfit`: the stretch whose assumptions do not even hold at its beginning, `ways`: the signs that
    speeds have there, if that is all; `missed`: the state that is never reached; `blow`: the blow whose modes do not
    hold; `growing`: what is to be largest (or smallest), but is more so every time.
    """

    legs: list[Leg] = field(default_factory=list)
    values: dict[sp.Symbol, float] = field(default_factory=dict)
    ends: Ends | None = None
    misfit: int | None = None
    why: str = ""
    missed: str | None = None
    ways: dict[str, int] = field(default_factory=dict)
    at: State = field(default_factory=dict)
    blow: int | None = None
    growing: list[str] = field(default_factory=list)
    tends: dict[sp.Symbol, float] = field(default_factory=dict)
    """Letters of states that are only approached, with their values far along the way there."""
