"""Joints that the file calls by a point which they do not name: `N(A)` of a contact without `at`, where only one can be
meant. A particle touches at its own point, a rim at the one through which its floor goes.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from typing import Any

from planar_cli.joints.base import Joint
from planar_cli.problem.language.expression import Quantity
from planar_cli.problem.scene.scene import Line, Problem


def with_joints_called(problem: Problem) -> Problem:
    """The problem in which a joint is at the point by which alone a quantity asks for it, and has its name."""
    said = (problem.loads, problem.motion, problem.instant, problem.states, problem.find)
    asked = {(q.things[0], q.word) for q in _quantities(said) if q.things}
    taken = {e.name for entries in (problem.joints, problem.loads, problem.bodies) for e in entries}
    joints: list[Any] = list(problem.joints)
    found: set[str] = set()
    for point in (p.name for p in problem.points if p.name not in taken):
        words = {word for name, word in asked if name == point}
        meant = [
            i for i, joint in enumerate(joints) if words.intersection(joint.quantities) and _at(joint, problem) == point
        ]
        own = [(joints[i].name, word) for i in meant for word in joints[i].quantities]
        if len(meant) == 1 and asked.isdisjoint(own):
            found.add(joints[meant[0]].at)
            joints[meant[0]] = replace(joints[meant[0]], name=point, at=point)
    left = {j.at for j in joints if j.touches}
    points = tuple(p for p in problem.points if p.name not in found - left)
    return replace(problem, joints=tuple(joints), points=points)


def _at(joint: Joint, problem: Problem) -> str | None:
    """The point at which two bodies touch: the one told, a particle's own, else that through which a floor goes."""
    if not joint.touches:
        return None
    touching: Any = joint
    if any(p.name == touching.at and p.mark != joint.mark for p in problem.points):
        return str(touching.at)
    shapes = [s.shape for s in problem.surfaces if s.name in touching.between]
    return next((shape.through for shape in shapes if isinstance(shape, Line)), None)


def _quantities(value: Any) -> Iterator[Quantity]:
    """All quantities in a value, however deep."""
    if isinstance(value, Quantity):
        yield value
    if isinstance(value, tuple):
        for item in value:
            yield from _quantities(item)
    for slot in (s for kind in type(value).__mro__ for s in getattr(kind, "__slots__", ())):
        yield from _quantities(getattr(value, slot))
