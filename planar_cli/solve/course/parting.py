"""Where things part: a contact that lifts off, a rope that slackens.

A joint that has parted states nothing of places any more. What it kept as long as it held is then its gap, which opens
from zero; where it closes again things strike each other, and only an `impact` tells what comes of that.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from decimal import Decimal
from typing import TYPE_CHECKING

import sympy as sp

from planar_cli.equation.displacement import Coordinate, Displacement
from planar_cli.equation.exact import Unvalued
from planar_cli.equation.motion import Motion
from planar_cli.problem.facts import Mode
from planar_cli.solve.course.constraints import kept_while_held
from planar_cli.solve.instant import Instant

if TYPE_CHECKING:
    from planar_cli.solve.course.regime import Regime

DRAW = Decimal("0.61803")


@dataclass(frozen=True, slots=True)
class Parted:
    """A joint that has parted, in velocity unknowns. `residual`: what it kept, of places; `openings`: by the mode in
    which it held (its index), the velocity with which that opens, as drawn.
    """

    joint: str
    words: str
    residual: sp.Expr
    openings: tuple[tuple[int, sp.Expr], ...]


@dataclass(frozen=True, slots=True)
class Gap:
    """What opens where a joint has parted, a formula of the general position. `senses`: by the index of the mode in
    which it held, 1 where the formula grows as it opens, else -1.
    """

    joint: str
    words: str
    expr: sp.Expr
    senses: tuple[tuple[int, int], ...]

    def opening(self, held: int | None) -> sp.Expr:
        """What is positive where it is open. `held`: the mode in which it held before (None: the first that may be)."""
        senses = dict(self.senses)
        return senses.get(-1 if held is None else held, self.senses[0][1]) * self.expr


def parted_modes(drawn: Instant, choice: tuple[int, ...]) -> dict[str, tuple[Mode, ...]]:
    """The modes, as drawn, of all joints that have parted in a choice."""
    return {j.name: modes for (j, modes), i in zip(drawn.modes, choice, strict=True) if modes[i].parted}


def parted_joints(
    drawn: Instant,
    choice: tuple[int, ...],
    displacement: Displacement,
    coordinates: tuple[Coordinate, ...],
    motion: Motion,
) -> tuple[Parted, ...]:
    """All joints that have parted in a choice of modes, and what they kept."""
    found = []
    for (joint, modes), i in zip(drawn.modes, choice, strict=True):
        if not modes[i].parted:
            continue
        slides = next((m for m in modes if m.facts.pushes and m.facts.joinings == modes[i].touching.joinings), None)
        kept = kept_while_held(drawn, joint, slides, displacement, coordinates) if slides is not None else ()
        openings = tuple((k, _opening(m, motion)) for k, m in enumerate(modes) if m.facts.pushes)
        if kept:
            # Of a face that lifts off, the distance alone: it may also turn.
            found.append(Parted(joint.name, modes[i].words, kept[0].residual, openings))
    return tuple(found)


def _opening(mode: Mode, motion: Motion) -> sp.Expr:
    """The velocity with which a joint opens that presses or pulls: the power of a unit of its reaction."""
    push = next(p for p in mode.facts.pushes if p.kind in ("normal", "tension"))
    power = sp.S.Zero
    for a in push.actions:
        if a.body == "ground":
            continue
        if a.force is not None:
            power += a.force.dot(motion.velocity(a.point, a.body))
        power += a.couple * motion.velocities[a.body].angular
    return sp.expand(power)


def gaps_of(regime: Regime) -> Iterator[Gap]:
    """The gaps of a regime that is worked out, each with the sense in which it opens."""
    general = regime.general
    base = general.instant.scene.valuations[0]
    drawn = {c.symbol: c.drawn for c in general.coordinates if c.drawn is not None}
    numbers = {regime.time: Decimal(0), **{s: base(e) for s, e in drawn.items()}}
    numbers |= {u: DRAW + Decimal(i) / 7 for i, u in enumerate(general.free)}
    value = base.extended(numbers)
    for parted in general.parted:
        # What stands between bars keeps its sign until the gap has closed again.
        bars = {a: a.args[0] if value(a.args[0]) >= 0 else -a.args[0] for a in parted.residual.atoms(sp.Abs)}
        kept = parted.residual.xreplace(bars)
        rate = sp.diff(kept, regime.time)
        rate += sum(sp.diff(kept, q) * r for q, r in regime.rates.items())
        senses = []
        for index, opening in parted.openings:
            try:
                grows = value(rate * regime.closed(opening))
            except (ArithmeticError, Unvalued):
                continue
            if grows:
                senses.append((index, 1 if grows > 0 else -1))
        if senses:
            yield Gap(parted.joint, parted.words, kept, tuple(senses))


__all__ = ["Gap", "Parted", "gaps_of", "parted_joints", "parted_modes"]
