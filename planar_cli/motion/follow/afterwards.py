"""What a file leaves open of how the partners of a plastic impact go on, after the states that it acts between.

Partners that touch stay in contact as long as they press on each other, and slide along each other where nothing holds
them. That has no meaning where they are drawn beside each other, or where both are points.
"""

from __future__ import annotations

import math
from collections.abc import Collection, Sequence

from planar_cli.base_units import in_base
from planar_cli.joints.base import Joint
from planar_cli.motion.regime.guards import speed_of
from planar_cli.motion.regime.hybrid import HybridModel
from planar_cli.motion.regime.model import Choice
from planar_cli.motion.scene.encounters import Encounter
from planar_cli.motion.terms.source import compiled
from planar_cli.motion.terms.terms import Term
from planar_cli.problem.scene.outlines import meeting_place
from planar_cli.units import LENGTH, default_unit

BEGINS = 1e-4
"""A joint begins to hold what is closer than this part of the scene's length: places of the file have some four digits.
"""
TOUCHES = 1e-6
"""Partners touch that are closer than this part of the scene's length."""
STILL = 1e-6
"""Points do not slide along each other below this part of the speeds of the scene, within its time."""
SOON = 1e-3
"""In parts of the scene's time: so long they are looked at."""


def drawn_apart(
    model: HybridModel, t: float, y: Sequence[float], struck: Collection[str] = ()
) -> tuple[str, str] | None:
    """The impact whose partners are not at one place after it, and what is open then; None: there is none. `struck`:
    the encounters of a blow that has just been.
    """
    plastic = {
        impact: [e for e in found if e.plastic and (e.over or e.name in struck)]
        for impact, found in model.encounters.items()
    }
    for impact, encounters in plastic.items():
        gap = min(map(abs, _numbers(model, [e.distance for e in encounters], t, y)), default=0.0)
        if gap > TOUCHES * model.scales.length:
            one, other = _names(encounters[0])
            us = model.scene.problem.us
            unit = default_unit(LENGTH, us=us)
            return impact, (
                f"after the plastic impact {one} and {other} are {gap / in_base(unit, us):.3g} {unit.text} apart "
                "as they are drawn, and nothing holds them"
            )
    return None


def begun_apart(model: HybridModel, begun: Sequence[Joint], t: float, y: Sequence[float]) -> tuple[str, str] | None:
    """The joint of those that begin now whose partners do not touch, and by how much; None: all do."""
    scene = model.scene
    for joint in begun:
        one, other = getattr(joint, "between", ("", ""))
        place = meeting_place(scene, (one, other), getattr(joint, "at", ""))
        off = scene.spot(one, place, joint.during) - scene.spot(other, place, joint.during)
        gap = math.hypot(*_numbers(model, [scene.graph.of(off.x), scene.graph.of(off.y)], t, y))
        if gap > BEGINS * model.scales.length:
            us = scene.problem.us
            unit = default_unit(LENGTH, us=us)
            size = f"{gap / in_base(unit, us):.3g} {unit.text}"
            return joint.name, f"{joint.name} begins, and {one} is {size} away from {other}"
    return None


def sliding_points(model: HybridModel, choice: Choice, t: float, y: Sequence[float]) -> tuple[str, str] | None:
    """The impact whose partners are points that press on each other and would slide along each other; None: none."""
    indices = model.chosen(choice)
    held = [e for e in model.lasting if e.gap.points and not model.modes[e.name][indices[e.name]].parted]
    if not held:
        return None
    regime = model.regime(choice)
    forces = {p.joint: abs(n) for p, n in zip(regime.reactions, regime.forces(t, y), strict=True) if p.kind == "normal"}
    step = SOON * model.scales.time
    soon = [v + step * r for v, r in zip(y, regime.rates(t, y), strict=True)]
    speeds = [speed_of(model.graph, model.scene, e.sliding) for e in held]
    now, then = (_numbers(model, speeds, t, state) for state in (y, soon))
    for encounter, before, after in zip(held, now, then, strict=True):
        slides = max(abs(before), abs(after - before) / SOON) > STILL * model.scales.speed
        if slides and forces.get(encounter.name, 0.0) > STILL * model.scales.force:
            one, other = _names(encounter)
            return encounter.impact, (
                f"after the plastic impact {one} and {other} press on each other and move along each other, "
                "and points have no faces"
            )
    return None


def _names(encounter: Encounter) -> tuple[str, str]:
    return encounter.gap.first, encounter.gap.second


def _numbers(model: HybridModel, terms: Sequence[Term], t: float, y: Sequence[float]) -> list[float]:
    layout = model.layout
    return list(compiled(terms, layout.state, layout.time).function(t, y)) if terms else []
