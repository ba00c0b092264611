"""Which way a body turns after a blow, where that is known before anything is worked out: then that way counts as
positive in all its motion.

A body that does not turn at first gets or keeps its angular momentum about the point at which the ground holds or
supports it: no impulse through that point, and no friction there, changes its sense.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import replace

import sympy as sp

from planar_cli.equation.scene.scene import Scene
from planar_cli.equation.system.setup import Earlier, Setup
from planar_cli.equation.system.system import Statements
from planar_cli.joints.base import Joint
from planar_cli.problem.language.expression import AtRest, JustAfter, Quantity, Relation
from planar_cli.problem.scene.facts import Joining
from planar_cli.problem.scene.geometry import Vec
from planar_cli.problem.scene.scene import GROUND, Body, Line, Particle, Problem, Rod, Round
from planar_cli.solve.principled import at_instants


def counted_as_struck(problem: Problem, earlier: Mapping[str, Earlier]) -> Problem:
    """The same problem, in which the rotation of its only body counts clockwise where a blow turns it so."""
    body, joint = _only(problem)
    if body is None or joint is None or not any(_is_after_blow(s.relations) for s in problem.states):
        return problem
    scene = Setup(problem, Statements.of((), ()), earlier, True).scene
    at = _held_at(scene, joint, body)
    if at is None or not scene.is_zero(scene.bodies[body.name].theta):
        return problem
    senses = {scene.sign(sp.sympify(m)) for m in _momenta(scene, body.name, at)} - {0}
    return replace(problem, turning=(body.name,)) if senses == {-1} else problem


def _only(problem: Problem) -> tuple[Body | None, Joint | None]:
    """The only body, and the only joint, which holds or supports it at the ground; no force but its weight acts."""
    if len(problem.bodies) != 1 or len(problem.joints) != 1 or problem.coordinates:
        return None, None
    (body,), (joint,) = problem.bodies, problem.joints
    plain = all(x.strikes for x in problem.loads) and not at_instants(problem.method).general
    return (body, joint) if plain and not isinstance(body.shape, Particle | Rod) else (None, None)


def _is_after_blow(relations: tuple[object, ...]) -> bool:
    return any(isinstance(s, JustAfter) for s in relations)


def _held_at(scene: Scene, joint: Joint, body: Body) -> Vec | None:
    """The point of the ground at which a joint holds the body, or on which a round one is supported by a plane."""
    between = getattr(joint, "between", ())
    surface = next((s for s in scene.problem.surfaces if s.name in between and s.body is None), None)
    if surface is None:
        return _pin(scene, joint, body)
    if not isinstance(surface.shape, Line) or not isinstance(body.shape, Round):
        return None
    along, centre = scene.surface_direction(surface), scene.center(body.name)
    away = along.turned()
    side = scene.sign(away.dot(centre - scene.point(surface.shape.through)))
    foot: Vec = centre - away * (side * scene.radius(body.name))
    return foot


def _pin(scene: Scene, joint: Joint, body: Body) -> Vec | None:
    """The point of the ground about which a joint lets the body turn, if it does that alone."""
    modes = () if joint.strikes else joint.modes(scene)
    joinings: tuple[Joining, ...] = modes[0].facts.joinings if len(modes) == 1 else ()
    if len(joinings) != 1 or not joinings[0].only_turns:
        return None
    return joinings[0].point if {joinings[0].mover, joinings[0].base} == {GROUND, body.name} else None


def _momenta(scene: Scene, body: str, at: Vec) -> Iterator[sp.Expr]:
    """The parts of the angular momentum about a point, of the first state and of impulses."""
    first = scene.problem.states[0].relations
    for relation in first:
        if isinstance(relation, AtRest) or not isinstance(relation, Relation) or relation.operator != "=":
            continue
        left = relation.left
        if not isinstance(left, Quantity) or left.word not in ("v", "omega") or len(left.things) != 1:
            continue
        value = scene.value(relation.right)
        if left.word == "omega":
            yield value
        elif left.things[0] in (body, scene.center_name(body)) and len(left.parts) == 1:
            axis = {"x": Vec(sp.S.One, sp.S.Zero), "y": Vec(sp.S.Zero, sp.S.One)}.get(left.parts[0].kind)
            yield sp.S.One if axis is None else (scene.center(body) - at).cross(axis * value)
    # What rolls in the end turns the way in which the blow sends its centre, however high it is struck.
    rolls = isinstance(scene.shape(body), Round)
    for w in (w for load in scene.problem.loads for w in load.impulses(scene)):
        struck = scene.center(body) if rolls else w.point
        yield w.couple + ((struck - at).cross(w.force) if w.force is not None else 0)
