"""Plainer forms of expressions, and how long they are, at a price that fits thousands of calls.

SymPy's own `simplify` brings in its physical units at the first call, which costs as much as importing SymPy; its
`count_ops` walks all of an expression even where only "longer than ten" is asked.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping
from functools import lru_cache
from typing import Any

import sympy as sp

from planar_cli.equation.algebra.bounds import with_certain_signs
from planar_cli.equation.algebra.cancelling import cancelled
from planar_cli.equation.algebra.common_factors import factor_terms, together
from planar_cli.equation.algebra.counting import operations
from planar_cli.equation.algebra.expansion import expanded, wide
from planar_cli.equation.algebra.factoring import factored
from planar_cli.equation.algebra.trigonometry import put_together

MANY = 60
"""An expression of more operations than this is left as it is by `tidy`."""
SOME = 30
"""Beyond so many operations only common factors are looked for."""
MANY_DIGITS = 10**15
"""A denominator beyond this is one of a number that was put in for a long formula."""
PRINTABLE = 1000
"""A formula of more operations than this is not printed as one: its lines are, step by step."""
DIGITS = 50
"""Of numbers that refute a zero."""
ANGLES = (sp.asin, sp.acos, sp.atan)
"""The fraction inside is put together by itself."""
FEW = 2
"""So short an expression is left alone."""
_KEPT = 50_000


def longer(expr: sp.Expr, limit: int) -> bool:
    """Has an expression more operations than `limit`? Long ones are told without counting all of them."""
    return _surely_longer(expr, limit) or operations(expr) > limit


def _surely_longer(expr: sp.Expr, limit: int) -> bool:
    """Do the sums and products alone, in which signs and numbers are no operations of their own, exceed the limit?"""
    seen, stack = 0, [expr]
    while stack:
        part = stack.pop()
        if part.is_Add:
            seen += len(part.args) - 1
        elif part.is_Mul:
            seen += sum(not a.is_Number for a in part.args) - 1
        if seen > limit:
            return True
        stack.extend(part.args)
    return False


@lru_cache(maxsize=_KEPT)
def letters(expr: sp.Expr) -> frozenset[sp.Symbol]:
    """The free symbols of an expression, which SymPy gathers anew each time it is asked, in each part each time."""
    if not expr.args or not isinstance(expr, sp.Add | sp.Mul | sp.Pow | sp.Function):
        return frozenset(expr.free_symbols)
    return frozenset().union(*map(letters, expr.args))


def by_name(symbols: Iterable[sp.Symbol]) -> list[sp.Symbol]:
    """Symbols in the order of their names: that of a set differs from run to run, and must not decide what is told."""
    return sorted(symbols, key=lambda s: s.name)


def parts_of(exprs: Iterable[sp.Basic]) -> Iterator[sp.Basic]:
    """Every distinct part of expressions once, those inside it first. Formulas that were put together of others hold
    the same parts many times over, which SymPy's traversals go through each time.
    """
    seen: set[sp.Basic] = set()
    waiting: list[tuple[sp.Basic, bool]] = [(e, False) for e in reversed(list(exprs))]
    while waiting:
        part, ready = waiting.pop()
        if ready:
            yield part
        elif part not in seen:
            seen.add(part)
            waiting.append((part, True))
            waiting += [(a, False) for a in reversed(part.args)]


def replaced(expr: sp.Expr, rule: Mapping[sp.Expr, sp.Expr]) -> sp.Expr:
    """`xreplace`, each distinct part once."""
    found: dict[sp.Basic, sp.Basic] = {}
    for part in parts_of([expr]):
        new = tuple(found[a] for a in part.args)
        same = all(a is b for a, b in zip(new, part.args, strict=True))
        found[part] = rule[part] if part in rule else part if same else part.func(*new)
    return found[expr]


@lru_cache(maxsize=_KEPT)
def derivative(expr: sp.Expr, x: sp.Symbol) -> sp.Expr:
    """The derivative of an expression, put together as SymPy does it from those of its parts, which are remembered:
    equations of one motion have most parts in common, and whoever plans asks for the same ones again and again.
    """
    if x not in letters(expr):
        return sp.S.Zero
    if expr == x:
        return sp.S.One
    if expr.is_Add:
        return sp.Add(*(derivative(a, x) for a in expr.args))
    if expr.is_Mul:
        args = expr.args
        rates = ((i, derivative(a, x)) for i, a in enumerate(args))
        return sp.Add(*(sp.Mul(*args[:i], rate, *args[i + 1 :]) for i, rate in rates if rate != 0))
    if expr.is_Pow and x not in letters(expr.exp):
        return expr * (derivative(expr.base, x) * expr.exp / expr.base)
    if isinstance(expr, sp.tan):
        # As the course writes it; SymPy has 1 + tan².
        return sp.cos(expr.args[0]) ** -2 * derivative(expr.args[0], x)
    if isinstance(expr, sp.sin | sp.cos | sp.exp | sp.log):
        return expr.fdiff(1) * derivative(expr.args[0], x)
    if isinstance(expr, sp.sign):
        # It steps where its argument vanishes: there |s| has no second derivative, and beside it none but zero.
        return sp.S.Zero
    return sp.diff(expr, x)


@lru_cache(maxsize=_KEPT)
def trigonometric(expr: sp.Expr) -> sp.Expr:
    """Angles put together where sines and cosines multiply each other; sin² + cos² = 1 goes first."""
    if _degree(expr) < 2 or wide(expr):
        return expr
    short = _with_one(expr)
    return short if _degree(short) < 2 or longer(short, MANY) else put_together(short)


@lru_cache(maxsize=_KEPT)
def _degree(expr: sp.Expr) -> int:
    """How many sines and cosines are multiplied or divided by each other at most."""
    if isinstance(expr, sp.tan):
        return 2
    if isinstance(expr, sp.sin | sp.cos):
        return 1
    if expr.is_Mul:
        return sum(_degree(a) for a in expr.args)
    if expr.is_Pow:
        inside = _degree(expr.base)
        return inside * abs(int(expr.exp)) if expr.exp.is_Integer else inside
    return max((_degree(a) for a in expr.args), default=0)


def _with_one(expr: sp.Expr) -> sp.Expr:
    """sin² = 1 - cos² put in, or the other way round, where that makes it shorter."""
    whole = expanded(expr)
    forms = [expr]
    squares = [p for p in parts_of([whole]) if isinstance(p, sp.Pow) and p.exp == 2]
    for function, other in ((sp.sin, sp.cos), (sp.cos, sp.sin)):
        own = [p for p in squares if isinstance(p.base, function)]
        if own:
            forms.append(expanded(replaced(whole, {p: 1 - other(p.base.args[0]) ** 2 for p in own})))
    return min(forms, key=operations)


def simplified(expr: Any) -> sp.Expr:
    """The shortest of the usual forms: cancelled, put together, trigonometric, factored."""
    return _simplified(sp.sympify(expr))


@lru_cache(maxsize=_KEPT)
def _simplified(expr: sp.Expr) -> sp.Expr:
    if not expr.args or wide(expr):
        return expr
    if expr.has(sp.log):
        # All is real here, which SymPy does not see of a root of a difference: ln(e^x) is x.
        expr = expr.replace(_log_of_exp, lambda e: e.args[0].args[0])
    if expr.has(sp.Abs, sp.sign):
        expr = with_certain_signs(expr)
    if expr.has(*ANGLES):
        expr = expr.replace(lambda e: isinstance(e, ANGLES), lambda e: e.func(_simplified(e.args[0])))
    whole = expanded(expr)
    forms = [expr, whole]
    if _degree(expr) >= 2:
        forms += [trigonometric(f) for f in dict.fromkeys((min(forms, key=_effort), expr))]
    best = min(forms, key=_effort)
    if operations(best) <= FEW:
        return best
    quotient = cancelled(_joined(best))
    forms += [quotient, together(best)]
    if _degree(quotient) >= 2:
        forms.append(trigonometric(quotient))
    best = min(forms, key=_effort)
    last = [sp.signsimp(best), factor_terms(best), _joined(best, deep=True), best]
    if expr.is_number:
        last += [sp.radsimp(best), sp.sqrtdenest(best)]
    # Of forms that read equally well, the factored one comes before the others.
    return min([*last, *forms], key=_effort)


def in_factors(expr: sp.Expr) -> sp.Expr:
    """The plainer of an expression simplified and, of a short one without functions, in its factors:
    (m_1 - m_2) (g + a) for m_1 (g + a) - m_2 g - m_2 a.
    """
    found = simplified(expr)
    if longer(found, SOME) or not found.is_rational_function(*found.free_symbols):
        return found
    return min((found, factored(found)), key=_effort)


def _log_of_exp(expr: sp.Expr) -> bool:
    return isinstance(expr, sp.log) and isinstance(expr.args[0], sp.exp)


def identically_zero(expr: Any) -> bool:
    """Is it zero whatever its letters are? A number at one place that is not zero refutes it: to simplify a long
    expression that is not zero takes minutes, when SymPy's factoring, which tries places at random, meets unlucky ones.
    """
    expr = sp.sympify(expr)
    if expr.is_Rational:
        return bool(expr == 0)
    return not _refuted(expr) and bool(simplified(expr) == 0)


@lru_cache(maxsize=_KEPT)
def _refuted(expr: sp.Expr) -> bool:
    """Has it a value other than zero at some place?"""
    ordered = sorted(letters(expr), key=lambda s: s.name)
    for sign in (1, -1):
        place = {
            s: sp.Rational(7 + 3 * n, 10 + 2 * n) * (1 if s.is_nonnegative or n % 2 else sign)
            for n, s in enumerate(ordered)
        }
        number = expr.evalf(DIGITS, subs=place)
        if number.is_Float and number.is_finite and abs(number) > sp.Float(10) ** (-DIGITS // 2):
            return True
    return False


def _joined(expr: sp.Expr, deep: bool = False) -> sp.Expr:
    """`powsimp` where there is something for it. `deep`: also inside functions and roots, exponents only."""
    if not _to_join(expr, deep):
        return sp.Add(*(_with_number_inside(t) for t in sp.Add.make_args(expr)))
    return sp.powsimp(expr, combine="exp", deep=True) if deep else sp.powsimp(expr)


def _to_join(expr: sp.Expr, deep: bool) -> bool:
    """Are there powers that could become one? Roots of different sums under one exponent only without `deep`."""
    products = expr.atoms(sp.Mul) if deep else (t for t in sp.Add.make_args(expr) if t.is_Mul)
    return any(_powers_to_join(p, 1 if not deep else len(p.args)) for p in products) or expr.has(sp.exp)


def _powers_to_join(product: sp.Expr, most: int) -> bool:
    """Has a product more roots than so many, one of a product, a letter as exponent, or factors that differ in their
    sign alone?
    """
    roots = [f for f in product.args if f.is_Pow and not f.exp.is_Integer]
    if len(roots) > most or any(f.base.is_Mul or not f.exp.is_Rational for f in roots):
        return True
    sums = {a.base if a.is_Pow else a for a in product.args if a.is_Add or (a.is_Pow and a.base.is_Add)}
    return len(sums) > 1 and any(-s in sums for s in sums)


def _with_number_inside(term: sp.Expr) -> sp.Expr:
    """A number that stands before a sum alone goes into it: (2 a + 2 b)/(2 c) is (a + b)/c."""
    number, rest = term.as_coeff_Mul(rational=True)
    whole = [f for f in sp.Mul.make_args(rest) if not f.is_Pow]
    if number == 1 or len(whole) != 1 or not whole[0].is_Add:
        return term
    return sp.Mul(sp.Mul(number, whole[0]), *(f for f in sp.Mul.make_args(rest) if f.is_Pow))


def with_short_roots(expr: sp.Expr) -> sp.Expr:
    """An expression with what stands under its square roots factored, where that makes it shorter."""
    half = (sp.Rational(1, 2), -sp.Rational(1, 2))
    sums = [p for p in expr.atoms(sp.Pow) if p.exp in half and p.base.has(sp.Add) and p.free_symbols]
    if not sums or any(longer(p, SOME) for p in sums):
        return expr
    rooted = expr.xreplace({p: factored(p.base) ** p.exp for p in sums})
    return min((expr, simplified(rooted), sp.powsimp(factored(rooted))), key=_beside_roots)


def with_whole_roots(expr: sp.Expr, root: Callable[[sp.Expr], sp.Expr]) -> sp.Expr:
    """An expression without the roots of fractions that are complete squares; `root`: of what is not negative."""
    found: dict[sp.Expr, sp.Expr] = {}
    for power in expr.atoms(sp.Pow):
        if abs(power.exp) != sp.Rational(1, 2) or not power.free_symbols or longer(power, SOME):
            continue
        above, below = sp.fraction(sp.together(power.base))
        if below.free_symbols:
            whole = root(above) / root(below)
            if not any(abs(p.exp) == sp.Rational(1, 2) for p in whole.atoms(sp.Pow)):
                found[power] = whole ** (2 * power.exp)
    return expr.xreplace(found) if found else expr


def _beside_roots(expr: sp.Expr) -> int:
    """Operations, where the root of a number is a number: √6 √(R - r) is printed as √(6 (R - r))."""
    return operations(expr.xreplace({p: sp.Integer(2) for p in expr.atoms(sp.Pow) if p.is_number}))


@lru_cache(maxsize=_KEPT)
def _effort(expr: sp.Expr) -> int:
    """What an expression costs its reader: its operations, more for fractions inside a denominator and -a - b."""
    sums = (p for p in parts_of([expr]) if isinstance(p, sp.Add))
    reversed_signs = sum(all(a.could_extract_minus_sign() for a in s.args) for s in sums)
    return operations(expr) + 3 * _nested(expr, inside=False) + 2 * reversed_signs


@lru_cache(maxsize=_KEPT)
def _nested(expr: sp.Expr, inside: bool) -> int:
    """Fractions that stand in a sum under a fraction stroke."""
    if not expr.args:
        return 0
    below = expr.is_Pow and expr.exp.could_extract_minus_sign()
    own = int(inside and below)
    return own + sum(_nested(a, inside or (below and a.is_Add)) for a in expr.args)


def tidy(expr: Any) -> sp.Expr:
    """A short expression in its plainest form; a long one as it is."""
    expr = sp.sympify(expr)
    if expr.is_Float:
        return sp.nsimplify(expr)
    if expr.is_number or expr.is_Symbol:
        return trigonometric(expr) if expr.is_Add and not longer(expr, SOME) else expr
    return _tidied(expr)


@lru_cache(maxsize=_KEPT)
def _tidied(expr: sp.Expr) -> sp.Expr:
    if longer(expr, MANY) or rounded_inside(expr) or wide(expr):
        return expr
    if _degree(expr) >= 2 and longer(expr, SOME):
        expr = _with_one(expr)
    found = factor_terms(expr)
    if not longer(expr, SOME) and (_degree(expr) >= 2 or not expr.is_polynomial(*expr.free_symbols)):
        trial = trigonometric(expr) if expr.has(sp.sin, sp.cos) else cancelled(together(expr))
        if operations(trial) < operations(found):
            found = trial
    return found


def rounded_inside(expr: sp.Expr) -> bool:
    """Does a number with very many digits stand in the expression, one that was put in for a long formula?"""
    return any(r.q > MANY_DIGITS or abs(r.p) > MANY_DIGITS for r in expr.atoms(sp.Rational))


def are_zero(amounts: Iterable[sp.Expr], formulas: Mapping[sp.Symbol, sp.Expr]) -> bool:
    """Do all of them vanish with the letters that were found to be zero?"""
    zeros = {s: f for s, f in formulas.items() if f == 0}
    return all(simplified(a.xreplace(zeros)) == 0 for a in amounts if a != 0)
