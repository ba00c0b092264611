"""The contract of the shelf of loads.

A load is what acts on bodies beside the reactions of their joints: a force, a couple, an impulse, a stream. A member is
one file with one final class:

    @dataclass(frozen=True, slots=True, kw_only=True)
    class Torque(Load):
        '''manual page: Meaning, YAML, Equations, Signs, Valid when, Reference'''

        kind: ClassVar[str] = "torque"
        body: str = key(BodyKey(), "the body it turns")

The fields that every entry of a file has stand in `problem/scene/entry.py`.

What the rest of the program must know of a kind stands in class variables: how it is told (`effect`, `line`, `letter`,
`working`), and what it does (`pulls`, `opposes`, `dissipates`, `brings_mass`); `quantities` are words that may be asked
of it alone.

A member states facts only and does not import SymPy at module level, so that reading a file stays quick.
"""

from __future__ import annotations

import re
from abc import ABC, abstractmethod
from dataclasses import dataclass
from typing import Any, ClassVar, Self

from planar_cli.problem.scene.entry import Entry
from planar_cli.problem.scene.facts import Effect, Mode, Wrench
from planar_cli.problem.scene.residuals import Residual
from planar_cli.problem.scene.setting import MovingSetting, Setting

_POINT = re.compile(r"[A-Z]\d?")


def mode_key(load: str) -> str:
    """What the modes of a load are called: a joint may have the load's name."""
    return f"load {load}"


@dataclass(frozen=True, slots=True, kw_only=True)
class Load(Entry, ABC):
    """What every load has beside its own keys; the module's docstring is the contract."""

    effect: ClassVar[Effect | None] = None
    """How it stands among the effects of a scene; None: by its kind."""
    line: ClassVar[str] = "magnitude of {}"
    """The words beside a magnitude that has a line of its own; {} is the load's name, {called} how it is called."""
    pushing: ClassVar[str] = ""
    """The same of one that may also push, where it does; empty of one that does not."""
    letter: ClassVar[str] = "F"
    """The letter of such a magnitude."""
    working: ClassVar[str] = ""
    """What does work, in words; {} is the load's name. "": its kind and its name."""
    pulls: ClassVar[bool] = False
    """Is its magnitude the pull along the line of its ends, what `tension(j)` asks?"""
    opposes: ClassVar[bool] = False
    """Is its force always against the velocity, whose sense may be open?"""
    dissipates: ClassVar[bool] = False
    """Does it turn motion into heat?"""
    brings_mass: ClassVar[bool] = False
    """Does matter come to a body with it, or go from one?"""
    turns_only: ClassVar[bool] = False
    """Is it a couple, which a particle cannot take?"""

    @property
    def called(self) -> str:
        """By its ends where it has no name of its own: then it has that of one of them, perhaps with a number."""
        ends: tuple[str, ...] = getattr(self, "between", None) or ()
        return f"the {self.kind} from {ends[0]} to {ends[1]}" if self._has_no_name else self.phrase(self.name)

    @property
    def beside(self) -> str:
        """The words beside its magnitude."""
        return self.by_line(self.line)

    def by_line(self, words: str) -> str:
        """Words like those of `line` with its name."""
        return words.format(self.name, called=self.called)

    @property
    def short_name(self) -> str:
        """AB by its ends, where it has no name of its own and they have short ones; else the name that it has."""
        ends: tuple[str, ...] = getattr(self, "between", None) or ()
        return "".join(ends) if self._has_no_name and all(_POINT.fullmatch(end) for end in ends) else self.name

    @property
    def _has_no_name(self) -> bool:
        """Has it only the name of one of its ends, perhaps with a number?"""
        ends: tuple[str, ...] = getattr(self, "between", None) or ()
        return any(re.fullmatch(rf"{re.escape(end)}_?\d*", self.name) for end in ends)

    def in_full(self) -> Self:
        """The load with what its short forms stand for, once its body is known."""
        return self

    def modes(self, scene: Setting) -> tuple[Mode, ...]:
        """The ways in which the load may act, where there are several; tests and idle loads go by `mode_key`."""
        return ()

    def residuals(self, scene: Setting, mode: Mode) -> tuple[Residual, ...]:
        """A load keeps no places."""
        return ()

    def impulses(self, scene: Setting) -> tuple[Wrench, ...]:
        """What the load does to each body in a blow: nothing, where it is a finite force."""
        return ()

    @abstractmethod
    def wrenches(self, scene: MovingSetting) -> tuple[Wrench, ...]:
        """What the load does to each body, once positions and velocities are known.

        What it does to the ground needs not be stated, and is left out of the equations by whoever asks.
        """

    def stored(self, scene: Setting) -> tuple[Any, Any, int, str] | None:
        """What its potential energy is made of: factor, measure, power and the letter of the measure, for m g · y_G
        (power 1) and k s²/2 (power 2); None: it is of no such kind.
        """
        return None

    def potential(self, scene: Setting) -> Any | None:
        """Its potential energy [J] in this position, whose value where it is zero is free; None: it has none.

        Where none is stated, a function of place is still looked for: the integral of the load's power.
        """
        made = self.stored(scene)
        if made is None:
            return None
        factor, measure, power, _ = made
        return factor * measure if power == 1 else factor * measure**power / power
