"""How fast a body turns whose mass centre has a speed that the file states: ω_2 = v_G,2/r = 1/0.01 = 100 rad/s."""

from __future__ import annotations

from decimal import Decimal

import sympy as sp

from planar_cli.equation.algebra.plain import simplified
from planar_cli.principles.base import Moving
from planar_cli.problem.scene.polar import VectorStatement
from planar_cli.report.document.blocks import Equation, line
from planar_cli.report.given.as_stated import Stated, in_base
from planar_cli.report.words.sides import number_of
from planar_cli.report.words.state_words import at
from planar_cli.report.words.words import Phrases
from planar_cli.solve.between.trace.trace import BalanceTrace, MotionTrace, Result
from planar_cli.solve.between.trace.trace import Relation as MotionRelation

NEAR = Decimal("1e-20")


def turning_by_speed(
    e: MotionRelation, r: Result, stated: Stated | None, found: MotionTrace, phrases: Phrases
) -> Equation | None:
    """The line, with the reason that a balance has for the speed of the mass centre; None where the file states another
    thing. v = arm · |ω|, the arm a formula of letters that have numbers.
    """
    if not isinstance(stated, VectorStatement) or stated.vector.word != "v" or stated.size is None:
        return None
    size, things = in_base(number_of(stated.size), phrases.ledger.us), stated.vector.things
    made = next((m for m in _ending(found, e.stop) if m.omega == r.unknown and things == (m.center,)), None)
    if made is None or not size:
        return None
    square = (made.vx**2 + made.vy**2).xreplace({r.unknown: sp.S.One}).xreplace(dict(found.route.plain))
    arm = simplified(sp.sqrt(square))
    if not arm.free_symbols or r.unknown in arm.free_symbols or not phrases.has_numbers(arm):
        return None
    if abs(phrases.value(arm) * abs(r.value) - size) > NEAR * size:
        return None
    letter = sp.Symbol(f"v_{made.center}__{e.stop}", positive=True)
    formula = letter / arm if r.value > 0 else -letter / arm
    put = phrases.numbers(formula, {letter: size})
    sides = (phrases.math(r.unknown), phrases.math(formula), *([] if put is None else [put]))
    return Equation((*sides, phrases.shown(r.unknown, r.value)), None, line(at(e.stop)), line(made.why))


def _ending(found: MotionTrace, state: str) -> list[Moving]:
    """What moves at the end of the balances that end in a state."""
    sources = (x.source for leg in found.route.steps for x in leg.relations)
    balances = [b for b in sources if isinstance(b, BalanceTrace) and b.stop == state and b.parts is not None]
    return [m for b in balances if b.parts is not None for m in b.parts.moving]
