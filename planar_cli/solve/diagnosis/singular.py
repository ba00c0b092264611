"""Singular positions, decided exactly at the drawn position: dead centres and change points.

Dead centre: a given speed whose coefficient on every motion that the joints allow is zero, though not in the positions
next to it (its rate along that motion is not zero): 0 · ω = v.

Change point: the joints lose an equation. A combination ν of their velocity equations vanishes, ν J = 0. Where supports
are merely redundant it does so all the way; here its rate, ν · γ(v), a quadratic form in the motions v that J allows,
is not zero. The motions for which it is zero are the ways in which the linkage can leave.
"""

from __future__ import annotations

from decimal import Decimal

import sympy as sp

from planar_cli.equation.algebra.form import Nonlinear, linear_form
from planar_cli.equation.kinematics.motion import Tree
from planar_cli.equation.system.conditions import ACCELERATION, VELOCITY, Condition, joint_conditions, stated
from planar_cli.equation.system.system import System
from planar_cli.equation.values.exact import CERTAIN, ONE, ZERO, Unvalued, Valuation
from planar_cli.problem.language.expression import Relation
from planar_cli.records import record
from planar_cli.solve.instant.instant import Instant
from planar_cli.solve.instant.study import certain, number_row
from planar_cli.solve.multibody.linear import Row, solve

SMALL = CERTAIN * 10**10
Vector = list[Decimal]


@record
class DeadCentre:
    """The given relation that says nothing here, and the motions that the joints allow."""

    relation: Relation
    motions: tuple[dict[sp.Symbol, Decimal], ...]


@record
class ChangePoint:
    """The motions that the joints' velocities allow, and those with which the linkage can leave (() when not worked
    out).
    """

    motions: tuple[dict[sp.Symbol, Decimal], ...]
    branches: tuple[dict[sp.Symbol, Decimal], ...]


class Joints:
    """The velocity equations of the joints alone, in numbers, and what they leave free."""

    def __init__(self, instant: Instant, system: System) -> None:
        self.instant, self.system = instant, system
        self.value = instant.scene.valuations[0]
        told = [e for c in self.conditions(VELOCITY) for e in c.rows()]
        # What is written with a coordinate may move as that does.
        standing = {s for e in told for s in e.free_symbols}
        rates = [s for s in instant.scene.evaluator.speeds if s in standing]
        self.columns = [*system.tree.velocity_unknowns(), *rates]
        self.rows: list[Row] = [number_row(linear_form(e, set(self.columns)), self.columns, self.value) for e in told]
        self.null: list[Vector] = list(solve([[*r[:-1], ZERO] for r in self.rows], len(self.columns)).null.values())

    def conditions(self, level: int) -> list[Condition]:
        """What the joints demand at a level."""
        system, rigid = self.system, self.system.scene.rigid
        touching = [mode.touching for mode in system.modes.values()]
        rows = [row for mode in system.modes.values() for row in mode.facts.rows]
        found = joint_conditions(system.tree, rows, system.first, level, rigid)
        if level == VELOCITY:
            closures = tuple(j for t in touching for j in t.joinings)
            found += joint_conditions(
                Tree((), closures), [r for t in touching for r in t.rows], system.first, level, rigid
            )
        return found

    @property
    def steady(self) -> bool:
        """Do no belts or drives run by themselves?"""
        return all(not row[-1] for row in self.rows)

    def as_motion(self, vector: Vector) -> dict[sp.Symbol, Decimal]:
        return dict(zip(self.columns, vector, strict=True))

    def moving(self, vector: Vector) -> Valuation:
        """Numbers of everything in this motion, without acceleration."""
        rates = self.system.tree.acceleration_unknowns()
        still = dict.fromkeys(self.instant.scene.evaluator.speeds, ZERO)
        still |= dict.fromkeys(self.instant.scene.evaluator.second_rates, ZERO)
        return self.value.extended({**still, **dict.fromkeys(rates, ZERO), **self.as_motion(vector)})

    def bends(self, vector: Vector) -> list[Decimal]:
        """γ(v): what the acceleration equations of the joints leave when the unknown accelerations are zero."""
        numbers = self.moving(vector)
        return [certain(e, numbers) for c in self.conditions(ACCELERATION) for e in c.rows()]


def blocked(instant: Instant, system: System, starts: dict[sp.Symbol, Decimal]) -> bool:
    """Do the joints forbid, to the second order, a motion that their velocities allow?"""
    joints = Joints(instant, system)
    vector = [starts.get(x, ZERO) for x in joints.columns]
    if not joints.steady or not any(vector):
        return False
    bends = joints.bends(vector)
    if len(bends) != len(joints.rows):
        return False
    size = max((abs(b) for b in bends), default=ZERO)
    across = [[*(r[j] for r in joints.rows), ZERO] for j in range(len(joints.columns))]
    for nu in solve(across, len(joints.rows)).null.values():
        if abs(sum((a * b for a, b in zip(nu, bends, strict=True)), ZERO)) > SMALL * max(size, ONE):
            return True
    return False


