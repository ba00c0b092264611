"""A minus sign before a difference goes into it: a = (P - μ N)/m for a = -(μ N - P)/m."""

from __future__ import annotations

from planar_cli.report.notation.formula import Call, Formula, Negative, Product, Quotient, Root, Sum


def turned(found: Formula) -> Formula:
    """A whole side without the minus sign that stands before its only difference.

    A difference of two names keeps it, as in -(R - r) φ̇: there it may be a length. So does a sum in which most terms
    would get one.
    """
    if not isinstance(found, Negative):
        return found
    inside = found.inside
    above = inside.above if isinstance(inside, Quotient) else inside
    factors = above.factors if isinstance(above, Product) else (above,)
    sums = [f for f in factors if isinstance(f, Sum)]
    if len(sums) != 1 or 2 * sum(minus for minus, _ in sums[0].terms) < len(sums[0].terms):
        return found
    if len(sums[0].terms) == 2 and not any(isinstance(t, Product | Quotient | Root | Call) for _, t in sums[0].terms):
        return found
    terms = sorted(((not minus, term) for minus, term in sums[0].terms), key=lambda t: t[0])
    other = tuple(Sum(tuple(terms)) if f is sums[0] else f for f in factors)
    above = other[0] if len(other) == 1 else Product(other)
    return Quotient(above, inside.below) if isinstance(inside, Quotient) else above
