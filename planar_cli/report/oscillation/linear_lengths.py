"""Lengths of springs and dampers, and the moments of their pulls, to the first order, before the linear equation that
comes of them.

    AK ≈ h + l θ,  AK′ ≈ l,  DW′ ≈ l/2
    moments:   -k l² θ - 1/4 c l² ω ≈ I_O α
"""

from __future__ import annotations

from collections.abc import Sequence

import sympy as sp

from planar_cli.equation.algebra.plain import simplified
from planar_cli.records import record
from planar_cli.report.document.blocks import Block, Equation, Math, Paragraph, Text, line
from planar_cli.report.oscillation.small_motion import LINEAR

SLOPE = "′"
"""Ends the name of the derivative of a length by the angle."""


@record
class _Length:
    """A length with its derivative, and both to the first order in the angle."""

    letter: sp.Symbol
    slope: sp.Symbol
    near: sp.Expr
    rate: sp.Expr


def with_linear_lengths(blocks: Sequence[Block]) -> list[Block]:
    """The blocks of a motion; as they are where no linear equation rests on such lengths, or something else comes of
    these.
    """
    found = list(blocks)
    at = next((i for i, b in enumerate(found) if isinstance(b, Paragraph) and Text(LINEAR) in b.line), None)
    if at is None:
        return found
    heading, told = found[at], found[at + 1]
    assert isinstance(heading, Paragraph)
    angle = next((p.expr for p in heading.line if isinstance(p, Math)), None)
    before = [b for b in found[:at] if isinstance(b, Equation)]
    lengths = [x for b in before if (x := _length(b, before, angle)) is not None]
    moment = next((b for b in before if b.number is not None and _holds(b, lengths)), None)
    if moment is None or not isinstance(told, Equation):
        return found
    left, right = moment.sides
    pulls = {p: e for b in before for p, e in _pull(b, lengths).items()}
    if not isinstance(left, Math) or not isinstance(right, Math) or not lengths:
        return found
    linear = sp.expand(_near(left.expr.xreplace(pulls), lengths))
    if not _leads_to(linear, told, angle):
        return found
    needed = [x for x in lengths if any(e.has(x.letter) for e in pulls.values())]
    places = [Equation((Math(x.letter), Math(x.near)), relation="≈") for x in needed]
    slopes = [Equation((Math(x.slope), Math(x.rate)), relation="≈") for x in lengths]
    balance = Equation((Math(linear), right), None, line("moments:"), relation="≈")
    return [*found[: at + 1], *places, *slopes, balance, *found[at + 1 :]]


def _length(b: Equation, before: Sequence[Equation], angle: sp.Expr | None) -> _Length | None:
    """The length whose derivative a line tells; None of any other line."""
    head, last = b.sides[0], b.sides[-1]
    if not isinstance(head, Math) or not isinstance(last, Math) or not str(head.expr).endswith(SLOPE) or angle is None:
        return None
    name = str(head.expr).removesuffix(SLOPE)
    roots = ((s.expr, e.sides[1]) for e in before if isinstance(s := e.sides[0], Math) and len(e.sides) == 2)
    letter, root = next(((s, r.expr) for s, r in roots if str(s) == name and isinstance(r, Math)), (None, None))
    if letter is None or root is None:
        return None
    still = simplified(root.subs(angle, 0))
    rate = simplified(last.expr.subs(angle, 0).xreplace({letter: still}))
    if still.has(sp.Pow) or simplified(sp.diff(root, angle).subs(angle, 0) - rate) != 0:
        return None
    return _Length(letter, head.expr, still + rate * angle, rate)


def _holds(b: Equation, lengths: Sequence[_Length]) -> bool:
    first = b.sides[0]
    slopes = {x.slope for x in lengths}
    return len(b.sides) == 2 and isinstance(first, Math) and bool(first.expr.free_symbols & slopes)


def _pull(b: Equation, lengths: Sequence[_Length]) -> dict[sp.Expr, sp.Expr]:
    """A pull by the length or its derivative, by its letter; empty of any other line."""
    letters = {s for x in lengths for s in (x.letter, x.slope)}
    if not b.lead or b.number is not None or len(b.sides) < 2:
        return {}
    head, formula = b.sides[:2]
    if not isinstance(head, Math) or not isinstance(formula, Math) or not formula.expr.free_symbols & letters:
        return {}
    return {head.expr: formula.expr}


def _near(expr: sp.Expr, lengths: Sequence[_Length]) -> sp.Expr:
    put = {s: e for x in lengths for s, e in ((x.letter, x.near), (x.slope, x.rate))}
    return expr.xreplace(put)


def _leads_to(linear: sp.Expr, told: Equation, angle: sp.Expr | None) -> bool:
    """Is a sum of moments that of the linear equation θ̈ + c θ̇ + w² θ = 0, but for one factor?"""
    side = told.sides[0]
    if not isinstance(side, tuple) or not isinstance(angle, sp.Symbol):
        return False
    parts = [p.expr for p in side if isinstance(p, Math)]
    rate = next((s for p in parts for s in p.free_symbols if s.name == f"{angle.name}_dot"), None)
    spin = next((s for s in linear.free_symbols if s.name.startswith("omega")), None)
    if len(parts) != 3 or rate is None or spin is None or linear.has(sp.sin, sp.cos):
        return False
    if not linear.is_polynomial(angle, spin) or sp.Poly(linear, angle, spin).total_degree() > 1:
        return False
    whole = sp.Add(*parts[1:])
    first, second = linear.coeff(angle) / whole.coeff(angle), linear.coeff(spin) / sp.expand(whole).coeff(rate)
    rest = simplified(linear - linear.coeff(angle) * angle - linear.coeff(spin) * spin)
    return bool(rest == 0 and simplified(first - second) == 0)