def change_point(instant: Instant, system: System) -> ChangePoint | None:
    """Is the drawn position a change point?"""
    joints = Joints(instant, system)
    count = len(joints.rows)
    plain = [e for c in joints.conditions(ACCELERATION) for e in c.rows()]
    if not joints.null or not joints.steady or len(plain) != count:
        return None
    across = [[*(r[j] for r in joints.rows), ZERO] for j in range(len(joints.columns))]
    dependencies = solve(across, count).null.values()
    forms = [f for nu in dependencies if (f := _form(joints, list(nu))) is not None]
    if not forms:
        return None
    return ChangePoint(tuple(joints.as_motion(v) for v in joints.null), _branches(joints, forms))


def _form(joints: Joints, nu: Vector) -> list[list[Decimal]] | None:
    """The quadratic form ν · γ on the motions that the joints allow; None when it vanishes."""

    def at(vector: Vector) -> Decimal:
        parts = [a * b for a, b in zip(nu, joints.bends(vector), strict=True)]
        total, size = sum(parts, ZERO), max((abs(p) for p in parts), default=ZERO)
        return ZERO if abs(total) <= SMALL * max(size, SMALL) else total

    null = joints.null
    squares = [at(v) for v in null]
    form = [[ZERO] * len(null) for _ in null]
    for i, v in enumerate(null):
        form[i][i] = squares[i]
        for j in range(i):
            both = at([a + b for a, b in zip(v, null[j], strict=True)])
            half = (both - squares[i] - squares[j]) / 2
            form[i][j] = form[j][i] = ZERO if abs(half) <= SMALL else half
    return form if any(any(row) for row in form) else None


def _branches(joints: Joints, forms: list[list[list[Decimal]]]) -> tuple[dict[sp.Symbol, Decimal], ...]:
    """Where two motions are free: the combinations for which every form vanishes."""
    if len(joints.null) != 2:
        return ()
    (a, b), (_, c) = forms[0]
    root = b * b - a * c
    if root < 0:
        return ()
    if not a:
        pairs = [(ONE, ZERO), (-c, 2 * b)] if b else [(ONE, ZERO)]
    else:
        pairs = [((-b + s * root.sqrt()) / a, ONE) for s in (1, -1)]
    found = []
    for p, q in pairs:
        if all(abs(f[0][0] * p * p + 2 * f[0][1] * p * q + f[1][1] * q * q) <= SMALL * 10**5 for f in forms):
            vector = [p * x + q * y for x, y in zip(*joints.null, strict=True)]
            size = max(abs(x) for x in vector)
            found.append(joints.as_motion([ZERO if abs(x) <= SMALL * size else x for x in vector]))
    return tuple(found)


def dead_centre(instant: Instant, system: System) -> DeadCentre | None:
    """Is there a given speed that says nothing in this position alone?"""
    joints = Joints(instant, system)
    if not joints.null or not joints.steady:
        return None
    names = {s.name for s in instant.scene.ledger.coordinates}
    quantities = system.quantities_of(system.first, None)
    for relation, _ in instant.statements.relations:
        conditions = stated([(relation, True)], quantities, quantities.evaluator, names, VELOCITY)
        try:
            silent = bool(conditions) and all(_silent(joints, e) for c in conditions for e in c.rows())
        except (Nonlinear, Unvalued):
            continue
        if silent and any(_changes(joints, relation, names, v) for v in _mixed(joints.null)):
            return DeadCentre(relation, tuple(joints.as_motion(v) for v in joints.null))
    return None


def _mixed(null: list[Vector]) -> list[Vector]:
    """The free motions, and sums of two."""
    sums = [[a + b for a, b in zip(u, v, strict=True)] for i, u in enumerate(null) for v in null[:i]]
    return [*null, *sums]


def _silent(joints: Joints, expr: sp.Expr) -> bool:
    """Is an equation about velocities without a word on every free motion?"""
    inside = set(joints.columns)
    row = number_row(linear_form(expr, inside), joints.columns, joints.value)
    return all(abs(sum((a * b for a, b in zip(row, v, strict=False)), ZERO)) <= SMALL for v in joints.null)


def _changes(joints: Joints, relation: Relation, names: set[str], vector: Vector) -> bool:
    """Does what the relation says of the velocities change along this motion?"""
    system, numbers = joints.system, joints.moving(vector)
    rates = list(system.tree.acceleration_unknowns())
    rows = [
        number_row(linear_form(e, set(rates)), rates, _without(numbers, rates))
        for c in joints.conditions(ACCELERATION)
        for e in c.rows()
    ]
    solved = solve(rows, len(rates))
    if solved.conflict is not None:
        return False
    quantities = system.quantities_of(system.first, None)
    settled = numbers.extended(dict(zip(rates, solved.values, strict=True)))
    conditions = stated([(relation, True)], quantities, quantities.evaluator, names, ACCELERATION)
    return any(abs(certain(e, settled)) > SMALL for c in conditions for e in c.rows())


def _without(numbers: Valuation, symbols: list[sp.Symbol]) -> Valuation:
    return numbers.without(symbols)
