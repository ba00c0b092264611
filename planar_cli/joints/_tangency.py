"""What two outlines that touch have in common: their tangent; and on which side of a floor a body stands."""

from __future__ import annotations

from fractions import Fraction

from planar_cli.errors import Mark
from planar_cli.problem.facts import Outline
from planar_cli.problem.geometry import Vec
from planar_cli.problem.setting import Setting

CROSSING = Fraction(1, 10**6)
"""The square of the sine between two outlines [1] from which they cross; less is what numbers of few digits leave."""


def demand_common_tangent(
    between: tuple[str, ...], at: str, a: Outline, b: Outline, scene: Setting, mark: Mark
) -> None:
    """A rim has the tangent of what it touches. FileProblem where it crosses it."""
    if a.tangent is None or b.tangent is None or "arc" not in (a.kind, b.kind):
        return
    sine = a.tangent.cross(b.tangent)
    if scene.sign(sine * sine - CROSSING) > 0:
        text = f"{between[0]} and {between[1]} cross at {at}: their tangents there differ"
        hint = f"turn the surface, or place {at} where the radius of the rim is at right angles to what it touches"
        raise scene.refuse(mark, "PL534", text, hint)


def demand_above(base: Outline, normal: Vec, between: tuple[str, ...], at: str, scene: Setting, mark: Mark) -> None:
    """A body stands on the floor that is meant by `ground`. FileProblem where it is drawn below it."""
    if base.floor and scene.sign(normal.y) < 0:
        body = between[0]
        text = f"{body} is drawn below {at}, where it touches the ground"
        wall = f"`surfaces: {{wall: {{through: {at}, angle: 90 deg}}}}` and `between: [{body}, wall]`"
        hint = f"declare what it touches: {wall}"
        raise scene.refuse(mark, "PL535", text, hint)


def beyond_the_line(base: Outline, place: Vec, center: Vec, left: Vec, scene: Setting) -> Vec:
    """From a straight surface to the mass centre of what touches it, where the contact is drawn off that surface: what
    comes down on it later may be drawn with this end up. Elsewhere nothing.
    """
    if base.on_line is None or scene.is_zero((place - base.on_line).dot(left)):
        return Vec(0, 0)
    return center - base.on_line
