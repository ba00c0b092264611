"""A motion that the file writes down beside forces: places that nothing holds, laws kept up by a force of their own."""

from __future__ import annotations

from collections.abc import Iterable

import sympy as sp

from planar_cli.errors import Diagnostic, NoSolution
from planar_cli.problem.expression import Relation
from planar_cli.problem.scene import Problem
from planar_cli.solve.instant.asked import names_anywhere
from planar_cli.solve.instant.instant import Instant


def placed_by_nothing(instant: Instant) -> NoSolution | None:
    """What to say where equations of motion contradict each other; None: a joint acts on every body that is so placed.

    A formula of fewer coordinates than the body has freedoms is a constraint, and a constraint takes reactions.
    """
    scene = instant.scene
    held = {a.body for _, modes in instant.modes for m in modes for push in m.facts.pushes for a in push.actions}
    for body in scene.problem.bodies:
        model = scene.bodies[body.name]
        inside = (model.center.x + model.center.y + model.theta).free_symbols & set(scene.ledger.coordinates)
        if not inside or body.name in held or len(inside) >= (3 if scene.rigid(body.name) else 2):
            continue
        names = " and ".join(sorted(s.name for s in inside))
        text = f"the place of {body.name} is written with {names}, but no joint holds it so, nor do the loads"
        hint = "add the joint that does: a guide, a pin, a link, rolling on a surface"
        return NoSolution([Diagnostic(body.mark, "PL602", text, hint)])
    return None


def driven_with(problem: Problem, sought: Iterable[sp.Symbol]) -> str:
    """What a law of `motion` with a sought constant means among loads; "" where there is none."""
    names = {s.name for s in sought}
    for law in problem.motion if problem.loads else ():
        said = law.statement
        if isinstance(said, Relation) and names & (names_anywhere(said.left) | names_anywhere(said.right)):
            return (
                f"`{said.text}` in `motion` is kept up by a force of its own, whatever acts: put into the states"
                " what is known of the motion that the loads bring about, its place and velocity at the start, say"
            )
    return ""
