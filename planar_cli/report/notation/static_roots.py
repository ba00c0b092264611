"""Roots that show the value they would have without one of their terms, as a book writes a load that drops on a spring.

v = √(g (m g + 2 k h)/k) as √(2 g h + m g²/k): more than √(2 g h), by what the way over the spring adds.
c = (m g + √(m g (m g + 2 k h)))/k as m g (1 + √(1 + 2 k h/(m g)))/k: so many times the compression at rest.
"""

from __future__ import annotations

import sympy as sp

HALF = sp.Rational(1, 2)


def with_static_roots(expr: sp.Expr) -> sp.Expr:
    """The formula with such roots, all of positive letters; itself where there are none."""
    if not any(p.exp == HALF and p.base.is_Add and len(p.base.args) == 2 for p in expr.atoms(sp.Pow)):
        return expr
    return expr.replace(_is_two_terms, _from_its_start).replace(lambda e: isinstance(e, sp.Mul), _termwise)


def _rooted(term: sp.Expr) -> tuple[sp.Expr, sp.Expr] | None:
    """A product as a factor and the square of all its roots, a product with one sum of two terms, of which one has a
    letter of the other factors in it; None: it is no such product.
    """
    factors = sp.Mul.make_args(term)
    halves = [f for f in factors if isinstance(f, sp.Pow) and abs(f.exp) == HALF]
    bases = [f.base for f in halves]
    sums = [b for b, f in zip(bases, halves, strict=True) if b.is_Add and f.exp == HALF]
    if len(sums) != 1 or len(sums[0].args) != 2 or not all(b.is_Symbol or b.is_Integer or b in sums for b in bases):
        return None
    above = {f.base for f in halves if f.exp == HALF and f.base.is_Symbol}
    parts = [set(sp.Mul.make_args(t)) for t in sums[0].args]
    plain = all(f.is_Number or f.is_Symbol for part in parts for f in part)
    if not plain or not any(above & part for part in parts) or not all(s.is_positive for s in term.free_symbols):
        return None
    return sp.Mul(*(f for f in factors if f not in halves)), sp.Mul(*(f**2 for f in halves))


def _termwise(term: sp.Mul) -> sp.Expr:
    """The square multiplied out, where its divisor goes out of one of both terms; else itself."""
    found = _rooted(term)
    if found is None or not sp.fraction(found[1])[1].free_symbols:
        return term
    whole = sp.expand(found[1])
    short = whole.is_Add and any(not sp.fraction(t)[1].free_symbols for t in whole.args)
    return found[0] * sp.sqrt(whole) if short else term


def _is_two_terms(e: sp.Basic) -> bool:
    return isinstance(e, sp.Add) and len(e.args) == 2 and any(_rooted(t) is not None for t in e.args)


def _from_its_start(total: sp.Add) -> sp.Expr:
    """A ± √(A (A + B)) as A (1 ± √(1 + B/A)); another sum itself."""
    for start, other in (total.args, total.args[::-1]):
        found = _rooted(other)
        if found is None or abs(found[0]) != 1 or not (start.is_Mul or start.is_Symbol):
            continue
        more = sp.expand(found[1] / start) - start
        if found[1].free_symbols and more.is_Mul and not sp.fraction(more)[1].free_symbols and start.is_positive:
            return start * (1 + found[0] * sp.sqrt(1 + more / start))
    return total
