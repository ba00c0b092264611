"""Why a speed relative to something that moves is smallest where it is across the way: it then does no more than cancel
the part of the other velocity across that way.

v_boat = v_stream + v_boat/stream,   v_boat/stream ⊥ v_boat:   along v_boat/stream, 0 = v_stream · e + |v_boat/stream|
"""

from __future__ import annotations

from decimal import Decimal

import sympy as sp

from planar_cli.problem.language.expression import Extreme, Name, Part, Quantity, Relation
from planar_cli.problem.scene.geometry import Vec
from planar_cli.report.document.blocks import Line, line
from planar_cli.report.document.blocks import Name as Letter
from planar_cli.solve.solution import InstantSolution

NEAR = Decimal("1e-12")


def across_what_it_makes(extreme: Extreme, instant: InstantSolution) -> Line:
    """`v_boat/stream is perpendicular to v_boat: it then only cancels the part of v_stream across it.` Empty: what is
    extreme is no such speed, or it is not perpendicular there.
    """
    relative = _relative(extreme, instant)
    if relative is None:
        return ()
    own, other = relative.things
    evaluator = instant.trial.system.quantities().evaluator

    def velocity(*things: str) -> Vec | None:
        parts = ((Part(axis, None, relative.mark),) for axis in "xy")
        found = (evaluator.value(Quantity("v", things, None, part, None, relative.mark)) for part in parts)
        x, y = (instant.value.known(sp.sympify(p)) for p in found)
        return None if x is None or y is None else Vec(x, y)

    way, beside, carried = velocity(own), velocity(own, other), velocity(other)
    if way is None or beside is None or carried is None or not way.dot(way) or not carried.dot(carried):
        return ()
    if abs(way.dot(beside)) > NEAR * (way.dot(way) + beside.dot(beside)):
        return ()
    told = line(Letter(f"v_{own}/{other}"), " is perpendicular to ", Letter(f"v_{own}"))
    return line(*told, ": it then only cancels the part of ", Letter(f"v_{other}"), " across that line.")


def _relative(extreme: Extreme, instant: InstantSolution) -> Quantity | None:
    """v(A/B) of which the size is extreme, by itself or by a letter for it."""
    if isinstance(extreme.side, Quantity):
        return _of_size(extreme.side)
    if not isinstance(extreme.side, Name):
        return None
    for relation, *_ in instant.instant.statements.relations:
        if isinstance(relation, Relation) and relation.operator == "=":
            for one, other in ((relation.left, relation.right), (relation.right, relation.left)):
                if isinstance(one, Name) and one.name == extreme.side.name and isinstance(other, Quantity):
                    return _of_size(other)
    return None


def _of_size(quantity: Quantity) -> Quantity | None:
    """v(A/B).mag"""
    parts = [p.kind for p in quantity.parts]
    return quantity if quantity.word == "v" and len(quantity.things) == 2 and parts == ["mag"] else None
