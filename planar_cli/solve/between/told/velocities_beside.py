"""The velocities of points of which a find is made up, each by its letter on a line of its own before it.

e = (v_Ax,2 - v_Cx,2)/u   after   v_Ax,2 = v_Gx,2 - 1/2 l ω_2
"""

from __future__ import annotations

import re
from collections.abc import Iterator

import sympy as sp

from planar_cli.equation.algebra.counting import operations
from planar_cli.equation.algebra.plain import by_name
from planar_cli.problem.language.expression import Quantity, Relation
from planar_cli.problem.language.walk import walk
from planar_cli.solve.between.equations.asked_finds import AskedFind
from planar_cli.solve.roads import is_curve

POINT = re.compile(r"[A-Z]\d*")
LEAST, MOST = 2, 12
"""A velocity of fewer operations needs no letter; a longer one is no help."""


def velocities_inside(asked: AskedFind) -> Iterator[tuple[sp.Symbol, str, str]]:
    """The stand-ins of components of velocities of points in a find that is more than one of them, each with the name
    of its letter and its state.
    """
    what = asked.find.found.what
    if isinstance(what, Quantity | Relation) or is_curve(what) or len(asked.raw) != 1:
        return
    for q in walk(what):
        if not isinstance(q, Quantity) or q.word != "v" or not isinstance(q.at, str) or len(q.things) != 1:
            continue
        kinds = [p.kind for p in q.parts]
        if kinds not in (["x"], ["y"]) or not POINT.fullmatch(q.things[0]):
            continue
        same = asked.reader.pending[asked.reader.number(q)]
        # Every reading has a stand-in of its own.
        found = (s for s in by_name(asked.raw[0].free_symbols) if asked.reader.pending.get(s) == same)
        yield from ((s, f"v_{q.things[0]}{kinds[0]}", q.at) for s in found)


def is_worth_a_letter(formula: sp.Expr) -> bool:
    return LEAST <= operations(formula) <= MOST and not formula.is_number
