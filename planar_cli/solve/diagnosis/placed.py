"""A motion that the file writes down beside forces: places that nothing holds, laws kept up by a force of their own."""

from __future__ import annotations

from collections.abc import Iterable, Sequence

import sympy as sp

from planar_cli.errors import Diagnostic, NoSolution
from planar_cli.problem.language.expression import Function, Relation
from planar_cli.problem.language.walk import walk
from planar_cli.problem.scene.scene import Problem
from planar_cli.solve.diagnosis.clash import clash, parts_of, sources
from planar_cli.solve.diagnosis.words import listed
from planar_cli.solve.instant.asked import names_anywhere
from planar_cli.solve.instant.instant import Instant, Trial
from planar_cli.solve.solution import Found

HINT = "add the joint that does, or correct it: a guide, a pin, a link, rolling on a surface"


def placed_by_nothing(instant: Instant) -> NoSolution | None:
    """What to say where equations of motion contradict each other; None: a joint acts on every body that is so placed.

    A formula of fewer coordinates than the body has freedoms is a constraint, and a constraint takes reactions.
    """
    return _unheld(instant, [b.name for b in instant.scene.problem.bodies])


def not_held_at(instant: Instant, trial: Trial) -> NoSolution | None:
    """The same at one instant, where bodies with mass contradict themselves; None: it is not for want of a joint."""
    if trial.objection == "velocities":
        return None
    texts = sources(trial)
    bodies, joints = parts_of(instant, texts)
    stated = any(r.text in texts for r, _ in instant.statements.relations)
    if stated or joints or any(instant.scene.bodies[b].mass == 0 for b in bodies):
        return None
    return _unheld(instant, bodies) or held_by_too_little(instant, trial)


def _unheld(instant: Instant, bodies: Sequence[str]) -> NoSolution | None:
    """What to say of the first of these bodies whose place is so written, and on which no joint acts."""
    held = {a.body for _, modes in instant.modes for m in modes for push in m.facts.pushes for a in push.actions}
    for body in (b for b in instant.scene.problem.bodies if b.name in bodies):
        if body.name not in held and (names := _written_with(instant, body.name)):
            text = f"the place of {body.name} is written with {names}, but no joint holds it so, nor do the loads"
            return NoSolution([Diagnostic(body.mark, "PL602", text, HINT)])
    return None


def held_by_too_little(instant: Instant, trial: Trial) -> NoSolution:
    """What to say where equations of motion contradict each other though joints act on every body that is so placed."""
    bodies, _ = parts_of(instant, sources(trial))
    placed = {name: names for name in bodies if (names := _written_with(instant, name))}
    if not placed:
        return NoSolution([clash(instant, trial, instant.scene.problem.find[0].mark)])
    names = listed(dict.fromkeys(placed.values()))
    text = f"the joints and loads do not hold {listed(placed)} as written with {names}: "
    text += f"the equations of motion of {listed(bodies)} contradict each other"
    mark = next(b.mark for b in instant.scene.problem.bodies if b.name in placed)
    return NoSolution([Diagnostic(mark, "PL602", text, HINT)])


def _written_with(instant: Instant, name: str) -> str:
    """The coordinates with which the place of a body is written, if they are fewer than its freedoms."""
    scene = instant.scene
    model = scene.bodies[name]
    inside = (model.center.x + model.center.y + model.theta).free_symbols & set(scene.ledger.coordinates)
    constrains = len(inside) < (3 if scene.rigid(name) else 2)
    return " and ".join(sorted(s.name for s in inside)) if constrains else ""


def driven_with(problem: Problem, sought: Iterable[sp.Symbol] | None) -> str:
    """What a law of `motion` with a sought constant (None: any law, best one with an unknown of the file) means among
    loads; "" where there is none.
    """
    said = [law.statement for law in problem.motion if isinstance(law.statement, Relation)] if problem.loads else []
    names = {u.name for u in problem.unknowns} if sought is None else {s.name for s in sought}
    held = [r for r in said if names & (names_anywhere(r.left) | names_anywhere(r.right))]
    chosen = next(iter([*held, *(said if sought is None else [])]), None)
    if chosen is None:
        return ""
    hint = (
        f"`{chosen.text}` in `motion` is kept up by a force of its own, whatever acts: put into the states"
        " what is known of the motion that the loads bring about, its place and velocity at the start, say"
    )
    if {n.name for n in walk(chosen) if isinstance(n, Function)} & {"sin", "cos"}:
        hint += "; the amplitude of the steady vibration is read where it `is largest` long after a start at rest"
    return hint


def told_throughout(problem: Problem, found: Iterable[Found]) -> tuple[Found, ...]:
    """Formulas that hold throughout. NoSolution: one has a constant that is sought, and that nothing tells."""
    every = tuple(found)
    inside = {x.name for f in every for e in f.asked for x in e.free_symbols}
    loose = [u for u in problem.unknowns if u.name in inside]
    if loose:
        names = listed(u.name for u in loose)
        text = f"{names} {'are' if loose[1:] else 'is'} open: no state and no instant tells enough"
        hint = driven_with(problem, None) or "give `states`, or an `instant`, and what is known there"
        raise NoSolution([Diagnostic(loose[0].mark, "PL623", text, hint)])
    return every
