"""Two bodies that move alike, by symmetry, have one speed on the page: T_2 = m v_A² + 1/2 I ω² with v_B = -v_A."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import fields, is_dataclass, replace
from typing import Any

import sympy as sp

from planar_cli.solve.between.trace.trace import MotionTrace, Relation, Result, RouteStep
from planar_cli.solve.solved_problem import PartSolution

ALIKE = "by symmetry"
Put = dict[sp.Symbol, sp.Expr]


def with_alike_put_in(part: PartSolution) -> PartSolution:
    """The part with the letters of one of such bodies in place of those of the other; as it is where there are none."""
    motion = part.motion
    if motion is None or not any(_link(e) for step in motion.route.steps for e in step.relations):
        return part
    asked = {s for r in motion.requests if len(r.parts) == 1 for s in r.parts if s.is_Symbol}
    put: Put = {}
    steps: list[RouteStep] = []
    for step in motion.route.steps:
        links = [e for e in step.relations if (pair := _link(e)) is not None and _is_speed(pair[0], asked, motion)]
        put |= dict(pair for e in links if (pair := _link(e)) is not None)
        steps += _step(step, links, put)
    route = replace(motion.route, steps=tuple(steps))
    requests = tuple(replace(r, parts=tuple(_mapped(e, put) for e in r.parts)) for r in motion.requests)
    return replace(part, motion=replace(motion, route=route, requests=requests))


def _is_speed(letter: sp.Symbol, asked: set[sp.Symbol], motion: MotionTrace) -> bool:
    """Is it a speed that is not asked for itself?"""
    return letter not in asked and letter in motion.general and motion.general[letter] in motion.free


def _link(relation: Relation) -> tuple[sp.Symbol, sp.Expr] | None:
    """Which letter is which other one, but for its sign."""
    if relation.kind != "link" or not relation.words.endswith(ALIKE):
        return None
    terms = sp.Add.make_args(relation.residual)
    own = next((t for t in terms if t.is_Symbol), None)
    if own is None or len(terms) != 2:
        return None
    # The one that is named last is told by the other.
    pair = sorted((t.as_coeff_Mul()[1] for t in terms), key=lambda s: str(s.name))
    sign = -1 if all(not t.could_extract_minus_sign() for t in terms) else 1
    return pair[1], sign * pair[0]


def _step(step: RouteStep, links: list[Relation], put: Put) -> list[RouteStep]:
    """A step in such letters; nothing of one that only says that they are alike."""
    rest = tuple(e for e in step.relations if e not in links)
    if not links:
        return [_mapped(step, put)]
    if not rest:
        return []
    unknowns = tuple(u for u in step.unknowns if u not in put)
    results = tuple(r for u in unknowns if (r := _result(u, step, put)) is not None)
    return [replace(_mapped(replace(step, relations=rest, results=()), put), unknowns=unknowns, results=results)]


def _result(unknown: sp.Symbol, step: RouteStep, put: Put) -> Result | None:
    own = next((r for r in step.results if r.unknown == unknown), None)
    if own is None or own.formula is None or not own.formula.free_symbols & put.keys():
        return own
    other = next((r for r in step.results if put.get(r.unknown) in (unknown, -unknown)), None)
    if other is None:
        return own
    sign = 1 if put[other.unknown] == unknown else -1
    formula = None if other.formula is None else sign * other.formula
    roots = tuple(
        replace(r, expression=None if r.expression is None else sign * r.expression, value=sign * r.value)
        for r in other.roots
    )
    return replace(own, formula=formula, roots=roots)


def _mapped(thing: Any, put: Mapping[sp.Symbol, sp.Expr]) -> Any:
    """With the letters put in, wherever formulas stand in it."""
    if isinstance(thing, sp.Basic):
        return thing.xreplace(dict(put)) if isinstance(thing, sp.Expr) else thing
    if isinstance(thing, tuple):
        return tuple(_mapped(t, put) for t in thing)
    if is_dataclass(thing) and not isinstance(thing, type):
        new = {f.name: _mapped(getattr(thing, f.name), put) for f in fields(thing) if f.init}
        changed = {n: v for n, v in new.items() if v is not getattr(thing, n)}
        return replace(thing, **changed) if changed else thing
    return thing
