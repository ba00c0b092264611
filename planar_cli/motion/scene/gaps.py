"""How far apart the partners of a contact or an impact are, and where and along which line they would touch.

Bodies meet with a corner on an edge or a rim, with two rims, or with a corner on a curve; every such pair has a signed
distance that is positive while they are apart. An edge, a circle or a curve is met from the side on which the other
partner is drawn; the edges of a plate from outside.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import replace

from planar_cli.motion.scene.boundaries import Boundary, Bow, Corner, Edge, Rim, boundaries, boundary_center
from planar_cli.motion.scene.carried import Carried
from planar_cli.motion.scene.curves import curve_at
from planar_cli.motion.scene.feet import Foot
from planar_cli.motion.terms.terms import Term
from planar_cli.problem.scene.geometry import Vec
from planar_cli.problem.scene.scene import GROUND
from planar_cli.records import record

NEAR = 1e-9
"""Nearer than this part of the scene's extent two drawn places are one."""
FACING = math.cos(math.pi / 4)
"""An edge faces a direction if its normal is nearer to it than the edge itself."""

Feet = Mapping[tuple[str, str], Foot]
"""Where rims are nearest to curves, by surface and body."""


@record
class Gap:
    """One way in which two partners may touch."""

    first: str
    """The body of the first partner, or the ground."""
    second: str
    """That of the second."""
    distance: Term
    """Positive while they are apart, m."""
    point: Vec
    """Where they touch when the distance is zero."""
    normal: Vec
    """The unit vector from the first to the second."""
    within: tuple[Term, ...] = ()
    """Not negative where this pair is the one that touches: the foot is inside the edge, m."""
    told: bool = True
    """Does the drawing tell on which side of each other they are?"""
    points: bool = False
    """Do two points meet, which have no faces along which they could slide?"""
    thin: tuple[Vec, Term] | None = None
    """Of a rod's long side, which may be met from both: the centre of what meets it, and its radius [m]."""
    line: tuple[Vec, Term] | None = None
    """The same of a line without end."""
    free: bool = False
    """Does nothing keep them on their side of such a line until they meet?"""
    facing: str = ""
    """Of two points that are drawn as one: the name of that which notes their side."""

    def reversed(self) -> Gap:
        """The same with the partners exchanged."""
        return replace(self, first=self.second, second=self.first, normal=-self.normal)

    def from_other_side(self) -> Gap:
        """The same where they are on the other side of each other."""
        return replace(self, distance=-self.distance, normal=-self.normal)


def gaps_of(
    scene: Carried,
    feet: Feet,
    between: tuple[str, ...],
    normal: Vec | None = None,
    later: bool = False,
    named: tuple[Vec, str] | None = None,
) -> tuple[Gap, ...]:
    """All pairs of the outlines of two partners that may touch. `normal`: the direction that the file gives. `later`:
    they strike in another position than the drawn one. `named`: the point that the file names, and whose it is.
    """
    ours, theirs = (boundaries(scene, partner) for partner in between)
    meets = [b for b in (*ours, *theirs) if _is_named(scene, b, named)]
    ours, theirs = (_named(one, meets, other) for one, other in ((ours, theirs), (theirs, ours)))
    found = [gap for a in ours for b in theirs for gap in _pair(scene, feet, a, b)]
    if normal is None:
        return tuple(found or _ends(scene, ours, theirs, None))
    # Along a rod its end is met, not its side.
    along = [gap for gap in found if scene.sign(gap.normal.dot(normal)) == 0]
    across = [gap for gap in found if gap not in along]
    if across and all(_is_met_at_its_end(scene, gap, normal) for gap in found):
        # The shapes leave the direction open, which the file tells.
        return tuple(_ends(scene, ours, theirs, normal)) or tuple(across)
    turning = [gap for gap in along if later and not scene.vanishes(gap.normal.dot(normal))]
    if across or not turning:
        return tuple([*across, *turning] or _ends(scene, ours, theirs, normal))
    ends = _ends(scene, ours, theirs, normal) if all(gap.thin is not None for gap in turning) else []
    met = [_where(scene, gap, scene.graph.of(gap.normal.dot(normal)), 1) for gap in turning]
    return (*met, *(_where(scene, end, scene.graph.of(turning[0].normal.dot(normal)), -1) for end in ends))


