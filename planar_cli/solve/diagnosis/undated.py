"""States that no relation of theirs dates, as what they state holds all the way from the state before."""

from __future__ import annotations

from collections.abc import Sequence
from decimal import Decimal

from planar_cli.errors import Diagnostic, NoSolution
from planar_cli.problem.language.expression import Quantity, Relation
from planar_cli.problem.language.walk import walk
from planar_cli.solve.between.equations.motion_equations import MotionEquations
from planar_cli.solve.between.roots.chain import Branch
from planar_cli.solve.regimes.mode_sequence import fixed_time

TINY = Decimal("1e-15")
"""A rate below this part of its terms is the rounding of zero."""


def undated(course: MotionEquations, branches: Sequence[Branch]) -> NoSolution | None:
    """What to write where a state says only what holds in the state before, and does not change from there on; None:
    every state says something new. `branches`: solutions of the equations.
    """
    blows = {blow.stop.name for blow in course.blows.values()}
    for i, state in enumerate(course.states):
        demands = [d for d in course.demands[state.name] if d.kind == "equation"]
        if not i or not demands or fixed_time(state.relations) or state.name in blows:
            continue
        before = course.states[i - 1].name
        own, since = course.stops[state.name].letters, course.stops[before]
        earlier = {own[s]: letter for s, letter in since.letters.items() if s in own}
        general = {letter: s for s, letter in own.items()}
        for branch in branches:
            value = course.base().extended(branch.values)
            rates = [since.at(course.regimes[i - 1].derivative(d.residual.xreplace(general))) for d in demands]
            held = [*(d.residual.xreplace(earlier) for d in demands), *rates]
            if all((n := value.known(e)) is not None and abs(n) <= value.size(e) * TINY for e in held):
                texts = ", ".join(dict.fromkeys(f"`{d.text}`" for d in demands))
                text = f"nothing says when state {state.name} is: {texts} holds in state {before} and stays so"
                hint = "give a relation that holds first in this state; what a later one says of it may stand here"
                return NoSolution([Diagnostic(state.mark, "PL623", text, hint)])
    return None


def mode_at_a_time(course: MotionEquations) -> str:
    """What to write where a mode was meant to begin at the given time of its state; "": there is no such state."""
    for state in course.states[1:]:
        told = fixed_time(state.relations)
        modes = [r for r in state.relations if isinstance(r, Relation) and _asks_mode(r)]
        if told is not None and modes:
            begins = f"where `{modes[0].text}` is to begin at `{told.text}`, write the time since the first state"
            return f"{begins}: `t - t @ {course.first.name} = …`; at a given time it only says how it is then"
    return ""


def _asks_mode(relation: Relation) -> bool:
    return any(isinstance(node, Quantity) and node.word == "mode" for node in walk(relation))
