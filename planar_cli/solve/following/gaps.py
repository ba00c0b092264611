"""Whether what has parted opens, and when it closes again."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import replace

import sympy as sp

from planar_cli.equation.scales import Here
from planar_cli.errors import NoValue
from planar_cli.problem.facts import Mode
from planar_cli.problem.geometry import Vec
from planar_cli.solve.between.events import FollowedSegment, events, scale_of
from planar_cli.solve.regimes.directions import becomes_negative
from planar_cli.solve.regimes.equations import Equation
from planar_cli.solve.regimes.mode_sequence import ModeSequence, Workshop
from planar_cli.solve.regimes.regime import Regime
from planar_cli.solve.regimes.regime_sequence import RegimeSequence

OPEN = 1e-10
"""A gap that is open, in parts of the largest length in sight."""
HALVINGS = 24


def openings(course: RegimeSequence, i: int, regime: Regime) -> Iterator[tuple[sp.Expr, str]]:
    """What is positive where joints have parted from state i on, and the words of it."""
    for gap in regime.gaps:
        held = held_before(course.modes, course.workshop, i, gap.joint)
        yield gap.opening(None if held is None else held[0]), gap.words


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
    rates = [(regime.derivative(g.expr), g.words) for g in regime.gaps]
    return [Equation(first.at(rate), "start", f"{words}, and has just touched", first.name) for rate, words in rates]


def closes_at_once(regime: Regime, opening: sp.Expr, here: Here) -> bool:
    """Would what is taken for parted press into its partner?"""
    for expr in (opening, rate := regime.derivative(opening)):
        sign = here.sign(expr)
        if sign:
            return sign < 0
    return becomes_negative(regime, rate, here)


def closing(g: Callable[[float], float], segment: FollowedSegment, until: float | None) -> float | None:
    """When a gap that opens from zero at the beginning of a segment has closed again; None: not before `until`."""
    scale = scale_of(segment)
    for k in range(HALVINGS, -1, -1):
        begin = segment.t0 + scale * 2.0**-k
        if until is not None and begin >= until:
            return None
        try:
            away = g(begin)
        except NoValue:
            return None
        if abs(away) > OPEN * segment.length:
            break
    else:
        return None
    if away < 0:
        return begin
    later = replace(segment, t0=begin, start=segment.at(begin))
    return next((r.value for r in events(g, later, until) if r.kind == "crossing"), None)