def _is_met_at_its_end(scene: Carried, gap: Gap, normal: Vec) -> bool:
    """Is an edge drawn so that it is met at its end, and aslant?"""
    aslant, touches = scene.sign(gap.normal.cross(normal)) != 0, scene.sign(gap.distance) == 0
    return aslant and touches and any(scene.sign(w) == 0 for w in gap.within)


def _is_named(scene: Carried, boundary: Boundary, named: tuple[Vec, str] | None) -> bool:
    """Is it the corner that the file names?"""
    if named is None or not isinstance(boundary, Corner) or boundary.body != named[1]:
        return False
    gap: Vec = boundary.place - named[0]
    return math.hypot(scene.graph.of(gap.x).value, scene.graph.of(gap.y).value) <= NEAR * scene.extent


def _named(found: list[Boundary], met: list[Boundary], others: list[Boundary]) -> list[Boundary]:
    """Of several corners the one that the file names, if it is among them; with it a rod's end meets what has edges of
    its own, not those with its corners.
    """
    if any(b in met for b in found):
        return [b for b in found if not isinstance(b, Corner) or b in met]
    edged = any(isinstance(b, Edge) for b in found)
    return [b for b in found if not isinstance(b, Corner)] if edged and any(b in met for b in others) else found


def _where(scene: Carried, gap: Gap, cosine: Term, sense: int) -> Gap:
    """The same where an edge faces the direction of the normal (`sense` 1), or lies along it (-1)."""
    facing = (scene.graph.call("abs", cosine) - FACING) * (sense * scene.extent)
    return replace(gap, within=(*gap.within, facing))


def _ends(scene: Carried, ours: list[Boundary], theirs: list[Boundary], normal: Vec | None) -> list[Gap]:
    """Corners that meet corners."""
    corners = [(a, b) for a in ours for b in theirs if isinstance(a, Corner) and isinstance(b, Corner)]
    met = [gap for a, b in corners for gap in _corners(scene, a, b, normal)]
    if len(ours) > 1 and len(theirs) > 1:
        return met
    # A particle meets the end that is drawn nearest.
    return sorted(met, key=lambda gap: gap.distance.value)[:1]


def _pair(scene: Carried, feet: Feet, a: Boundary, b: Boundary) -> list[Gap]:
    """One pair; nothing where these cannot touch, or another pair tells."""
    match a, b:
        case (Corner() | Rim(), Edge()):
            return [_on_edge(scene, a, b)]
        case (Rim() | Corner(), Rim()):
            return _on_rim(scene, a, b)
        case (Corner(), Bow()):
            return [_on_curve(scene, a, b)]
        case (Rim(), Bow()):
            return [_over_curve(scene, feet[b.surface.name, a.body], a, b)]
        case (Edge(), Corner() | Rim()) | (Rim(), Corner()) | (Bow(), Corner() | Rim()):
            return [gap.reversed() for gap in _pair(scene, feet, b, a)]
    return []


def _side(scene: Carried, off: Term) -> int:
    """On which side something is drawn; where it is drawn on the line itself, on the left."""
    return scene.sign(off) or 1


def _on_edge(scene: Carried, one: Corner | Rim, edge: Edge) -> Gap:
    """From the edge to a corner or a rim; `first` is the corner's body."""
    graph = scene.graph
    center = one.place if isinstance(one, Corner) else one.center
    reach = center - edge.start
    left = edge.along.turned()
    side = 1 if edge.solid else _edge_side(scene, one, edge)
    out = left * (side or _side(scene, scene.graph.of(left.y)))
    distance, foot = graph.of(reach.dot(out)), graph.of(reach.dot(edge.along))
    radius = one.radius if isinstance(one, Rim) else graph.number(0.0)
    within = _beside(edge, foot, distance)
    thin = (center, radius) if edge.length is not None and not edge.solid else None
    line = (center, radius) if edge.length is None else None
    touching = center - out * radius
    return Gap(one.body, edge.body, distance - radius, touching, -out, within, side != 0, thin=thin, line=line)


