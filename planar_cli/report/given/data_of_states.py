"""Data of the states of a motion: what the file gives, as it gives it, and what follows from that at once."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from decimal import Decimal
from typing import Any

from planar_cli.problem.language.expression import Relation
from planar_cli.problem.scene.scene import Particle
from planar_cli.report.document.blocks import Block, Equation, Name, line
from planar_cli.report.given.as_stated import Stated, between, gives, stated_in
from planar_cli.report.given.conditions_of_states import condition_blocks, followed_from, given_by_another
from planar_cli.report.given.turning_by_speed import turning_by_speed
from planar_cli.report.notation.names import plain_name
from planar_cli.report.words.origins import known_from
from planar_cli.report.words.sides import said
from planar_cli.report.words.state_words import at
from planar_cli.report.words.words import Phrases
from planar_cli.solve.between.trace.trace import MotionTrace, Result, RouteStep

COMPONENTS = ("x", "y", ",x", ",y")
"""What a component has behind the letter of what moves along one axis alone."""
SAME = Decimal("1e-20")


def datum_blocks(
    leg: RouteStep,
    found: MotionTrace,
    phrases: tuple[Phrases, Phrases],
    chain_of: Callable[[Result], tuple[Any, ...]],
    others: Callable[[Result], Iterator[Block]],
    headed: bool,
) -> Iterator[Block]:
    """The data of one step of the route. `phrases`: of the motion, and of what has numbers; `chain_of`: letter =
    formula = numbers = value; `others`: the roots that were not taken; `headed`: what is given stands at the head of
    the page.
    """
    e = leg.relations[0]
    headed_by = list(condition_blocks(leg, found, phrases[0]))
    yield from headed_by
    for r in leg.results:
        chain = chain_of(r)
        said_there = stated_in(found.problem, e.stop, e.words) if e.kind == "given" else None
        stated = said_there if _is_number(r, phrases[0]) else None
        middle = between(stated, r.unknown, r.value, phrases[1]) if len(chain) == 2 else ()
        if turns := turning_by_speed(e, r, said_there, found, phrases[1]):
            yield turns
            continue
        sides = (chain[0], *([middle] if middle else []), *chain[1:])
        if headed and (_is_datum_of_file(r, found) or (len(sides) == 2 and _is_repeated(said_there, r, found))):
            continue
        if stated is None or gives(stated, r.value, phrases[1]):
            another = list(given_by_another(e, r, found, phrases)) if e.kind == "given" and stated is None else []
            if another:
                yield from (*another, Equation(sides))
                continue
            words = known_from(e, r)
            yield Equation(sides, None, () if headed_by and not words else line(at(e.stop, words)))
            continue
        component = bool(middle)
        condition = [] if component else list(followed_from(e, r, stated, found, phrases))
        yield from condition
        # Under the heading of its condition a value needs no second one.
        yield Equation(sides, None, () if condition else line(at(e.stop)))
        yield from () if component else others(r)


def _is_number(r: Result, phrases: Phrases) -> bool:
    """Does it rest on numbers of the file alone?"""
    return r.value.is_finite() and (not phrases.symbolic if r.formula is None else bool(r.formula.is_number))


def _is_datum_of_file(r: Result, found: MotionTrace) -> bool:
    """Is it what the file gives under the name that it has in print: r_A, and r in state A?"""
    name, ledger = plain_name(r.unknown.name.replace("__", "_")), found.ledger
    own = next((s for s in (*ledger.values, *ledger.definitions) if plain_name(s.name) == name), None)
    given = None if own is None or own.name not in {g.name for g in found.problem.given} else found.value.known(own)
    return given is not None and found.value.known(r.unknown) is not None and abs(given - r.value) <= SAME * abs(given)


def _is_repeated(stated: Stated | None, r: Result, found: MotionTrace) -> bool:
    """Would its line only say again what is given, 2: t = 2 s and then t_2 = 2 s; 1: v_Ax = 4 m/s and then v_A,1 for
    what moves along x alone, or v of the only body.
    """
    if not isinstance(stated, Relation):
        return False
    named = said(stated.left, 1)
    match named:
        case (Name(name),):
            letter = plain_name(r.unknown.name.partition("__")[0])
            if plain_name(name) in (letter, *(f"{letter}{c}" for c in COMPONENTS)):
                return True
            (body, *more) = found.problem.bodies
            place = body.shape.place if isinstance(body.shape, Particle) else None
            alone = letter.removesuffix(f"_{place}") if isinstance(place, str) and not more else ""
            return bool(alone) and name in {f"{alone}_{body.name}_{c}" for c in COMPONENTS}
    return False
