"""Two equations k cos β = …, k sin β = … in an angle and a time: squared and added they leave the time alone, and then
the cosine and the sine tell the angle.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from typing import Any

import sympy as sp

from planar_cli.equation.algebra.expansion import expanded
from planar_cli.equation.algebra.plain import longer, simplified
from planar_cli.report.document.blocks import Block, Equation, Math, line
from planar_cli.report.words.swallowed import with_unit
from planar_cli.report.words.words import Phrases
from planar_cli.solve.between.trace.trace import Result
from planar_cli.units import TIME

LONGEST = 24
"""Longer sums are not squared on a page."""


def squared(
    residuals: Sequence[sp.Expr], results: Sequence[Result], known: Mapping[sp.Symbol, sp.Expr], phrases: Phrases
) -> list[Block]:
    """The lines that eliminate an angle; empty where two equations are others. `known`: formulas of all that was
    found before.
    """
    if len(residuals) != 2 or len(results) != 2:
        return []
    for angle, other in (tuple(results), tuple(reversed(results))):
        parts = _components(residuals, angle.unknown)
        if parts is None:
            continue
        across, up, size = parts
        whole = expanded(_known(across, known) ** 2 + _known(up, known) ** 2 - _known(size, known) ** 2)
        root = _root(whole, other.unknown)
        if root is None or longer(across, LONGEST) or longer(up, LONGEST):
            continue
        values = {other.unknown: root}
        cosine, sine = (simplified(_known(e / size, known).xreplace(values)) for e in (across, up))
        tried = phrases.value.known(angle.unknown)
        own = [phrases.value.known(e - f(angle.unknown)) for e, f in ((cosine, sp.cos), (sine, sp.sin))]
        if tried is None or any(x is None or abs(x) > CLOSE for x in own):
            continue
        return list(_told((across, up, size), whole, root, (cosine, sine), (angle, other), phrases))
    return []


CLOSE = 1e-20


def _components(residuals: Sequence[sp.Expr], angle: sp.Symbol) -> tuple[sp.Expr, sp.Expr, sp.Expr] | None:
    """What k cos β and k sin β are, and k; None: the equations are others."""
    found: dict[Any, tuple[sp.Expr, sp.Expr]] = {}
    for residual in residuals:
        for function in (sp.cos(angle), sp.sin(angle)):
            k = expanded(residual).coeff(function)
            rest = expanded(residual - k * function)
            if k != 0 and angle not in rest.free_symbols | k.free_symbols:
                found[function.func] = (-rest, k)
    if set(found) != {sp.cos, sp.sin}:
        return None
    (across, k), (up, other) = found[sp.cos], found[sp.sin]
    if expanded(k**2 - other**2) != 0:
        return None
    up = up if expanded(k - other) == 0 else -up
    return (-across, -up, -k) if k.could_extract_minus_sign() else (across, up, k)


def _known(expr: sp.Expr, known: Mapping[sp.Symbol, sp.Expr]) -> sp.Expr:
    for _ in range(4):
        expr = expr.xreplace(dict(known))
    return expr


def _root(whole: sp.Expr, x: sp.Symbol) -> sp.Expr | None:
    """The one root besides zero of what is left."""
    if not whole.is_polynomial(x):
        return None
    powers = sp.Poly(whole, x).all_coeffs()[::-1]
    while powers and powers[0] == 0:
        powers = powers[1:]
    return simplified(-powers[0] / powers[1]) if len(powers) == 2 else None


def _told(
    parts: tuple[sp.Expr, sp.Expr, sp.Expr],
    whole: sp.Expr,
    root: sp.Expr,
    functions: tuple[sp.Expr, sp.Expr],
    results: tuple[Result, Result],
    phrases: Phrases,
) -> Iterator[Block]:
    (across, up, size), (angle, other) = parts, results
    squares = sp.Add(sp.Pow(across, 2, evaluate=False), sp.Pow(up, 2, evaluate=False), evaluate=False)
    lead = line("squared and added, since cos² + sin² = 1:")
    yield Equation((Math(squares), phrases.math(size**2)), None, lead)
    right = expanded(size**2)
    multiplied = expanded(whole + right)
    if not right.free_symbols - multiplied.free_symbols and right != 0:
        opened = "with the data of the start, multiplied out:"
        yield Equation((phrases.math(multiplied), phrases.math(right)), None, line(opened))
    terms = sp.Add.make_args(whole)
    left = sp.Add(*(t for t in terms if not t.could_extract_minus_sign()))
    yield Equation((phrases.math(left), phrases.math(left - whole)), None, line("hence:"))
    told = with_unit(root, TIME, phrases.ledger, phrases.figures) or phrases.math(root)
    none = whole.xreplace({other.unknown: sp.S.Zero}) == 0
    why = line("so that, as ", Math(other.unknown), " ≠ 0:") if none else line("so that:")
    yield Equation((phrases.math(other.unknown), told), None, why)
    for function, part, value in ((sp.cos, across, functions[0]), (sp.sin, up, functions[1])):
        above = line("(", Math(part), ")") if part.is_Add else line(Math(part))
        quotient = line(*above, "/(", Math(size), ")")
        yield Equation((Math(function(angle.unknown)), quotient, phrases.math(value)))
    yield Equation((phrases.math(angle.unknown), phrases.shown(angle.unknown, angle.value)))
