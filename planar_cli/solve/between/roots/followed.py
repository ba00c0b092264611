"""What comes of following a motion in numbers: the states that are reached, and what ends an assumption on the way."""

from __future__ import annotations

from dataclasses import field

import sympy as sp

from planar_cli.errors import NoSolution
from planar_cli.records import changing, record
from planar_cli.simulate.run import Run
from planar_cli.solve.between.roots.events import FollowedSegment, State


@record
class Ends:
    """A stretch ends before its state."""

    stretch: int
    time: float
    """When [s]."""
    expr: sp.Expr
    """What vanishes then."""
    words: str
    """What ends."""
    choice: tuple[int, ...] | None = None
    """The modes that follow; None: the same, and something goes the other way."""


@changing
class Followed:
    """What came of following a motion."""

    run: Run | None = None
    """The motion of the scene."""
    foreseen: bool = False
    """Does the file alone tell it?"""
    segments: list[FollowedSegment] = field(default_factory=list)
    """What was passed."""
    values: dict[sp.Symbol, float] = field(default_factory=dict)
    """Symbols of the states that were reached."""
    lost: str = ""
    """Why it can not be followed in these regimes; "" where it can."""
    spent: NoSolution | None = None
    """What to say where that is so because a free part of a rope has run out."""
    struck: tuple[int, float, str] | None = None
    """A stretch on which something strikes that no state of the file speaks of, when [s], and what."""
    ends: Ends | None = None
    """An assumption that ended first."""
    misfit: int | None = None
    """The stretch whose assumptions do not even hold at its beginning."""
    choice: tuple[int, ...] | None = None
    """The modes that it has there; None: others than these are to be tried."""
    why: str = ""
    """What speaks against them."""
    dated: int | None = None
    """The state that was put in where the next one is, which a mode alone tells."""
    missed: str | None = None
    """The state that is never reached."""
    ways: dict[str, int] = field(default_factory=dict)
    """The signs that speeds have there, if they alone are not those of the stretch."""
    at: State = field(default_factory=dict)
    """The state in which the last stretch begins."""
    onward: FollowedSegment | None = None
    """What goes on from the last state."""
    blow: int | None = None
    """The stretch that ends with an impact whose modes do not hold."""
    far: dict[int, frozenset[str]] = field(default_factory=dict)
    """By the stretch that ends with them: impacts whose bodies are apart."""
    sizes: dict[sp.Symbol, float] = field(default_factory=dict)
    """What the letters of its regimes are measured by, in what was passed."""
    tends: dict[sp.Symbol, float] = field(default_factory=dict)
    """Letters of states that are only approached, with their values far along the way there."""
