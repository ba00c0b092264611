"""One instant as a plain linear system in numbers: accelerations of every body and all pushes at once.

No tree, no choice of unknowns: each body has a_x, a_y (of its mass centre) and α. It decides which modes are possible,
which values are unique, and every sign, before anything is planned or printed.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable
from dataclasses import field
from decimal import Decimal
from typing import Any

from planar_cli.equation.values.exact import CERTAIN, ZERO, Valuation
from planar_cli.problem.scene.facts import Joining, Pull, Push, Row, Wrench
from planar_cli.problem.scene.geometry import Vec
from planar_cli.problem.scene.scene import GROUND
from planar_cli.records import changing
from planar_cli.solve.multibody.linear import Row as NumberRow

Twist = tuple[Vec, Decimal]
"""Velocity of the mass centre and ω, as numbers."""


@changing
class Assembly:
    """Rows in the unknowns (a_x, a_y, α of each body; pushes; sought loads), made from facts and numbers.

    `twists`: velocities of the bodies, settled. `names`: what each column is; `sources`: what each row says.
    """

    value: Valuation
    centers: dict[str, Vec]
    rigid: Callable[[str], bool]
    twists: dict[str, Twist]
    columns: dict[Any, int] = field(default_factory=dict)
    rows: list[dict[int, Decimal]] = field(default_factory=list)
    sources: list[str] = field(default_factory=list)
    alike: dict[str, str] = field(default_factory=dict)
    """Pushes that have the size of another one, and no column."""

    def __post_init__(self) -> None:
        for body in self.centers:
            for part in ("x", "y", "turn") if self.rigid(body) else ("x", "y"):
                self.column((body, part))

    def column(self, key: Any) -> int:
        return self.columns.setdefault(key, len(self.columns))

    def dense(self) -> list[NumberRow]:
        """The rows as lists, the constant last."""
        width = len(self.columns)
        found = []
        for row in self.rows:
            line = [ZERO] * (width + 1)
            for j, c in row.items():
                line[width if j < 0 else j] = c
            found.append(line)
        return found

    def number(self, v: Vec) -> Vec:
        return Vec(self.value(v.x), self.value(v.y))

    # --- motion ------------------------------------------------------------------------------------------------------

    def point_velocity(self, body: str, point: Vec) -> Vec:
        """v of the body's material point, all numbers."""
        if body == GROUND:
            return Vec(ZERO, ZERO)
        velocity, omega = self.twists[body]
        return velocity + (point - self.centers[body]).turned() * omega

    def spin(self, body: str) -> Decimal:
        return ZERO if body == GROUND else self.twists[body][1]

    def _add(self, row: dict[int, Decimal], body: str, point: Vec, direction: Vec, sign: int) -> None:
        """sign · direction · a of the body's material point."""
        if body == GROUND:
            return
        arm = point - self.centers[body]
        parts = [((body, "x"), direction.x), ((body, "y"), direction.y)]
        if self.rigid(body):
            parts.append(((body, "turn"), arm.cross(direction)))
        for key, c in parts:
            column = self.columns[key]
            row[column] = row.get(column, ZERO) + sign * c
        row[-1] = row.get(-1, ZERO) - sign * direction.dot(arm) * self.spin(body) ** 2

    def _spin(self, row: dict[int, Decimal], body: str, factor: Decimal) -> None:
        if body != GROUND and self.rigid(body):
            column = self.columns[(body, "turn")]
            row[column] = row.get(column, ZERO) + factor

    def joining(self, joining: Joining) -> None:
        """The accelerations that a joining forbids."""
        for direction in self._forbidden(joining):
            self.rows.append(self.across(joining, direction))
            self.sources.append(joining.joint)
        held = joining.keeps or all(b == GROUND or self.rigid(b) for b in (joining.mover, joining.base))
        if not joining.turns and held:
            row: dict[int, Decimal] = {}
            self._spin(row, joining.mover, Decimal(1))
            self._spin(row, joining.base, Decimal(-1))
            if row:
                self.rows.append(row)
                self.sources.append(joining.joint)

    def _forbidden(self, joining: Joining) -> tuple[Vec, ...]:
        if joining.path is not None:
            return (self.number(joining.path.tangent.turned()),)
        if joining.rolling is not None:
            tangent = self.number(joining.rolling.tangent)
            return tangent, tangent.turned()
        return Vec(Decimal(1), ZERO), Vec(ZERO, Decimal(1))

    def across(self, joining: Joining, direction: Vec) -> dict[int, Decimal]:
        """direction · (a_mover - a_base) less the bend and Coriolis part."""
        row: dict[int, Decimal] = {}
        point = self.number(joining.point)
        self._add(row, joining.mover, point, direction, 1)
        self._add(row, joining.base, point, direction, -1)
        base, mover = self.spin(joining.base), self.spin(joining.mover)
        bend, normal = ZERO, direction
        if joining.path is not None:
            tangent = self.number(joining.path.tangent)
            gap = self.point_velocity(joining.mover, point) - self.point_velocity(joining.base, point)
            if joining.drift is not None:
                gap = gap - self.number(joining.drift)
            speed, normal = gap.dot(tangent), tangent.turned()
            bend = self.value(joining.path.curvature) * speed**2 + 2 * base * speed
        elif joining.rolling is not None and base != mover:
            normal = self.number(joining.rolling.tangent).turned()
            bend = (base - mover) ** 2 / self.value(joining.rolling.mover - joining.rolling.base)
        row[-1] = row.get(-1, ZERO) - bend * normal.dot(direction)
        if joining.pace is not None:
            row[-1] -= self.number(joining.pace).dot(direction)
        if joining.drift is not None and joining.path is None and base:
            # A belt that is carried along: its surface turns with the body.
            row[-1] -= 2 * base * self.number(joining.drift).turned().dot(direction)
        return row

    def row(self, row: Row) -> dict[int, Decimal]:
        """The acceleration of a row."""
        found: dict[int, Decimal] = {-1: -self.value(row.pace)} if row.pace != 0 else {}
        for pull in row.pulls:
            self._add(found, pull.anchor.body, self.number(pull.anchor.point), self.number(pull.direction), 1)
        for body, factor in row.spins:
            self._spin(found, body, self.value(factor))
        for s in row.segments:
            direction = self.number(s.direction)
            start, end = self.number(s.start.point), self.number(s.end.point)
            self._add(found, s.end.body, end, direction, 1)
            self._add(found, s.start.body, start, direction, -1)
            if s.length is not None:
                across = (self.point_velocity(s.end.body, end) - self.point_velocity(s.start.body, start)).dot(
                    direction.turned()
                )
                found[-1] = found.get(-1, ZERO) + across**2 / self.value(s.length)
        if row.sharpening != 0:
            found[-1] = found.get(-1, ZERO) - self.value(row.sharpening) * self._pulled(row.slides) ** 2
        return found

    def _pulled(self, pulls: Iterable[Pull]) -> Decimal:
        """Σ of the velocities along pulls."""
        anchors = ((p.anchor.body, self.number(p.anchor.point), self.number(p.direction)) for p in pulls)
        return sum((self.point_velocity(body, at).dot(along) for body, at, along in anchors), ZERO)

    def row_speed(self, row: Row) -> Decimal:
        """The value of a row at velocity level, less its rate."""
        total = self._pulled(row.pulls) - self.value(row.rate)
        for body, factor in row.spins:
            total += self.spin(body) * self.value(factor)
        for s in row.segments:
            gap = self.point_velocity(s.end.body, self.number(s.end.point)) - self.point_velocity(
                s.start.body, self.number(s.start.point)
            )
            total += gap.dot(self.number(s.direction))
        return total

    # --- forces ------------------------------------------------------------------------------------------------------

    def kinetics(
        self,
        masses: dict[str, tuple[Any, Any]],
        pushes: tuple[Push, ...],
        wrenches: tuple[Wrench, ...],
        sought: tuple[tuple[str, Wrench], ...] = (),
    ) -> None:
        """Σ F - m a = 0 and Σ M_G - I α = 0 of every body. `sought`: what a unit of an unknown load does."""
        rows: dict[str, tuple[dict[int, Decimal], ...]] = {body: ({}, {}, {}) for body in self.centers}
        self.alike |= {push.name: push.like for push in pushes if push.like}
        for push in pushes:
            for action in push.actions:
                self._act(
                    rows, self.column(push.like or push.name), action.body, action.point, action.force, action.couple
                )
        for name, wrench in sought:
            self._act(rows, self.column(name), wrench.body, wrench.point, wrench.force, wrench.couple)
        for wrench in wrenches:
            self._act(rows, -1, wrench.body, wrench.point, wrench.force, wrench.couple)
        for body, (x, y, turn) in rows.items():
            mass, inertia = (self.value(m) for m in masses[body])
            x[self.columns[(body, "x")]] = -mass
            y[self.columns[(body, "y")]] = -mass
            self._keep(x, f"{body}, along x")
            self._keep(y, f"{body}, along y")
            if self.rigid(body):
                turn[self.columns[(body, "turn")]] = -inertia
                self._keep(turn, f"{body}, about its mass centre")

    def _keep(self, row: dict[int, Decimal], source: str) -> None:
        self.rows.append(row)
        self.sources.append(source)

    def _act(self, rows: Any, column: int, body: str, point: Vec, force: Vec | None, couple: Any) -> None:
        if body == GROUND:
            return
        at = self.number(point)
        f = self.number(force) if force is not None else Vec(ZERO, ZERO)
        moment = _moment(at - self.centers[body], f) + self.value(couple)
        for row, c in zip(rows[body], (f.x, f.y, moment), strict=True):
            if c:
                row[column] = _cancelled(row.get(column, ZERO), c)


def _moment(arm: Vec, force: Vec) -> Decimal:
    """Zero of a force along its arm, where only last digits are left."""
    return _cancelled(arm.x * force.y, -arm.y * force.x)


def _cancelled(one: Decimal, other: Decimal) -> Decimal:
    """A sum of loads; zero where only their last digits are left, which a small mass makes large."""
    total = one + other
    return ZERO if abs(total) <= CERTAIN * max(abs(one), abs(other)) else total
