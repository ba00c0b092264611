"""What two outlines that touch have in common: their tangent; and on which side of a floor a body stands."""

from __future__ import annotations

from fractions import Fraction

from planar_cli.errors import Mark
from planar_cli.problem.scene.facts import Outline, center_of
from planar_cli.problem.scene.geometry import Vec
from planar_cli.problem.scene.setting import Setting

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


def away(mover: Outline, base: Outline, place: Vec, scene: Setting) -> Vec:
    """The side of the contact on which the mover is, where the shapes tell: else zero.

    A rim lies towards its own centre, except that a rim which encloses the other (a drum round a wheel, a ring on a
    peg) lies outside; a straight edge lies off the rim that it touches.
    """
    own, other = center_of(mover, place), center_of(base, place)
    if mover.kind == "straight" and base.kind == "arc" and other is not None:
        return place - other
    if mover.kind != "arc" or own is None:
        return Vec(0, 0)
    out = own - place
    if base.kind == "arc" and other is not None:
        towards = other - place
        if scene.sign(out.dot(towards)) > 0 and scene.sign(out.dot(out) - towards.dot(towards)) > 0:
            return -out
    return out


def drawn_by_points(body: str, scene: Setting) -> bool:
    """Is a body drawn by points alone, with no mass centre among them?"""
    points = scene.drawn_by(body)
    return bool(points) and scene.center_name(body) not in points


def middle_of(body: str, scene: Setting) -> Vec:
    """The mass centre of a body; of one that is drawn by points alone, and has none, their mean."""
    if not drawn_by_points(body, scene):
        return scene.center(body)
    points = scene.drawn_by(body)
    total = scene.point(points[0])
    for name in points[1:]:
        total = total + scene.point(name)
    mean: Vec = total / len(points)
    return mean


def away_from_base(base: Outline, between: tuple[str, ...], place: Vec, scene: Setting) -> Vec:
    """From the middle of the base; a round wall named beside its body, about its centre, is the inside."""
    surfaced = base.body not in between
    shapeless = base.body != "ground" and (drawn_by_points(base.body, scene) or not scene.rigid(base.body))
    if base.body == "ground" or (surfaced and shapeless):
        return Vec(0, 0)  # points of a truck tell nothing of its bed, nor does a wedge drawn as a particle
    out = place - middle_of(base.body, scene)
    if base.kind != "arc" or base.center is None or not surfaced:
        return out
    gap = base.center - scene.center(base.body)
    return -out if scene.is_zero(gap.dot(gap)) else Vec(0, 0)
