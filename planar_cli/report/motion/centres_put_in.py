"""What a statement about a mass centre says once the coordinate of this is put in: y_G = r, hence 2 r² = 3 h².

Of a body of parts by their moments first: y_G = r means Σ m_i (y_i - r) = 0, so that 1/2 h m_2 = 4 m_1 r/(3 π).
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

import sympy as sp

from planar_cli.equation.algebra.plain import by_name, identically_zero, simplified
from planar_cli.equation.values.ledger import Ledger
from planar_cli.report.document.blocks import Block, Equation, line
from planar_cli.report.words.origins import balanced
from planar_cli.report.words.words import Phrases
from planar_cli.solve.between.trace.trace import Relation


def centres_put_in(e: Relation, phrases: Phrases) -> Iterator[Block]:
    """Nothing where the relation has no letter of a mass centre."""
    if e.told is None:
        return
    numerator, denominator = sp.fraction(sp.together(e.residual))
    vanishing = [f for f in sp.Mul.make_args(numerator) if f.is_Add]
    if len(vanishing) == 1 and denominator.free_symbols:
        letters = by_name(s for s in e.told.free_symbols if s not in e.residual.free_symbols)
        named = [piece for s in letters for piece in (", ", phrases.math(s))][1:]
        how = "put in, multiplied out"
        moments = _of_parts(e.told, letters[0], phrases.ledger) if len(letters) == 1 else None
        if moments is not None:
            sides = tuple(map(phrases.math, moments))
            yield Equation(sides, None, (), line("with ", *named, " put in"))
            masses = by_name((moments[0] - moments[1]).free_symbols & phrases.ledger.definitions.keys())
            named = [piece for s in masses for piece in (", ", phrases.math(s))][1:]
            how = "put in"
        sides = tuple(map(phrases.math, balanced(replace(e, told=None), vanishing[0])))
        yield Equation(sides, None, (), line("with ", *named, f" {how}"))


def _of_parts(told: sp.Expr, centre: sp.Symbol, ledger: Ledger) -> tuple[sp.Expr, sp.Expr] | None:
    """Σ m_i (y_i - y) = 0 for y_G = y, what is positive on the left and the others on the right; None: the mass centre
    is not that of several masses, or the arms of all of them count the same way.
    """
    moment, mass = sp.fraction(ledger.definitions.get(centre, sp.S.Zero))
    parts = by_name(ledger.definitions.get(mass, sp.S.Zero).free_symbols)
    slope = sp.diff(told, centre)
    if (
        len(parts) < 2
        or centre in slope.free_symbols
        or not identically_zero(sp.Add(*parts) - ledger.definitions[mass])
    ):
        return None
    place = centre - told / slope
    arms = {m: simplified(sp.diff(moment, m).xreplace(dict(ledger.definitions)) - place) for m in parts}
    if not identically_zero(moment - sp.Add(*(m * sp.diff(moment, m) for m in parts))):
        return None
    terms = [m * arm for m, arm in arms.items()]
    left = [t for t in terms if not t.could_extract_minus_sign()]
    right = [-t for t in terms if t.could_extract_minus_sign()]
    return (sp.Add(*left), sp.Add(*right)) if left and right else None
