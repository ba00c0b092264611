"""How often the direction to a place has turned round since the first state, counted along the motion that is followed.

Where a place is written with an angle that goes on, its turns are in it. Elsewhere, as of a particle in x and y, the
direction alone tells no turns.
"""

from __future__ import annotations

import math
from dataclasses import replace

import sympy as sp

from planar_cli.equation.system.setup import has_quantity
from planar_cli.errors import Diagnostic, NoSolution, Undecided
from planar_cli.problem.language.expression import Quantity, Relation, Statement
from planar_cli.problem.scene.scene import State
from planar_cli.solve.between.branches.solved_motion import SolvedMotion
from planar_cli.solve.regimes.timeline import is_place_angle


def count_turns(found: SolvedMotion) -> None:
    """Put the whole turns into the angles of places that finds and states ask for at other states.

    NoSolution: a state gives such an angle, and the direction is reached after other turns.
    """
    if found.followed is None or found.followed.run is None:
        return
    for reader in found.course.distinct_readers():
        for symbol, q in reader.winding.items():
            other, state, value = reader.pending[symbol]
            angle = _angle(found, q, state)
            number = found.value.known(other.at(found.course.stops[state], value))
            told = math.remainder(angle, 2 * math.pi) if number is None else float(number)
            turns = round((angle - told) / (2 * math.pi))
            reader.pending[symbol] = other, state, value + 2 * sp.pi * turns
        reader.winding.clear()
    for later in found.course.states[1:]:
        for relation in later.relations:
            _demand_turns(found, later, relation)


def _demand_turns(found: SolvedMotion, state: State, relation: Statement) -> None:
    """NoSolution: an angle of a place that a state gives is not the one that was reached."""
    if not isinstance(relation, Relation) or relation.operator != "=":
        return
    reader = found.course.readers[state.name]
    for side, other in ((relation.left, relation.right), (relation.right, relation.left)):
        if not is_place_angle(side) or side.at is not None or has_quantity(other):
            continue
        stated = float(found.value(reader.at(found.course.stops[state.name], reader.number(other))))
        angle = _angle(found, side, state.name)
        if abs(angle - stated) > 1:
            reached = f"{math.degrees(angle):.4g} deg"
            text = f"state {state.name}: `{relation.text}` holds up to whole turns only: there it is {reached}"
            hint = "angles of places count turns from the first state: give the angle that is reached"
            raise NoSolution([Diagnostic(relation.mark, "PL621", text, hint)])


def _angle(found: SolvedMotion, q: Quantity, state: str) -> float:
    """The direction to a place at a state, with its turns from the first state on."""
    assert found.followed is not None
    assert found.followed.run is not None
    measures = found.followed.run.measures
    moment = measures.moments.get(state)
    if moment is None:
        raise Undecided(f"the turns of `{q.word}(…).angle` at state {state} can not be counted: it is not reached")
    return measures.number(replace(q, at=None), moment)
