"""A law that is linear in its speed, told as the derivative of a product and integrated at once.

d[(M + q t) v]/dt = (M + q t) dv/dt + v q = F
(M + q t) v = F t
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import sympy as sp

from planar_cli.equation.algebra.plain import derivative, identically_zero, longer, simplified
from planar_cli.report.document.blocks import Block, Equation, Line, Math, Paragraph, line
from planar_cli.report.notation.clean import is_clean
from planar_cli.report.words.words import Phrases
from planar_cli.solve.between.trace.trace import MotionTrace, Relation, RouteTrace

MOST = 24
"""A longer product is not written out."""


def product_blocks(e: Relation, route: RouteTrace, found: MotionTrace, phrases: Phrases) -> Iterator[Block]:
    """The law of which a relation is the integral, and the integral up to any time; nothing of another relation."""
    if e.span is None or e.span.product is None or e.span.explicit is None or e.law is None:
        return
    roles, general = found.ledger.roles, dict(found.general)
    ends = {s: general[s] for s in found.general if roles[s].at == e.stop}
    start = {s: route.plain.get(s, s) for s in found.general if roles[s].at == e.since}
    factor, rate, whole = (
        simplified(x.xreplace(ends).xreplace(start)) for x in (*e.span.product, e.span.product[0] * e.span.explicit)
    )
    t = next((general[s] for s in general if general[s].name == "t"), None)
    v = next((g for g in ends.values() if g == e.law.speed), e.law.speed)
    if t is None or v is None or e.law.factor != 1 or any(longer(x, MOST) for x in (factor, rate, whole)):
        return
    if not phrases.symbolic and not is_clean(found.ledger, factor * v, whole):
        return
    bracket = line("(", Math(factor), ")") if factor.is_Add else line(phrases.math(factor))
    product = line(*bracket, " ", Math(v))
    change = derivative(factor, t)
    apart = line(*bracket, " d", Math(v), "/d", Math(t), *_added(change * v, phrases))
    left = line("d[", *product, "]/d", Math(t))
    yield Equation((left, apart, phrases.math(rate)))
    if rate == 0 and (body := _of_mass(factor, found)):
        yield Paragraph(line(f"so that the momentum of {body} is conserved:"))
    yield Equation((product, phrases.math(whole)))


def _added(term: sp.Expr, phrases: Phrases) -> Line:
    sign, size = (" - ", -term) if term.could_extract_minus_sign() else (" + ", term)
    return line(sign, phrases.math(size))


def _of_mass(factor: sp.Expr, found: MotionTrace) -> str:
    """The body whose mass a factor is, so that its product with the velocity is a momentum; "" for none."""
    scenes: list[Any] = [r.solution.instant.scene for r in found.regimes]
    masses = [(name, body.mass) for scene in scenes for name, body in scene.bodies.items()]
    return next((name for name, m in masses if identically_zero(sp.sympify(m) - factor)), "")
