"""A speed as a function of the time or of the place, where several states need it: integrated once, then each state is
put in.

∫[0 → v] dv/(g (1 - v²/v_t²)) = ∫[0 → t] dt,   v = v_t tanh(g t/v_t)
v_5 = v_t tanh(g t_5/v_t);   later   v_95 = v_t tanh(g t_95/v_t),   t_95 = v_t artanh(0.95)/g
"""

from __future__ import annotations

from collections.abc import Collection, Iterable
from dataclasses import replace
from typing import Any

import sympy as sp

from planar_cli.equation.algebra.plain import longer, simplified
from planar_cli.report.document.blocks import Block, Equation, Math
from planar_cli.report.given.as_stated import Telling
from planar_cli.report.laws.antiderivatives import integral_blocks
from planar_cli.report.laws.evaluated_integrals import evaluated
from planar_cli.report.laws.laws import said_by
from planar_cli.report.notation.clean import is_clean
from planar_cli.solve.between.trace.trace import Relation, RouteTrace

FAMILIES = (("v(t)", "t(v)"), ("v(q)", "q(v)"))
"""Kinds of relations that say the same of a state: the first of each gives the speed."""
SOLVED = "solved for v"
"""In the words of an integral that the speed does not stand alone in."""
LONGEST = 24
"""A longer function is told of each state by itself."""


def integrals_told(
    e: Relation,
    sides: tuple[sp.Expr, ...],
    route: RouteTrace,
    telling: Telling,
    letters: tuple[set[tuple[sp.Symbol, str]], Collection[sp.Symbol]],
) -> list[Block]:
    """The integrals of a relation, with what they come to. `letters`: the coordinates that were told as functions of
    the time, with the states from which; and what runs, or is not known yet.
    """
    found = evaluated(e, sides, route, telling, letters[0])
    own = list(integral_blocks(sides, letters[1], e, telling.phrases)) if found is None else found
    law = _speed_law(e, own, route, telling)
    return own if law is None else law


def _speed_law(e: Relation, integrals: Iterable[Block], route: RouteTrace, telling: Telling) -> list[Block] | None:
    """What stands in place of the integral of `e`: that up to any time or place with the function, where it comes
    first; later the function with the state put in, or nothing where the line that follows is just that; None: no two
    states need it, or its letters do not tell it. `integrals`: what stands there else.
    """
    family = next((f for f in FAMILIES if e.kind in f), None)
    if family is None or e.law is None or e.law.speed is None or telling.phrases.symbolic:
        return None
    alike = [r for leg in telling.found.route.steps for r in leg.relations if r.kind in family and _is_alike(r, e)]
    if (
        len({r.stop for r in alike}) < 2
        or alike[0].kind != family[0]
        or alike[0].span is None
        or SOLVED not in alike[0].span.words
    ):
        return None
    first = _function(alike[0], route, telling)
    if first is None:
        return None
    (speed, end), function = first
    general = telling.found.general
    if (e.kind, e.stop) == (alike[0].kind, alike[0].stop):
        put = {s: general[s] for s in (speed, end)}
        told = (_put_in(b, put) for b in integrals)
        return [*told, _equation(general[speed], function.xreplace(put), e, telling)]
    own = {g: s for s, g in general.items() if s.name.endswith(f"__{e.stop}")}
    if e.kind == family[0] or not {general[speed], general[end]} <= own.keys():
        return []
    return [_equation(own[general[speed]], function.xreplace({end: own[general[end]]}), e, telling)]


def _is_alike(one: Relation, e: Relation) -> bool:
    """Is it an integral of the same law from the same state, with limits that are told?"""
    law, own = one.law, e.law
    same = law is not None and own is not None and said_by(law) == said_by(own)
    return same and one.since == e.since and one.span is not None and None not in (one.span.left, one.span.right)


def _function(e: Relation, route: RouteTrace, telling: Telling) -> tuple[tuple[sp.Symbol, sp.Symbol], sp.Expr] | None:
    """The letters of the speed and of the time or place at its end, and the speed by the other, or its square by the
    place; None: other letters of states are in it, or it is long, or hides units.
    """
    general, law = telling.found.general, e.law
    assert law is not None
    ends = {s: g for s, g in general.items() if s.name.endswith(f"__{e.stop}")}
    speed = next((s for s, g in ends.items() if g in (law.speed, law.v)), None)
    if speed is None or law.factor != 1:
        return None
    power = _power(e)
    residual = e.residual.xreplace({s: f for s, f in route.plain.items() if s not in ends})
    slope = sp.diff(residual, speed**power) if power == 1 else residual.coeff(speed, power)
    function = simplified(speed**power - residual / slope) if slope in (1, -1) else speed
    letters = function.free_symbols & general.keys()
    if len(letters) != 1 or speed in letters or longer(function, LONGEST):
        return None
    (end,) = letters
    clean = is_clean(telling.phrases.ledger, speed**power, function)
    return ((speed, end), function) if end in ends and clean else None


def _power(e: Relation) -> int:
    """Of the speed in its function."""
    return 2 if e.kind[-2] == "q" or e.kind[0] == "q" else 1


def _equation(speed: sp.Symbol, function: sp.Expr, e: Relation, telling: Telling) -> Equation:
    return Equation((telling.phrases.math(speed ** _power(e)), telling.phrases.math(function)))


def _put_in(block: Any, put: dict[sp.Symbol, sp.Symbol]) -> Any:
    """A block with other letters in its formulas."""
    match block:
        case Equation():
            return replace(block, sides=tuple(_put_in(side, put) for side in block.sides))
        case Math():
            return replace(block, expr=block.expr.xreplace(put))
        case tuple():
            return tuple(_put_in(piece, put) for piece in block)
    return block
