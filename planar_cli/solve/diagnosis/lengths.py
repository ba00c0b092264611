"""Sizes that are stated beside the places that tell them, and are checked: rods between two points, cords on drums."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from decimal import Decimal
from typing import Any

import sympy as sp

from planar_cli.equation.scene.scene import Scene
from planar_cli.equation.system.setup import Earlier, Setup, first_unit
from planar_cli.equation.system.system import Statements
from planar_cli.errors import Diagnostic, Mark, NoSolution
from planar_cli.problem.checks.scope import members_of
from planar_cli.problem.language.expression import Name, Side
from planar_cli.problem.language.walk import walk
from planar_cli.problem.scene.keys import RopeStop
from planar_cli.problem.scene.scene import Body, Problem, Rod, Round
from planar_cli.solve.diagnosis.tangents import ROUNDED, untaut
from planar_cli.solve.diagnosis.words import in_unit
from planar_cli.units import LENGTH, default_unit, parse_unit

Length = tuple[Body, str, str, Side]
"""A rod, its two points, and its length."""
Cord = tuple[Round, str, str, Mark]
"""A round body, its name, the point where a cord leaves it, and where that is said."""
Line = tuple[Round, str, tuple[RopeStop, ...], str, Mark]
"""A round body, its name, the stops of a cord from where it leaves that on, what the cord is called, and where."""


def demand_lengths(problem: Problem, earlier: Mapping[str, Earlier]) -> None:
    """NoSolution: a rod is not as long as its ends are apart, a cord leaves a drum where there is no rim or not along
    the rim, or the disks of a belt are too near each other.
    """
    rods, cords, lines = list(_rods(problem)), list(_cords(problem)), list(_lines(problem))
    if not rods and not cords and not any(joint.kind == "belt" for joint in problem.joints):
        return
    now: tuple[Any, ...] = problem.instant or (problem.states[0].relations if problem.states else ())
    # What is told by the time is open here, as any place is that is sought.
    laws = (law.statement for law in problem.motion)
    always = tuple(s for s in laws if not any(isinstance(n, Name) and n.name == "t" for n in walk(s)))
    statements = Statements.of(always, now)
    scene = Setup(problem, statements, earlier, False).scene
    wrong = [d for d in (*(_unfit(scene, *r) for r in rods), *(_off_rim(scene, *c) for c in cords)) if d is not None]
    wrong = wrong or [d for line in lines if (d := _off_tangent(scene, line)) is not None]
    wrong = wrong or list(untaut(scene))
    if wrong:
        raise NoSolution(wrong)


def _rods(problem: Problem) -> Iterator[Length]:
    places = {p.name for p in problem.points}
    for body in problem.bodies:
        match body.shape:
            case Rod(start, str(end), _, length) if length is not None and {start, end} <= places:
                yield body, start, end, length


def _cords(problem: Problem) -> Iterator[Cord]:
    drums = {b.name: b.shape for b in problem.bodies if isinstance(b.shape, Round)}
    for member in members_of(problem):
        named = [(stop.body, stop.name) for stop in getattr(member, "path", ()) if isinstance(stop, RopeStop)]
        named += [(getattr(member, "body", None), getattr(member, "wound_at", None) or "")]
        for body, point in named:
            if body in drums and point:
                yield drums[body], body, point, member.mark


def _lines(problem: Problem) -> Iterator[Line]:
    """Parts of ropes between a drum and a point, or two drums, that run straight where places tell."""
    drums = {b.name: b.shape for b in problem.bodies if isinstance(b.shape, Round)}
    for joint in problem.joints:
        path: tuple[RopeStop, ...] = getattr(joint, "path", ())
        if not path or getattr(joint, "along", None) is not None:
            continue
        for stops in (path, path[::-1]):
            if stops[0].body in drums:
                yield drums[stops[0].body], stops[0].body, stops, joint.called, joint.mark


def _unfit(scene: Scene, body: Body, start: str, end: str, side: Side) -> Diagnostic | None:
    value, length = scene.valuations[0], sp.sympify(scene.value(side))
    apart = sp.sympify(scene.length(scene.point(end) - scene.point(start)))
    if scene.rests_on_sought(apart) or scene.rests_on_sought(length):
        text = f"the length of {body.name} and the places of {start} and {end} both tell how far apart these are"
        return Diagnostic(body.mark, "PL615", text, f"leave `length` out, and state `r({end}/{start}).mag = …`")
    if abs(value(apart - length)) <= ROUNDED * abs(value(length)):
        return None
    text = f"{body.name} does not reach from {start} to {end}"
    if not scene.ledger.symbolic:
        told, between = _shown(scene, value(length), side), _shown(scene, value(apart), side)
        text = f"{body.name} has the length {told}, but from {start} to {end} there are {between}"
    return Diagnostic(body.mark, "PL615", text, "leave `length` out, as the places tell it, or correct a place")


def _off_rim(scene: Scene, shape: Round, body: str, point: str, mark: Mark) -> Diagnostic | None:
    value = scene.valuations[0]
    arm = scene.point(point) - scene.point(shape.center)
    square = sp.sympify(arm.dot(arm))
    rims = [r for r in (shape.radius, shape.hub) if r is not None]
    radii = [sp.sympify(scene.value(r)) for r in rims]
    if any(scene.rests_on_sought(e) for e in (square, *radii)):
        return None
    far = value(square).sqrt()
    if any(abs(far - value(r)) <= ROUNDED * value(r) for r in radii):
        return None
    text = f"the cord leaves {body} at {point}, which is on no rim of it"
    if not scene.ledger.symbolic:
        sizes = " or ".join(_shown(scene, value(r), s) for r, s in zip(radii, rims, strict=True))
        text += f": {_shown(scene, far, shape.radius)} from its centre, and not {sizes}"
    return Diagnostic(mark, "PL522", text, f"draw {point} on the rim, or correct `radius:` or `hub:`")


def _off_tangent(scene: Scene, line: Line) -> Diagnostic | None:
    """A cord leaves a rim at right angles to the radius: what it leads to lies on this line, or has its rim there."""
    shape, body, (start, stop, *_), cord, mark = line
    rim, other = start.name, stop.name
    value = scene.valuations[0]
    arm, reach = scene.point(rim) - scene.point(shape.center), scene.point(other) - scene.point(rim)
    inward = sp.sympify(reach.dot(arm))
    pulley = scene.pulley(other) if stop.way in ("over", "under") else ""
    radius = sp.sympify(scene.radius(pulley) if pulley else 0)
    if scene.rests_on_sought(inward) or scene.rests_on_sought(radius):
        return None
    aside = abs(abs(value(inward)) / value(sp.sympify(arm.dot(arm))).sqrt() - value(radius))
    if aside <= ROUNDED * value(sp.sympify(reach.dot(reach))).sqrt():
        return _other_way(scene, line, value(inward)) if radius else None
    there = f"the rim of {pulley}" if radius else other
    text = f"{cord} leaves {body} at {rim} at right angles to the radius there, and {there} is not on that line"
    if not scene.ledger.symbolic:
        text += f", but {_shown(scene, aside, shape.radius)} beside it"
    return Diagnostic(
        mark, "PL522", text, f"draw {other} on that line, or {rim} where the cord to {other} leaves the rim"
    )


def _other_way(scene: Scene, line: Line, inward: Decimal) -> Diagnostic | None:
    """A cord passes a pulley on the side on which its part from the drum touches the rim. `inward`: the arm of the rim
    point times the way from there to the centre of the pulley.
    """
    shape, _, (start, stop, after, *_), cord, mark = line
    rim, center = scene.point(start.name), scene.point(stop.name)
    arm, value = rim - scene.point(shape.center), scene.valuations[0]
    ahead, turn = sp.sympify((scene.point(after.name) - rim).x), sp.sympify((center - rim).cross(arm))
    if scene.rests_on_sought(ahead) or scene.rests_on_sought(turn):
        return None
    # The centre lies to the left of what runs on from the drum where these two have one sign.
    left = inward * value(turn) > 0
    if left == ((value(ahead) > 0) == (stop.way == "under")):
        return None
    other = "over" if stop.way == "under" else "under"
    text = f"{cord} leaves {start.body} at {start.name} on the other side of {stop.name}: as drawn it runs {other} it"
    return Diagnostic(mark, "PL522", text, f"write `{other} {stop.name}`, or correct a place")


def _shown(scene: Scene, value: Decimal, side: Side) -> str:
    """A length in the unit of the file."""
    if isinstance(side, Name):
        side = next((g.value for g in scene.problem.given if g.name == side.name and g.value is not None), side)
    written = first_unit(side)
    us = scene.problem.us
    return in_unit(value, default_unit(LENGTH, us=us) if written is None else parse_unit(written), us)
