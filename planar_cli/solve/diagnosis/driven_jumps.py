"""A law of `motion` that takes hold in a state where the speed that it gives is another one as the state arrives.

Parts that are driven alone may be told so, as an ideal crank is. What they carry gets a blow, of which the file says
nothing: with which velocities it goes on is open then.
"""

from __future__ import annotations

from decimal import Decimal

from planar_cli.equation.values.exact import Unvalued, Valuation
from planar_cli.errors import Diagnostic, NoValue
from planar_cli.problem.language.expression import Quantity, Relation
from planar_cli.problem.language.walk import walk
from planar_cli.solve.between.equations.motion_equations import MotionEquations
from planar_cli.solve.diagnosis.words import in_unit, unit_of

JUMPS = Decimal("1e-6")
"""By more than this part of its size a speed is another one."""
SPEEDS = frozenset(("v", "omega", "dot"))


def driven_jump(course: MotionEquations, value: Valuation) -> Diagnostic | None:
    """What is driven at another speed at once, and how a blow is written; None: nothing is."""
    for law in course.problem.motion:
        told = law.statement
        state = law.during[0] if law.during is not None else ""
        if state not in course.stops or state == course.states[0].name or not isinstance(told, Relation):
            continue
        driving = next((q for q in _speeds(told) if q.things), None)
        if driving is None:
            continue
        reader, stop = course.readers[state], course.stops[state]
        try:
            evaluator = reader.quantities().evaluator
            left, right = (value(stop.at(evaluator.value(side))) for side in (told.left, told.right))
        except (Unvalued, NoValue):
            continue
        if abs(left - right) <= JUMPS * max(abs(left), abs(right)):
            continue
        instant = reader.regime.general.instant
        before = in_unit(left, unit_of(instant, told.left, told.right), course.ledger.us)
        driven = told.text.split("=")[0].strip()
        text = f"`{told.text}` from state {state} on, where {driven} is {before} as it arrives: that takes a blow"
        thing, size = driving.things[0], "moment" if driving.word == "omega" else "magnitude"
        blow = (
            f"a state `[just after {state}, {told.text}]` next, an `impulse` on {thing} up to it with an unknown {size}"
        )
        hint = f"write the blow: {blow}, and this law from that state on; or let the speed change in time"
        return Diagnostic(told.mark, "PL639", text, hint)
    return None


def _speeds(relation: Relation) -> list[Quantity]:
    return [n for n in walk(relation) if isinstance(n, Quantity) and n.word in SPEEDS]
