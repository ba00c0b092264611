"""The contract of the shelf of loads.

A load is what acts on bodies beside the reactions of their joints: a force, a couple, an impulse, a stream. A member is
one file with one final class:

    @dataclass(frozen=True, slots=True, kw_only=True)
    class Torque(Load):
        '''manual page: Meaning, YAML, Equations, Signs, Valid when, Reference'''

        kind: ClassVar[str] = "torque"
        body: str = key(BodyKey(), "the body it turns")

- `kind` is the word in the file; the fields declared with `key(...)` are its YAML keys and its part of the JSON Schema.
- `choices` names the groups of keys of which exactly one is written.
- `strikes`: it acts only in a blow, between a state and one just after it.
- `name` is the load's own `name:`; else that of its point; else that of its first body. Reading a file settles it.
- `during` is the span of states in which the load acts; None: always.
- `mark` is the place of the entry in the file.

What the rest of the program must know of a kind stands in class variables: how it is told (`effect`, `line`, `letter`,
`working`), and what it does (`pulls`, `opposes`, `dissipates`); `quantities` are words that may be asked of it alone.

A member states facts only and does not import SymPy at module level, so that reading a file stays quick.
"""

from __future__ import annotations

from abc import ABC, abstractmethod
from dataclasses import dataclass
from typing import Any, ClassVar

from planar_cli.errors import Mark
from planar_cli.problem.facts import Effect, Mode, Wrench
from planar_cli.problem.keys import Choice
from planar_cli.problem.residuals import Residual
from planar_cli.problem.setting import MovingSetting, Setting, StruckSetting


def mode_key(load: str) -> str:
    """What the modes of a load are called: a joint may have the load's name."""
    return f"load {load}"


@dataclass(frozen=True, slots=True, kw_only=True)
class Load(ABC):
    """What every load has beside its own keys; the module's docstring is the contract."""

    kind: ClassVar[str]
    choices: ClassVar[tuple[Choice, ...]] = ()
    strikes: ClassVar[bool] = False
    effect: ClassVar[Effect | None] = None
    """How it stands among the effects of a scene; None: by its kind."""
    line: ClassVar[str] = "magnitude of {}"
    """The words beside a magnitude that has a line of its own; {} is the load's name."""
    letter: ClassVar[str] = "F"
    """The letter of such a magnitude."""
    working: ClassVar[str] = ""
    """What does work, in words; {} is the load's name. "": its kind and its name."""
    quantities: ClassVar[tuple[str, ...]] = ()
    """Quantities of the language that may be asked of this kind and not of every load: tension."""
    pulls: ClassVar[bool] = False
    """Is its magnitude the pull along the line of its ends, what `tension(j)` asks?"""
    opposes: ClassVar[bool] = False
    """Is its force always against the velocity, whose sense may be open?"""
    dissipates: ClassVar[bool] = False
    """Does it turn motion into heat?"""

    name: str
    during: tuple[str, str] | None
    mark: Mark

    def attachments(self) -> tuple[tuple[str, str], ...]:
        """Pairs (point, body): the points that belong to a body because this load names them together."""
        return ()

    def rims(self) -> tuple[tuple[str, str], ...]:
        """Pairs (point, body): where a cord leaves a rim. Such a point keeps its direction from the body's centre."""
        return ()

    def modes(self, scene: Setting) -> tuple[Mode, ...]:
        """The ways in which the load may act, where there are several; tests and idle loads go by `mode_key`."""
        return ()

    def residuals(self, scene: Setting, mode: Mode) -> tuple[Residual, ...]:
        """A load keeps no places."""
        return ()

    def impulses(self, scene: StruckSetting) -> tuple[Wrench, ...]:
        """What the load does to each body in a blow: nothing, where it is a finite force."""
        return ()

    @abstractmethod
    def wrenches(self, scene: MovingSetting) -> tuple[Wrench, ...]:
        """What the load does to each body, once positions and velocities are known.

        What it does to the ground needs not be stated, and is left out of the equations by whoever asks.
        """

    def potential(self, scene: Setting) -> Any | None:
        """Its potential energy [J] in this position, whose value where it is zero is free; None: it has none.

        Where none is stated, a function of place is still looked for: the integral of the load's power.
        """
        return None
