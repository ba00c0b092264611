"""Pulls of cords that unwind, and belts: what leaves a rim leaves it along the rim."""

from __future__ import annotations

from collections.abc import Iterator
from decimal import Decimal

import sympy as sp

from planar_cli.equation.scene.scene import Scene
from planar_cli.errors import Diagnostic
from planar_cli.problem.language.expression import Name, Quantity
from planar_cli.problem.language.walk import walk
from planar_cli.problem.scene.geometry import Vec
from planar_cli.problem.scene.scene import Round

ROUNDED = Decimal("5e-4")
"""Places are drawn with some four digits: a length may differ from their distance by this part."""


def untaut(scene: Scene) -> Iterator[Diagnostic]:
    """Forces `wound_at` a rim that do not pull along it, and belts of which no straight part touches both disks."""
    yield from _across_rims(scene)
    yield from _belts(scene)


def _across_rims(scene: Scene) -> Iterator[Diagnostic]:
    value, drums = scene.valuations[0], {b.name: b.shape for b in scene.problem.bodies if isinstance(b.shape, Round)}
    for load in scene.problem.loads:
        rim, body = getattr(load, "wound_at", None), getattr(load, "body", "")
        if rim is None or body not in drums:
            continue
        pull = _pull(scene, load, rim)
        if pull is None:
            continue
        arm = scene.point(rim) - scene.point(drums[body].center)
        inward, sizes = sp.sympify(pull.dot(arm)), sp.sympify(pull.dot(pull) * arm.dot(arm))
        if scene.rests_on_sought(inward) or abs(value(inward)) <= ROUNDED * value(sizes).sqrt():
            continue
        text = f"{load.called} pulls on a cord that leaves {body} at {rim}, and not at right angles to the radius there"
        hint = f"put {rim} where a cord in this direction leaves the rim, or write `at: {rim}` where nothing unwinds"
        yield Diagnostic(load.mark, "PL522", text, hint)


def _pull(scene: Scene, load: object, rim: str) -> Vec | None:
    """The direction of a force; None: it turns, or rests on more than numbers."""
    towards, angle = getattr(load, "towards", None), getattr(load, "angle", None)
    if towards is not None:
        return scene.point(towards) - scene.point(rim)
    if angle is None or getattr(load, "relative_to", None) is not None:
        return None
    if any(isinstance(n, Quantity) or (isinstance(n, Name) and n.name == "t") for n in walk(angle)):
        return None
    return scene.unit(angle)


def _belts(scene: Scene) -> Iterator[Diagnostic]:
    """With letters the sizes are not compared: they may be such that it fits."""
    value = scene.valuations[0]
    for joint in scene.problem.joints if not scene.ledger.symbolic else ():
        between: tuple[str, ...] = getattr(joint, "between", ())
        if joint.kind != "belt" or any(not isinstance(scene.bodies[b].shape, Round) for b in between):
            continue
        one, other = between
        reach = scene.center(other) - scene.center(one)
        crossed = bool(getattr(joint, "crossed", False))
        across = sp.sympify(scene.radius(one) + scene.radius(other) * (1 if crossed else -1))
        apart = sp.sympify(reach.dot(reach))
        if scene.rests_on_sought(apart) or scene.rests_on_sought(across) or value(apart) > value(across) ** 2:
            continue
        if value(apart) == 0:
            # Of disks with one centre the belt itself tells.
            continue
        text = (
            f"no {'crossed ' if crossed else ''}belt runs straight from {one} to {other}: they are too near each other"
        )
        hint = "draw them farther apart, or correct a radius"
        yield Diagnostic(joint.mark, "PL522", text, hint)
