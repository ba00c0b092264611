"""Conditions between coordinates: what closes loops, ropes of a given length, rims that roll on each other.

They come from the same position residuals of the joints that the independent check uses, written in the coordinates of
a general position.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from decimal import Decimal
from typing import Any

import mpmath
import sympy as sp

from planar_cli.equation.algebra.plain import derivative, simplified
from planar_cli.equation.scene.curves import bend_at, off_curve
from planar_cli.equation.scene.displacement import Coordinate, Displacement
from planar_cli.equation.scene.pose import HERE, Pose
from planar_cli.equation.scene.scene import Scene
from planar_cli.equation.scene.turning import written_angle
from planar_cli.equation.values.exact import DIGITS, Valuation
from planar_cli.equation.values.ledger import Kind
from planar_cli.equation.values.sample import anywhere
from planar_cli.errors import NotReached
from planar_cli.joints.base import Joint
from planar_cli.loads.base import Load
from planar_cli.problem.scene.facts import Mode, Outline
from planar_cli.problem.scene.geometry import Vec
from planar_cli.problem.scene.ordinary import Scales
from planar_cli.problem.scene.scene import GROUND, Curve, Surface
from planar_cli.records import changing, record
from planar_cli.solve.instant.instant import Instant
from planar_cli.solve.multibody.linear import solve
from planar_cli.units import parse_unit

STEPS = 60
SMALL = Decimal("1e-45")


@record
class Constraint:
    """A residual that vanishes in every position; `title` says what it keeps, `joint` whose it is. `kind`: "loop", or
    "motion" where the file itself states it, or "kept" where it only stays what it was as the joint took hold.
    """

    residual: sp.Expr
    title: str
    joint: str
    kind: str = "loop"


@changing
class GeneralPoses:
    """The poses of a displaced scene, as expressions in its coordinates. `start`: the coordinates as drawn."""

    scene: Scene
    displacement: Displacement
    start: Mapping[sp.Symbol, sp.Expr]
    value: Valuation
    time: sp.Expr

    def number(self, drawn: Any) -> Any:
        return self._written(sp.sympify(drawn))

    def vector(self, drawn: Vec) -> Vec:
        return Vec(self._written(drawn.x), self._written(drawn.y))

    def point(self, body: str, drawn: Vec) -> Vec:
        pose = self.displacement.poses.get(body, HERE)
        if body in self.displacement.formula:
            return drawn + pose.place - pose.drawn
        return pose.point(self.vector(drawn))

    def direction(self, body: str, drawn: Vec) -> Vec:
        if body in self.displacement.formula:
            return drawn
        return self.displacement.poses.get(body, HERE).vector(self.vector(drawn))

    def angle(self, body: str) -> Any:
        turn = self.displacement.poses.get(body, HERE).turn
        if turn == 0 and body in self.displacement.formula:
            theta = self.displacement.poses[body].now
            told = theta - self._drawn(theta)
            return told if told != 0 else self._turned_by_points(body)
        return turn

    def _turned_by_points(self, body: str) -> sp.Expr:
        """By how much a body has turned on which the file places points with its coordinates; 0 where it has none."""
        scene, center = self.scene, self.scene.center(body)
        arms = (scene.point(point) - center for point in sorted(scene.own_points) if scene.owner(point) == body)
        return next((turn for arm in arms if (turn := self.turned(arm)) != 0), sp.S.Zero)

    def _written(self, expr: sp.Expr) -> sp.Expr:
        """What the file writes with its own coordinates, as it was at the start."""
        roles = self.scene.ledger.roles
        return expr.subs({s: v for s, v in self.start.items() if v in roles and roles[v].kind is Kind.START})

    def length(self, v: Vec) -> Any:
        return sp.sqrt(simplified(v.dot(v)))

    def root(self, square: Any) -> Any:
        return sp.sqrt(simplified(square))

    def turned(self, v: Vec) -> Any:
        angle = written_angle(v, {*self.start, self.scene.ledger.symbols["t"]}, self.positive)
        if angle is not None:
            return self.change(angle)
        before = Vec(self._drawn(v.x), self._drawn(v.y))
        cross, dot = simplified(before.cross(v)), simplified(before.dot(v))
        return sp.S.Zero if cross == 0 else sp.atan2(cross, dot)

    def positive(self, number: Any) -> bool:
        return bool(self.value(self._drawn(sp.sympify(number))) >= 0)

    def change(self, number: Any) -> Any:
        return number - self._drawn(number)

    def off_curve(self, curve: Outline, other: Outline, place: Vec) -> Any:
        """How far a corner is off a curve, as the body of the curve sees it."""
        _, shape, pose = self._curve(curve)
        if other.kind == "arc":
            raise self._not_followed(curve, other)
        return off_curve(self.scene, shape, pose, self.point(other.body, place), self._sign)

    def foot(self, curve: Outline, rim: Outline, place: Vec) -> tuple[Any, Any]:
        """No formula tells where a rim touches a curve."""
        raise self._not_followed(curve, rim)

    def _not_followed(self, curve: Outline, rim: Outline) -> Exception:
        text = f"{rim.body} touches the curve {curve.curve} with its rim: its places are not followed over time"
        return self.scene.refuse(self.scene.surfaces[curve.curve].mark, "PL591", text, "ask at one instant")

    def along_curve(self, curve: Outline, body: str, place: Vec) -> Vec:
        """The tangent of a curve where the body's point is."""
        surface, shape, pose = self._curve(curve)
        return bend_at(self.scene, surface, shape, pose, self.point(body, place)).tangent

    def _curve(self, outline: Outline) -> tuple[Surface, Curve, Pose]:
        """The surface of an outline, its curve, and where its body is."""
        surface = self.scene.surfaces[outline.curve]
        assert isinstance(surface.shape, Curve)
        return surface, surface.shape, self.displacement.poses.get(surface.body or GROUND, HERE)

    def _sign(self, number: Any) -> int:
        return 1 if self.positive(number) else -1

    def _drawn(self, expr: Any) -> Any:
        return sp.sympify(expr).subs(self.start)


