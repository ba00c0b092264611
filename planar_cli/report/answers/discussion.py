"""What is worth discussing: the value of a given at which an answer vanishes and changes its sign."""

from __future__ import annotations

from decimal import Decimal

import sympy as sp

from planar_cli.equation.algebra.common_factors import factor_terms, together
from planar_cli.equation.algebra.expansion import expanded
from planar_cli.equation.algebra.plain import longer
from planar_cli.report.document.blocks import Line, Math, Name, Relation, Value, line
from planar_cli.report.notation.clean import is_clean
from planar_cli.report.words.senses import direction_words
from planar_cli.report.words.words import Phrases
from planar_cli.solve.instant.roots import linear_or_square_roots
from planar_cli.solve.solution import Found
from planar_cli.units import LENGTH, RATE, VELOCITY

MOST = 2
LONGEST = 60
SHORT = 16
"""A condition with more operations is of use to nobody."""
FAR = 3
"""A value that differs by more than this ratio from the one of the file is another machine."""


def discussion_lines(found: tuple[Found, ...], phrases: Phrases) -> list[Line]:
    """At most two remarks: for which value of a given an answer is zero."""
    remarks: list[Line] = []
    for answer in found:
        if answer.kind != "number" or not answer.expressions or len(remarks) >= MOST:
            continue
        remark = _sign_change(answer, phrases)
        if remark is not None:
            remarks.append(remark)
    return remarks


def _sign_change(answer: Found, phrases: Phrases) -> Line | None:
    """The first given at whose positive value the answer passes through zero."""
    expr = (answer.expressions or (sp.S.Zero,))[0]
    if longer(expr, LONGEST):
        return None
    numerator = sp.fraction(together(expr))[0]
    factors = [f for f in sp.Mul.make_args(factor_terms(expanded(numerator))) if f.is_Add]
    if not factors:
        return None
    turning = factors[-1]
    options = []
    for symbol in sorted(turning.free_symbols, key=lambda s: s.name):
        for root in linear_or_square_roots(turning, symbol) if _is_free(symbol, phrases) else ():
            remark = _remark(answer, symbol, root, turning, phrases)
            if remark is not None:
                options.append((_distance(symbol, root, phrases), symbol.name, remark))
    return min(options, key=lambda o: o[:2])[2] if options else None


def _is_free(symbol: sp.Symbol, phrases: Phrases) -> bool:
    """Can it have another value in the scene as it is drawn? A length can not, but for a radius of gyration."""
    unit = phrases.ledger.units.get(symbol)
    return symbol.name != "g" and (unit is None or unit.dimension != LENGTH or symbol.name.startswith("k_"))


def _distance(symbol: sp.Symbol, root: sp.Expr, phrases: Phrases) -> Decimal:
    """How far the value is from the present one, as a ratio."""
    now, then = abs(phrases.value(symbol)), phrases.value(root)
    return max(now / then, then / now) if now and then else Decimal(10) ** 9


def _remark(answer: Found, symbol: sp.Symbol, root: sp.Expr, turning: sp.Expr, phrases: Phrases) -> Line | None:
    value = phrases.value.known(root)
    rises = phrases.value.known(sp.diff(turning, symbol).subs(symbol, root))
    if value is None or rises is None:
        return None
    if value <= 0 or not rises or root.has(sp.I):
        return None
    if root.is_Symbol or root.is_number or longer(root, SHORT) or not is_clean(phrases.ledger, root, symbol):
        return None
    opening, end = (
        line("With "),
        line(", ", Name(answer.name), " would be zero", *_beyond(answer, symbol, value, phrases), "."),
    )
    if phrases.symbolic:
        return line(opening, Relation(Math(symbol), "=", Math(root)), end)
    if _distance(symbol, root, phrases) > FAR:
        return None
    unit = phrases.shown(symbol, Decimal(value))
    return line(
        opening, Relation(Math(symbol), "=", Math(root)), " = ", Value(unit.number, unit.unit, unit.figures), end
    )


def _beyond(answer: Found, symbol: sp.Symbol, zero: Decimal, phrases: Phrases) -> Line:
    """What there is beyond a zero. A speed that comes to zero may stay there: friction turns with it."""
    if answer.unit.dimension in (VELOCITY, RATE):
        return ()
    other = (
        direction_words(answer, -answer.values[0], phrases.ledger, phrases.value, phrases.slopes)
        if answer.values
        else ""
    )
    if phrases.symbolic:
        return line("; beyond it, it has the other sign")
    side = "larger" if zero > phrases.value(symbol) else "smaller"
    return line(f"; for a {side} ", Math(symbol), f" it is {other}" if other else " it has the other sign")
