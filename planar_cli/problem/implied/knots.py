"""Knots: particles without mass on a line at which springs join, so that one spring after the other is stretched.

Nothing of a knot resists, so that the springs at it balance all the time. That is a relation between places, and a law
like those of `motion`; a force that would keep it is zero, as it already holds. It is written for small oscillations
about equilibria, in which it is known on which side of its neighbours a knot is: far from there it has other roots.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import fields, replace
from fractions import Fraction
from functools import reduce
from typing import Any

from planar_cli.errors import Mark
from planar_cli.problem.language.expression import Binary, Equilibrium, Law, Number, Part, Quantity, Relation, Side
from planar_cli.problem.language.walk import walk
from planar_cli.problem.scene.scene import Body, Line, Particle, Problem


def with_balanced_knots(problem: Problem) -> Problem:
    """The problem and its cases with that law for every knot; the same object where there are none."""
    cases = tuple(replace(case, problem=with_balanced_knots(case.problem)) for case in problem.cases)
    laws = tuple(law for body in problem.bodies if (law := _balance(problem, body)) is not None)
    if not laws and all(a.problem is b.problem for a, b in zip(cases, problem.cases, strict=True)):
        return problem
    return replace(problem, motion=(*problem.motion, *laws), cases=cases)


def balanced_knots(problem: Problem) -> Iterator[str]:
    """The names of the knots whose balance is such a law."""
    texts = {law.statement.text for law in problem.motion}
    yield from (body.name for body in problem.bodies if _words(body) in texts)


def _words(knot: Body) -> str:
    return f"the springs at {knot.name} balance"


def _balance(problem: Problem, body: Body) -> Law | None:
    """The law of a knot; None: the body is none, or what it joins is more than springs, or `motion` speaks of it."""
    if not body.is_massless or not isinstance(body.shape, Particle) or not problem.states:
        return None
    if not all(any(isinstance(r, Equilibrium) for r in state.relations) for state in problem.states):
        return None
    place = body.shape.place
    own = {body.name, place} if isinstance(place, str) else {body.name}
    joints = [j for j in problem.joints if own & _names_in(j)]
    springs: list[Any] = [load for load in problem.loads if own & _names_in(load)]
    said = any(own & {*n.things} for law in problem.motion for n in walk(law.statement) if isinstance(n, Quantity))
    if len(joints) != 1 or len(springs) < 2 or said or not all(map(_is_plain, springs)):
        return None
    angle = _direction(problem, joints[0])
    if angle is None:
        return None
    mark = body.mark
    pulls = [_pull(spring, own, angle, mark) for spring in springs]
    total = reduce(lambda one, other: Binary("+", one, other, mark), pulls)
    return Law(Relation(total, "=", Number(Fraction(0), None, 1, mark), _words(body), mark), None)


def _is_plain(load: Any) -> bool:
    """Is it a spring that acts all the time, pulls and pushes, and has a length of its own?"""
    return load.kind == "spring" and load.during is None and load.acts is None and load.natural_length is not None


def _direction(problem: Problem, joint: Any) -> Side | None:
    """The direction of the fixed, smooth line on which a guide keeps a point; None: it is none such."""
    if joint.kind != "guide" or joint.during is not None or any((joint.mu, joint.mu_s, joint.mu_k)):
        return None
    if not isinstance(joint.along, str):
        found: Side = joint.along
        return found
    surface = next((s for s in problem.surfaces if s.name == joint.along), None)
    fixed = surface is not None and isinstance(surface.shape, Line) and surface.body is None
    return surface.shape.angle if fixed and surface is not None and isinstance(surface.shape, Line) else None


def _pull(spring: Any, own: set[str], angle: Side, mark: Mark) -> Side:
    """k (l - l_0) r/l: the pull of a spring on the knot along its line, r to the other end."""
    one, other = spring.between
    end, knot = (other, one) if one in own else (one, other)
    length = Quantity("r", (end, knot), None, (Part("mag", None, mark),), None, mark)
    reach = Quantity("r", (end, knot), None, (Part("along", angle, mark),), None, mark)
    stretch = Binary("-", length, spring.natural_length, mark)
    tension = Binary("*", spring.stiffness, stretch, mark)
    return Binary("/", Binary("*", tension, reach, mark), length, mark)


def _names_in(entry: Any) -> set[str]:
    """All names that an entry holds as they stand, alone or in a list."""
    values = (getattr(entry, f.name) for f in fields(entry) if f.name not in ("name", "kind"))
    listed = (v if isinstance(v, tuple) else (v,) for v in values)
    return {x for several in listed for x in several if isinstance(x, str)}
