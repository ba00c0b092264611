"""Times that a file gives for states, where nothing else on the page tells them: a find may be the same long after."""

from __future__ import annotations

from collections.abc import Iterator

from planar_cli.problem.expression import Name, Relation
from planar_cli.problem.walk import names_of_states, walk
from planar_cli.report.blocks import Block, Equation, Math, line
from planar_cli.report.state_words import at
from planar_cli.report.words import Phrases
from planar_cli.solve.between.trace import MotionTrace


def times_given(found: MotionTrace, phrases: Phrases) -> Iterator[Block]:
    """A line for each state that a find names, the time of which is given and in no step of the way."""
    told = {r.unknown for step in found.route.steps for r in step.results}
    told |= {s for step in found.route.steps for e in step.relations for s in e.residual.free_symbols}
    times = {s.name: s for s, general in found.general.items() if general.name == "t"}
    asked = {name for r in found.requests for name in names_of_states(r.find.found.what)}
    for state in found.problem.states[1:]:
        t = times.get(f"t__{state.name}")
        dated = any(_gives_time(r) for r in state.relations if isinstance(r, Relation))
        if t is not None and t not in told and state.name in asked and dated and phrases.value.known(t) is not None:
            yield Equation((line(Math(t)), phrases.shown(t)), None, line(at(state.name, "as given")))


def _gives_time(relation: Relation) -> bool:
    """Is it `t = 3 s`?"""
    plain = any(isinstance(s, Name) and s.name == "t" and s.at is None for s in (relation.left, relation.right))
    count = sum(isinstance(n, Name) and n.name == "t" for n in walk(relation))
    return plain and count == 1 and relation.operator == "="
