"""The kinetic energies of which a share is made up, each by its letter on a line of its own before it.

share = 1 - T_2/T_1   after   T_1 = 1/2 m v_0²,  T_2 = 1/2 I_C ω_2²
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import sympy as sp

from planar_cli.equation.algebra.counting import operations
from planar_cli.equation.algebra.plain import by_name
from planar_cli.problem.language.expression import Binary, Quantity, Relation
from planar_cli.problem.language.outermost import quantities_in
from planar_cli.problem.language.walk import walk
from planar_cli.solve.between.equations.asked_finds import AskedFind
from planar_cli.solve.roads import is_curve

WORD = "KE"
MOST = 40
"""A longer energy is no help, also without what is zero in it."""


def energies_inside(asked: AskedFind, letter: str) -> Iterator[tuple[sp.Symbol, str, str]]:
    """The stand-ins of kinetic energies in a find that divides by one, each with its letter, which is `letter`, and its
    state; none where energies of several bodies are meant.
    """
    what = asked.find.found.what
    if isinstance(what, Quantity | Relation) or is_curve(what) or len(asked.raw) != 1 or not _is_share(what):
        return
    energies = [q for q in quantities_in(what) if q.word == WORD]
    if len({q.things for q in energies}) != 1 or not all(isinstance(q.at, str) for q in energies):
        return
    for state, q in {str(q.at): q for q in energies}.items():
        same = asked.reader.pending.get(asked.reader.number(q))
        found = (s for s in by_name(asked.raw[0].free_symbols) if asked.reader.pending.get(s) == same)
        yield from ((s, letter, state) for s in found)


def energy_is_worth_a_letter(formula: sp.Expr) -> bool:
    return not formula.is_number and operations(formula) <= MOST


def _is_share(what: Any) -> bool:
    """Does it divide by a kinetic energy alone?"""
    quotients = (n for n in walk(what) if isinstance(n, Binary) and n.operator == "/")
    return any(isinstance(n.right, Quantity) and n.right.word == WORD for n in quotients)
