"""What is asked of a motion as a function: where it holds, and the check that its derivative is the law again.

ω from let_go to lowest, as a function of θ:   …   the positive root, as θ grows there
d(1/2 θ̇²)/dθ = g cos θ / r, which is θ̈
"""

from __future__ import annotations

from collections.abc import Iterator

import sympy as sp

from planar_cli.equation.plain import identically_zero, longer, simplified
from planar_cli.report.blocks import Block, Equation, Line, Math, Name, Paragraph, line
from planar_cli.report.words import Phrases
from planar_cli.solve.between.trace import MotionTrace, Relation, RouteTrace

SHORT = 12
"""A law of more operations is not written out once more."""


def heading(name: str, found: MotionTrace, route: RouteTrace) -> Paragraph:
    """Where a function holds: what a square tells only as long as the motion keeps its sense."""
    e = _squared(route)
    if e is None or e.law is None:
        return Paragraph(line(Name(name), " throughout the motion:"))
    states = list(found.states)
    after = states[states.index(e.since) + 1 :] if e.since in states else []
    where = f" from {e.since} to {after[0]}" if e.since and after else " as long as the sense of the motion is kept"
    return Paragraph(line(Name(name), f"{where}, as a function of ", Math(e.law.coordinate.symbol), ":"))


def root_words(route: RouteTrace) -> Iterator[Block]:
    """Why one sign of the root is taken."""
    e = _squared(route)
    results = [r for leg in route.steps if e in leg.relations for r in leg.results]
    if e is None or e.law is None or len(results) != 1 or not results[0].value:
        return
    grows = results[0].value > 0
    q = Math(e.law.coordinate.symbol)
    kind, way = ("positive", " grows there") if grows else ("negative", " decreases there")
    yield Paragraph(line(f"the {kind} root, as ", q, way))


def passing_lines(name: str, found: MotionTrace, phrases: Phrases) -> Iterator[Block]:
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
