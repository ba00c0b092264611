"""The unknown of a balance of energies is what is asked: a fall x = y_1 - y_2 or a swing φ = θ_2 - θ_1, where nothing
else rests on the letter of the state that it is made of.

q -> x by x = a + k f(q), f(q) being q, sin q or cos q;  m g (y_1 - y_2) -> m g x,  cos θ_2 -> cos (θ_1 + φ)
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from dataclasses import replace

import sympy as sp

from planar_cli.equation.algebra.counting import operations
from planar_cli.equation.algebra.plain import longer, simplified
from planar_cli.equation.values.exact import Valuation
from planar_cli.equation.values.ledger import Kind, Role
from planar_cli.errors import Undecided
from planar_cli.principles.base import EnergyParts
from planar_cli.records import record
from planar_cli.solve.between.roots.closed import closed_roots
from planar_cli.solve.between.trace.trace import BalanceTrace, MotionTrace, Relation, Request, Result, RouteStep

LONGEST = 120
"""An equation of more operations is left as it is."""
NEAR = sp.Rational(1, 10**11)

Put = Callable[[sp.Expr], sp.Expr]


@record
class _Change:
    """What is asked in the place of the letter of a state."""

    request: Request
    step: RouteStep
    letter: sp.Symbol
    asked: sp.Symbol
    put: Put
    """An expression in what is asked."""


def by_what_is_asked(motion: MotionTrace) -> MotionTrace:
    """A motion whose balances of energies are solved for what is asked, where that makes them shorter."""
    for request in motion.requests:
        for change in _changes(motion, request):
            changed = _changed(motion, change)
            if changed is not None:
                motion = changed
                break
    return motion


def _changes(motion: MotionTrace, request: Request) -> Iterator[_Change]:
    """What is asked instead of each letter on which it rests and that a balance gives."""
    name = request.find.name
    if len(request.parts) != 1 or request.unit is None or request.beside or name in motion.ledger.symbols:
        return
    (expr,) = request.parts
    if not expr.is_Add:
        return
    numbers = _numbers(motion.route.formulas)
    for step in motion.route.steps:
        letter = step.unknowns[0]
        if letter not in expr.free_symbols or not _balances(step) or is_used(motion, request, step, letter):
            continue
        asked = sp.Symbol(name, real=True)
        inverse = _inverse(expr.xreplace(numbers), letter, asked)
        if inverse is not None:
            yield _Change(request, step, letter, asked, _putting(inverse, numbers))


def _numbers(formulas: Mapping[sp.Symbol, sp.Expr]) -> dict[sp.Symbol, sp.Expr]:
    """Letters of states whose numbers are told, itself or by another one."""
    found: dict[sp.Symbol, sp.Expr] = {}
    for s, f in formulas.items():
        number = found.get(f, f)
        if number.is_number and number.is_finite:
            found[s] = number
    return found


def _balances(step: RouteStep) -> bool:
    """Is it one balance of energies that gives one letter?"""
    source = step.relations[0].source
    return (
        len(step.relations) == len(step.unknowns) == 1 and isinstance(source, BalanceTrace) and bool(source.law.letter)
    )


def is_used(motion: MotionTrace, request: Request, own: RouteStep, letter: sp.Symbol) -> bool:
    """Does anything else that is told rest on this letter?"""
    others = [e for r in motion.requests if r is not request for e in (*r.parts, *(f for _, f in r.beside))]
    others += [s.formula for s in motion.spans if s.formula is not None]
    others += [limit for s in motion.spans for piece in s.pieces for limit in piece.limits]
    steps = [s for r in (motion.route, *motion.passing.values()) for s in r.steps if s is not own]
    others += [e.residual for s in steps for e in s.relations]
    asked = {state for regime in motion.regimes for state in regime.asked}
    role = motion.ledger.roles.get(letter)
    return role is None or role.at in asked or any(letter in e.free_symbols for e in others)


def _inverse(expr: sp.Expr, letter: sp.Symbol, asked: sp.Symbol) -> tuple[sp.Expr, sp.Expr] | None:
    """What stands in the place of f(letter), as x = a + k f: f and (x - a)/k; None: it is no such formula."""
    inside = sp.Dummy(real=True)
    for function in (letter, sp.sin(letter), sp.cos(letter)):
        plain = expr.xreplace({function: inside})
        slope = sp.diff(plain, inside)
        if letter not in plain.free_symbols and inside not in slope.free_symbols and slope != 0:
            return function, sp.expand((asked - plain.xreplace({inside: sp.S.Zero})) / slope)
    return None


def _putting(inverse: tuple[sp.Expr, sp.Expr], numbers: Mapping[sp.Symbol, sp.Expr]) -> Put:
    """Puts what is asked into an expression, with the numbers of the places between which it is."""
    function, formula = inverse
    (letter,) = function.free_symbols

    def put(expr: sp.Expr) -> sp.Expr:
        if letter not in expr.free_symbols:
            return expr
        found = expr.xreplace({function: formula}).xreplace(dict(numbers))
        return found if longer(found, LONGEST) else simplified(found)

    return put


def _changed(motion: MotionTrace, change: _Change) -> MotionTrace | None:
    """The motion told so; None: its balance is no shorter then, or what is asked has no formula."""
    (relation,) = change.step.relations
    before = relation.residual.xreplace({**motion.route.plain, **_numbers(motion.route.formulas)})
    residual = change.put(before)
    if change.letter in residual.free_symbols or longer(residual, LONGEST):
        return None
    if operations(residual) > operations(simplified(before)):
        return None
    number = motion.value(change.request.parts[0])
    value = motion.value.extended({change.asked: number})
    result = solved_for_asked(residual, change.asked, value, motion.symbolic)
    if result is None:
        return None
    ledger, unit = motion.ledger, change.request.unit
    assert unit is not None
    ledger.adopt(change.asked, unit, Role(Kind.SOUGHT))
    relations = (relation_in(relation, change.put),)
    needs = change.step.needs & residual.free_symbols
    step = RouteStep(relations, (change.asked,), needs, (result,), False)
    steps = tuple(step if s is change.step else s for s in motion.route.steps)
    settled = motion.route.settled | ({change.asked} if change.letter in motion.route.settled else frozenset())
    formulas = {**motion.route.formulas, change.asked: result.formula}
    request = replace(change.request, parts=(change.asked,))
    return replace(
        motion,
        value=value,
        unknowns=motion.unknowns | {change.asked},
        route=replace(motion.route, steps=steps, settled=settled, formulas=formulas),
        requests=tuple(request if r is change.request else r for r in motion.requests),
        named={**motion.named, change.asked: change.request.parts[0]},
    )


def solved_for_asked(residual: sp.Expr, asked: sp.Symbol, value: Valuation, symbolic: bool) -> Result | None:
    """What is asked from its equation, with all roots."""
    truth = value(asked)
    try:
        roots = closed_roots(residual, asked, value, truth, symbolic)
    except Undecided:
        return None
    taken = next((r for r in roots if abs(r.value - truth) <= abs(truth) * value(NEAR)), None)
    formula = None if taken is None else taken.expression
    return None if formula is None else Result(asked, formula, truth, tuple(roots))


def relation_in(e: Relation, put: Put) -> Relation:
    """A balance with all its parts, what `put` makes of them."""
    b = e.source
    assert isinstance(b, BalanceTrace)
    source = replace(
        b,
        before=put(b.before),
        after=put(b.after),
        brought=tuple((words, put(x)) for words, x in b.brought),
        amounts=tuple((body, put(x)) for body, x in b.amounts),
        parts=None if b.parts is None else _parts(b.parts, put),
    )
    return replace(e, residual=put(e.residual), source=source)


def _parts(parts: EnergyParts, put: Put) -> EnergyParts:
    moving = tuple(
        replace(m, vx=put(m.vx), vy=put(m.vy), omega=put(m.omega), place=tuple(map(put, m.place))) for m in parts.moving
    )
    storages = tuple(replace(s, first=put(s.first), last=put(s.last)) for s in parts.storages)
    return replace(parts, moving=moving, storages=storages)