def _beside(edge: Edge, foot: Term, off: Term) -> tuple[Term, ...]:
    """Not negative where the edge is the one that is met, `off` beside it.

    Inside a plate that is up to the middle, and to the lines that halve the angles at its corners: what lies on another
    edge, or behind the opposite one, has not come through this one.
    """
    if edge.length is None:
        return ()
    if edge.depth is None:
        return (foot, edge.length - foot)
    inner = (off - off.graph.call("abs", off)) * 0.5
    return (foot + inner, edge.length - foot + inner, off + edge.depth * 0.5)


def _edge_side(scene: Carried, one: Corner | Rim, edge: Edge) -> int:
    """The side of a line on which the partner is drawn, by its place, then by its body; 0 where nothing tells."""
    places = [boundary_center(scene, one)]
    places += [scene.center(one.body)] if one.body != GROUND else []
    for place in reversed(places):
        side = scene.sign((place - edge.start).cross(edge.along)) * -1
        if side:
            return side
    return 0


def _on_rim(scene: Carried, one: Rim | Corner, rim: Rim) -> list[Gap]:
    """From one rim or corner to a rim; one inside the other where it is drawn so and either is hollow."""
    graph = scene.graph
    place = one.place if isinstance(one, Corner) else one.center
    own = one.radius if isinstance(one, Rim) else graph.number(0.0)
    reach = place - rim.center
    far = graph.call("sqrt", graph.of(reach.dot(reach)))
    out = reach / far
    inside = scene.sign(rim.radius - own - far) >= 0 and scene.sign(rim.radius + own - far) > 0
    if inside and rim.hollow:
        return [Gap(one.body, rim.body, rim.radius - own - far, place + out * own, out)]
    if isinstance(one, Rim) and one.hollow and scene.sign(own - rim.radius - far) >= 0:
        return [Gap(one.body, rim.body, own - rim.radius - far, rim.center - out * rim.radius, out)]
    return [Gap(one.body, rim.body, far - own - rim.radius, place - out * own, -out)]


def _on_curve(scene: Carried, corner: Corner, bow: Bow) -> Gap:
    """From a curve, to the first order of the distance: exact where it is zero."""
    bend = curve_at(scene, bow.surface, bow.curve, corner.place)
    left = bend.tangent.turned()
    off = scene.graph.of((corner.place - bend.place).dot(left))
    drawn = scene.sign(off)
    side = drawn or _side(scene, scene.graph.of(left.y))
    return Gap(corner.body, bow.body, off * side, corner.place, left * -side, told=drawn != 0)


def _over_curve(scene: Carried, foot: Foot, rim: Rim, bow: Bow) -> Gap:
    """From a curve to a rim, above the foot of its centre."""
    left = foot.bend.tangent.turned()
    side = scene.sign(foot.height) or 1
    return Gap(rim.body, bow.body, foot.height * side - rim.radius, foot.bend.place, left * -side)


def _corners(scene: Carried, a: Corner, b: Corner, normal: Vec | None) -> list[Gap]:
    """Two points meet along the direction that the file gives, else along the line on which they are drawn."""
    reach = b.place - a.place
    if normal is None:
        drawn = Vec(*(scene.graph.number(scene.graph.of(p).value) for p in (reach.x, reach.y)))
        if scene.is_zero(reach.dot(reach)):
            return []
        normal = drawn / scene.length(drawn)
    drawn_at = scene.sign(scene.graph.of(reach.dot(normal)))
    out = normal * (drawn_at or 1)
    return [Gap(a.body, b.body, scene.graph.of(reach.dot(out)), a.place, out, told=drawn_at != 0, points=True)]
