"""What is asked of accelerations and forces at one state alone, in letters, is told by the equations there: with θ = 0
in place of sines and cosines of every θ, which nothing needs.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import replace
from typing import Any

import sympy as sp

from planar_cli.equation.algebra.plain import longer, simplified
from planar_cli.equation.values.exact import Valuation
from planar_cli.report.document.blocks import Block, Equation, Forces, Heading, Line, Math, Paragraph, Text, line
from planar_cli.report.given.named_lengths import with_named_lengths
from planar_cli.report.instant.telling import Telling
from planar_cli.report.kinetics.gathered import gathered
from planar_cli.report.kinetics.idle_centres import without_idle_centre
from planar_cli.report.kinetics.raw_moments import without_nothing
from planar_cli.report.motion.by_components import with_components
from planar_cli.report.motion.shown import place_at, place_drawn, place_of_rest
from planar_cli.report.oscillation.small_deviations import in_small_deviations, is_of_small_deviations
from planar_cli.report.recast.known_put_in import rates_alike
from planar_cli.report.words.state_words import place
from planar_cli.report.words.words import Phrases
from planar_cli.solve.between.trace.trace import MotionTrace, RegimeTrace
from planar_cli.solve.instant.stages import acceleration_unknowns
from planar_cli.solve.instant.used import used_blocks
from planar_cli.solve.solution import InstantSolution

ACCELERATIONS, KINETICS = "Accelerations:", "Kinetic analysis"
SHORT, MOST = 20, 60
"""Equations of fewer operations are told in general. What is longer at the state is not made plainer."""


def state_of(motion: MotionTrace, regime: RegimeTrace) -> str:
    """The one state at which forces and accelerations of a regime are asked, where nothing else rests on them and an
    angle is right or nought; "": there is none, or in general they are as short.
    """
    instant = regime.solution
    system = instant.trial.system
    kinetic = {*(s.name for s in acceleration_unknowns(system)), *(s.name for s in system.symbols.values())}
    if not motion.symbolic or len(regime.asked) != 1 or regime.resting is None or regime.resting & kinetic:
        return ""
    (state,) = regime.asked
    stages = (s for s in used_blocks(instant.stages, regime.wanted) if s.level == "acceleration")
    written = [w.residual for s in stages for b in s.blocks for w in b.equations if not w.given]
    places = places_at(motion, state)
    turned = {s for s, known in places.items() if known != 0 or motion.ledger.units[s].angle}
    if not any(longer(e, SHORT) and e.free_symbols & turned for e in written):
        return ""
    return state


def places_at(motion: MotionTrace, state: str) -> dict[sp.Symbol, sp.Expr]:
    """The coordinates that are nought in a state, and the angles that are right, by letters of the general position."""
    found: dict[sp.Symbol, sp.Expr] = {}
    for own, general in motion.general.items():
        if motion.ledger.roles[own].at != state or general.name == "t":
            continue
        known = motion.route.plain.get(own, motion.route.formulas.get(own))
        if known is None or not known.is_number:
            continue
        right = motion.ledger.units[general].angle and (2 * known / sp.pi).is_integer
        if known == 0 or right:
            found[general] = known
    return found


def where_told(motion: MotionTrace, instant: InstantSolution) -> Valuation | None:
    """The numbers of the position in which a general position is drawn; None: there are none."""
    if is_of_small_deviations(motion, instant):
        return place_of_rest(motion, instant)
    state = state_of(motion, motion.regime(instant))
    return place_at(motion, instant, state) if state else place_drawn(motion, instant)


def where_asked(
    blocks: list[Block], motion: MotionTrace, instant: InstantSolution, telling: Telling, phrases: Phrases
) -> list[Block]:
    """The blocks of a general position near the equilibrium, or at the state, of which alone something is asked; as
    they are where it is asked of more.
    """
    state = state_of(motion, motion.regime(instant))
    if not state:
        told = in_small_deviations(blocks, motion, instant, telling, phrases)
        return without_idle_centre(with_named_lengths(told, motion, instant, phrases))
    places = places_at(motion, state)
    angles = [line(Math(s), " = ", phrases.math(a)) for s, a in places.items() if motion.ledger.units[s].angle]
    where = line(f"{place(state)}, ", *(piece for i, a in enumerate(angles) for piece in (", " if i else "", *a)), ":")
    start = next((i for i, b in enumerate(blocks) if _is(b, ACCELERATIONS) or _is(b, KINETICS)), len(blocks))
    found, alike = list[Block](blocks[:start]), rates_alike(instant)
    for block in blocks[start:]:
        if _is(block, ACCELERATIONS):
            found.append(Paragraph(line("Accelerations ", *where)))
            continue
        put = _put(block, places, phrases)
        if put is None:
            return blocks
        found.append(with_components(put, instant, places, alike, phrases))
        if _is(block, KINETICS):
            found.append(Paragraph(line(*_capital(where))))
    return gathered(found, alike, phrases)


def _capital(words: Line) -> Line:
    first, *rest = words
    return line(first.text[:1].upper() + first.text[1:], *rest) if isinstance(first, Text) else words


def _is(block: Block, words: str) -> bool:
    if isinstance(block, Heading):
        return block.text == words
    return isinstance(block, Paragraph) and "".join(getattr(p, "text", "") for p in block.line) == words


def _put(block: Block, places: Mapping[sp.Symbol, sp.Expr], phrases: Phrases) -> Block | None:
    """A block at the place; None: it says nothing there."""
    if isinstance(block, Equation):
        sides = tuple(_side(side, places, phrases) for side in block.sides)
        if len(sides) > 1 and all(isinstance(s, Math) and s.expr == 0 for s in sides):
            return None
        return replace(block, sides=_once(sides), note=_line(block.note, places, phrases))
    if isinstance(block, Forces):
        left, right = (_line(side, places, phrases) for side in (block.left, block.right))
        return (
            None
            if any(isinstance(p, Math) and p.expr == 0 for p in (*left, *right))
            else replace(block, left=left, right=right)
        )
    return block


def _once(sides: tuple[Any, ...]) -> tuple[Any, ...]:
    """Without a side that became the one before it."""
    return tuple(s for i, s in enumerate(sides) if i < 2 or s != sides[i - 1])


def _side(side: Any, places: Mapping[sp.Symbol, sp.Expr], phrases: Phrases) -> Any:
    if isinstance(side, tuple):
        return without_nothing(_line(side, places, phrases))
    return next(_pieces((side,), places, phrases))


def _line(whole: Line, places: Mapping[sp.Symbol, sp.Expr], phrases: Phrases) -> Line:
    return tuple(_pieces(whole, places, phrases))


def _pieces(whole: Line, places: Mapping[sp.Symbol, sp.Expr], phrases: Phrases) -> Iterator[Any]:
    for piece in whole:
        if isinstance(piece, Math) and isinstance(piece.expr, sp.Basic) and piece.expr.free_symbols & places.keys():
            put = piece.expr.xreplace(dict(places))
            plain = put.is_Add or longer(put, MOST)
            yield phrases.math(put if plain else simplified(put))
        else:
            yield piece
