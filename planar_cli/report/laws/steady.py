"""The formulas of constant acceleration as the course writes them: in letters where they are first used, then with what
is known at both states, the terms in their order.

From thrown to top, constant acceleration, y of ball: v² = v_0² + 2 a (y - y_0)
(3)  0 = v0² - 2 g (y_top - h)
"""

from __future__ import annotations

from collections.abc import Callable, Collection, Mapping
from typing import Any

import sympy as sp

from planar_cli.equation.algebra.plain import by_name, longer, simplified
from planar_cli.report.document.blocks import Line, Math, Paragraph, line
from planar_cli.report.in_numbers.with_units import in_units_held
from planar_cli.report.notation.rounding import rounded
from planar_cli.report.words.origins import is_steady
from planar_cli.report.words.words import Phrases
from planar_cli.solve.between.trace import trace

AXES, WAY = ("x", "y"), "s"
"""Letters that a coordinate has in the formula: that of its axis, else of a way."""
Neat = Callable[[sp.Expr], sp.Expr]
"""A formula as the page writes it."""
MOST = 30
"""A longer side stays as it is."""


def with_law(heading: Line, e: trace.Relation, sides: tuple[Any, ...], told: set[str], phrases: Phrases) -> Paragraph:
    """The heading of a relation with these sides, and the formula in letters where it is first used. `told`: the
    kinds whose formulas were told, to which it is added.
    """
    law = _law_in_letters(e, sides, {s.name for s in phrases.ledger.symbols.values()})
    if law is None or law[0] in told:
        return Paragraph(heading)
    told.add(law[0])
    return Paragraph(line(*heading, " ", *law[1]))


def _law_in_letters(e: trace.Relation, shown: tuple[Any, ...], given: Collection[str]) -> tuple[str, Line] | None:
    """A kind of formula and the formula; None where the equation with these sides shows all of its terms, or a letter
    of the formula has another meaning among the letters of the file, `given`.
    """
    law = e.law
    if law is None or law.order != 2 or law.f == 0 or not is_steady(e) or _is_whole(e.kind, shown):
        return None
    turns, axis = law.coordinate.unit == "rad", law.coordinate.symbol.name.split("_")[0]
    place = "theta" if turns else axis if axis in AXES else WAY
    speed, rate = ("omega", "alpha") if turns else ("v", "a")
    if {speed, rate} & set(given) or (place in given and place != law.coordinate.symbol.name):
        return None
    q, v, a, t = (sp.Symbol(n, real=True) for n in (place, speed, rate, "t"))
    # As the file writes it, which may call a speed v0.
    first, start = (sp.Symbol(f"{n}0" if f"{n}0" in given else f"{n}_0", real=True) for n in (place, speed))
    sums: dict[str, tuple[sp.Expr, tuple[sp.Expr, ...]]] = {
        "v(q)": (v**2, (start**2, 2 * a * (q - first))),
        "v(t)": (v, (start, a * t)),
        "q(t)": (q, (first, start * t, a * t**2 / 2)),
    }
    left, terms = sums[e.kind]
    whole = [piece for term in terms for piece in (" + ", Math(term))][1:]
    return f"{e.kind}, {turns}", line(Math(left), " = ", *whole)


def _is_whole(kind: str, shown: tuple[Any, ...]) -> bool:
    """Has an equation as many terms as its law, with a letter alone on its left?"""
    if len(shown) < 2 or not isinstance(shown[0], Math) or shown[0].expr.is_number:
        return False
    terms = [p for p in shown[1] if isinstance(p, Math)] if isinstance(shown[1], tuple) else [shown[1]]
    count = sum(len(sp.Add.make_args(t.expr)) for t in terms if isinstance(t, Math))
    return count == (3 if kind == "q(t)" else 2)


def in_order(e: trace.Relation, plain: dict[sp.Symbol, sp.Expr], neat: Neat, phrases: Phrases) -> tuple[Any, ...]:
    """Both sides with the terms in the order of the law: that at the end, that at the start, what is gained; of an
    integral v dv = a dq what both of its sides are, 1/2 v² - 1/2 v_0² and that of a. Empty: it is no such relation, or
    its sides are long.
    """
    span, law = e.span, e.law
    if span is None or law is None or law.order != 2 or law.f == 0 or law.factor != 1:
        return ()
    if not is_steady(e):
        plainly = isinstance(span.left, sp.Integral) and span.left.function == span.left.variables[0]
        squared = e.kind == "v(q)" and plainly and not span.unevaluated
        return _integrated(_squares(e, plain), plain, neat, phrases) if squared else ()
    if e.kind == "v(q)":
        own, first, gained = _squares(e, plain) or (sp.S.Zero,) * 3
    elif span.explicit is not None:
        own, first = simplified(span.residual + span.explicit), sp.S.Zero
        gained = span.explicit
    else:
        return ()
    gained = neat(gained.xreplace(plain))
    if e.kind == "v(q)" and not longer(gained, MOST):
        # 2 a times the place at the end less that at the start, whichever of them is larger.
        rate = law.f.xreplace(plain)
        way = simplified(gained / (2 * rate))
        gained = 2 * rate * way if way.is_Add and not rate.is_Add else gained
    return () if own == 0 else _sides(own.xreplace(plain), first.xreplace(plain), gained, phrases)


def _squares(e: trace.Relation, plain: Mapping[sp.Symbol, sp.Expr]) -> tuple[sp.Expr, sp.Expr, sp.Expr] | None:
    """v², v_0² and what is gained, of v² - v_0² less what is gained; None: it is no such relation."""
    assert e.span is not None
    found = []
    for residual in (e.span.residual, e.residual):
        # Data at the start may stand in the relation for their letters.
        known = residual.free_symbols <= e.residual.free_symbols | plain.keys()
        coefficients = {s: residual.coeff(s, 2) for s in by_name(residual.free_symbols)}
        ends, starts = ([s for s, c in coefficients.items() if c == sign] for sign in (1, -1))
        if known and len(ends) == 1 and len(starts) < 2:
            own, first = ends[0] ** 2, sp.Add(*(s**2 for s in starts))
            found.append((own, first, own - first - residual))
    return found[0] if found else None


def _integrated(
    squares: tuple[sp.Expr, sp.Expr, sp.Expr] | None, plain: dict[sp.Symbol, sp.Expr], neat: Neat, phrases: Phrases
) -> tuple[Any, ...]:
    if squares is None:
        return ()
    own, first, gained = (x.xreplace(plain) for x in squares)
    half = neat(gained / 2)
    if longer(half, MOST) or own == first:
        return ()
    right = phrases.math(half) if half == 0 else in_units_held((own - first) / 2, half, phrases)
    return phrases.math((own - first) / 2), right


def _sides(own: sp.Expr, first: sp.Expr, gained: sp.Expr, phrases: Phrases) -> tuple[Any, ...]:
    if longer(gained, MOST):
        return ()
    left = phrases.math(own)
    if first == 0 or gained == 0:
        return left, in_units_held(own if own != 0 else gained, first + gained, phrases)
    sign, size = (" - ", -gained) if gained.could_extract_minus_sign() else (" + ", gained)
    right = in_units_held(first, size, phrases)
    if right.expr.as_coeff_Mul()[0].is_negative:
        # The smaller place less the larger, as the law has it: v_0² + 2 a (x - x_0), not v_0² + -2 a (x_0 - x).
        right = Math(rounded(phrases.met(size), phrases.figures))
    return left, line(phrases.math(first), sign, right)
