"""Derivations of several unknowns together, taken one after the other where their equations allow it."""

from __future__ import annotations

import itertools
from collections.abc import Callable, Sequence
from dataclasses import replace
from decimal import Decimal

import sympy as sp

from planar_cli.equation.algebra.plain import longer, simplified
from planar_cli.equation.values.exact import Valuation
from planar_cli.solve.between.roots.substitution import STATE
from planar_cli.solve.between.trace.derivation import Derivation
from planar_cli.solve.regimes.equations import Equation

Inside = Callable[[Equation], frozenset[sp.Symbol]]
Regular = Callable[[tuple[Equation, ...], tuple[sp.Symbol, ...]], bool]

SIGNED = ("extreme", "link", "loop")
LONGEST = 60
"""A longer equation is not made plainer."""
NOTHING = Decimal("1e-9")
"""A factor that is smaller, in parts of the size of its terms, may be zero."""


def one_by_one(order: Sequence[Derivation], inside: Inside, regular: Regular) -> list[Derivation]:
    """The same unknowns from the same equations: what an earlier derivation told is known, an equation in which only
    one unknown is left gives it at once, and equations that this makes dispensable go.
    """
    found: list[Derivation] = []
    known: set[sp.Symbol] = set()
    for derivation in order:
        steps = [derivation] if len(derivation.unknowns) == 1 else _split(derivation, known, inside, regular)
        found += [s for s in steps if not known.issuperset(s.unknowns)]
        known.update(derivation.unknowns)
    return found


def _split(derivation: Derivation, known: set[sp.Symbol], inside: Inside, regular: Regular) -> list[Derivation]:
    """One derivation in the smallest steps."""
    left = {x for x in derivation.unknowns if x not in known}
    equations, steps = list(derivation.equations), []
    while left:
        step = _smallest(equations, left, inside, regular)
        if step is None:
            return [derivation]
        chosen, unknowns = step
        needs = frozenset().union(*(inside(e) for e in chosen)) - set(unknowns)
        steps.append(replace(derivation, equations=chosen, unknowns=unknowns, needs=needs))
        equations = [e for e in equations if e not in chosen]
        left -= set(unknowns)
    return steps


def _smallest(
    equations: Sequence[Equation], left: set[sp.Symbol], inside: Inside, regular: Regular
) -> tuple[tuple[Equation, ...], tuple[sp.Symbol, ...]] | None:
    """The fewest equations that fix as many of these unknowns and contain no other of them."""
    for count in range(1, len(left) + 1):
        for chosen in itertools.combinations(equations, count):
            open_ones = tuple(sorted(left & frozenset().union(*(inside(e) for e in chosen)), key=lambda s: s.name))
            if len(open_ones) == count and regular(chosen, open_ones):
                return chosen, open_ones
    return None


def without_factors(equation: Equation, value: Valuation) -> Equation:
    """A condition whose factors are known not to vanish loses them: of 2 v dv/dt = 0 with v > 0, dv/dt = 0 is left. A
    number stays with a polynomial in numbers: of (20 - 4 t)/m = 0, 20 - 4 t = 0 is left. What has a sign there is not
    told by its size: with y < 0, -y stands for |y|. Of what the file says of letters of a state, the one factor that
    vanishes is left: of l ω sin θ = 0 with ω > 0, sin θ = 0.
    """
    if equation.kind in SIGNED:
        equation = _signed(equation, value)
    factors = sp.Mul.make_args(sp.factor_terms(equation.residual))
    if equation.kind == "given":
        moving = [f for f in factors if any(STATE in s.name for s in f.free_symbols)]
        nil = [f for f in moving if not _differs_from_zero(f, value)]
        return equation if len(nil) != 1 or len(moving) == 1 else replace(equation, residual=nil[0])
    if equation.kind != "extreme":
        return equation
    kept = [f for f in factors if not _differs_from_zero(f, value)]
    if len(kept) == len(factors) or not kept:
        return equation
    rest = sp.Mul(*kept)
    if rest.is_Add and len(rest.free_symbols) == 1 and rest.is_polynomial():
        rest = sp.expand(rest * sp.Mul(*(f for f in factors if f.is_number)))
    return replace(equation, residual=rest)


def _signed(equation: Equation, value: Valuation) -> Equation:
    """An equation in which nothing is told by its size whose sign is known in this motion."""
    signed = {a: a.args[0] * sign for a in equation.residual.atoms(sp.Abs) if (sign := _sign_of(a.args[0], value))}
    if not signed or longer(equation.residual, LONGEST):
        return equation
    return replace(equation, residual=simplified(equation.residual.xreplace(signed)))


def _sign_of(expr: sp.Expr, value: Valuation) -> int:
    """Which sign it has in this motion; 0: none that is known."""
    number = value.known(expr)
    return 0 if number is None or not _differs_from_zero(expr, value) else 1 if number > 0 else -1


def _differs_from_zero(factor: sp.Expr, value: Valuation) -> bool:
    number = value.known(factor)
    return number is not None and number.is_finite() and abs(number) > NOTHING * value.size(factor)