def start_of(coordinates: Iterable[Coordinate]) -> dict[sp.Symbol, sp.Expr]:
    """All coordinates as drawn."""
    return {c.symbol: c.drawn if c.drawn is not None else c.start for c in coordinates}


def constraints_of(
    drawn: Instant, choice: tuple[int, ...], displacement: Displacement, coordinates: tuple[Coordinate, ...]
) -> tuple[Constraint, ...]:
    """All conditions between the coordinates that the tree has not already built in; what a joint keeps only for some
    time depends on where it begins.
    """
    scene = drawn.scene
    base = scene.valuations[0]
    start = start_of(coordinates)
    value = base.extended({s: base(s) for s in start.values() if s.is_Symbol and s in base.values})
    value = value.extended(_loose_starts(coordinates, start, value, scene.ledger.scales))
    poses = GeneralPoses(scene, displacement, start, value, scene.ledger.symbols["t"])
    found: list[Constraint] = []
    for (joint, modes), index in zip(drawn.modes, choice, strict=True):
        if joint.during is not None:
            if GROUND in getattr(joint, "between", ()):
                found += _residuals(scene, joint, modes[index], poses, value, start, "kept")
            elif not modes[index].parted:
                found += _residuals(scene, joint, modes[index], poses, value, start, "loop", anywhere=True)
                found += _residuals(scene, joint, modes[index], poses, value, start, "kept", anywhere=False)
            continue
        if not modes[index].parted:
            found += _residuals(scene, joint, modes[index], poses, value, start, "loop")
    return tuple(found)


def kept_while_held(
    drawn: Instant, joint: Joint | Load, mode: Mode, displacement: Displacement, coordinates: tuple[Coordinate, ...]
) -> tuple[Constraint, ...]:
    """What a joint would keep in one of its modes, in the coordinates of a position in which it has parted."""
    base = drawn.scene.valuations[0]
    start = start_of(coordinates)
    value = base.extended(_loose_starts(coordinates, start, base, drawn.scene.ledger.scales))
    poses = GeneralPoses(drawn.scene, displacement, start, value, drawn.scene.ledger.symbols["t"])
    return tuple(_residuals(drawn.scene, joint, mode, poses, value, start, "loop"))


