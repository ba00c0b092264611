"""What a joint held before it parted, and how that begins to open."""

from __future__ import annotations

import sympy as sp

from planar_cli.problem.scene.facts import Mode
from planar_cli.problem.scene.geometry import Vec
from planar_cli.solve.regimes.equations import Equation
from planar_cli.solve.regimes.mode_sequence import ModeSequence, Workshop
from planar_cli.solve.regimes.regime_sequence import RegimeSequence


def held_before(sequence: ModeSequence, workshop: Workshop, i: int, joint: str) -> tuple[int, Mode] | None:
    """The last mode, and its index, in which a joint held on the stretches before state i; None: in none."""
    for k in range(min(i, len(sequence.stretches)) - 1, -1, -1):
        stretch = sequence.stretches[k]
        drawn = workshop.drawn(stretch.span)
        for (own, modes), index in zip(drawn.modes, stretch.choice, strict=True):
            if own.name == joint and modes[index].facts.pushes:
                return index, modes[index]
    return None


def changes_sides(sequence: ModeSequence, workshop: Workshop, i: int, choice: tuple[int, ...]) -> bool:
    """Would a contact press on the other side of a surface than it did before state i?"""
    for (joint, modes), index in zip(workshop.drawn(sequence.stretch(i).span).modes, choice, strict=True):
        held = held_before(sequence, workshop, i, joint.name)
        if held is None:
            continue
        if any(_opposite(p, q) for p, q in zip(_forces(modes[index]), _forces(held[1]), strict=False)):
            return True
    return False


def _forces(mode: Mode) -> list[Vec]:
    """The forces of its normal pushes on the first body."""
    return [p.actions[0].force for p in mode.facts.pushes if p.kind == "normal" and p.actions[0].force is not None]


def _opposite(a: Vec, b: Vec) -> bool:
    return bool(sp.expand(a.x + b.x) == 0 and sp.expand(a.y + b.y) == 0)


def just_parted(course: RegimeSequence) -> list[Equation]:
    """Where the first state is the end of a contact: what is about to part has no velocity apart."""
    regime, first = course.regimes[0], course.first
    base = regime.general.instant.scene.valuations[0]
    value = base.extended({c.symbol: base(c.drawn) for c in regime.coordinates if c.drawn is not None})
    found = []
    for parted in regime.general.parted:
        # What stands between bars keeps its sign until the gap has closed again.
        between = {a: a.args[0] for a in parted.residual.atoms(sp.Abs) if value.known(a.args[0]) is not None}
        bars = {a: inside if value(inside) >= 0 else -inside for a, inside in between.items()}
        rate = regime.derivative(parted.residual.xreplace(bars))
        if rate != 0:
            words = f"{parted.words}, and has just touched"
            found.append(Equation(first.at(rate), "start", words, first.name))
    return found
