"""A problem solved: every find of the file and of its cases, with the stages that show how, and the checks that were
made.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import field
from typing import TYPE_CHECKING

from planar_cli.problem.language.expression import Side
from planar_cli.problem.scene.scene import Problem
from planar_cli.records import changing, record
from planar_cli.solve.between.trace.trace import MotionTrace
from planar_cli.solve.passages import Tale
from planar_cli.solve.solution import Found, InstantSolution

if TYPE_CHECKING:
    from planar_cli.simulate.run import Run, Simulation


@record
class Confirmation:
    """What following a motion by independent facts says of answers that were found otherwise."""

    words: str = ""
    """As a check; "" where nothing was compared."""
    finds: frozenset[str] = frozenset()
    """Which finds agree; where one does not, there is no solution."""
    apart: Mapping[str, str] = field(default_factory=dict)
    """Why the others could not be compared, by their names."""
    run: Run | None = None
    """That motion, where no letter has a number that was drawn for it."""


NOT_COMPARED = Confirmation()


@changing
class PartSolution:
    """The file's own finds, or those of one case. `motion`: how its states follow each other in time, where they do;
    then `instants` are the general positions of its regimes. `tale`: what is told beside the instants. `followed`: the
    motion from which all answers are read off, where nothing else gives them; then there are no instants.
    """

    case: str
    instants: tuple[InstantSolution, ...]
    found: tuple[Found, ...]
    motion: MotionTrace | None = None
    tale: Tale | None = None
    followed: Simulation | None = None
    confirmed: Confirmation = NOT_COMPARED
    run: Run | None = None
    """The motion as it was followed from what the file tells, or from what was found."""
    pieces: Mapping[str, tuple[tuple[str, Side, Found], ...]] = field(default_factory=dict)
    """Where there are several instants, by find: the quantities of which it is made, each with its state and answer."""

    @property
    def clockwise(self) -> tuple[str, ...]:
        """The bodies whose rotation counts clockwise."""
        return tuple(sorted({b for i in self.instants for b in i.trial.system.builder.clockwise}))

    @property
    def not_compared(self) -> tuple[str, ...]:
        """The answers of a motion that following it does not confirm, with the reasons, in phrases for the checks."""
        if self.motion is None:
            return ()
        reasons = self.confirmed.apart
        listed = {why: [n for n, r in reasons.items() if r == why] for why in reasons.values()}
        return tuple(f"not compared: {', '.join(names)} ({why})" for why, names in listed.items())


@changing
class Solution:
    """A whole file solved."""

    problem: Problem
    parts: tuple[PartSolution, ...]
    seconds: dict[str, float]
