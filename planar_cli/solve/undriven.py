"""Bodies without mass that nothing drives: states tell their velocities, and no motion leads from one to the next.

Each such state is complete in itself. Velocities of particles that nothing joins do not rest on where they are, so that
they are worked out in every state by itself.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import replace
from typing import Any

from planar_cli.errors import FileProblem, NoSolution
from planar_cli.motion.regime.model import Model
from planar_cli.problem.language.expression import AtRest, Name, Quantity, Relation
from planar_cli.problem.language.walk import names_of_states, walk
from planar_cli.problem.scene.scene import Particle, Problem, State
from planar_cli.simulate.answers import Answered
from planar_cli.simulate.run import BEGINNING, Run, simulate


def nothing_drives(model: Model) -> str:
    """The first body without mass that no joint and no law moves; "" where there is none."""
    held = [model.held(j, k) for j in model.joints for k in range(len(model.modes[j.name]))]
    moved = {i for h in held for c in h.constraints for i in c.row} | {i for d in model.drives for i in d.row}
    free = (s for i, s in enumerate(model.layout.slots) if i not in moved and s.kind in ("x", "y"))
    return next((s.body for s in free if s.mass.constant and s.mass.value == 0), "")


def standing_alone(run: Run) -> dict[str, Answered]:
    """Finds at states to which no motion leads, each from what its state says by itself."""
    problem = run.problem
    if not nothing_drives(run.measures.model) or not _no_place_counts(problem):
        return {}
    found: dict[str, Answered] = {}
    for state in problem.states:
        asked = tuple(f for f in problem.find if _is_of(state, f.found.what))
        if state.name in run.measures.moments or not asked or not _tells_velocities(state.relations):
            continue
        alone = replace(problem, states=(state,), find=asked, answers=())
        try:
            answers = simulate(alone, replace(run.settings, speeds={}, times=BEGINNING)).answers
        except (FileProblem, NoSolution):
            # It is told by other states as well.
            continue
        found |= {a.name: a for a in answers if not a.why}
    return found


def _no_place_counts(problem: Problem) -> bool:
    """Are there only particles that nothing joins, and laws of their velocities?"""
    particles = all(isinstance(b.shape, Particle) for b in problem.bodies)
    laws = [law.statement for law in problem.motion if law.during is None]
    return particles and not problem.joints and len(laws) == len(problem.motion) and _tells_velocities(laws)


def _tells_velocities(statements: Iterable[Any]) -> bool:
    return all(isinstance(s, AtRest) or (isinstance(s, Relation) and _of_velocities(s)) for s in statements)


def _is_of(state: State, what: Any) -> bool:
    return names_of_states(what) == {state.name} and _of_velocities(what)


def _of_velocities(tree: Any) -> bool:
    """Does it speak of velocities and constants alone?"""
    return all(word == "v" for word in _words(tree))


def _words(tree: Any) -> Iterator[str]:
    for node in walk(tree):
        if isinstance(node, Quantity):
            yield node.word
        elif isinstance(node, Name) and node.name == "t":
            yield node.name
