"""The coordinates of the file in terms of the bodies' own: what each is, and what keeps a point where it is written.

A coordinate with which a place or an angle is written is solved for, where it enters linearly: `A: [s, 0]` says
s = x of A, a rod's far end at the angle theta says theta = the rod's angle. What is written besides is kept as a
residual (y of A stays 0). A coordinate that nothing tells so stays a variable of its own.
"""

from __future__ import annotations

from dataclasses import field

from planar_cli.motion.scene.carried import Carried
from planar_cli.motion.scene.places import Drawing, points_of
from planar_cli.motion.terms.replacing import replaced
from planar_cli.motion.terms.sides import names_in
from planar_cli.motion.terms.terms import Term
from planar_cli.problem.language.expression import Side
from planar_cli.problem.scene.geometry import Vec
from planar_cli.problem.scene.scene import GROUND, At, Foot, Midpoint, Point, Polar, Rims, Tip, Towards, TwoFacts
from planar_cli.records import changing, record


@record
class Tie:
    """A residual of places that stays zero, beside those of the joints."""

    title: str
    """What it keeps, in words."""
    residual: Term
    """m or rad."""


@record
class _Handle:
    """What the file writes with coordinates, and the same of the bodies."""

    title: str
    group: str
    """Of the two parts of one place: the point's name."""
    kind: str
    """x, y, angle (of a body), direction or distance (of a place that is seen from another)."""
    formula: Term
    """As written, in variables that stand for the coordinates."""
    moving: Term
    """As the bodies have it."""


