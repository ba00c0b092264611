"""Steps by which equations that are nonlinear in several unknowns become equations in one unknown.

Tried in this order: an unknown that enters one equation linearly is expressed; an angle whose cosine and sine enter two
equations linearly goes by cos² + sin² = 1; of two equations with squares the squares cancel by subtraction; of two
polynomials the resultant is taken.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from decimal import Decimal
from itertools import combinations

import sympy as sp

from planar_cli.equation.algebra.common_factors import together
from planar_cli.equation.algebra.expansion import expanded, wide
from planar_cli.equation.algebra.form import Form, Nonlinear, linear_form
from planar_cli.equation.algebra.plain import letters, longer, tidy
from planar_cli.equation.values.exact import Valuation
from planar_cli.records import record
from planar_cli.solve.instant.algebra import Line

CLOSE = Decimal("1e-25")
HIGHEST = 8
"""Resultants of polynomials whose degrees multiply to more than this are not taken."""

LONGEST = 200
"""Nor those of longer ones, in operations."""


@record
class Pending:
    """An equation that is still to be used: its residual, and the numbers of the equations that it comes from."""

    residual: sp.Expr
    numbers: tuple[int, ...]


@record
class Step:
    """One unknown expressed, and the equations that are left."""

    line: Line
    pool: list[Pending]


def alone(pool: Sequence[Pending], left: Sequence[sp.Symbol]) -> int | None:
    """The first equation in one unknown only."""
    for i, p in enumerate(pool):
        if sum(s in p.residual.free_symbols for s in left) == 1:
            return i
    return None


def in_factors(pool: Sequence[Pending], left: frozenset[sp.Symbol]) -> list[list[Pending]]:
    """The same equations for each factor of one that is a product of factors in unlike unknowns, each of which may be
    zero: to divide by one of them would lose its roots. Empty: there is no such equation.
    """
    for i, p in enumerate(pool):
        if not p.residual.is_Mul or len(p.residual.free_symbols & left) < 2:
            continue
        factors = [f.base if f.is_Pow and f.exp.is_positive else f for f in p.residual.args if f.free_symbols & left]
        if len({frozenset(f.free_symbols & left) for f in factors}) > 1:
            above = [f for f in factors if not (f.is_Pow and f.exp.is_negative)]
            return [[*pool[:i], Pending(f, p.numbers), *pool[i + 1 :]] for f in above]
    return []


def closes(residual: sp.Expr, value: Valuation) -> bool:
    """Does an equation hold in numbers?"""
    number = value.known(residual)
    return number is not None and abs(number) <= CLOSE * max(value.size(residual), CLOSE)


def eliminate(
    pool: list[Pending],
    left: Sequence[sp.Symbol],
    letters: Sequence[sp.Symbol],
    value: Valuation,
    positive: Sequence[sp.Symbol] = (),
) -> Step | None:
    """An equation that gives one unknown, which is put into the others; unknowns that are not letters first.
    `positive`: unknowns of which only a positive value counts.
    """
    order = sorted(left, key=lambda s: s in letters)
    found = _linear(pool, order, left, value, True) or _circle(pool, order, left, value)
    if found is None and alone(pool, left) is None:
        found = _linear(pool, order, left, value, False) or _even(pool, [x for x in order if x in positive])
    return found


def _even(pool: list[Pending], candidates: Iterable[sp.Symbol]) -> Step | None:
    """A letter that is positive, such as a time since the start, and enters by its square alone."""
    candidates = list(candidates)
    if not candidates or any(wide(p.residual) for p in pool):
        return None
    whole = [expanded(p.residual) for p in pool]
    for x in candidates:
        square = sp.Dummy("x2", positive=True)
        put = {x ** (2 * n): square**n for n in (*range(-2, 0), *range(1, HIGHEST + 1))}
        flat = [e.xreplace(put) if x in letters(e) else e for e in whole]
        if any(x in f.free_symbols for f in flat):
            continue
        for i, f in enumerate(flat):
            form = _form(f, square)
            if form is None or form.terms.get(square, sp.S.Zero) == 0:
                continue
            formula = tidy(-form.constant / form.terms[square])
            rest = [Pending(tidy(o.xreplace({square: formula})), pool[j].numbers) for j, o in enumerate(flat) if j != i]
            return Step(Line(x, sp.sqrt(formula), None, pool[i].numbers), rest)
    return None


def _linear(
    pool: list[Pending], order: Iterable[sp.Symbol], left: Sequence[sp.Symbol], value: Valuation, constant: bool
) -> Step | None:
    """An unknown that enters linearly, with a factor that does not vanish; `constant`: it holds no other unknown."""
    for x in order:
        for i, p in enumerate(pool):
            if x not in p.residual.free_symbols:
                continue
            form = _form(p.residual, x)
            if form is None:
                continue
            factor = form.terms.get(x, sp.S.Zero)
            if factor == 0 or (constant and any(s in factor.free_symbols for s in left)):
                continue
            if value.vanishes(factor):
                continue
            formula = tidy(-form.constant / factor)
            rest = [Pending(tidy(o.residual.xreplace({x: formula})), o.numbers) for j, o in enumerate(pool) if j != i]
            return Step(Line(x, formula, None, p.numbers), rest)
    return None


def _form(residual: sp.Expr, x: sp.Symbol) -> Form | None:
    """A residual taken apart by one unknown; None where that enters nonlinearly."""
    try:
        return linear_form(residual, {x})
    except Nonlinear:
        pass
    if wide(residual):
        return None
    try:
        return linear_form(expanded(residual), {x})
    except Nonlinear:
        return None


def _circle(
    pool: list[Pending], order: Iterable[sp.Symbol], left: Sequence[sp.Symbol], value: Valuation
) -> Step | None:
    """Two equations A_i cos x + B_i sin x + C_i = 0: both are expressed, and cos² + sin² = 1 is left."""
    c, s = sp.Dummy("c"), sp.Dummy("s")
    for x in order:
        forms = []
        for i, p in enumerate(pool):
            flat = p.residual.xreplace({sp.cos(x): c, sp.sin(x): s})
            if flat == p.residual or x in flat.free_symbols:
                continue
            try:
                form = linear_form(flat, {c, s})
            except Nonlinear:
                continue
            forms.append((i, form.terms.get(c, sp.S.Zero), form.terms.get(s, sp.S.Zero), form.constant))
        for (i, a1, b1, c1), (j, a2, b2, c2) in combinations(forms, 2):
            whole = tidy(a1 * b2 - a2 * b1)
            if whole == 0 or (not any(u in whole.free_symbols for u in left) and value.is_zero(whole)):
                continue
            cosine, sine = tidy((b1 * c2 - b2 * c1) / whole), tidy((a2 * c1 - a1 * c2) / whole)
            circle = sp.fraction(together(cosine**2 + sine**2 - 1))[0]
            numbers = tuple(dict.fromkeys((*pool[i].numbers, *pool[j].numbers)))
            formula = sp.atan2(sine, cosine)
            others = [p for n, p in enumerate(pool) if n not in (i, j)]
            rest = [Pending(tidy(o.residual.xreplace({x: formula})), o.numbers) for o in others]
            return Step(Line(x, formula, None, numbers), [Pending(tidy(expanded(circle)), numbers), *rest])
    return None


def combined(
    pool: list[Pending], left: Sequence[sp.Symbol], value: Valuation, any_alone: bool = False
) -> list[Pending] | None:
    """Two equations made into a simpler one that takes the place of one of them. `any_alone`: see `subtracted`."""
    return subtracted(pool, left, value, any_alone) or _resultant(pool, left, value)


def subtracted(
    pool: list[Pending], left: Sequence[sp.Symbol], value: Valuation, any_alone: bool = False
) -> list[Pending] | None:
    """The squares of one unknown cancel, and what is left is linear in some unknown; `any_alone`: or it holds one
    unknown alone, whose formula is looked for.
    """
    for i, j in combinations(range(len(pool)), 2):
        for x in left:
            leads = [_square(pool[n].residual, x, left) for n in (i, j)]
            if leads[0] is None or leads[1] is None:
                continue
            less = tidy(expanded(leads[1] * pool[i].residual - leads[0] * pool[j].residual))
            made = Pending(less, (*pool[i].numbers, *pool[j].numbers))
            if _linear([made], left, left, value, True) is not None or (any_alone and alone([made], left) is not None):
                return [*(p for n, p in enumerate(pool) if n != j), made]
    return None


def _square(residual: sp.Expr, x: sp.Symbol, left: Sequence[sp.Symbol]) -> sp.Expr | None:
    """The factor of x² in a quadratic equation, when it holds no other unknown."""
    if x not in letters(residual) or wide(residual):
        return None
    lead: list[sp.Expr] = []
    highest = 0
    for term in sp.Add.make_args(expanded(residual)):
        # A polynomial of many letters would take long to make.
        power, others = 0, []
        for factor in sp.Mul.make_args(term):
            base, exponent = factor.as_base_exp()
            if base != x:
                others.append(factor)
            elif exponent not in (1, 2):
                return None
            else:
                power = int(exponent)
        if any(x in letters(f) for f in others):
            return None
        highest = max(highest, power)
        if power == 2:
            lead.append(sp.Mul(*others))
    if highest != 2 or any(s in letters(f) for s in left for f in lead):
        return None
    return sp.Add(*lead)


def _without(one: sp.Expr, other: sp.Expr, x: sp.Symbol) -> sp.Expr:
    """The resultant of two polynomials in x that are multiplied out; of those in x² that of the square, of which it is
    the square. Their factors stand as letters meanwhile: long ones take all the time.
    """
    pace = 2 if all(e.coeff(x, n) == 0 for e in (one, other) for n in range(1, HIGHEST + 1, 2)) else 1
    factors: dict[sp.Symbol, sp.Expr] = {}
    forms = []
    for e in (one, other):
        form = sp.S.Zero
        for n in range(0, HIGHEST + 1, pace):
            factor = e.coeff(x, n)
            letter = sp.Dummy() if factor.free_symbols else factor
            if letter != factor:
                factors[letter] = factor
            form += letter * x ** (n // pace)
        forms.append(form)
    return expanded(sp.resultant(*forms, x).xreplace(factors))


def _resultant(pool: list[Pending], left: Sequence[sp.Symbol], value: Valuation) -> list[Pending] | None:
    """An equation without x from two polynomials in x; both stay, to give x afterwards and to be tested."""
    for i, j in combinations(range(len(pool)), 2):
        inside = [s for s in left if s in pool[i].residual.free_symbols | pool[j].residual.free_symbols]
        if len(inside) != 2 or wide(pool[i].residual) or wide(pool[j].residual):
            continue
        for x in inside:
            y = next(s for s in inside if s != x)
            one, other = (expanded(pool[n].residual) for n in (i, j))
            # How long they are is seen at once; their degrees take as long as they are.
            if longer(one * other, LONGEST) or not (one.is_polynomial(x, y) and other.is_polynomial(x, y)):
                continue
            if sp.total_degree(one, x, y) * sp.total_degree(other, x, y) > HIGHEST:
                continue
            found = _without(one, other, x)
            if found != 0 and y in found.free_symbols and not any(p.residual == found for p in pool):
                numbers = tuple(dict.fromkeys((*pool[i].numbers, *pool[j].numbers)))
                return [Pending(found, numbers), *pool]
    return None
