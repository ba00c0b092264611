"""What is asked of a motion as a function: where it holds, and the check that its derivative is the law again.

θ̇ dθ̇ = θ̈ dθ from θ = 0, θ̇ = 0 to any θ:   …   the positive root: θ grows
d(1/2 θ̇²)/dθ = g cos θ / r, which is θ̈
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from typing import Any

import sympy as sp

from planar_cli.equation.algebra.plain import identically_zero, longer, simplified
from planar_cli.report.document.blocks import Block, Equation, Line, Math, Name, Paragraph, line
from planar_cli.report.words.origins import calculus, head
from planar_cli.report.words.spoken import spoken
from planar_cli.report.words.words import Phrases
from planar_cli.solve.between.trace.trace import MotionTrace, Relation, Result, RouteTrace

SHORT = 12
"""A law of more operations is not written out once more."""


def passing_blocks(
    found: MotionTrace, phrases: Phrases, way: Callable[[RouteTrace], Iterator[Block]]
) -> Iterator[Block]:
    """All that is asked as a function. `way`: tells a route."""
    routes = {n: r for n, r in found.passing.items() if any(not leg.is_datum for leg in r.steps)}
    for i, (name, route) in enumerate(routes.items()):
        fresh = route not in list(routes.values())[:i]
        yield from _heading(name, found, route, fresh)
        if fresh:
            even = _is_even(found, name, route)
            told = [b for b in way(route) if not (even and _is_root(b, route))]
            told += [] if even else _root_words(route)
            yield from _in_general(found, route, phrases, told)
        yield from _lines(name, found, phrases)


def _heading(name: str, found: MotionTrace, route: RouteTrace, fresh: bool) -> Iterator[Paragraph]:
    """Where a function holds: what a square tells only as long as the motion keeps its sense. `fresh`: the way to it
    follows, and with it where a square begins.
    """
    e = _squared(route)
    if e is None or e.law is None:
        yield Paragraph(line(Name(name), " throughout the motion:"))
        return
    if fresh:
        return
    states = list(found.states)
    after = states[states.index(e.since) + 1 :] if e.since in states else []
    where = f" from {e.since} to {after[0]}" if e.since and after else " as long as the sense of the motion is kept"
    yield Paragraph(line(Name(name), f"{where}, as a function of ", Math(e.law.coordinate.symbol), ":"))


def _in_general(found: MotionTrace, route: RouteTrace, phrases: Phrases, told: Iterable[Block]) -> Iterator[Block]:
    """The blocks of the way to a function. That of a square has one heading: the law, from where to any place."""
    e = _squared(route)
    heads = () if e is None else (head(e, found.ledger.symbols),)
    for block in told:
        if e is not None and isinstance(block, Paragraph) and block.line in heads:
            yield Paragraph(line(*_law(e, found), *_start(e, found, route, phrases)))
        else:
            yield block


def _law(e: Relation, found: MotionTrace) -> Line:
    """`θ̇ dθ̇ = θ̈ dθ`, with its letters apart from its words."""
    assert e.law is not None
    assert e.span is not None
    q = e.law.coordinate.symbol
    rate, second = (Name(f"{q.name}_{dots}") for dots in ("dot", "ddot"))
    if e.span.words != "v dv = a dq" or e.law.coordinate.words != q.name:
        return spoken(calculus(e), found.ledger.symbols)
    return line(rate, " d", rate, " = ", second, " d", Math(q))


def _start(e: Relation, found: MotionTrace, route: RouteTrace, phrases: Phrases) -> Line:
    """` from θ = θ_0, θ̇ = 0 to any θ:`, with the place and the speed at the state at which it begins."""
    assert e.law is not None
    q = e.law.coordinate.symbol
    speed = e.law.speed if e.law.speed is not None and e.law.factor == 1 else sp.Symbol(f"{q.name}_dot", real=True)
    parts: list[Any] = []
    for general in (q, speed):
        own = next((s for s, g in found.general.items() if g == general and found.ledger.roles[s].at == e.since), None)
        if own is None:
            continue
        told = route.formulas.get(own, found.route.formulas.get(own, own))
        value = phrases.math(told) if phrases.symbolic or told == 0 else phrases.shown(own)
        parts += [", " if parts else " from ", Math(general), " = ", value]
    return line(*parts, " to any ", Math(q), ":")


def _root_words(route: RouteTrace) -> Iterator[Block]:
    """Why one sign of the root is taken."""
    e = _squared(route)
    results = [r for leg in route.steps if e in leg.relations for r in leg.results]
    if e is None or e.law is None or len(results) != 1 or not results[0].value:
        return
    grows = results[0].value > 0
    q = Math(e.law.coordinate.symbol)
    kind, way = ("positive", " grows") if grows else ("negative", " decreases")
    yield Paragraph(line(f"the {kind} root: ", q, way))


def _is_even(found: MotionTrace, name: str, route: RouteTrace) -> bool:
    """Is all that rests on a square asked of the square alone, in which the sign of the root drops out?"""
    names = {n for n, r in found.passing.items() if r == route} | {name}
    parts = [p for r in found.requests if r.find.name in names for p in r.parts]
    roots = {r.unknown: r.formula for r in _roots(route) if r.formula is not None}
    turned = {s: -s for s in roots}
    held = {a for f in roots.values() for a in f.atoms(sp.Pow) if a.exp == sp.S.Half}
    return bool(roots) and all(p.xreplace(turned) == p and not p.atoms(sp.Pow) & held for p in parts)


def _roots(route: RouteTrace) -> list[Result]:
    """The speeds that the relation v² = … of a route gives."""
    e = _squared(route)
    return [r for leg in route.steps if e in leg.relations for r in leg.results]


def _is_root(block: Block, route: RouteTrace) -> bool:
    """Is it the line of such a speed?"""
    speeds = {r.unknown for r in _roots(route)}
    match block:
        case Equation(sides=(Math(expr=own), *_), number=None):
            return own in speeds
    return False


def _lines(name: str, found: MotionTrace, phrases: Phrases) -> Iterator[Block]:
    """What is asked, in the letters that were just told."""
    for asked in found.requests:
        if asked.find.name != name:
            continue
        names = [name] if len(asked.parts) == 1 else [f"{name}_{axis}" for axis in "xy"]
        for own, part in zip(names, asked.parts, strict=True):
            if not part.is_Symbol:
                yield Equation((line(Name(own)), phrases.math(part)))


def passing_check(found: MotionTrace, phrases: Phrases) -> Line:
    """The derivative of v²/2 by the coordinate is its law; empty where no such function is asked."""
    for route in found.passing.values():
        e = _squared(route)
        if e is None or e.law is None or e.law.order != 2 or longer(e.law.f, SHORT):
            continue
        q, law = e.law.coordinate.symbol, e.law.f
        results = [r for leg in route.steps if e in leg.relations for r in leg.results if r.formula is not None]
        if len(results) != 1 or results[0].formula is None or law.has(e.law.v):
            continue
        half = simplified(results[0].formula ** 2 / 2)
        if not identically_zero(sp.diff(half, q) - law):
            continue
        rate = Name(f"{q.name}_dot")
        derived = line("d(1/2 ", rate, "²)/d", Math(q), " = d(", phrases.math(half), ")/d", Math(q))
        return line(*derived, " = ", phrases.math(law), " = ", Name(f"{q.name}_ddot"))
    return ()


def _squared(route: RouteTrace) -> Relation | None:
    """The relation v² = …, of a route."""
    return next((e for leg in route.steps for e in leg.relations if e.kind == "v(q)"), None)
