"""What comes before the forces of a part of a motion, with the moments of inertia on which it rests."""

from __future__ import annotations

from collections.abc import Iterable, Sequence

from planar_cli.report.blocks import Block, Heading, Math
from planar_cli.report.in_order_of_time import in_turn, states_of, states_told, steps_before
from planar_cli.report.inertias import with_inertias
from planar_cli.report.laws import without_given
from planar_cli.report.mentioned import pieces_of
from planar_cli.report.motion import MotionTelling
from planar_cli.report.motion_phrases import motion_phrases
from planar_cli.report.motion_title import title_of
from planar_cli.report.nil_impulses import nil_impulses
from planar_cli.report.origins import needed_steps, told_once
from planar_cli.solve.between.trace import MotionTrace
from planar_cli.solve.solution import InstantSolution


def motion_telling(motion: MotionTrace, figures: int, why: str | None) -> MotionTelling:
    """What tells a motion. `why`: the name of the find on which it then rests alone."""
    asked = [a for a in motion.requests if a.find.name == why]
    letters = frozenset(s.name for a in asked for p in a.parts for s in p.free_symbols)
    return MotionTelling(motion, motion_phrases(motion, figures), 1, None if why is None else letters)


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
        body = list(told_once(telling.told_route(found.route, part)))
        states = states_told(states_of(part, found), states_of(telling.early, found))
        telling.early += part
        steps += bool(body)
        own += [Heading(f"STEP {steps}", title_of(part, found), states), *body] if body else []
    told = with_inertias(own, found, instant.instant.scene, telling.numeric, before)
    used = _letters(own)
    kept = without_given([b for b in told if b in own or _letters([b]) & used], before)
    return kept, steps, telling.next - 1


def _letters(blocks: Iterable[Block]) -> set[str]:
    """The first letters of lines, or all in them."""
    return {s.name for b in blocks for p in pieces_of(b) if isinstance(p, Math) for s in p.expr.free_symbols}
