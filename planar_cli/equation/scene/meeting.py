"""Where two bodies meet that strike each other, and along which line: the point of contact and the common normal.

A particle meets where it is, a round body where the line of centres, or its radius across the other's edge, leaves its
rim, a rod or a plate with the end or corner that is nearest. (An Introduction to Planar Dynamics, 3.7, 4.6.)
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from decimal import Decimal

import sympy as sp

from planar_cli.equation.scene.scene import Scene
from planar_cli.errors import FileProblem, Mark, refuse
from planar_cli.problem.scene.facts import Meeting
from planar_cli.problem.scene.geometry import Vec
from planar_cli.problem.scene.outlines import outline_of
from planar_cli.problem.scene.scene import GROUND, Circle, Line, Particle, Plate, Rod
from planar_cli.problem.scene.shapes import rim_of
from planar_cli.records import record


@record
class Partner:
    """One of the two. `center`, `radius`: of a round one. `line`: a point and the direction of a straight one.
    `corners`: points with which it may meet another. `body`: who carries it.
    """

    name: str
    body: str
    center: Vec | None = None
    radius: sp.Expr | None = None
    line: tuple[Vec, Vec] | None = None
    corners: tuple[Vec, ...] = ()
    particle: bool = False


def meeting_of(
    scene: Scene,
    between: tuple[str, ...],
    normal: Vec | None,
    mark: Mark,
    at: str = "",
    during: tuple[str, str] | None = None,
) -> Meeting:
    """Where `between` meet. `normal`: the direction that the file gives; refused where the shapes leave it open. `at`:
    the point that the file names, "": none. `during`: between which states alone they strike each other; until then
    nothing keeps them on the side of a line without end on which they are drawn.
    """
    a, b = partners_of(scene, between, at)
    point = _point(scene, a, b)
    if point is None and normal is not None:
        point = a.center or b.center
    if point is None:
        text = f"where {a.name} and {b.name} touch is open"
        raise refuse(
            mark, "PL528", text, "let a particle, a round rim or the end of a rod, named by `at`, touch the other"
        )
    across = normal or _normal(scene, a, b, point, mark)
    if across is None:
        text = f"the direction in which {a.name} and {b.name} strike each other is open"
        raise refuse(mark, "PL528", text, "write `normal: 0 deg`, the direction of the common normal")
    named = scene.point(at) if at and at not in between and scene.owner(at) in (a.body, b.body) else None
    side = _side(scene, a, b, across, point, named)
    lined = any(p.line is not None and not p.corners for p in (a, b))
    passed = lined and during is not None and not scene.problem.holds_at_first(during)
    return Meeting(point, across * side if side else across, bool(side) and not passed)


def partners_of(scene: Scene, between: tuple[str, ...], at: str = "") -> tuple[Partner, Partner]:
    """Both, with the corners that may strike: of one that meets a straight surface the one that the file names (`at`),
    else those that do not lie on it already, as another contact of the same two says.
    """
    a, b = (partner_of(scene, name) for name in between)
    return _with_free_corners(scene, a, b, at), _with_free_corners(scene, b, a, at)


def _with_free_corners(scene: Scene, one: Partner, other: Partner, at: str) -> Partner:
    if at and is_threaded(scene, other, one):
        named = tuple(p for p in one.corners if _is_at(scene, p, at))
        return replace(one, corners=named or one.corners)
    if len(one.corners) < 2 or other.line is None:
        return one
    if other.corners:
        named = tuple(p for p in one.corners if at and _is_at(scene, p, at))
        return replace(one, corners=named or one.corners)
    names = {one.name, other.name}
    contacts = (j for j in scene.problem.joints if j.unilateral and not j.strikes)
    held = [getattr(j, "at", "") for j in contacts if {*getattr(j, "between", ())} == names]
    said = [p for p in one.corners if at and _is_at(scene, p, at)]
    free = [p for p in one.corners if not any(_is_at(scene, p, name) for name in held if name)]
    return replace(one, corners=tuple(said or free or one.corners))


def is_threaded(scene: Scene, round_one: Partner, rod: Partner) -> bool:
    """Is the centre of a round body on the line of a rod, like a ball on a wire? Then its rim meets but the ends."""
    if round_one.center is None or round_one.particle or rod.line is None or not rod.corners:
        return False
    start, along = rod.line
    return scene.is_zero((round_one.center - start).cross(along))


def _is_at(scene: Scene, corner: Vec, name: str) -> bool:
    if name not in scene.points:
        return False
    gap = corner - scene.point(name)
    return scene.is_zero(gap.dot(gap))


def partner_of(scene: Scene, name: str) -> Partner:
    """The shape with which a body or surface strikes."""
    surface = scene.surfaces.get(name)
    if surface is not None:
        body, form = surface.body or GROUND, surface.shape
        if isinstance(form, Line):
            return Partner(name, body, line=(scene.point(form.through), scene.surface_direction(surface)))
        if isinstance(form, Circle):
            return Partner(name, body, scene.point(form.center), scene.value(form.radius))
        return Partner(name, body)
    if name == GROUND:
        return Partner(name, GROUND)
    found = scene.bodies[name]
    shape = found.shape
    if isinstance(shape, Particle):
        return Partner(name, name, found.center, sp.S.Zero, particle=True)
    rim = rim_of(shape)
    if rim is not None:
        return Partner(name, name, scene.point(rim.center), scene.value(rim.radius))
    if isinstance(shape, Rod):
        return _rod(scene, name, shape)
    if isinstance(shape, Plate):
        return Partner(name, name, corners=_corners(scene, name, shape))
    own = tuple(scene.point(p) for p, owners in scene.owners.items() if name in owners)
    return Partner(name, name, corners=own)


def _rod(scene: Scene, name: str, shape: Rod) -> Partner:
    start, along = scene.point(shape.start), scene.direction(name)
    if shape.end is not None:
        return Partner(name, name, line=(start, along), corners=(start, scene.point(shape.end)))
    end = start + (scene.bodies[name].center - start) * 2
    return Partner(name, name, line=(start, along), corners=(start, end))


def _corners(scene: Scene, name: str, shape: Plate) -> tuple[Vec, ...]:
    along, center = scene.along_plate(name, shape), scene.point(shape.center)
    half, depth = scene.value(shape.width) / 2, scene.value(shape.height) / 2
    return tuple(center + along * (i * half) + along.turned() * (j * depth) for i in (-1, 1) for j in (-1, 1))


# --- the point -------------------------------------------------------------------------------------------------------


def _point(scene: Scene, a: Partner, b: Partner) -> Vec | None:
    for one in (a, b):
        if one.particle:
            return one.center
    if a.center is not None and b.center is not None:
        return _between_rims(scene, a, b)
    for one, other in ((a, b), (b, a)):
        if one.center is not None and one.radius is not None:
            return _on_rim(scene, one, other)
    reaches = [(p, _apart(scene, p, other)) for one, other in ((a, b), (b, a)) if other.line for p in one.corners]
    if reaches:
        return min(reaches, key=lambda reach: reach[1])[0]
    if a.corners and b.corners:
        pairs = [(p, (p - q).dot(p - q)) for p in a.corners for q in b.corners]
        value = scene.valuations[0]
        return min(pairs, key=lambda pair: value(pair[1]))[0]
    return (a.corners or b.corners or (None,))[0]


def _between_rims(scene: Scene, a: Partner, b: Partner) -> Vec:
    """On the line of centres; a body inside a ring touches it beyond its own centre."""
    moving, other = (b, a) if a.body == GROUND else (a, b)
    assert moving.center is not None
    assert other.center is not None
    assert other.radius is not None
    reach = other.center - moving.center
    inside = scene.surfaces.get(other.name) is not None and scene.sign(other.radius**2 - reach.dot(reach)) > 0
    out = reach / scene.length(reach) * (-1 if inside else 1)
    found: Vec = moving.center + out * moving.radius
    return found


def _on_rim(scene: Scene, one: Partner, other: Partner) -> Vec | None:
    """Where the rim meets an edge: at the foot on its line, or at a corner beyond the ends of the edge."""
    assert one.center is not None
    assert one.radius is not None
    value = scene.valuations[0]
    if other.line is not None:
        start, along = other.line
        way = (one.center - start).dot(along)
        foot: Vec = start + along * way
        if not other.corners:
            return foot
        reach = (other.corners[-1] - other.corners[0]).dot(along)
        if 0 <= value(way) <= value(reach):
            # Between both ends of a rod on which it slides nothing tells which of them it strikes.
            return foot if not is_threaded(scene, one, other) else None
    if other.corners:
        center = one.center
        return _nearest(scene, other.corners, lambda p: (p - center).dot(p - center))
    return None


def _apart(scene: Scene, p: Vec, other: Partner) -> Decimal:
    """The square of the distance of a corner from a straight edge, which may have ends."""
    assert other.line is not None
    value, (start, along) = scene.valuations[0], other.line
    off: Decimal = value((p - start).cross(along)) ** 2
    ways = [value((q - p).dot(along)) for q in other.corners]
    return off + max(min(ways), -max(ways), Decimal(0)) ** 2 if ways else off


def _nearest(scene: Scene, points: tuple[Vec, ...], square: Callable[[Vec], sp.Expr]) -> Vec:
    value = scene.valuations[0]
    return min(points, key=lambda p: value(square(p)))


# --- the normal ------------------------------------------------------------------------------------------------------


def _normal(scene: Scene, a: Partner, b: Partner, point: Vec, mark: Mark) -> Vec | None:
    for partner in (a, b):
        if partner.center is not None and not partner.particle:
            other = b if partner is a else a
            if other.line is None or other.corners:
                out = point - partner.center
                if not scene.is_zero(out.dot(out)):
                    return _unit(scene, out)
    for partner in sorted((a, b), key=lambda p: bool(p.corners)):
        if partner.line is not None:
            return _turned(partner.line[1])
    if a.particle and b.particle:
        assert a.center is not None
        assert b.center is not None
        return _between_points(scene, b.center - a.center)
    for partner in (a, b):
        if partner.name in scene.surfaces or partner.name in scene.bodies:
            try:
                tangent = outline_of(scene, partner.name, point, mark).tangent
            except FileProblem:
                continue
            if tangent is not None:
                return _turned(tangent)
    return None


def _between_points(scene: Scene, reach: Vec) -> Vec | None:
    """Along the line on which two points are drawn. On one line throughout it is the drawn one: where they meet nothing
    is left of the way between them.
    """
    drawn = Vec(scene.as_drawn(reach.x), scene.as_drawn(reach.y))
    if scene.is_zero(drawn.dot(drawn)):
        return None
    return _unit(scene, drawn if scene.is_zero(reach.cross(drawn)) else reach)


def _is_struck_anywhere(scene: Scene, partner: Partner, normal: Vec) -> bool:
    """May a particle come to a body from the side of its mass centre too: to a named point of it, or along its line?"""
    if partner.body == GROUND or partner.particle or partner.name in scene.surfaces:
        return False
    if partner.line is not None:
        return not scene.is_zero(scene.as_drawn(partner.line[1].dot(normal)))
    return partner.center is None and not isinstance(scene.bodies[partner.name].shape, Plate)


def _unit(scene: Scene, v: Vec) -> Vec:
    length = scene.length(v)
    return Vec(v.x / length, v.y / length)


def _turned(v: Vec) -> Vec:
    return Vec(-v.y, v.x)


def _side(scene: Scene, a: Partner, b: Partner, normal: Vec, point: Vec, named: Vec | None) -> int:
    """+1 where b lies on the side of the normal, -1 where it lies on the other; 0 where the drawing does not tell.
    `named`: the point of one of them that the other strikes.
    """

    def sign(expr: sp.Expr) -> int:
        return scene.sign(scene.as_drawn(expr))

    def is_told(expr: sp.Expr) -> bool:
        """Does no coordinate of the file leave it open? With one either may come from either side."""
        inside = sp.sympify(scene.as_drawn(expr)).free_symbols
        return scene.displacement is None or not inside & {*scene.ledger.coordinates}

    if a.particle and b.particle:
        assert a.center is not None
        assert b.center is not None
        reach = (b.center - a.center).dot(normal)
        return sign(reach) if is_told(reach) else 0
    pairs = ((b, a, 1), (a, b, -1))
    for partner, other, sense in pairs:
        if not partner.particle or partner.center is None:
            continue
        if other.line is not None and scene.is_zero(scene.as_drawn(other.line[1].dot(normal))):
            off = (partner.center - other.line[0]).dot(normal)
            side = sign(off) * sense
            if side:
                return side if is_told(off) else 0
        if _is_struck_anywhere(scene, other, normal):
            # A stop, or a wall from inside: only where the particle is drawn tells from which side it comes.
            places = other.corners if named is None else (named,)
            signs = {sign((partner.center - place).dot(normal)) for place in places}
            return signs.pop() * sense if len(signs) == 1 else 0
    # A surface may lie anywhere on the body that carries it: what strikes it tells first. So does what slides on a rod.
    last = {p.name for p, other, _ in pairs if p.name in scene.surfaces or is_threaded(scene, other, p)}
    for partner, other, sense in sorted(pairs, key=lambda pair: pair[0].name in last):
        if partner.body == GROUND:
            continue
        center = partner.center or scene.center(partner.body)
        # A rod may be drawn with the end up that comes down on a floor: its mass centre is above that.
        place = other.line[0] if other.line is not None and not other.corners else point
        side = sign((center - place).dot(normal)) * sense
        if side:
            return side
    return 0
