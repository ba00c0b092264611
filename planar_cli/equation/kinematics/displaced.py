"""The scene in a general position: every body is carried along the tree of joints by one coordinate for each freedom.

A body hung by a pin turns by its angle, one in a guide slides by a length (on a circle by an arc, on a curve by the
abscissa), one that rolls advances by the arc that it unrolls; a free body has x, y and an angle. What closes a loop is
left to conditions between coordinates. (An Introduction to Planar Dynamics, 1.3, 2.2, 2.3.)
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import field, replace
from decimal import Decimal

import sympy as sp

from planar_cli.equation.algebra.expansion import expanded
from planar_cli.equation.algebra.plain import derivative, simplified
from planar_cli.equation.kinematics.line_of_centres import line_of_centres
from planar_cli.equation.kinematics.motion import Edge, Tree
from planar_cli.equation.scene.curves import curve_place
from planar_cli.equation.scene.displacement import Coordinate, CoordinateNames, Displacement
from planar_cli.equation.scene.outlines import is_straight, round_center
from planar_cli.equation.scene.placed_from import placed_from
from planar_cli.equation.scene.pose import HERE, Pose
from planar_cli.equation.scene.scene import Scene
from planar_cli.equation.scene.swaying import sent_aside
from planar_cli.equation.values.sample import anywhere
from planar_cli.problem.scene.geometry import Vec
from planar_cli.problem.scene.going import AGAINST
from planar_cli.problem.scene.scene import GROUND, Circle, Curve, Line, Round
from planar_cli.records import changing

ZERO = sp.S.Zero


@changing
class Displacer:
    """Displaces the bodies of one scene along one tree. `surface_of`: the surface on which a joint slides, by name;
    `time`: the time since the drawn instant; `formula`: bodies whose places the file itself writes with coordinates;
    `still`: names of velocity unknowns that stay zero; `made`: symbols of all displacements of the same problem.
    """

    scene: Scene
    tree: Tree
    surface_of: Callable[[str], str]
    time: sp.Expr
    formula: frozenset[str]
    still: frozenset[str]
    made: CoordinateNames
    poses: dict[str, Pose] = field(default_factory=lambda: {GROUND: HERE})
    coordinates: list[Coordinate] = field(default_factory=list)
    _begun: set[str] = field(default_factory=set)
    """Bodies that are placed already, or as soon as those are from which the file places them."""

    def run(self) -> Displacement:
        """All bodies in the order of the tree, then the points of contact."""
        pinned = (e for e in self.tree.edges if e.parent == GROUND and e.joining is not None and e.joining.only_turns)
        self.formula |= {e.body for e in pinned if self._turned_by_points(e.body)}
        for edge in self.tree.edges:
            self._place(edge)
        return Displacement(self.poses, self._spots(), tuple(self.coordinates), self.formula, self.tree.clockwise)

    # --- bodies ------------------------------------------------------------------------------------------------------

    def _place(self, edge: Edge) -> None:
        """A body, after those from which the file places it."""
        if edge.body in self._begun:
            return
        self._begun.add(edge.body)
        carrier, _ = self._origin(edge.body)
        for other in self.tree.edges:
            if other.body == carrier or (other.body == edge.parent and edge.body not in self.formula):
                self._place(other)
        self.poses[edge.body] = self._fixed(edge) if edge.body in self.formula else self._pose(edge)

    def _origin(self, body: str) -> tuple[str, str]:
        """The other body, and its point, from which the file places a body with its coordinates; the ground if none."""
        return placed_from(self.scene, body) if body in self.formula else (GROUND, "")

    def _coordinate(
        self,
        name: str,
        unit: str,
        drawn: sp.Expr | None,
        speed: sp.Symbol,
        factor: sp.Expr,
        words: str,
        body: str,
        turns: bool = False,
    ) -> sp.Expr:
        """A coordinate of its own, or where it is drawn if it stays there. `turns`: it is the angle of the body."""
        if speed.name in self.still and drawn is not None:
            return drawn
        # Directions read in degrees; what rolls has turned by radians.
        shape = next((b.shape for b in self.scene.problem.bodies if b.name == body), None)
        shown = "deg" if unit == "rad" and not (isinstance(shape, Round) and turns) else unit
        ledger = self.scene.ledger
        symbol = self.made.coordinate(ledger, name, body, shown)
        start = self.made.start(ledger, symbol, shown)
        self.coordinates.append(Coordinate(symbol, start, unit, drawn, speed, factor, words, body, shown))
        return symbol

    def _angle(self, edge: Edge) -> tuple[sp.Expr, sp.Expr]:
        """The body's angle as drawn and now."""
        body = self.scene.bodies[edge.body]
        if edge.spin is None:
            turn = ZERO if edge.particle else self.poses[edge.parent].turn
            return (body.theta, body.theta + turn) if turn != 0 else (ZERO, ZERO)
        alone = sum(e.spin is not None for e in self.tree.edges) == 1
        surface = "" if edge.joining is None else self.surface_of(edge.joining.joint)
        if (line := line_of_centres(self.scene, edge, surface, alone)) is not None:
            told = (line.drawn, edge.spin, line.ratio * edge.turn, line.words, edge.body)
            return body.theta, body.theta + (self._coordinate(line.name, "rad", *told) - line.drawn) / line.ratio
        name = "theta" if alone else f"theta_{edge.body}"
        own = (body.theta * edge.turn, edge.spin, sp.S.One, f"angle of {edge.body}", edge.body, True)
        return body.theta, self._coordinate(name, "rad", *own) * edge.turn

    def _fixed(self, edge: Edge) -> Pose:
        """The file says where the body is; only an angle that it does not say may be left."""
        body = self.scene.bodies[edge.body]
        coordinates = set(self.scene.ledger.coordinates)
        center = body.center
        carrier, origin = self._origin(edge.body)
        if carrier != GROUND and carrier in self.poses:
            # It goes along with the point from which it is placed, unless each is placed from a point of the other.
            center = center + self.poses[carrier].point(self.scene.point(origin)) - self.scene.point(origin)
        if edge.spin is None or body.theta.free_symbols & coordinates or self._turned_by_points(edge.body):
            return Pose(body.center, center, body.theta, body.theta)
        before, now = self._angle(edge)
        return Pose(body.center, center, before, now)

    def _turned_by_points(self, name: str) -> bool:
        """Does the file place another point of the body as its angle grows?"""
        scene, coordinates = self.scene, set(self.scene.ledger.coordinates)
        for point in scene.own_points:
            arm = scene.point(point) - scene.bodies[name].center if scene.owner(point) == name else Vec(ZERO, ZERO)
            if coordinates & (simplified(arm.x).free_symbols | simplified(arm.y).free_symbols):
                return True
        return False

    def _pose(self, edge: Edge) -> Pose:
        joining, body = edge.joining, self.scene.bodies[edge.body]
        if joining is None:
            return self._free(edge)
        before, now = self._angle(edge)
        own = Pose(body.center, body.center, before, now)
        parent = self.poses[edge.parent]
        if joining.rolling is not None:
            rim = self._rim_center(edge)
            return Pose(body.center, self._rolled(edge, rim, now - before) + own.vector(body.center - rim), before, now)
        start = joining.point
        if joining.path is None:
            meeting = parent.point(start)
            if joining.drift is not None:
                meeting = meeting + parent.vector(joining.drift) * (-self.time if edge.backward else self.time)
            return Pose(body.center, meeting + own.vector(body.center - start), before, now)
        if self._rim_on_line(edge):
            return Pose(body.center, self._sliding_rim(edge), before, now)
        track = self._track(edge)
        if edge.backward:
            return Pose(body.center, parent.point(start) + own.vector(body.center - track), before, now)
        return Pose(body.center, parent.point(track) + own.vector(body.center - start), before, now)

    def _rim_on_line(self, edge: Edge) -> bool:
        """Does a round body slide with its rim along a straight path?"""
        joining, shape = edge.joining, self.scene.bodies[edge.body].shape
        if joining is None or joining.path is None or edge.backward or not isinstance(shape, Round):
            return False
        off = joining.point - self.scene.bodies[edge.body].center
        surface = self.scene.surfaces.get(self.surface_of(joining.joint))
        straight = surface is None or isinstance(surface.shape, Line)
        return straight and not self.scene.is_zero(off.dot(off)) and self.scene.is_zero(joining.path.curvature)

    def _sliding_rim(self, edge: Edge) -> Vec:
        """The centre moves along the line; the rim slides under it: ẇ = v - h (ω - ω_base), h the centre's height."""
        joining, center = edge.joining, self.scene.bodies[edge.body].center
        assert joining is not None
        assert joining.path is not None
        assert edge.slide is not None
        t = joining.path.tangent
        height = t.cross(self.scene.arms.between(joining.point, center))
        spins = {e.body: (e.spin or ZERO) * e.turn for e in self.tree.edges}
        turning = spins[edge.body] - spins.get(edge.parent, ZERO)
        drift = joining.drift or Vec(ZERO, ZERO)
        extra = simplified(-height * turning + drift.dot(t))
        name = self.scene.own_name(edge.body)
        words = f"way of {name}"
        w = self._coordinate(f"s_{name}", "m", ZERO, edge.slide, sp.S.One, words, edge.body)
        if self.coordinates and self.coordinates[-1].symbol == w:
            self.coordinates[-1] = replace(self.coordinates[-1], extra=extra)
        return self.poses[edge.parent].point(center + t * w)

    def _free(self, edge: Edge) -> Pose:
        body = self.scene.bodies[edge.body]
        name = self.scene.own_name(edge.body)
        assert edge.slide is not None
        assert edge.rise is not None
        open_place = body.center.x.is_Symbol and body.center.x in self.scene.open_places
        parts = []
        for axis, speed, sense in (("x", edge.slide, edge.rightward), ("y", edge.rise, edge.upward)):
            drawn = getattr(body.center, axis)
            words = f"{axis} of {name}"
            if open_place:
                start, rate = self.made.start(self.scene.ledger, drawn, "m"), sp.Integer(sense)
                self.coordinates.append(Coordinate(drawn, start, "m", None, speed, rate, words, edge.body, "m"))
                parts.append(drawn)
            elif sense < 0:
                parts.append(self._against(name, drawn, speed, axis, edge.body))
            else:
                parts.append(self._coordinate(f"{axis}_{name}", "m", drawn, speed, sp.S.One, words, edge.body))
        before, now = self._angle(edge)
        return Pose(body.center, Vec(*parts), before, now)

    def _against(self, name: str, drawn: sp.Expr, speed: sp.Symbol, axis: str, body: str) -> sp.Expr:
        """x or y of what goes against that axis all the time: by its way, from the origin where it passes that, else
        from where it starts.
        """
        ways = dict(self.scene.problem.going)
        zero = ZERO if body in ways and ways[body].past_zero else drawn
        words = f"way of {name} {AGAINST[axis]}"
        way = self._coordinate(f"s_{name}", "m", zero - drawn, speed, sp.S.One, words, body)
        if self.coordinates and self.coordinates[-1].symbol == way:
            self.coordinates[-1] = replace(self.coordinates[-1], against=axis, zero=zero)
        return zero - way

    def _track(self, edge: Edge) -> Vec:
        """Where the sliding point is on its track, the track taken as drawn."""
        joining = edge.joining
        assert joining is not None
        assert joining.path is not None
        assert edge.slide is not None
        start, path, place = joining.point, joining.path, joining.place
        surface = self.scene.surfaces.get(self.surface_of(joining.joint))
        shape = surface.shape if surface is not None else None
        drift = joining.drift * self.time if joining.drift is not None else Vec(ZERO, ZERO)
        if isinstance(shape, Curve):
            return self._on_curve(edge, shape)
        if isinstance(shape, Circle) or not self.scene.is_zero(path.curvature):
            radius = 1 / path.curvature
            out = start - self.scene.point(shape.center) if isinstance(shape, Circle) else -path.tangent.turned()
            before = simplified(sp.atan2(out.y, out.x))
            if edge.parent == GROUND and self.scene.problem.plane != "vertical":
                # Where nothing depends on the height, speeds and their rates tell the way along the circle.
                way, words = f"s_{place}", f"way of {place} along its path"
                now = before + self._coordinate(way, "m", ZERO, edge.slide, sp.S.One, words, edge.body) / radius
            else:
                phi, words = f"phi_{place}", f"angle of {place} on its circle"
                now = self._coordinate(phi, "rad", before, edge.slide, 1 / radius, words, edge.body)
            center: Vec = start + path.tangent.turned() * radius
            return Pose(start, start, before, now).vector(start - center) + center
        words = f"way of {place} along its path"
        t = path.tangent
        going = edge.body in dict(self.scene.problem.going) and edge.parent == GROUND and not edge.backward
        if going and (t.x, t.y) in ((-1, 0), (0, -1)):
            axis = "y" if t.x == 0 else "x"
            now = self._against(place, getattr(start, axis), edge.slide, axis, edge.body)
            return (Vec(now, start.y) if axis == "x" else Vec(start.x, now)) + drift
        if self.scene.is_zero(t.y) and self.scene.is_zero(t.x - 1) and edge.parent == GROUND and not edge.backward:
            x = self._coordinate(f"x_{place}", "m", start.x, edge.slide, sp.S.One, f"x of {place}", edge.body)
            return Vec(x, start.y) + drift
        if self.scene.is_zero(t.x) and self.scene.is_zero(t.y - 1) and edge.parent == GROUND and not edge.backward:
            y = self._coordinate(f"y_{place}", "m", start.y, edge.slide, sp.S.One, f"y of {place}", edge.body)
            return Vec(start.x, y) + drift
        s = self._coordinate(f"s_{place}", "m", ZERO, edge.slide, sp.S.One, words, edge.body)
        along: Vec = start + t * s + drift
        return along

    def _on_curve(self, edge: Edge, shape: Curve) -> Vec:
        joining = edge.joining
        assert joining is not None
        assert joining.path is not None
        assert edge.slide is not None
        variable, at = curve_place(self.scene, shape)
        start, place = joining.point, joining.place
        if shape.kind == "y":
            name, unit, drawn, words = f"x_{place}", "m", start.x, f"x of {place}"
        else:
            name, unit, words = f"phi_{place}", "rad", f"angle of {place}"
            drawn = simplified(sp.atan2(start.y, start.x))
        slope = Vec(sp.diff(at.x, variable), sp.diff(at.y, variable))
        speed = sp.sqrt(simplified(slope.dot(slope)))
        symbol = self._coordinate(name, unit, drawn, edge.slide, ZERO, words, edge.body)
        if isinstance(symbol, sp.Symbol) and self.coordinates and self.coordinates[-1].symbol == symbol:
            along = self.scene.sign(joining.path.tangent.dot(slope).subs(variable, drawn)) or 1
            rate = (along / speed).subs(variable, symbol)
            self.coordinates[-1] = replace(self.coordinates[-1], factor=rate)
        return Vec(at.x.subs(variable, symbol), at.y.subs(variable, symbol))

    def _rim_center(self, edge: Edge) -> Vec:
        """The centre of the arc on which a body rolls; its mass centre may lie elsewhere."""
        joining, center = edge.joining, self.scene.bodies[edge.body].center
        assert joining is not None
        assert joining.rolling is not None
        own = joining.rolling.base if edge.backward else joining.rolling.mover
        if own == 0:
            return center
        rim: Vec = joining.point + joining.rolling.tangent.turned() / own
        off = rim - center
        return center if self.scene.is_zero(off.dot(off)) else rim

    def _rolled(self, edge: Edge, rim: Vec, turn: sp.Expr) -> Vec:
        """The centre of a rim that has unrolled its arc on a line or on another rim."""
        joining = edge.joining
        assert joining is not None
        assert joining.rolling is not None
        roll, parent, start = joining.rolling, self.poses[edge.parent], joining.point
        own, other = (roll.base, roll.mover) if edge.backward else (roll.mover, roll.base)
        relative = turn - parent.turn
        drift = joining.drift or Vec(ZERO, ZERO)
        way = drift.dot(roll.tangent) * self.time * (-1 if edge.backward else 1)
        if other == 0:
            height = roll.tangent.cross(self.scene.arms.between(start, rim))
            return parent.point(rim + roll.tangent * (way - height * relative))
        hub = self.scene.arms.centre(start + roll.tangent.turned() / other)
        if own == 0:
            # A straight edge on a rim: the normal turns with the edge, (θ_b - θ_a) ρ of it has passed the foot.
            passed = roll.tangent * (relative / other)
            return Pose(hub, parent.point(hub), ZERO, turn).point(rim - passed)
        # Same arc on both rims: (ψ - θ_b) ρ_b = (ψ - θ_a) ρ_a, ψ the direction of the line of centres.
        rho_own, rho_other = 1 / own, 1 / other
        psi = simplified((rho_other * parent.turn - rho_own * turn) / (rho_other - rho_own))
        return Pose(hub, parent.point(hub), ZERO, psi).point(start + roll.tangent.turned() / own)

    # --- points of contact -------------------------------------------------------------------------------------------

    def _spots(self) -> dict[str, Vec]:
        """Points where round outlines touch, and where ropes leave rims, stay with the centre, not with the rim."""
        found: dict[str, Vec] = {}
        for joint in (*self.scene.problem.joints, *self.scene.problem.idle):
            at, between = getattr(joint, "at", None), getattr(joint, "between", ())
            if joint.touches and at is not None and len(between) == 2:
                spot = self._touching(at, between)
                if spot is not None:
                    found[at] = spot
        rims = [pair for joint in self.scene.problem.joints for pair in joint.rims()]
        for point, body in (*rims, *(pair for load in self.scene.problem.loads for pair in load.rims())):
            found[point] = self._with_center(point, body)
        for joint in self.scene.problem.joints:
            found |= {point: self._tangent(point, body, other) for point, body, other in joint.tangents()}
        return found

    def _tangent(self, point: str, body: str, other: str) -> Vec:
        """Where a cord that runs straight to another point leaves a rim: P = C + ρ n + L t with t along the rim, so
        that n = (ρ r - L r × k) / r² with r = P - C and L² = r² - ρ². What has mass hangs on its cord without swaying,
        but where a state sends it aside.
        """
        scene, drum = self.scene, self.scene.hub(body, self.scene.point(point))
        start, owner = scene.point(other), scene.owner(other, body)
        hangs = owner != GROUND and scene.bodies[owner].mass != 0 and scene.problem.plane == "vertical"
        if owner == GROUND or (hangs and not sent_aside(scene, owner, False)):
            return self._with_center(point, body)
        arm = scene.point(point) - drum
        reach = self.poses[owner].point(start) - self.poses[body].point(drum)
        radius, way = scene.length(arm), scene.sign(arm.cross(start - drum))
        length = sp.sqrt(expanded(reach.dot(reach) - radius**2))
        normal: Vec = (reach * radius - reach.turned() * (length * way)) / reach.dot(reach)
        if self._is_steady(normal):
            return self._with_center(point, body)
        place: Vec = self.poses[body].point(drum) + normal * radius
        return place

    def _is_steady(self, direction: Vec) -> bool:
        """Does a direction stay the same, for the numbers of the file, however things move?"""
        inside = direction.x.free_symbols | direction.y.free_symbols
        moving = [c for c in self.coordinates if c.symbol in inside]
        value = self.scene.valuations[0]
        here = {c.symbol: (value.known(c.drawn or ZERO) or Decimal(0)) + anywhere(i) for i, c in enumerate(moving)}
        slopes = (derivative(e, c.symbol) for c in moving for e in (direction.x, direction.y))
        return all(value.extended(here).vanishes(slope) for slope in slopes)

    def _with_center(self, point: str, body: str) -> Vec:
        """A point of a rim that keeps its direction from the centre."""
        center = self.scene.hub(body, self.scene.point(point))
        return self._carried(body, center) + (self.scene.point(point) - center)

    def _touching(self, at: str, between: tuple[str, ...]) -> Vec | None:
        place = self.scene.point(at)
        rounds = [(p, c) for p in between if (c := round_center(self.scene, p, place)) is not None]
        if len(rounds) == 2:
            (a, ca), (b, cb) = rounds
            reach = cb - ca
            share = simplified((place - ca).dot(reach) / reach.dot(reach))
            now_a, now_b = (self._carried(p, c) for p, c in ((a, ca), (b, cb)))
            between_rims: Vec = now_a + (now_b - now_a) * share
            return between_rims
        if len(rounds) == 1:
            (name, center), other = rounds[0], next(p for p in between if p != rounds[0][0])
            if is_straight(self.scene, other, place):
                carrier = self.poses[self.scene.carrier(other)]
                return self._carried(name, center) + carrier.vector(place - center)
        return None

    def _carried(self, partner: str, center: Vec) -> Vec:
        return self.poses[self.scene.carrier(partner)].point(center)
