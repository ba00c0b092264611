"""What one condition of a state says at once, in one line: it is at its highest, where it has no velocity; a rod lies
level or stands upright there.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from decimal import Decimal
from typing import Any

import sympy as sp

from planar_cli.equation.values.ledger import Kind
from planar_cli.problem.scene.scene import Rod
from planar_cli.report.document.blocks import Block, Equation, Math, Name, Paragraph, line
from planar_cli.report.words.spoken import spoken
from planar_cli.report.words.state_words import at
from planar_cli.report.words.turning_values import over_time, why_there
from planar_cli.report.words.words import Phrases
from planar_cli.solve.between.trace.trace import (
    FUNCTION,
    GIVEN_RATE,
    BalanceTrace,
    ImpactEquation,
    MotionTrace,
    Relation,
    Result,
    RouteStep,
)

ANGLE = "angle of "
SAME = Decimal("1e-20")


def told_at_once(
    leg: RouteStep,
    later: Sequence[RouteStep],
    found: MotionTrace,
    phrases: Phrases,
    law: Callable[[Relation], Iterator[Block]],
) -> Iterator[Block]:
    """`At 2, AB is horizontal: θ_2 = 0.` Empty: it is several conditions, or none of these. `law`: the blocks of the
    law of which a relation is an integral; `later`: the steps from which such a law is taken.
    """
    e, r = leg.relations[0], leg.results[0]
    if len(leg.relations) > 1 or len(leg.results) > 1 or not e.stop or r.formula is None:
        return
    if e.kind in (FUNCTION, GIVEN_RATE):
        formula = sp.sympify(r.formula)
        value = [phrases.shown(r.unknown, r.value)] if phrases.has_numbers(formula) else []
        put = phrases.substituted(formula, value[0]) if value else []
        yield Equation((Math(r.unknown), phrases.math(formula), *put, *value), None, line(at(e.stop)))
        return
    if e.kind == "given" and r.formula in found.general and r.unknown not in found.general:
        # v_0 is the speed in state 1 that the equations have given.
        yield Equation((Math(r.unknown), Math(r.formula), phrases.shown(r.unknown, r.value)), None, line(at(e.stop)))
        return
    shown: Any = Math(sp.S.Zero) if r.formula == 0 else phrases.shown(r.unknown, r.value)
    if over_time(e) and r.formula == 0 and r.unknown not in (e.residual / r.unknown).free_symbols:
        # Of a place everybody knows that its speed is zero there.
        speed = found.ledger.roles[found.general.get(r.unknown, r.unknown)].kind is Kind.SPEED
        words = e.words if speed else f"{e.words}, {why_there(e)}"
    elif over_time(e) and (resting := _place_of_rest(r, later, found)) is not None:
        # A vibration is fastest where it would rest, which its law has told by then.
        words, shown = f"{e.words}, {why_there(e)}", Math(resting[1])
        yield from law(resting[0])
    elif (rod := _rod(e, r, found)) is not None:
        words = rod
    else:
        return
    # As a name it is one of the letters of the page, which may be shorter there.
    yield Paragraph(line(*spoken(at(e.stop, words), found.ledger.symbols), " ", Name(r.unknown.name), " = ", shown))


def is_by_functions(found: MotionTrace) -> bool:
    """Does anything at a state follow from a function of the place, which then comes first?"""
    return any(e.kind == FUNCTION for step in found.route.steps for e in step.relations)


def _place_of_rest(r: Result, later: Sequence[RouteStep], found: MotionTrace) -> tuple[Relation, sp.Symbol] | None:
    """The relation of a vibration, and the letter of its place of rest, where a place of a state is that."""
    for e in (e for leg in later for e in leg.relations if e.law is not None and e.law.vibration is not None):
        vibration = e.law.vibration if e.law is not None else None
        for letter in vibration.rest if vibration is not None else ():
            own = e.law is not None and found.general.get(r.unknown) == e.law.coordinate.symbol
            known = found.value.known(letter)
            if own and known is not None and abs(known - r.value) <= SAME * abs(known):
                return e, letter
    return None


def _rod(e: Relation, r: Result, found: MotionTrace) -> str | None:
    """`AB is horizontal`, where a condition of places gives a multiple of a right angle as the angle of a rod."""
    general = found.general.get(r.unknown)
    if (
        general is None
        or r.formula is None
        or e.span is not None
        or isinstance(e.source, BalanceTrace | ImpactEquation)
    ):
        return None
    quarters = 2 * r.formula / sp.pi
    others = {s for s in e.residual.xreplace(dict(found.route.plain)).free_symbols if s in found.general} - {r.unknown}
    if others or not quarters.is_Integer:
        return None
    for regime in found.regimes:
        scene = regime.solution.instant.scene
        for c in scene.displacement.coordinates if scene.displacement is not None else ():
            shape = next((b.shape for b in scene.problem.bodies if c.words == f"{ANGLE}{b.name}"), None)
            if c.symbol == general and isinstance(shape, Rod):
                return f"{c.body} is {'vertical' if quarters % 2 else 'horizontal'}"
    return None
