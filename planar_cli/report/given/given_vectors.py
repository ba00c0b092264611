"""Vectors that the data tell: one whose components are given needs no formula, and a letter that is given as another is
written as that: v_P = v, so that a_P = v²/ρ e_n.
"""

from __future__ import annotations

from collections.abc import Sequence
from decimal import Decimal

import sympy as sp

from planar_cli.equation.algebra.plain import identically_zero
from planar_cli.problem.scene.geometry import Vec
from planar_cli.report.document.blocks import Math
from planar_cli.report.notation.enough_figures import figures_of
from planar_cli.report.notation.numbers import significant
from planar_cli.report.notation.ordering import NUMBER
from planar_cli.report.words.words import Phrases
from planar_cli.solve.solution import InstantSolution
from planar_cli.units import Dimension

GIVEN = "given"
"""The source of an equation that the file states, and what is said beside its vector."""


def is_given(vector: Vec, instant: InstantSolution, phrases: Phrases) -> bool:
    """Is every component of a vector in numbers zero or one that the file gives?"""
    if phrases.symbolic:
        return False
    parts = [sp.sympify(p) for p in (vector.x, vector.y) if phrases.certain(p) != 0]
    equations = (w for s in instant.stages for b in s.blocks for w in b.equations)
    given = [w.left for w in equations if w.source == GIVEN and not w.left.is_number]
    return bool(parts) and all(any(identically_zero(p - left) for left in given) for p in parts)


def letters_given(instant: InstantSolution) -> dict[sp.Symbol, sp.Expr]:
    """The unknowns that come to a letter of the file, or to zero."""
    own = {*instant.instant.scene.ledger.letters, sp.S.Zero}
    return {s: e for stage in instant.stages for s, e in stage.algebra.formulas.items() if e in own}


def size_of(vector: Sequence[Decimal], dimension: Dimension, phrases: Phrases) -> Math:
    """√(x² + y²) with the numbers, in the units of the page."""
    numbers = [phrases.of_dimension(v, dimension).number for v in vector]
    figures = figures_of(numbers, lambda v: (v[0] ** 2 + v[1] ** 2).sqrt(), phrases.figures)
    texts = {sp.Symbol(f"{NUMBER}{i}", real=True): significant(n, figures) for i, n in enumerate(numbers)}
    x, y = texts
    return Math(sp.sqrt(sp.Add(x**2, y**2, evaluate=False), evaluate=False), texts)


def says_all(vector: Vec | None, closed: Sequence[sp.Expr] | None) -> bool:
    """Is a vector in letters the answer already?"""
    if vector is None or closed is None or len(closed) != 2:
        return False
    return all(identically_zero(sp.sympify(p) - e) for p, e in zip((vector.x, vector.y), closed, strict=True))
