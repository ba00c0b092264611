"""Heat: the power that joints and wasteful loads take out of a motion.

Of a contact that slips -F · (speed of slip), also on a belt; else -(F · v + M ω) of all that a joint does.
"""

from __future__ import annotations

from planar_cli.loads.base import Load
from planar_cli.motion.regime.guards import speed_of
from planar_cli.motion.regime.held import Held
from planar_cli.motion.regime.regime import Regime
from planar_cli.motion.scene.quantities import Quantities
from planar_cli.motion.scene.scene import MovingScene
from planar_cli.motion.terms.terms import Term
from planar_cli.problem.scene.acting import kind_of
from planar_cli.problem.scene.geometry import Vec


def heat_of(name: str, quantities: Quantities, regime: Regime, scene: MovingScene) -> Term:
    """What a joint takes [W]; `all`: what all joints and all loads that waste energy do."""
    reactions, graph = quantities.reactions, quantities.scene.graph
    assert reactions is not None
    total = graph.number(0.0)
    for held in regime.parts.held:
        if name in ("all", reactions.joints.get(held.joint, held.joint)):
            total = total + _lost(held, quantities, scene)
    for w in reactions.wrenches:
        load = kind_of(w)
        own = load is None and reactions.joints.get(w.name, w.name) == name
        if own or (name == "all" and (load or Load).dissipates):
            total = total - _power(w.force, w.couple, w.point, w.body, quantities)
    return total


def _lost(held: Held, quantities: Quantities, scene: MovingScene) -> Term:
    """What the pushes of one joint take."""
    reactions, graph = quantities.reactions, quantities.scene.graph
    assert reactions is not None
    pushes = [(p, size) for p, size in reactions.pushes if p.joint == held.joint]
    friction = [size for p, size in pushes if p.kind == "friction"]
    if friction and held.mode.sliding is not None:
        slip: Term = -friction[0] * speed_of(graph, scene, held.mode.sliding)
        return slip
    total = graph.number(0.0)
    for p, size in pushes:
        for a in p.actions:
            total = total - size * _power(a.force, graph.of(a.couple), a.point, a.body, quantities)
    return total


def _power(force: Vec | None, couple: Term, point: Vec, body: str, quantities: Quantities) -> Term:
    """F · v + M ω of what acts at a point of a body."""
    scene = quantities.scene
    spin = couple * scene.turn(body)
    return spin if force is None else scene.graph.of(force.dot(scene.velocity(point, body))) + spin
