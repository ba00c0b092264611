"""Where things part: a contact that lifts off, a rope that slackens.

A joint that has parted states nothing of places any more. What it kept as long as it held is then its gap, which opens
from zero; where it closes again things strike each other, and only an `impact` tells what comes of that.
"""

from __future__ import annotations

import sympy as sp

from planar_cli.equation.scene.displacement import Coordinate, Displacement
from planar_cli.problem.scene.facts import Mode
from planar_cli.records import record
from planar_cli.solve.instant.instant import Instant
from planar_cli.solve.regimes.constraints import kept_while_held


@record
class Parted:
    """A joint that has parted."""

    joint: str
    words: str
    residual: sp.Expr
    """What it kept, of places."""


def parted_modes(drawn: Instant, choice: tuple[int, ...]) -> dict[str, tuple[Mode, ...]]:
    """The modes, as drawn, of all joints that have parted in a choice."""
    return {j.name: modes for (j, modes), i in zip(drawn.modes, choice, strict=True) if modes[i].parted}


def parted_joints(
    drawn: Instant, choice: tuple[int, ...], displacement: Displacement, coordinates: tuple[Coordinate, ...]
) -> tuple[Parted, ...]:
    """All joints that have parted in a choice of modes, and what they kept."""
    found = []
    for (joint, modes), i in zip(drawn.modes, choice, strict=True):
        if not modes[i].parted:
            continue
        slides = next((m for m in modes if m.facts.pushes and m.facts.joinings == modes[i].touching.joinings), None)
        kept = kept_while_held(drawn, joint, slides, displacement, coordinates) if slides is not None else ()
        if kept:
            # Of a face that lifts off, the distance alone: it may also turn.
            found.append(Parted(joint.name, modes[i].words, kept[0].residual))
    return tuple(found)