@changing
class Coordinates:
    """The coordinates of one scene."""

    scene: Carried
    stand_ins: dict[str, Term]
    """A variable for each coordinate, by name."""
    found: dict[str, Term] = field(default_factory=dict)
    """What each coordinate is."""
    ties: list[Tie] = field(default_factory=list)

    def run(self) -> None:
        """Solve for what can be told, keep the rest."""
        scene = self.scene
        drawing = Drawing(scene.problem, scene.sides.with_variables(self.stand_ins), scene.free)
        handles = [*self._angles(drawing), *self._points(drawing)]
        used = self._solve(handles)
        for name, variable in self.stand_ins.items():
            self.found.setdefault(name, variable)
        self._keep([h for h in handles if h not in used], used, drawing)

    # --- what is written ---------------------------------------------------------------------------------------------

    def _angles(self, drawing: Drawing) -> list[_Handle]:
        """Bodies whose angle is written with coordinates."""
        found = []
        for body in self.scene.problem.bodies:
            angle: Side | None = getattr(body.shape, "angle", None)
            place = self.scene.places[body.name]
            if angle is not None and place.theta is not None and self._written(angle):
                title = f"the angle of {body.name} follows its formula"
                found.append(_Handle(title, body.name, "angle", drawing.sides.value(angle), place.theta))
        return found

    def _written(self, *sides: Side) -> bool:
        return any(names_in(side) & self.stand_ins.keys() for side in sides)

    def _points(self, drawing: Drawing) -> list[_Handle]:
        """Points of bodies that are written with coordinates; those that follow from a body's angle come first."""
        first: list[_Handle] = []
        then: list[_Handle] = []
        for point in points_of(self.scene.problem).values():
            if self.scene.owner(point.name) == GROUND or point.name not in self.scene.own_points:
                continue
            if not self._follows(point):
                continue
            handles = self._of_point(point, drawing)
            rigidly = any(h.kind == "angle" for h in handles)
            (first if rigidly else then).extend(handles)
        return [*first, *then]

    def _follows(self, point: Point) -> bool:
        """Is the point written with a coordinate, or from a point that is?"""
        match point.place:
            case At(x, y):
                return self._written(x, y)
            case Polar(origin, distance, angle):
                return self._written(distance, angle) or self._follows_named(origin)
            case Towards(origin, towards, distance, offset):
                sides = [distance] if offset is None else [distance, offset]
                return self._written(*sides) or self._follows_named(origin) or self._follows_named(towards)
            case Midpoint(a, b):
                return self._follows_named(a) or self._follows_named(b)
            case TwoFacts() as facts:
                sides = [s for s in (facts.x, facts.y) if s is not None]
                others = [n for n, _ in (*facts.distances, *facts.lines)]
                sides += [side for _, side in (*facts.distances, *facts.lines)]
                return self._written(*sides) or any(self._follows_named(n) for n in others)
            case Foot(center, through, angle, towards):
                others = [n for n in (center, through, towards) if n]
                return (angle is not None and self._written(angle)) or any(self._follows_named(n) for n in others)
            case Tip(_, _, ends, plate, through, angle, towards):
                others = [n for n in (*ends, plate.center if plate is not None else "", through, towards) if n]
                sides = [s for s in (angle, plate.angle if plate is not None else None) if s is not None]
                return self._written(*sides) or any(self._follows_named(n) for n in others)
            case Rims(a, _, b, _):
                return self._follows_named(a) or self._follows_named(b)
        raise TypeError(type(point.place).__name__)

    def _follows_named(self, name: str) -> bool:
        point = points_of(self.scene.problem).get(name)
        return point is not None and self._follows(point)

    def _of_point(self, point: Point, drawing: Drawing) -> list[_Handle]:
        scene, place, name = self.scene, point.place, point.name
        title, moving = f"the place of {name} follows its formula", scene.point(name)
        # From a point that no body is drawn by (a point of contact), the whole formula counts.
        if isinstance(place, Polar) and (place.origin in scene.own_points or not self._follows_named(place.origin)):
            sides, body = drawing.sides, scene.owner(name)
            angle, distance = sides.value(place.angle), sides.value(place.distance)
            theta = scene.places[body].theta
            if body in scene.owners_of(place.origin) and theta is not None:
                turned = theta + (angle.value - theta.value)
                return [_Handle(f"the angle of {body} follows that of {name}", name, "angle", angle, turned)]
            reach = moving - scene.point(place.origin)
            length = scene.length(reach)
            if not length.zero:
                direction = scene.graph.turning(reach.y, reach.x) + angle.value
                # A distance may be drawn negative: against the written direction.
                along = -length if distance.value < 0 else length
                return [
                    _Handle(title, name, "direction", angle, direction),
                    _Handle(title, name, "distance", distance, along),
                ]
        formula = drawing.point(name)
        return [
            _Handle(title, name, "x", scene.graph.of(formula.x), scene.graph.of(moving.x)),
            _Handle(title, name, "y", scene.graph.of(formula.y), scene.graph.of(moving.y)),
        ]

    # --- solving -----------------------------------------------------------------------------------------------------

    def _solve(self, handles: list[_Handle]) -> set[_Handle]:
        """Take each handle in which one open coordinate enters linearly, until none is left."""
        used: set[_Handle] = set()
        going = True
        while going:
            going = False
            for handle in handles:
                if handle not in used and self._take(handle):
                    used.add(handle)
                    going = True
        return used

    def _take(self, handle: _Handle) -> bool:
        graph = self.scene.graph
        slopes = graph.gradient(handle.formula)
        open_names = [n for n, v in self.stand_ins.items() if n not in self.found and v in slopes]
        if len(open_names) != 1:
            return False
        name = open_names[0]
        variable = self.stand_ins[name]
        factor = slopes[variable]
        if not factor.constant or factor.value == 0:
            return False
        known = {self.stand_ins[n]: t for n, t in self.found.items()}
        rest = replaced(handle.formula, {**known, variable: graph.number(0.0)})
        self.found[name] = (handle.moving - rest) / factor
        return True

    # --- what is kept besides ----------------------------------------------------------------------------------------

    def _keep(self, handles: list[_Handle], used: set[_Handle], drawing: Drawing) -> None:
        known = {self.stand_ins[n]: t for n, t in self.found.items()}
        whole = {h.group for h in used}
        seen: set[str] = set()
        for handle in handles:
            if handle.kind in ("direction", "distance") and handle.group not in whole:
                # Neither part is solved for: the place itself is kept.
                if handle.group not in seen:
                    seen.add(handle.group)
                    self._place(handle, drawing, known)
                continue
            if handle.kind == "direction":
                self._across(handle, known)
                continue
            self._tie(handle.title, handle.moving - replaced(handle.formula, known))

    def _place(self, handle: _Handle, drawing: Drawing, known: dict[Term, Term]) -> None:
        off: Vec = self.scene.point(handle.group) - drawing.point(handle.group)
        for part in (off.x, off.y):
            self._tie(handle.title, replaced(self.scene.graph.of(part), known))

    def _across(self, handle: _Handle, known: dict[Term, Term]) -> None:
        """A place that is seen in a written direction has no part across it."""
        graph, place = self.scene.graph, points_of(self.scene.problem)[handle.group].place
        assert isinstance(place, Polar)
        reach = self.scene.point(handle.group) - self.scene.point(place.origin)
        angle = replaced(handle.formula, known)
        self._tie(handle.title, reach.y * graph.call("cos", angle) - reach.x * graph.call("sin", angle))

    def _tie(self, title: str, residual: Term) -> None:
        if any(not slope.constant or slope.value for slope in self.scene.graph.gradient(residual).values()):
            self.ties.append(Tie(title, residual))
