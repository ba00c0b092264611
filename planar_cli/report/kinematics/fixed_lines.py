"""What a fixed line says of a point that moves along it: E moves along the wall, so that v_Ex = 0."""

from __future__ import annotations

from collections.abc import Iterator

from planar_cli.equation.kinematics.motion import Edge
from planar_cli.equation.system.system import System
from planar_cli.problem.scene.facts import Joining
from planar_cli.problem.scene.scene import GROUND, with_article
from planar_cli.report.document.blocks import Line, Name, Paragraph, line
from planar_cli.report.words.words import Phrases

SHORT = 2
"""A component clings to a name of so many letters."""


def along_fixed(j: Joining, own: Name, level: str, system: System, phrases: Phrases) -> Line:
    """`own`: the velocity or the acceleration of the point of the joint; `level`: which of them it is."""
    assert j.path is not None
    if j.path.curvature == 0:
        return _along_straight(j, own, system, phrases)
    surface = _surface(j, system)
    goes = f"{j.place} moves along {with_article(surface.replace('_', ' ')) if surface else 'its path'}"
    if level == "velocity":
        return line(f"{goes}, so that ", own, " has no component across it")
    assert system.motion is not None
    v = system.motion.velocity(j.point, j.mover)
    if all(phrases.value.is_zero(p) for p in (v.x, v.y)):
        return line(f"{goes}, from rest, so that ", own, " has no component across it")
    return line(f"{goes}; across it ", own, " is its normal part")


def _along_straight(j: Joining, own: Name, system: System, phrases: Phrases) -> Line:
    """In which direction it moves, and which component it has not."""
    way, across = way_along(j, system, phrases), _across(j, phrases)
    if not across:
        return line(f"{j.place} {way}, so that ", own, " has no component across it")
    comma = "," if len(own.name) > SHORT + 2 else ""
    return line(f"{j.place} {way}, so that ", Name(f"{own.name}{comma}{across}"), " = 0")


def _guide(j: Joining, system: System) -> str:
    """The straight line along which a joint leads, in a word."""
    joint = next((one for one in system.scene.problem.joints if one.name == j.joint), None)
    return "its straight guide" if joint is not None and joint.kind == "guide" else "a straight line"


def way_along(j: Joining, system: System, phrases: Phrases) -> str:
    """moves along the wall, horizontally, along a straight line."""
    across, surface = _across(j, phrases), _surface(j, system)
    if surface:
        return f"moves along {with_article(surface.replace('_', ' '))}"
    if across and system.scene.problem.plane != "horizontal":
        return f"moves {'vertically' if across == 'x' else 'horizontally'}"
    return f"moves parallel to {'y' if across == 'x' else 'x'}" if across else f"moves along {_guide(j, system)}"


def _across(j: Joining, phrases: Phrases) -> str:
    """The axis across its line; "": this is oblique."""
    assert j.path is not None
    nil = phrases.value.is_zero
    return "x" if nil(j.path.tangent.x) else "y" if nil(j.path.tangent.y) else ""


def touches_at_rest(edge: Edge, system: System, told: set[str]) -> Iterator[Paragraph]:
    """C touches the fixed floor: v_C = 0, C is the instantaneous centre of disk; once of each body that rolls on what
    does not move. `told`: what was said.
    """
    j, key = edge.joining, f"rest {edge.body}"
    if j is None or j.rolling is None or j.base != GROUND or j.drift is not None or key in told:
        return
    told.add(key)
    surface, place = _surface(j, system).replace("_", " "), j.place.replace("_", ",")
    named = f"the fixed {surface}" if surface.islower() else f"{surface or 'the ground'}, which is fixed"
    centre = "" if edge.spin is None else f", {place} is the instantaneous centre of {edge.body.replace('_', ' ')}"
    yield Paragraph(line(Name(place), f" touches {named}: ", Name(f"v_{place}"), " = 0", centre))


def _surface(j: Joining, system: System) -> str:
    """The surface of the file along which a joint leads; "": it has no name."""
    problem = system.scene.problem
    joint = next((one for one in problem.joints if one.name == j.joint), None)
    along = getattr(joint, "along", None)
    names = {s.name for s in problem.surfaces}
    told = [*getattr(joint, "between", ()), getattr(along, "name", along)]
    return next((n for n in told if isinstance(n, str) and n in names), "")
