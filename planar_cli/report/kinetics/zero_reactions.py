"""Reactions that are drawn and are nought, as nothing else acts along them: → ΣF_x: A_x = 0."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from typing import Any

import sympy as sp

from planar_cli.problem.scene.geometry import Vec
from planar_cli.report.document.blocks import Block, Equation, Math, Name, Paragraph, line
from planar_cli.report.words.words import Phrases
from planar_cli.solve.instant.stages import Stage
from planar_cli.solve.solution import InstantSolution

AXES = {"x": Vec(sp.S.One, sp.S.Zero), "y": Vec(sp.S.Zero, sp.S.One)}


def zero_reactions(instant: InstantSolution, stage: Stage, phrases: Phrases, bodies: Iterable[str]) -> Iterator[Block]:
    """One line for each component along an axis that no equation of the plan has, and that is alone along that axis, of
    a reaction whose other component an equation has.
    """
    equations = [w for block in stage.blocks for w in block.equations]
    used = {s for w in equations for s in w.residual.free_symbols}
    system = instant.trial.system
    asked = {p.joint for p in system.pushes if p.kind == "component" and system.symbols[p.name] in used}
    others_of = {system.symbols[p.name] for p in system.pushes if p.joint in asked}
    last = next((w.bodies for w in reversed(equations) if w.law in ("force", "moment")), ())
    told: set[Any] = set()
    for body in bodies:
        for axis, unit in AXES.items():
            own, others = _along(instant, body, unit)
            (push, *more) = own or (None,)
            if push is None or more or others or push in used or push in told or push not in others_of:
                continue
            if phrases.value.known(push) == 0:
                told.add(push)
                lead = line(f"{phrases.arrow(unit.x, unit.y)} ", Name(f"ΣF_{axis}"), ":")
                yield from () if last == (body,) else (Paragraph(line(f"{body}:")),)
                yield Equation((Math(push), phrases.math(sp.S.Zero)), None, lead)


def _along(instant: InstantSolution, body: str, unit: Vec) -> tuple[list[sp.Expr], bool]:
    """The reactions on a body with a part along an axis; does anything else act there, or is the body accelerated?"""
    system, value = instant.trial.system, instant.value
    assert system.reactions is not None
    found = []
    parts = {system.symbols[p.name] for p in system.pushes if p.kind == "component"}
    for push, expr in system.reactions.pushes:
        forces = [a.force for a in push.actions if a.body == body and a.force is not None]
        if any(value.known(force.dot(unit)) != 0 for force in forces):
            found.append(expr)
    if not set(found) <= parts:
        # Whether something presses against a guide, its equation tells.
        return found, True
    loads = [w.force for w in system.wrenches if w.body == body and w.force is not None]
    acting = any(value.known(sp.sympify(force.dot(unit))) != 0 for force in loads)
    motion, model = system.motion, instant.instant.scene.bodies[body]
    if motion is None or model.mass == 0:
        return found, True
    return found, acting or value.known(motion.acceleration(model.center, body).dot(unit)) != 0