def drawn_starts(coordinates: Iterable[Coordinate], scales: Scales) -> dict[sp.Symbol, Decimal]:
    """Any values for where coordinates start."""
    return {c.start: anywhere() * scales.exact(parse_unit(c.unit).dimension) for c in coordinates}


def _loose_starts(
    coordinates: Iterable[Coordinate], start: Mapping[sp.Symbol, sp.Expr], value: Valuation, scales: Scales
) -> dict[sp.Symbol, Decimal]:
    """The same of those that the file leaves open."""
    every = drawn_starts(coordinates, scales)
    return {v: every.get(v, anywhere()) for v in start.values() if v.is_Symbol and v not in value.values}


def _residuals(
    scene: Scene,
    joint: Joint | Load,
    mode: Mode,
    poses: GeneralPoses,
    value: Valuation,
    start: Mapping[sp.Symbol, sp.Expr],
    kind: str,
    anywhere: bool | None = None,
) -> Iterator[Constraint]:
    """The places that a joint keeps in one of its modes; `anywhere`: only those that it keeps wherever it begins, or
    only the others.
    """
    for residual in joint.residuals(scene, mode):
        if anywhere not in (None, residual.anywhere):
            continue
        vanishing = residual.of(poses)
        for part in (vanishing.x, vanishing.y) if isinstance(vanishing, Vec) else (vanishing,):
            expr = sp.fraction(sp.together(part))[0] if anywhere else part
            expr = simplified(expr)
            if expr != 0 and expr.free_symbols & set(start) and not _vanishes(expr, value, start):
                yield Constraint(expr, residual.title, joint.name, kind)


def _vanishes(expr: sp.Expr, value: Valuation, start: Mapping[sp.Symbol, sp.Expr]) -> bool:
    """Does it vanish whatever the coordinates are?"""
    for seed in (1, 2):
        draw = value.extended({s: Decimal(seed * 7 + i) / 23 for i, s in enumerate(start)})
        if draw.known(expr) is None or not draw.is_zero(expr):
            return False
    return True


def project(
    constraints: tuple[Constraint, ...], unknowns: tuple[sp.Symbol, ...], value: Valuation
) -> dict[sp.Symbol, Decimal]:
    """Coordinates near those of `value` that satisfy all constraints, by Newton's method with the shortest steps.

    NotReached: it does not converge.
    """
    exprs = [c.residual for c in constraints]
    slopes = [[derivative(e, x) if x in e.free_symbols else sp.S.Zero for x in unknowns] for e in exprs]
    at = {x: value(x) for x in unknowns}
    with mpmath.workdps(DIGITS):
        for _ in range(STEPS):
            here = value.extended(at)
            remains, rises = [here(e) for e in exprs], [[here(d) for d in row] for row in slopes]
            if not all(v.is_finite() for row in (remains, *rises) for v in row):
                break
            rest = mpmath.matrix([mpmath.mpf(str(v)) for v in remains])
            jacobian = mpmath.matrix([[mpmath.mpf(str(v)) for v in row] for row in rises])
            step = _shortest(jacobian, rest)
            at = {x: at[x] - Decimal(mpmath.nstr(step[i], DIGITS)) for i, x in enumerate(unknowns)}
            if max(abs(s) for s in step) < mpmath.mpf(str(SMALL)):
                return at
    raise NotReached("the positions do not close")


def fixed_by(
    constraints: tuple[Constraint, ...], unknowns: tuple[sp.Symbol, ...], value: Valuation
) -> frozenset[sp.Symbol]:
    """The coordinates that the constraints leave no freedom at one time."""
    rows = [[value(derivative(c.residual, x)) for x in unknowns] + [Decimal(0)] for c in constraints]
    solved = solve(rows, len(unknowns))
    return frozenset(x for j, x in enumerate(unknowns) if solved.unique(j))


def _shortest(jacobian: Any, rest: Any) -> Any:
    """The shortest step that removes the remainders: Jᵀ (J Jᵀ)⁻¹ r, dependent rows left to a small weight."""
    square = jacobian * jacobian.T
    size = max([abs(square[i, i]) for i in range(square.rows)] + [mpmath.mpf(1)])
    for i in range(square.rows):
        square[i, i] += size * mpmath.mpf(10) ** -40
    return jacobian.T * mpmath.lu_solve(square, rest)
