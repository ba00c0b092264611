"""What a statement about a mass centre says once the coordinate of this is put in: y_G = r, hence 2 r² = 3 h²."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

import sympy as sp

from planar_cli.equation.plain import by_name
from planar_cli.report.blocks import Block, Equation, line
from planar_cli.report.origins import balanced
from planar_cli.report.words import Phrases
from planar_cli.solve.between.trace import Relation


def centres_put_in(e: Relation, phrases: Phrases) -> Iterator[Block]:
    """Nothing where the relation has no letter of a mass centre."""
    if e.told is None:
        return
    numerator, denominator = sp.fraction(sp.together(e.residual))
    vanishing = [f for f in sp.Mul.make_args(numerator) if f.is_Add]
    if len(vanishing) == 1 and denominator.free_symbols:
        letters = by_name(s for s in e.told.free_symbols if s not in e.residual.free_symbols)
        named = [piece for s in letters for piece in (", ", phrases.math(s))][1:]
        sides = tuple(map(phrases.math, balanced(replace(e, told=None), vanishing[0])))
        yield Equation(sides, None, (), line("with ", *named, " put in, multiplied out"))
