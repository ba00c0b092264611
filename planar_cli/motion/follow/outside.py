"""What acts on a scene from outside, as one force and one moment about the origin: for the balance of its momentum.

    p' = Σ F,   H' = Σ M        of all loads, and of what the joints do to the ground, reversed

What bodies do to each other does not count: whether it cancels is what the balance shows. A mass that grows or shrinks
brings or takes m' v, as seen from the body. A body that is a particle does not turn: what presses on a surface
of it, away from its point, has a moment about that point, which goes to whatever keeps the body from turning, outside.
A joint that is drawn beside the lines on which it acts leaves a moment, which goes the same way.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from planar_cli.motion.regime.hybrid import HybridModel
from planar_cli.motion.regime.regime import Regime
from planar_cli.motion.terms.source import compiled
from planar_cli.motion.terms.terms import Term
from planar_cli.motion.trajectory.automaton import Outside
from planar_cli.problem.scene.facts import Action
from planar_cli.problem.scene.geometry import Vec
from planar_cli.problem.scene.scene import GROUND


def outside_of(model: HybridModel, regime: Regime) -> Outside | None:
    """What acts from outside in a regime; None where drives exert forces that have no place."""
    if model.drives:
        return None
    layout, graph = model.layout, model.graph
    loads: dict[int, Term] = dict(regime.parts.loads)
    for held in regime.parts.held:
        for i, term in held.loads.items():
            loads[i] = loads[i] + term if i in loads else term
    for i, slot in enumerate(layout.slots):
        growth = graph.rate(slot.mass, layout.rates())
        if not (growth.constant and growth.value == 0):
            loads[i] = loads[i] + growth * slot.rate if i in loads else growth * slot.rate
    terms = list(_of_column(model, loads))
    beside = {j.name for j in model.joints if j.drawn_beside}
    for push in regime.reactions:
        force_x, force_y, moment = _to_outside(model, push.actions)
        terms += (force_x, force_y, _left_over(model, push.actions) if push.joint in beside else moment)
    code = compiled([graph.of(t) for t in terms], layout.state, layout.time)
    count = len(regime.reactions)

    def resultant(t: float, y: Sequence[float]) -> tuple[float, float, float]:
        numbers = code.function(t, y)
        total = numbers[:3]
        if count:
            for k, size in enumerate(regime.forces(t, y)):
                total = [a - size * b for a, b in zip(total, numbers[3 * k + 3 : 3 * k + 6], strict=True)]
        return total[0], total[1], total[2]

    scales = model.scales
    linear = scales.energy * scales.time / scales.length
    return Outside(resultant, (linear, linear, linear * scales.length))


def _of_column(model: HybridModel, column: Mapping[int, Term]) -> tuple[Term, Term, Term]:
    """The resultant of a generalized force."""
    layout, zero = model.layout, model.graph.number(0.0)
    force_x, force_y, moment = zero, zero, zero
    for frame in layout.frames.values():
        x, y = column.get(frame.x, zero), column.get(frame.y, zero)
        force_x, force_y = force_x + x, force_y + y
        moment = moment + layout.slots[frame.x].coordinate * y - layout.slots[frame.y].coordinate * x
        if frame.theta is not None:
            moment = moment + column.get(frame.theta, zero)
    return force_x, force_y, moment


def _left_over(model: HybridModel, actions: Sequence[Action]) -> Term:
    """The moment of what a unit of a push does to the bodies, reversed: that of the ground and of guides together."""
    graph, layout = model.graph, model.layout
    moment = graph.number(0.0)
    for action in actions:
        frame = layout.frames.get(action.body)
        if frame is None:
            continue
        moment = moment - graph.of(action.couple) if frame.theta is not None else moment
        if action.force is not None:
            center = Vec(layout.slots[frame.x].coordinate, layout.slots[frame.y].coordinate)
            point = action.point if frame.theta is not None else center
            moment = moment - graph.of(point.cross(action.force))
    return moment


def _to_outside(model: HybridModel, actions: Sequence[Action]) -> tuple[Term, Term, Term]:
    """What a unit of a push does to the ground, and to what keeps the particles from turning."""
    graph, layout = model.graph, model.layout
    force, moment = Vec(graph.number(0.0), graph.number(0.0)), graph.number(0.0)
    for action in actions:
        frame = layout.frames.get(action.body)
        if action.body != GROUND and (frame is None or frame.theta is not None):
            continue
        moment = moment + graph.of(action.couple)
        if action.force is None:
            continue
        if frame is None:
            force, arm = force + action.force, action.point
        else:
            arm = action.point - Vec(layout.slots[frame.x].coordinate, layout.slots[frame.y].coordinate)
        moment = moment + graph.of(arm.cross(action.force))
    return graph.of(force.x), graph.of(force.y), graph.of(moment)
