"""The extreme position of a mechanism in words: the slider rests for a moment, so crank and rod lie in one line, folded
on each other or stretched.

At 1, v_B = 0: OA and AB lie in one line, folded:   θ_AB,1 = θ_OA,1 - π
B stays on its line:                                (l - r) sin θ_OA,1 = e
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from typing import Any

import sympy as sp

from planar_cli.equation.algebra.plain import simplified
from planar_cli.equation.values.exact import PI
from planar_cli.problem.scene.scene import Rod
from planar_cli.report.document.blocks import Block, Equation, Line, Paragraph, Text, Value, line
from planar_cli.report.words.origins import balanced, head
from planar_cli.report.words.words import Phrases
from planar_cli.solve.between.trace.trace import DeadPosition, LinksInLine, MotionTrace, Result, RouteStep

HALF_TURN = 180
Chain = Callable[[Result, bool], tuple[Any, ...]]


def in_line_blocks(leg: RouteStep, found: MotionTrace, phrases: Phrases, number: int, chain: Chain) -> list[Block]:
    """A step that tells such a position, with one numbered equation; empty of another step. `chain`: the sides of a
    result.
    """
    own = leg.in_line
    if own is None:
        return []
    result = next(r for r in leg.results if r.unknown == own.first)
    before = found.route.steps[: found.route.steps.index(leg)] if leg in found.route.steps else ()
    earlier = [(s, same) for s in before if (same := s.in_line) is not None]
    if own.dead is not None:
        return list(_by_triangle((leg, own, own.dead), found, phrases, number, (chain, [same for _, same in earlier])))
    for step, same in earlier:
        turns = simplified((own.formula - same.formula) / (2 * sp.pi))
        if turns.is_Integer and own.folded == same.folded:
            return _again(leg, own, (step, same, int(turns)), found, phrases, (number, chain(result, False)))
    return list(_first(leg, own, found, phrases, number, (chain(result, False), not earlier)))


def _first(
    leg: RouteStep, own: LinksInLine, found: MotionTrace, phrases: Phrases, number: int, told: tuple[Any, bool]
) -> Iterator[Block]:
    e, loop = leg.relations
    sides, explained = told
    yield Paragraph(line(*_open(head(e, found.ledger.symbols)), ", ", *_why(own, e.words, found, explained), ":"))
    yield Equation((phrases.math(own.other), phrases.math(own.first + own.half_turns * sp.pi)))
    yield Paragraph(head(loop, found.ledger.symbols))
    closed = loop.residual.xreplace({own.other: own.first + own.half_turns * sp.pi})
    slope = simplified(sp.diff(closed, own.first) / sp.cos(own.first))
    whole = slope * sp.sin(own.first) + simplified(closed.xreplace({own.first: sp.S.Zero}))
    yield Equation(tuple(phrases.math(s) for s in balanced(loop, whole)), number)
    yield Equation(sides, None, line(f"({number}):"))
    yield from _not_the_other(own, found, phrases)


def _again(
    leg: RouteStep,
    own: LinksInLine,
    before: tuple[RouteStep, LinksInLine, int],
    found: MotionTrace,
    phrases: Phrases,
    told: tuple[int, tuple[Any, ...]],
) -> list[Block]:
    """The same position so many turns after an earlier one."""
    step, same, turns = before
    way = (
        f"{_way(own)} as at {step.relations[0].stop}, {'one turn' if abs(turns) == 1 else f'{abs(turns)} turns'} later:"
    )
    words = line(*_open(head(leg.relations[0], found.ledger.symbols)), f", {way}")
    formula = phrases.math(same.first + 2 * turns * sp.pi)
    return [Paragraph(words), Equation((told[1][0], formula, told[1][-1]), told[0])]


def _by_triangle(
    told: tuple[RouteStep, LinksInLine, DeadPosition],
    found: MotionTrace,
    phrases: Phrases,
    number: int,
    way: tuple[Chain, Sequence[LinksInLine]],
) -> Iterator[Block]:
    """The acute angle of the line, the place, and the angle turned since the position before."""
    leg, own, dead = told
    e, chain, earlier, explained = leg.relations[0], *way, not way[1]
    opening, span = _open(head(e, found.ledger.symbols)), f"from {dead.since} to {e.stop}"
    turns = "" if dead.turned is None else f"{span} the crank turns, at its constant rate, through"
    if dead.again:
        yield Paragraph(line(*opening, f", {_way(own)} as one turn before; {turns}:"))
    else:
        phi = phrases.math(dead.acute.unknown)
        yield Paragraph(line(*opening, ", ", *_why(own, e.words, found, explained), ", inclined at ", phi, ":"))
        length, offset = dead.sine
        yield Equation((phrases.math(length * sp.sin(dead.acute.unknown)), phrases.math(offset)), number)
        yield Equation(chain(dead.acute, False), None, line(f"({number}):"))
        yield from () if dead.place is None else [Equation(chain(dead.place, True))]
        yield from _pointing(own, dead, found, chain)
        yield from _order(own, earlier, found, phrases)
        yield from () if dead.turned is None else [Paragraph(line(turns[0].upper(), turns[1:], ":"))]
    if dead.turned is not None:
        radians = Value(dead.turned.value, "rad", phrases.figures)
        before = next((same.dead for same in reversed(earlier) if not dead.again), None)
        between = _between(dead, before, phrases)
        letter, *sides = chain(dead.turned, True)
        yield Equation((letter, *between, *sides, radians))


def _pointing(own: LinksInLine, dead: DeadPosition, found: MotionTrace, chain: Chain) -> Iterator[Block]:
    """`Folded, OA points away from B, at the angle θ_1 from the x axis:`"""
    names = _rods(own, found)
    if names is None or dead.direction is None:
        return
    end, crank = names[3], names[0]
    share = dead.along - dead.along.coeff(sp.cos(own.other)) * sp.cos(own.other)
    to = "points to" if found.value(share) * found.value(dead.along) > 0 else "points away from"
    words = f"{_way(own).capitalize()}, {crank} {to} {end}; its angle, counterclockwise from the x axis:"
    yield Paragraph(line(words))
    yield Equation(chain(dead.direction, False))


def _between(dead: DeadPosition, before: DeadPosition | None, phrases: Phrases) -> tuple[Any, ...]:
    """θ_2 - θ_1"""
    if before is None or before.direction is None or dead.direction is None:
        return ()
    return (phrases.math(dead.direction.unknown - before.direction.unknown),)


def _order(own: LinksInLine, earlier: Sequence[LinksInLine], found: MotionTrace, phrases: Phrases) -> Iterator[Block]:
    """`From θ_0 = 0 on OA comes to θ_1 first, then to θ_2.`"""
    if len(earlier) != 1 or own.dead is None or own.dead.direction is None:
        return
    before, names = earlier[0].dead, _rods(own, found)
    ends = {(g, s.name.rpartition("__")[2]): s for s, g in found.general.items()}
    start = ends.get((found.general.get(own.first, own.first), found.states[0]))
    if before is None or before.direction is None or start is None or names is None:
        return
    number = Value(found.value(found.route.plain.get(start, start)) * HALF_TURN / PI, "deg", phrases.figures)
    one, other = (phrases.math(d.unknown) for d in (before.direction, own.dead.direction))
    at = sp.Symbol(f"theta__{found.states[0]}", real=True)
    comes = line("From ", phrases.math(at), " = ", number, f" on, {names[0]} comes to ", one, " first, then to ", other)
    yield Paragraph(comes)


def _way(own: LinksInLine) -> str:
    return "folded" if own.folded else "stretched"


def _open(words: Line) -> Line:
    """A heading without its colon."""
    *parts, last = words
    return line(*parts, last.text.removesuffix(":")) if isinstance(last, Text) else line(*words)


def _why(own: LinksInLine, words: str, found: MotionTrace, explained: bool) -> Line:
    """Why two rods lie in one line where a velocity vanishes: the joint moves perpendicularly to both."""
    names = _rods(own, found)
    if names is None:
        return line(f"the two links lie in one line, {_way(own)}")
    one, other, joint, end = names
    both = f"{one} and {other} lie in one line, {_way(own)}"
    if not explained or not words.startswith("v("):
        return line(both)
    return line(f"{end} rests for a moment: {joint} then moves perpendicularly to {other} and to {one}, so that {both}")


def _rods(own: LinksInLine, found: MotionTrace) -> tuple[str, str, str, str] | None:
    """The two rods by their ends, their joint, and the other end of the second; None: they are no rods."""
    bodies = {
        c.symbol: c.body
        for regime in found.regimes
        if (displacement := regime.solution.instant.scene.displacement) is not None
        for c in displacement.coordinates
    }
    shapes = {b.name: b.shape for b in found.problem.bodies}
    one, other = (shapes.get(bodies.get(found.general[s], "")) for s in (own.first, own.other))
    if not isinstance(one, Rod) or not isinstance(other, Rod) or one.end is None or other.end is None:
        return None
    ends = (one.start, one.end), (other.start, other.end)
    joint = next((p for p in ends[0] if p in ends[1]), None)
    if joint is None:
        return None
    end = next(p for p in ends[1] if p != joint)
    return "".join(ends[0]), "".join(ends[1]), joint, end


def _not_the_other(own: LinksInLine, found: MotionTrace, phrases: Phrases) -> Iterator[Block]:
    """The sine has a second angle: there the second rod points to the other side."""
    names = _rods(own, found)
    if names is None or phrases.symbolic:
        return
    mirrored = (HALF_TURN - found.value(own.first) * HALF_TURN / PI) % (2 * HALF_TURN)
    mirrored += 2 * HALF_TURN if mirrored < 0 else 0
    side = "left" if found.value(sp.cos(own.other)) > 0 else "right"
    words = f": there {names[1]} would point to the {side}"
    yield Paragraph(line("Not ", Value(mirrored, "deg", phrases.figures), words))
