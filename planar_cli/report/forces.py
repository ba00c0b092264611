"""Free-body diagram = kinetic diagram, in words: the force list of each body that the equations use."""

from __future__ import annotations

from typing import Any

import sympy as sp

from planar_cli.problem.facts import Push
from planar_cli.report.blocks import Forces, Line, Math, Text
from planar_cli.report.words import Phrases
from planar_cli.solve.solution import InstantSolution
from planar_cli.solve.stages import Stage


def force_rows(instant: InstantSolution, stage: Stage, phrases: Phrases) -> list[Forces]:
    """One row for each body that takes part in the kinetic equations."""
    bodies: list[str] = []
    for block in stage.blocks:
        for w in block.equations:
            bodies += [b for b in w.bodies if b not in bodies]
    order = [b for b in instant.instant.scene.bodies if b in bodies]
    return [Forces(body, _acting(instant, body, phrases), _inertia(instant, stage, body)) for body in order]


def _acting(instant: InstantSolution, body: str, phrases: Phrases) -> Line:
    system = instant.trial.system
    parts: list[list[Any]] = []
    for w in system.wrenches:
        if w.body == body:
            where = _at(instant, w.point) if w.kind != "weight" else f"at {instant.instant.scene.center_name(body)}"
            if w.force is not None:
                parts.append([phrases.math(w.magnitude), Text(f" {phrases.arrow(w.force.x, w.force.y)} {where}")])
            elif w.couple != 0:
                parts.append([phrases.math(w.couple), Text(" ↺")])
    assert system.reactions is not None
    for push, expr in system.reactions.pushes:
        for action in push.actions:
            if action.body == body:
                parts.append(_push(push, expr, action, phrases))
    joined: list[Any] = []
    for i, part in enumerate(parts):
        joined += [Text(",  ")] * bool(i) + part
    return tuple(joined)


def _push(push: Push, expr: sp.Expr, action: Any, phrases: Phrases) -> list[Any]:
    if action.force is None:
        sign = phrases.value(sp.sympify(action.couple))
        return [Math(expr), Text(" ↺" if sign > 0 else " ↻")]
    assumed = " (assumed)" if push.kind == "friction" and expr.is_Symbol else ""
    return [Math(expr), Text(f" {phrases.arrow(action.force.x, action.force.y)} at {push.place}{assumed}")]


def _at(instant: InstantSolution, point: Any) -> str:
    """The name of a place."""
    scene, value = instant.instant.scene, instant.value
    for name, place in scene.points.items():
        if all(value.is_zero(getattr(place, a) - getattr(point, a)) for a in ("x", "y")):
            return f"at {name}"
    return ""


def _inertia(instant: InstantSolution, stage: Stage, body: str) -> Line:
    """m a_G and I α of a body."""
    scene = instant.instant.scene
    model = scene.bodies[body]
    parts: list[Any] = []
    if model.mass != 0:
        components = stage.accelerations.get(body, [])
        for direction, component in components:
            value = instant.value
            x, y = value(direction.x), value(direction.y)
            arrow = "→" if not y else "↑" if not x else "↗"
            parts += [Text(",  ")] * bool(parts) + [Math(sp.Mul(model.mass, component, evaluate=False)), Text(f" {arrow} at {scene.center_name(body)}")]
    alpha = instant.trial.system.motion.accelerations[body].angular if instant.trial.system.motion and model.rigid else sp.S.Zero
    if model.inertia != 0 and alpha != 0:
        parts += [Text(",  ")] * bool(parts) + [Math(model.inertia * alpha), Text(" ↺")]
    return tuple(parts) or (Text("0"),)
