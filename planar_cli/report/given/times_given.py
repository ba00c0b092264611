"""Times that a file gives for states, where nothing else on the page tells them: a find may be the same long after."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import takewhile

from planar_cli.problem.language.expression import Name, Relation
from planar_cli.problem.language.walk import names_of_states, walk
from planar_cli.report.document.blocks import Block, Equation, Math, line
from planar_cli.report.words.state_words import at
from planar_cli.report.words.words import Phrases
from planar_cli.solve.between.trace.trace import MotionTrace


def with_times_given(way: Sequence[Block], found: MotionTrace, phrases: Phrases) -> list[Block]:
    """The way with such lines first, among the times with which it begins in the order of the states."""
    times = list(_times_given(found, phrases))
    first = list(takewhile(lambda b: bool(_dated(b)), way)) if times else []
    states = [f"t__{name}" for name in found.states]
    if not all(_dated(b) in states for b in (*times, *first)):
        return [*times, *way]
    return [*sorted((*times, *first), key=lambda b: states.index(_dated(b))), *way[len(first) :]]


def _times_given(found: MotionTrace, phrases: Phrases) -> Iterator[Block]:
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


def _dated(block: Block) -> str:
    """The letter of a time of a state that a line without a number gives; "" of any other block."""
    own = block.sides[0] if isinstance(block, Equation) and block.number is None else None
    letter = own[0] if isinstance(own, tuple) and len(own) == 1 else own
    name = letter.expr.name if isinstance(letter, Math) and letter.expr.is_Symbol else ""
    return name if name.startswith("t__") else ""


def _gives_time(relation: Relation) -> bool:
    """Is it `t = 3 s`?"""
    plain = any(isinstance(s, Name) and s.name == "t" and s.at is None for s in (relation.left, relation.right))
    count = sum(isinstance(n, Name) and n.name == "t" for n in walk(relation))
    return plain and count == 1 and relation.operator == "="
