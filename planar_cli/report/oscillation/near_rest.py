"""A body near its equilibrium, drawn and summed up to the first order in the deviation δ: its accelerations are those
in the equilibrium without the terms with ω², which are of the second order.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from decimal import Decimal
from typing import Any

import sympy as sp

from planar_cli.equation.algebra.plain import simplified
from planar_cli.equation.scene.centres import centre_of
from planar_cli.problem.scene.geometry import Vec
from planar_cli.report.document.blocks import Block, Equation, Forces, Inline, Line, Math, Name, Paragraph, Text
from planar_cli.report.instant.telling import Telling
from planar_cli.report.kinetics.actions import onward
from planar_cli.report.kinetics.entries import entries, listed
from planar_cli.report.notation.names import index_of
from planar_cli.report.words.pointing import pointing
from planar_cli.report.words.words import Phrases
from planar_cli.solve.between.trace.oscillation_trace import NearRest
from planar_cli.solve.between.trace.trace import MotionTrace
from planar_cli.solve.instant.stages import acceleration_unknowns
from planar_cli.solve.solution import InstantSolution

SOLVED = "Solved for "
POSED = "drawn turned by δ from the equilibrium"
TURNED = Decimal("0.25")
"""So far, rad: as small as can be seen."""
SECOND_ORDER = "; terms with ω² are of the second order in it and left out"


def near_the_rest(blocks: list[Block], near: NearRest, instant: InstantSolution, phrases: Phrases) -> list[Block]:
    """Kinematics and diagrams of a general position in the equilibrium."""
    return [_put(block, near, instant, phrases) for block in blocks]


def sides_near(telling: Telling, near: NearRest, deviation: sp.Symbol) -> dict[int | None, tuple[sp.Expr, sp.Expr]]:
    """Both sides of the sum to the first order, by the number that it has on the page."""
    found: dict[int | None, tuple[sp.Expr, sp.Expr]] = {}
    for stage in telling.stages:
        for w in (w for block in stage.blocks for w in block.equations):
            if w.law in ("force", "moment") and w.left == near.of:
                sign = 1 if onward(w).left == w.left else -1
                found[telling.number(stage, w.number)] = (sign * near.slope * deviation, sign * near.inertia)
    return found


def with_numbers(blocks: Sequence[Block]) -> list[Block]:
    """`(1):` before the equation of motion that the last sum above it gives, solved for δ̈."""
    found: list[Block] = []
    number: int | None = None
    for block in blocks:
        if isinstance(block, Equation) and block.number is not None and _is_sum(block):
            number = block.number
        solved = bool(found) and isinstance(found[-1], Paragraph) and found[-1].line[:1] == (Text(SOLVED),)
        led = isinstance(block, Equation) and solved and number is not None
        found.append(replace(block, lead=(Text(f"({number}):"),)) if isinstance(block, Equation) and led else block)
    return found


def _is_sum(equation: Equation) -> bool:
    return any(isinstance(p, Name) and p.name.startswith("Σ") for p in equation.lead)


def differences(near: NearRest) -> list[tuple[sp.Symbol, sp.Symbol]]:
    """The differences of two letters in the moment of what has turned by δ."""
    sums = [f for f in sp.Mul.make_args(near.slope) if f.is_Add]
    pairs = [[t if t.is_Symbol else -t for t in f.args] for f in sums]
    return [(p[0], p[1]) for p in pairs if len(p) == 2 and all(t.is_Symbol for t in p)]


def _put(block: Block, near: NearRest, instant: InstantSolution, phrases: Phrases) -> Block:
    places = dict(near.places)
    if isinstance(block, Equation):
        sides = tuple(_slow(side, places) if isinstance(side, tuple) else side for side in block.sides)
        if sides != block.sides:
            sides = (*sides, *_as_one(block, places, instant, phrases))
        return replace(block, sides=sides, note=tuple(_pieces(block.note, places, phrases)))
    if isinstance(block, Forces) and block.right:
        drawn = _inertia(block, places, instant, phrases)
        return _turned(replace(block, right=drawn) if drawn else block, places, instant)
    return block


def _turned(block: Forces, places: dict[sp.Symbol, sp.Expr], instant: InstantSolution) -> Forces:
    """Drawn by a small angle off the equilibrium, as the sums are written, where one angle tells the position."""
    units = instant.instant.scene.ledger.units
    told = [s for s in places if units[s].places]
    alone = [units[s].turns for s in told] == [True]
    return replace(_put_by(block, {told[0]: places[told[0]]}), posed=POSED) if alone else block


def _put_by(block: Forces, rests: Mapping[sp.Symbol, sp.Expr]) -> Forces:
    """Drawn with angles that are a little more than in the equilibrium. `rests`: what they are there."""

    def there(piece: Inline) -> Inline:
        if not isinstance(piece, Text) or piece.way is None:
            return piece
        known = {q: rest for q, x in rests.items() if (rest := piece.way.value.known(x)) is not None}
        here = piece.way.value.extended({q: rest + TURNED for q, rest in known.items()})
        return replace(piece, way=replace(piece.way, value=here))

    left, right = (tuple(map(there, side)) for side in (block.left, block.right))
    return replace(block, left=left, right=right)


def turned_off(blocks: Sequence[Block], motion: MotionTrace, instant: InstantSolution) -> list[Block]:
    """The diagrams of a position that one angle tells, drawn by a small one off the equilibrium of a motion."""
    there = _at_rest(motion)
    return [_turned(b, there, instant) if isinstance(b, Forces) and b.right else b for b in blocks]


def swung(blocks: Sequence[Block], motion: MotionTrace, instant: InstantSolution) -> list[Block]:
    """The diagrams of a general position by which only swings about an equilibrium are told, its angles as large as can
    be seen.
    """
    if not motion.oscillations or any(since != stop for since, stop in motion.regime(instant).stretches):
        return list(blocks)
    angles = {g: motion.value.known(x) for g, x in _at_rest(motion).items() if motion.ledger.units[g].turns}
    rests = {g: sp.Rational(str(rest)) for g, rest in angles.items() if rest is not None}
    return [_put_by(b, rests) if isinstance(b, Forces) and b.right else b for b in blocks]


def _at_rest(motion: MotionTrace) -> dict[sp.Symbol, sp.Expr]:
    """What varies, with what it is in the equilibrium."""
    ledger, state = motion.ledger, motion.oscillations[0].state
    return {g: x for x, g in motion.general.items() if ledger.roles[x].at == state}


def _as_one(
    block: Equation, places: dict[sp.Symbol, sp.Expr], instant: InstantSolution, phrases: Phrases
) -> tuple[Line, ...]:
    """The acceleration of a mass centre along x or y, as one side more."""
    scene = instant.instant.scene
    body = next((b for b in scene.bodies if block.sides[0] == (Name(f"a_{index_of(centre_of(scene, b))}"),)), None)
    told = [] if body is None else list(_components(body, places, instant, phrases))
    return tuple((phrases.math(size), Text(f" {_arrow(way, phrases)}")) for size, way in told) if len(told) == 1 else ()


def _slow(side: Line, places: dict[sp.Symbol, sp.Expr]) -> Line:
    """Without a last term - ω² r."""
    if len(side) < 5:
        return side
    *before, sign, square, _, arm = side
    nought = isinstance(square, Math) and isinstance(square.expr, sp.Basic) and square.expr.xreplace(places) == 0
    return tuple(before) if nought and sign == Text(" - ") and isinstance(arm, Name) else side


def _pieces(whole: Line, places: dict[sp.Symbol, sp.Expr], phrases: Phrases) -> Iterator[Any]:
    for piece in whole:
        if isinstance(piece, Math) and isinstance(piece.expr, sp.Basic) and piece.expr.free_symbols & places.keys():
            yield phrases.math(simplified(piece.expr.xreplace(places)))
        else:
            yield piece


def _components(
    body: str, places: dict[sp.Symbol, sp.Expr], instant: InstantSolution, phrases: Phrases
) -> Iterator[tuple[sp.Expr, Vec]]:
    """The acceleration of a mass centre in the equilibrium: its parts along x and y, each in the sense in which it goes
    with the accelerations.
    """
    motion, model = instant.trial.system.motion, instant.instant.scene.bodies[body]
    if motion is None:
        return
    a = motion.acceleration(model.center, body)
    for component, way in ((a.x, Vec(sp.S.One, sp.S.Zero)), (a.y, Vec(sp.S.Zero, sp.S.One))):
        size = simplified(sp.sympify(component).xreplace(places))
        if size == 0:
            continue
        known = phrases.value.known(size.xreplace(dict.fromkeys(acceleration_unknowns(instant.trial.system), sp.S.One)))
        sign = -1 if size.could_extract_minus_sign() or (known is not None and known < 0) else 1
        yield simplified(sign * size), way * sign


def _arrow(way: Vec, phrases: Phrases) -> str:
    return phrases.arrow(way.x, way.y)


def _inertia(block: Forces, places: dict[sp.Symbol, sp.Expr], instant: InstantSolution, phrases: Phrases) -> Line:
    """m a_G of each body in its components, and its couple as it stands; empty: there is no such motion."""
    told = [list(_of_body(b, block, places, instant, phrases)) for b in block.body.split(", ")]
    return listed([entry for own in told for entry in own]) if all(told) else ()


def _of_body(
    body: str, block: Forces, places: dict[sp.Symbol, sp.Expr], instant: InstantSolution, phrases: Phrases
) -> Iterator[Line]:
    model = instant.instant.scene.bodies[body]
    here = [e for e in entries(block.right) if any(_is_there(p, model.center) for p in e)]
    ends = (p.text.partition(" at ") for e in here for p in e if isinstance(p, Text))
    at = next((" at " + place for _, _, place in ends if place), "")
    for size, way in _components(body, places, instant, phrases):
        told = phrases.math(sp.Mul(model.mass, size, evaluate=False))
        yield (told, pointing(phrases, f" {_arrow(way, phrases)}{at}", model.center, way))
    yield from (e for e in here if e[-1] in (Text(" ↺"), Text(" ↻")))


def _is_there(piece: Inline, center: Vec) -> bool:
    return isinstance(piece, Text) and piece.way is not None and piece.way.place == center
