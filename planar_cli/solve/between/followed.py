"""What comes of following a motion in numbers: the states that are reached, and what ends it on the way."""

from __future__ import annotations

from dataclasses import dataclass, field

import sympy as sp

from planar_cli.records import record
from planar_cli.solve.between.events import FollowedSegment, State


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
    again: bool = False
    """Does what had parted meet again?"""


@dataclass(slots=True)
class Followed:
    """What came of following a motion."""

    segments: list[FollowedSegment] = field(default_factory=list)
    """What was passed."""
    values: dict[sp.Symbol, float] = field(default_factory=dict)
    """Symbols of the states that were reached."""
    ends: Ends | None = None
    """An assumption that ended first."""
    misfit: int | None = None
    """The stretch whose assumptions do not even hold at its beginning."""
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
    blow: int | None = None
    """The stretch that ends with an impact whose modes do not hold."""
    far: dict[int, frozenset[str]] = field(default_factory=dict)
    """By the stretch that ends with them: impacts whose bodies are apart."""
    growing: list[str] = field(default_factory=list)
    """What is to be largest (or smallest), but is more so every time."""
    tends: dict[sp.Symbol, float] = field(default_factory=dict)
    """Letters of states that are only approached, with their values far along the way there."""
