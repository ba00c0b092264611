"""What keeps the prescribed motion of a coordinate going, found from how places change with numbers of coordinates.

It does work through that coordinate and through no other. Where it acts is not told by the file; as usual it is
a torque on a body that turns with the coordinate alone; else a force on a point that goes with it alone; else a torque
that two bodies exert on each other whose angle goes with it alone; else a force on a point across the way in which that
goes with the others.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from decimal import Decimal
from functools import cached_property
from itertools import permutations

import sympy as sp

from planar_cli.equation.scene.scene import Scene
from planar_cli.equation.values.exact import ZERO, Valuation
from planar_cli.problem.language.expression import Name, Quantity, Relation, Side
from planar_cli.problem.scene.geometry import Vec
from planar_cli.problem.scene.shapes import own_points
from planar_cli.solve.multibody.agreement import FEW
from planar_cli.solve.multibody.poses import Place
from planar_cli.solve.multibody.time_jets import Slopes

STEP = Decimal(10) ** -8
WEIGHTS = (Decimal(3) / 4, Decimal(-3) / 20, Decimal(1) / 60)
"""Of the differences between both sides, one to three steps away: the slope, but for the sixth power of a step."""


class CoordinateDrives:
    """Generalized forces of what drives coordinates, in numbers."""

    def __init__(self, scene: Scene, value: Valuation, places: Mapping[str, Place]) -> None:
        self.scene, self.value, self.places = scene, value, places

    def of(self, relation: Relation) -> Slopes | None:
        """The generalized force of a unit of what keeps a relation of one coordinate going; None: nothing does."""
        for q in self._driven(relation):
            if (found := self._exerted(q)) is not None:
                return found
        return None

    def _driven(self, relation: Relation) -> Iterator[sp.Symbol]:
        """The coordinates that the relation gives, or whose rate it gives."""
        for side in (relation.left, relation.right):
            name = _name_of(side)
            yield from (q for q in self.scene.ledger.coordinates if q.name == name)

    def _exerted(self, q: sp.Symbol) -> Slopes | None:
        found = self._turned(q) or self._pushed(q) or self._turned_apart(q) or self._pushed_across(q)
        return found or None

    def _turned(self, q: sp.Symbol) -> Slopes:
        for name, turns in self._turns.items():
            if turns.get(q) and len(turns) == 1:
                return self._couple(name, turns[q])
        return {}

    def _pushed(self, q: sp.Symbol) -> Slopes:
        for name, arm, ways in self._ways:
            if q in ways and len(ways) == 1:
                return self._force(name, arm, ways[q])
        return {}

    def _turned_apart(self, q: sp.Symbol) -> Slopes:
        for one, other in permutations(self._turns, 2):
            between = {c: self._turns[one].get(c, ZERO) - self._turns[other].get(c, ZERO) for c in self._coordinates}
            if abs(between[q]) > FEW and all(abs(turn) <= FEW for c, turn in between.items() if c != q):
                return {**self._couple(one, between[q]), **self._couple(other, -between[q])}
        return {}

    def _pushed_across(self, q: sp.Symbol) -> Slopes:
        for name, arm, ways in self._ways:
            others = [way for c, way in ways.items() if c != q]
            for push in (ways[q], *(way.turned() for way in others[:1])) if q in ways else ():
                work, large = push.dot(ways[q]), _size(push)
                if abs(work) > FEW * large * _size(ways[q]) and all(
                    abs(push.dot(way)) <= FEW * large * _size(way) for way in others
                ):
                    return self._force(name, arm, push if work > 0 else -push)
        return {}

    def _couple(self, body: str, moment: Decimal) -> Slopes:
        column = self.places[body].columns[2]
        return {} if column is None else {column: moment}

    def _force(self, body: str, arm: Vec, force: Vec) -> Slopes:
        x, y, turn = self.places[body].columns
        found: Slopes = {x: force.x, y: force.y}
        if turn is not None:
            found[turn] = arm.cross(force)
        return found

    # --- how places go with coordinates ------------------------------------------------------------------------------

    @cached_property
    def _coordinates(self) -> dict[sp.Symbol, Decimal]:
        """All coordinates with their numbers."""
        numbers = {q: self.value.known(q) for q in self.scene.ledger.coordinates}
        return {q: number for q, number in numbers.items() if number is not None}

    @cached_property
    def _turns(self) -> dict[str, dict[sp.Symbol, Decimal]]:
        """By how much rigid bodies turn with every coordinate that turns them."""
        bodies = self.scene.bodies
        return {name: self._slopes(bodies[name].theta) for name in bodies if self.scene.rigid(name)}

    @cached_property
    def _ways(self) -> list[tuple[str, Vec, dict[sp.Symbol, Vec]]]:
        """Of mass centres and of points that tell a shape: the body, the arm from its mass centre, and the ways in
        which they go with coordinates.
        """
        found = []
        for name, body in self.scene.bodies.items():
            own = [self.scene.points[p] for p in own_points(body.shape) if p in self.scene.points]
            for point in (body.center, *own):
                x, y = self._slopes(point.x), self._slopes(point.y)
                ways = {q: Vec(x.get(q, ZERO), y.get(q, ZERO)) for q in self._coordinates if q in x or q in y}
                arm = Vec(self.value(point.x), self.value(point.y)) - self.places[name].center
                found.append((name, arm, ways))
        return found

    def _slopes(self, expr: sp.Expr) -> dict[sp.Symbol, Decimal]:
        """How an expression changes with each coordinate on which it rests, by differences of its numbers."""
        expr = sp.sympify(expr)
        if not expr.free_symbols:
            return {}
        slopes = {q: _slope(self._along(expr, q, number)) for q, number in self._coordinates.items()}
        largest = max(map(abs, slopes.values()), default=ZERO)
        return {q: s for q, s in slopes.items() if abs(s) > FEW * largest}

    def _along(self, expr: sp.Expr, q: sp.Symbol, number: Decimal) -> Callable[[Decimal], Decimal]:
        return lambda step: self.value.extended({q: number + step})(expr)


def _slope(f: Callable[[Decimal], Decimal]) -> Decimal:
    """The derivative at zero, by differences."""
    found: Decimal = sum((w * (f(k * STEP) - f(-k * STEP)) for k, w in enumerate(WEIGHTS, start=1)), ZERO)
    return found / STEP


def _size(v: Vec) -> Decimal:
    """The larger of the components."""
    larger: Decimal = max(abs(v.x), abs(v.y))
    return larger


def _name_of(side: Side) -> str:
    """The name that stands on a side alone, or whose rate does; "" for any other side."""
    if isinstance(side, Quantity) and side.word in ("dot", "ddot") and isinstance(side.argument, Name):
        return side.argument.name
    return side.name if isinstance(side, Name) else ""
