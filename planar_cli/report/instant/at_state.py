"""Forces and accelerations at one state of a motion: the equations of its general position with the numbers there.

Where they are short in letters they are solved in general; else a page would be full of algebra that nobody asks for.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import replace
from decimal import Decimal
from typing import Any

import sympy as sp

from planar_cli.equation.algebra.plain import longer
from planar_cli.equation.values.exact import Valuation
from planar_cli.errors import NoValue
from planar_cli.report.document.blocks import Block, Equation, Heading, Name, line
from planar_cli.report.instant.telling import Telling
from planar_cli.report.kinematics.turning_axes import in_turning_axes
from planar_cli.report.notation.clean import is_clean
from planar_cli.report.words.words import Phrases
from planar_cli.solve.between.trace.trace import MotionTrace, RegimeTrace
from planar_cli.solve.instant.algebra import SolvedBlock
from planar_cli.solve.instant.stages import Stage
from planar_cli.solve.instant.used import used_blocks
from planar_cli.solve.solution import InstantSolution

LONGEST = 36
"""Equations and solutions of more operations are not told in general."""


def is_told_at_states(motion: MotionTrace, regime: RegimeTrace) -> bool:
    """Is what is asked of a regime at states too long in letters, or does it mix them with numbers that have units?
    What is the same at all times has its numbers in the general position, and is not told once more.
    """
    if motion.symbolic or not regime.asked or regime.wanted is None or _is_constant(regime):
        return False
    stages = used_blocks(regime.solution.stages, regime.wanted)
    ledger = regime.solution.instant.scene.ledger
    for block in (b for s in stages if s.level == "acceleration" for b in s.blocks):
        sides = [(w.left, w.right) for w in block.equations if not w.given]
        long = any(longer(left - right, LONGEST) or not is_clean(ledger, left, right) for left, right in sides)
        if long or any(longer(x.formula, LONGEST) for x in block.lines):
            return all(_has_values(regime.solution, motion, state) for state in regime.asked)
    return False


def _has_values(instant: InstantSolution, motion: MotionTrace, state: str) -> bool:
    """Has every line a number at a state? What is divided by may vanish there, though what is asked has a limit."""
    try:
        placed(instant, motion, state)
    except NoValue:
        return False
    return True


def _is_constant(regime: RegimeTrace) -> bool:
    """Are all unknowns that are asked for at states the same all the time?"""
    lasting = {x.name for x in regime.constants} | {x.name for s in regime.solution.stages for x in s.zero}
    return regime.wanted is not None and regime.wanted - (regime.resting or set()) <= lasting and bool(regime.constants)


def told_at_states(motion: MotionTrace) -> frozenset[str]:
    """The names of the finds that are told so."""
    regimes = (r for r in motion.regimes if is_told_at_states(motion, r))
    told = frozenset(name for r in regimes for asked in r.asked.values() for name in asked)
    return told - in_turning_axes(motion)


def state_blocks(motion: MotionTrace, figures: int, audience: str, steps: int, numbers: int) -> Iterator[Block]:
    """The kinetics of regimes at every state at which something of them is asked. `steps`, `numbers`: how many steps
    and numbered equations stand before.
    """
    regimes = [r for r in motion.regimes if is_told_at_states(motion, r)]
    elsewhere = in_turning_axes(motion)
    every = [(r, state, asked) for r in regimes for state, asked in r.asked.items() if not elsewhere >= set(asked)]
    for regime, state, asked in every:
        here = placed(regime.solution, motion, state)
        names = frozenset(s.name for parts in asked.values() for p in parts for s in p.free_symbols)
        phrases = Phrases(here.instant.scene.ledger, here.value, figures, False)
        telling = Telling(here, phrases, audience, names, steps, numbers)
        yield Heading("STATE", state)
        yield from telling.blocks()
        yield from _answers(motion, asked, phrases)
        steps, numbers = telling.steps, telling.count


def _answers(motion: MotionTrace, asked: Mapping[str, tuple[sp.Expr, ...]], phrases: Phrases) -> Iterator[Block]:
    """name = what it is = numbers = value."""
    units = {r.find.name: r.unit for r in motion.requests}
    for name, parts in asked.items():
        unit = units[name]
        for axis, part in zip(("x", "y") if len(parts) > 1 else ("",), parts, strict=True):
            if unit is None or (part.is_Symbol and part.name == name):
                continue
            values = phrases.in_units(phrases.value(part), unit)
            short = not longer(part, LONGEST)
            sides: list[Any] = [line(Name(name), f", {axis}" if axis else "")]
            sides += [phrases.math(part), *phrases.substituted(part, values[0])] if short else []
            yield Equation((*sides, *values))


def placed(instant: InstantSolution, motion: MotionTrace, state: str) -> InstantSolution:
    """A general position with the numbers of one state, as far as they are known."""
    roles = motion.ledger.roles
    own = {g: motion.value.known(x) for x, g in motion.general.items() if roles[x].at == state}
    here = {g: number for g, number in own.items() if number is not None}
    found = {x for s in instant.stages for x in (*s.algebra.unknowns, *s.algebra.explicit)} - set(here)
    value = instant.value.extended(motion.value.values).without(found).extended(here)
    for stage in instant.stages:
        value = _solved(stage, value)
    last = (s for s in instant.stages if s.level == "acceleration")
    return replace(instant, stages=tuple(_with_values(s, value) for s in last), value=value)


def _solved(stage: Stage, value: Valuation) -> Valuation:
    """With the numbers of everything that a stage gives."""
    lines = {x.symbol: x.formula for b in stage.blocks for x in b.lines if not x.letters}
    left = {**stage.algebra.explicit, **lines, **dict.fromkeys(stage.zero, sp.S.Zero)}
    while ready := [s for s, e in left.items() if all(value.known(x) is not None for x in e.free_symbols)]:
        zeros = {s for s in ready if value.is_zero(left[s])}
        value = value.extended({s: Decimal(0) if s in zeros else value(left[s]) for s in ready})
        left = {s: e for s, e in left.items() if s not in ready}
    return value


def _with_values(stage: Stage, value: Valuation) -> Stage:
    """Its lines with the numbers of the state."""

    def known(symbol: sp.Symbol) -> Decimal | None:
        return value.known(symbol)

    blocks = []
    for b in stage.blocks:
        lines = tuple(x if x.letters else replace(x, value=known(x.symbol)) for x in b.lines)
        blocks.append(SolvedBlock(b.equations, b.unknowns, b.letters, lines))
    return replace(stage, blocks=tuple(blocks))
