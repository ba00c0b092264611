"""What comes before the forces of a part of a motion, with the moments of inertia on which it rests."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from itertools import takewhile
from typing import Any

from planar_cli.report.document.blocks import Block, Equation, Heading, Math, Note, Paragraph, line
from planar_cli.report.document.mentioned import pieces_of
from planar_cli.report.instant.one_find import letters_of_find
from planar_cli.report.kinetics.inertias import with_inertias
from planar_cli.report.laws.along_both_axes import headed_once
from planar_cli.report.laws.laws import without_given
from planar_cli.report.momentum.motion_title import title_of
from planar_cli.report.momentum.nil_impulses import nil_impulses
from planar_cli.report.motion.in_order_of_time import (
    in_time,
    in_turn,
    last_by_energy,
    states_of,
    states_told,
    steps_before,
)
from planar_cli.report.motion.motion import MotionTelling
from planar_cli.report.oscillation.linear_lengths import with_linear_lengths
from planar_cli.report.words.motion_phrases import motion_phrases
from planar_cli.report.words.origins import needed_steps
from planar_cli.solve.between.trace.trace import PAIR, ImpactEquation, MotionTrace
from planar_cli.solve.solution import InstantSolution


def motion_telling(motion: MotionTrace, figures: int, why: str | None) -> MotionTelling:
    """What tells a motion. `why`: the name of the find on which it then rests alone."""
    letters = None if why is None else letters_of_find(motion, why)
    return MotionTelling(motion, motion_phrases(motion, figures), 1, letters)


def early_blocks(
    telling: MotionTelling, instant: InstantSolution, numbers: tuple[int, int], before: Sequence[Block]
) -> tuple[list[Block], int, int]:
    """What happens before the forces of an instant act; how many steps and numbered equations there are then.
    `numbers`: how many of them stand before it; `before`: all that was told.
    """
    found, (steps, count) = telling.found, numbers
    legs = steps_before(found, found.regime(instant), needed_steps(found.route, telling.wanted), telling.early)
    if not legs:
        return [], steps, count
    telling.next = count + 1
    own: list[Block] = [] if telling.early else list(nil_impulses(found, telling.phrases))
    for part in in_turn(legs, found):
        body = headed_once(telling.told_route(found.route, part))
        states = states_told(states_of(part, found), states_of(telling.early, found))
        telling.early += part
        steps += bool(body)
        own += [Heading(f"STEP {steps}", title_of(part, found), states), *body] if body else []
    told = with_inertias(own, found, instant.instant.scene, telling.numeric, before)
    used = _letters(own)
    kept = without_given([b for b in told if b in own or _letters([b]) & used], before)
    return kept, steps, telling.next - 1


def way_blocks(telling: MotionTelling, steps: int, speaks: tuple[int, str] | None) -> Iterator[Block]:
    """The steps that lead from state to state, then forces at single states. `steps`: how many steps stand before
    them; `speaks`: figures and audience of those forces; None: they are not told.
    """
    from planar_cli.report.instant.at_state import state_blocks

    early = _before_pair(telling, steps)
    way = [*early, *telling.blocks(steps + _headed(early) + 1)]
    yield from way
    if speaks is not None:
        yield from state_blocks(telling.found, *speaks, steps + _headed(way), telling.next - 1)


def _headed(blocks: Iterable[Block]) -> int:
    return sum(isinstance(b, Heading) for b in blocks)


def _before_pair(telling: MotionTelling, steps: int) -> list[Block]:
    """What leads to the state from which on two bodies move about their mass centre, each blow on the way by itself;
    empty where none move so.
    """
    found, told = telling.found, list[Block]()
    legs = needed_steps(found.route, telling.wanted)
    first = next((i for i, leg in enumerate(legs) if leg.relations[0].kind == PAIR), None)
    for part in in_turn(in_time(legs[:first], found), found) if first is not None else ():
        body = headed_once(telling.told_route(found.route, part))
        states = states_told(states_of(part, found), states_of(telling.early, found))
        telling.early += part
        steps += bool(body)
        told += [Heading(f"STEP {steps}", title_of(part, found), states), *body] if body else []
    return told


def leads_through(telling: MotionTelling, instant: InstantSolution) -> bool:
    """Do balances alone lead through all states, so that they stand before forces that are the same all the time?"""
    found = telling.found
    legs = needed_steps(found.route, telling.wanted)
    return bool(last_by_energy(found, found.regime(instant), legs)) and set(legs) <= {*telling.early}


def with_assumed_first(
    blocks: Sequence[Block], early: Sequence[Block], told: Sequence[Block]
) -> tuple[list[Block], list[Block]]:
    """Before what leads through all states, the last of the blocks, what is assumed of the instant that follows, as it
    holds for all of it; and the rest of the instant.
    """
    assumed = list(takewhile(lambda b: isinstance(b, Note), told))
    return [*blocks[: len(blocks) - len(early)], *assumed, *early], list(told[len(assumed) :])


def same_all_the_time(found: MotionTrace, instant: InstantSolution, told: Sequence[Block]) -> list[Block]:
    """That what is asked at the end of a stretch, but of a blow, has its value all the time; nothing where no equation
    is `told`.
    """
    if not any(isinstance(b, Equation) for b in told):
        return []
    regime = found.regime(instant)
    blows = {e.stop for leg in found.route.steps for e in leg.relations if isinstance(e.source, ImpactEquation)}
    later = {stop for _, stop in regime.stretches} - blows
    finds = [parts for state in later & regime.asked.keys() for parts in regime.asked[state].values()]
    same = [s for s in regime.constants if any(s in parts for parts in finds)]
    if not same:
        return []
    listed: list[Any] = []
    for i, s in enumerate(same):
        listed += [*([" and " if i == len(same) - 1 else ", "] if i else []), Math(s)]
    ((since, _), *_), (*_, (_, until)) = regime.stretches, regime.stretches
    span = " at every instant." if len(found.regimes) == 1 else f" all the time from {since} to {until}."
    return [Paragraph(line(*listed, " is" if len(same) == 1 else " are", " the same", span))]


def placed(moving: Sequence[Block], blocks: Sequence[Block], place: int | None, motion: MotionTrace) -> list[Block]:
    """The last lines of a motion behind all blocks, or at the place where the way through its states ends, if they need
    no forces, no heading and no numbers of equations.
    """
    forces = {s.name for regime in motion.regimes for s in regime.constants}
    numbered = any(isinstance(b, Heading) or (isinstance(b, Equation) and b.number is not None) for b in moving)
    if place is None or numbered or _letters(moving) & forces:
        return with_linear_lengths([*blocks, *moving])
    return [*blocks[:place], *moving, *blocks[place:]]


def _letters(blocks: Iterable[Block]) -> set[str]:
    """The first letters of lines, or all in them."""
    return {s.name for b in blocks for p in pieces_of(b) if isinstance(p, Math) for s in p.expr.free_symbols}
