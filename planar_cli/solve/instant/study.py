"""One choice of modes in numbers: its velocities, its accelerations and pushes, and whether its assumptions hold."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import field, replace
from decimal import Decimal
from functools import partial
from typing import Any

import sympy as sp

from planar_cli.equation.algebra.form import Form, Nonlinear, linear_form
from planar_cli.equation.kinematics.motion import Motion
from planar_cli.equation.kinematics.moving import all_wrenches
from planar_cli.equation.system.conditions import ACCELERATION, VELOCITY, Condition
from planar_cli.equation.system.system import System
from planar_cli.equation.values.exact import CERTAIN, ONE, ZERO, Valuation
from planar_cli.equation.values.tangent import Tangent
from planar_cli.errors import Undecided
from planar_cli.problem.scene.facts import Mode, Test, Wrench
from planar_cli.problem.scene.geometry import Vec
from planar_cli.records import changing
from planar_cli.solve.instant.tangents import tangent_in
from planar_cli.solve.multibody.assembly import Assembly, Twist
from planar_cli.solve.multibody.linear import Row, Solved, solve

MOST_INEQUALITIES = 4000
TINY = Decimal("1e-25")
"""A slower slip is none: what sixty digits leave of a zero, in m/s."""
"""Beyond so many the elimination of what is not unique is given up, and said so."""


@changing
class Velocities:
    """Velocity unknowns in numbers. `free`: those that no condition fixes; `nonlinear`: conditions left for later."""

    values: dict[sp.Symbol, Decimal]
    free: tuple[sp.Symbol, ...]
    conflict: tuple[list[tuple[Condition, Decimal]], Decimal] | None
    nonlinear: tuple[Condition, ...]
    loose: dict[sp.Symbol, dict[sp.Symbol, Decimal]] = field(default_factory=dict)


def solve_velocities(
    system: System,
    value: Valuation,
    at_rest: bool,
    seek: bool = True,
    given: dict[sp.Symbol, Decimal] | None = None,
    sways: bool = False,
) -> Velocities:
    """All velocity conditions at once; what stays free is zero at rest.

    `seek`: constants that are sought may be columns too. `given`: velocities that are known already. `sways`: what
    hangs may sway, though nothing tells that it does.
    """
    ledger = system.scene.ledger
    rates = system.scene.evaluator.speeds
    conditions = system.velocity_conditions()
    unknowns = [*system.tree.velocity_unknowns(), *rates]
    sought = [s for s in ledger.sought if any(s in e.free_symbols for c in conditions for e in c.rows())]
    columns = unknowns + [s for s in sought if seek and _linear_everywhere(s, conditions, set(unknowns))]
    rows: list[Row] = []
    sources: list[Condition] = []
    nonlinear: list[Condition] = []
    inside = set(columns)
    for condition in conditions:
        for expr in condition.rows():
            try:
                rows.append(number_row(linear_form(expr, inside), columns, value))
                sources.append(condition)
            except Nonlinear:
                nonlinear.append(condition)
    for x, number in (given or {}).items():
        if x in inside:
            rows.append([ONE if c == x else ZERO for c in columns] + [-number])
            sources.append(Condition("given", x.name, x))
    solved = solve(rows, len(columns))
    for x in () if sways else _swaying(system, columns, solved):
        rows.append([ONE if c == x else ZERO for c in columns] + [ZERO])
        sources.append(Condition("given", f"{x.name}: nothing makes it sway", x))
    solved = solve(rows, len(columns))
    conflict = None
    if solved.conflict is not None:
        factors, rest = solved.conflict
        conflict = ([(c, f) for c, f in zip(sources, factors, strict=True) if f], rest)
    if conflict is None and at_rest and given is None:
        conflict = _moves_at_rest(rows, sources, len(columns))
    values = dict(zip(columns, solved.values, strict=True))
    free = () if (at_rest and not nonlinear) or given is not None else tuple(columns[j] for j in solved.null)
    loose: dict[sp.Symbol, dict[sp.Symbol, Decimal]] = {}
    if free:
        loose = {
            columns[j]: {x: v for x, v in zip(columns, vector, strict=True) if v} for j, vector in solved.null.items()
        }
    if free:
        for j in range(len(columns)):
            if not solved.unique(j):
                del values[columns[j]]
    return Velocities(values, free, conflict, tuple(nonlinear), loose)


def _moves_at_rest(
    rows: list[Row], sources: list[Condition], width: int
) -> tuple[list[tuple[Condition, Decimal]], Decimal] | None:
    """A velocity stated for this instant that is not the one at rest: only `motion` moves what is at rest."""
    stated = [(r, c) for r, c in zip(rows, sources, strict=True) if c.now]
    if not stated:
        return None
    rest = solve([r for r, c in zip(rows, sources, strict=True) if not c.now], width)
    for row, condition in stated:
        remainder = sum((a * v for a, v in zip(row, rest.values, strict=False)), row[-1])
        if abs(remainder) > CERTAIN * 10**15:
            return [(condition, ONE), (Condition("given", "at rest", condition.residual), ONE)], remainder
    return None


def _swaying(system: System, columns: list[sp.Symbol], solved: Solved) -> list[sp.Symbol]:
    """Sideways velocities of what hangs on a rope, where nothing else moves with them and nothing tells them.

    What hangs does not swing unless the file says so; where accelerations or forces are given, they may tell the speed.
    """
    if system.states(ACCELERATION) and not system.states(VELOCITY):
        return []
    hanging = system.hanging()
    alone = [columns[j] for j, vector in solved.null.items() if sum(bool(c) for c in vector) == 1]
    return [x for x in alone if x in hanging]


def _linear_everywhere(symbol: sp.Symbol, conditions: list[Condition], unknowns: set[sp.Symbol]) -> bool:
    for condition in conditions:
        for expr in condition.rows():
            if symbol in expr.free_symbols:
                try:
                    linear_form(expr, unknowns | {symbol})
                except Nonlinear:
                    return False
    return True


def number_row(form: Form, columns: list[sp.Symbol], value: Valuation) -> Row:
    """A linear form as numbers, exact zeros where terms cancel."""
    return [*(certain(form.terms.get(x, sp.S.Zero), value) for x in columns), certain(form.constant, value)]


def certain(expr: sp.Expr, value: Valuation) -> Decimal:
    """The value, or an exact zero where the expression vanishes."""
    if expr == 0:
        return ZERO
    found = value(expr)
    return ZERO if found and abs(found) < Decimal("1e-15") and value.is_zero(expr) else found


@changing
class Outcome:
    """Numbers of one choice of modes for one valuation.

    `solved` over the columns of `assembly`; `failed`: the tests that do not hold, with their values; `open_tests`:
    tests whose value is free, but which can hold together; `nonlinear`: relations between accelerations or forces that
    were left out, as only a search solves them.
    """

    assembly: Assembly
    solved: Solved
    failed: tuple[tuple[Test, Decimal | None], ...]
    value: Valuation
    nonlinear: tuple[str, ...] = ()

    def push(self, name: str) -> Decimal | None:
        """The value of a push; None when it is not unique, zero when it is absent."""
        column = self.assembly.columns.get(self.assembly.alike.get(name, name))
        if column is None:
            return ZERO
        return self.solved.values[column] if self.solved.unique(column) else None


def accelerate(
    system: System, velocities: Velocities, value: Valuation, free: Motion, known: dict[sp.Symbol, Decimal]
) -> Outcome:
    """Accelerations and pushes of a system whose velocities are settled.

    `free`: a motion in which no body hangs on another; the file's own relations are read in it. `known`: unknowns that
    are settled, constants above all.
    """
    scene = system.scene
    numbers = value.extended(velocities.values)
    zero = {s: sp.S.Zero for s, v in velocities.values.items() if not v}
    system.settle(zero, ())
    assert system.motion is not None
    wrenches = all_wrenches(scene, system.motion, numbers, system.skids(), system.idle())
    system.settle(zero, wrenches)
    twists: dict[str, Twist] = {}
    centers: dict[str, Vec] = {}
    for name, body in scene.bodies.items():
        v = system.motion.velocity(body.center, name)
        centers[name] = Vec(numbers(body.center.x), numbers(body.center.y))
        twists[name] = (
            Vec(certain(v.x, numbers), certain(v.y, numbers)),
            certain(system.motion.velocities[name].angular, numbers),
        )
    assembly = Assembly(numbers, centers, scene.rigid, twists)
    for mode in system.modes.values():
        for joining in mode.facts.joinings:
            assembly.joining(joining)
        for row in mode.facts.rows:
            assembly.rows.append(assembly.row(row))
            assembly.sources.append(row.title)
    sought = set(scene.ledger.sought) - set(known)
    add_loads(assembly, system, wrenches, sought)
    nonlinear = add_given(assembly, system, free, sought, known)
    for law in system.laws:
        line = {assembly.column(law.push): ONE}
        factor = -numbers(law.factor)
        line[assembly.column(law.of) if law.of else -1] = factor
        assembly.rows.append(line)
        assembly.sources.append(f"friction law of {law.push}")
    solved = solve(assembly.dense(), len(assembly.columns))
    return Outcome(assembly, solved, failing(system, assembly, solved), numbers, nonlinear)


def with_pushes(system: System, outcome: Outcome, known: Mapping[sp.Symbol, Decimal]) -> Outcome:
    """The outcome with these pushes, where its equations leave pushes open: those that are not known go with them."""
    assembly = outcome.assembly
    columns = {
        c: known[s] for n, s in system.symbols.items() if s in known and (c := assembly.columns.get(n)) is not None
    }
    if not outcome.solved.null or not columns:
        return outcome
    width = len(assembly.columns)
    told = [[ONE if j == column else ZERO for j in range(width)] + [-v] for column, v in columns.items()]
    return replace(outcome, solved=solve([*assembly.dense(), *told], width))


def add_loads(assembly: Assembly, system: System, wrenches: tuple[Wrench, ...], sought: set[sp.Symbol]) -> None:
    """Kinetics of all bodies; sought magnitudes of loads are columns of their own."""
    scene = system.scene
    known: list[Wrench] = []
    unknown: list[tuple[str, Wrench]] = []
    for w in wrenches:
        force = w.force or Vec(sp.S.Zero, sp.S.Zero)
        forms = [linear_form(sp.sympify(e), sought) for e in (force.x, force.y, w.couple)]
        known.append(
            Wrench(w.name, w.kind, w.body, w.point, Vec(forms[0].constant, forms[1].constant), forms[2].constant)
        )
        for s in dict.fromkeys(s for f in forms for s in f.terms):
            parts = [f.terms.get(s, sp.S.Zero) for f in forms]
            unknown.append((s.name, Wrench(w.name, w.kind, w.body, w.point, Vec(parts[0], parts[1]), parts[2])))
    masses = {name: (b.mass, b.inertia) for name, b in scene.bodies.items()}
    assembly.kinetics(masses, system.pushes, tuple(known), tuple(unknown))


def add_given(
    assembly: Assembly, system: System, free: Motion, sought: set[sp.Symbol], known: dict[sp.Symbol, Decimal]
) -> tuple[str, ...]:
    """The file's own acceleration relations, over body accelerations, pushes, sought constants and rates of
    coordinates. Nonlinear ones count to first order where the unknowns are `known`; the others are returned.
    """
    conditions = system.stated_accelerations(free)
    if not conditions:
        return ()
    keys: dict[sp.Symbol, Any] = {symbol: name for name, symbol in system.symbols.items()}
    moving: dict[sp.Symbol, Decimal] = {}
    for edge in free.tree.edges:
        velocity, omega = assembly.twists[edge.body]
        for part, rate, speed, value in (
            ("x", edge.slide_rate, edge.slide, velocity.x),
            ("y", edge.rise_rate, edge.rise, velocity.y),
            ("turn", edge.spin_rate, edge.spin, omega),
        ):
            if rate is not None and speed is not None:
                keys[rate], moving[speed] = (edge.body, part), value
    for symbol in (*sought, *system.scene.evaluator.second_rates):
        keys[symbol] = symbol.name
    present = {p.name for p in system.pushes}
    value = assembly.value.extended(moving)
    still = {speed: sp.S.Zero for speed, v in moving.items() if v == 0}
    near = partial(tangent_in, keys=keys, system=system, free=free, value=value, known=known)
    nonlinear = []
    for condition in conditions:
        for expr in condition.rows():
            if (form := _first_order(expr.xreplace(still), keys, value, near)) is None:
                nonlinear.append(condition.text)
                continue
            row: dict[int, Decimal] = {-1: form.constant}
            for symbol, coefficient in form.slopes.items():
                if keys[symbol] not in system.symbols or keys[symbol] in present:
                    row[assembly.column(keys[symbol])] = coefficient
            assembly.rows.append(row)
            assembly.sources.append(condition.text)
    return tuple(nonlinear)


def _first_order(
    expr: sp.Expr, keys: dict[sp.Symbol, Any], value: Valuation, known: Callable[[sp.Expr], Tangent | None]
) -> Tangent | None:
    """A relation as a linear one; None where it is nonlinear and its unknowns are not known."""
    try:
        form = linear_form(expr, keys)
    except Nonlinear:
        return known(expr)
    return Tangent({s: certain(c, value) for s, c in form.terms.items()}, certain(form.constant, value))


def failing(system: System, assembly: Assembly, solved: Solved) -> tuple[tuple[Test, Decimal | None], ...]:
    """The tests that fail. Tests that depend on what is not unique may hold for some distribution: that is decided
    exactly, and by them alone.
    """
    affine: list[tuple[Test, Decimal, dict[int, Decimal]]] = []
    for mode in system.modes.values():
        tests = (test for test in mode.tests if not under_way(test, mode, assembly))
        affine.extend((test, *measure(test, assembly, solved)) for test in tests)
    failed: list[tuple[Test, Decimal | None]] = []
    open_tests = [(t, v, n) for t, v, n in affine if n]
    for test, value, null in affine:
        if not null and not _holds(value, test.strict):
            failed.append((test, value))
    if open_tests and not feasible([(v, n, t.strict) for t, v, n in open_tests]):
        failed += [(t, None) for t, _, _ in open_tests]
    return tuple(failed)


def under_way(test: Test, mode: Mode, assembly: Assembly) -> bool:
    """Is a slip that a test would let begin under way already?"""
    return test.row is not None and mode.sliding is test.row and abs(assembly.row_speed(test.row)) > TINY


def _holds(value: Decimal, strict: bool) -> bool:
    return value > CERTAIN * 10**8 if strict else value >= -CERTAIN * 10**8


def _least(vector: list[Decimal], free: list[list[Decimal]]) -> list[Decimal]:
    """The smallest vector left where these may be added in any amount: a rope may take what friction need not."""
    for i, way in enumerate(free):
        size = sum((c * c for c in way), ZERO)
        if size <= CERTAIN:
            continue
        others = [_across(other, way, size) for other in free[i + 1 :]]
        return _least(_across(vector, way, size), others)
    return vector


def _across(vector: list[Decimal], way: list[Decimal], size: Decimal) -> list[Decimal]:
    """The part of a vector across a direction, of which the square is `size`."""
    along = sum((a * b for a, b in zip(vector, way, strict=True)), ZERO) / size
    return [a - along * b for a, b in zip(vector, way, strict=True)]


def measure(test: Test, assembly: Assembly, solved: Solved) -> tuple[Decimal, dict[int, Decimal]]:
    """The value of a test and its slopes along what is free."""
    if test.within:
        limit = assembly.value(test.constant)
        columns = [assembly.columns[n] for n in test.within]
        parts = _least([solved.values[j] for j in columns], [[v[j] for j in columns] for v in solved.null.values()])
        return ONE - sum((p * p for p in parts), ZERO) / limit**2, {}
    line: dict[int, Decimal] = {-1: certain(sp.sympify(test.constant), assembly.value)}
    for name, factor in test.pushes:
        column = assembly.columns.get(name)
        if column is not None:
            line[column] = line.get(column, ZERO) + assembly.value(factor)
    if test.row is not None:
        line = {j: test.sense * c for j, c in assembly.row(test.row).items()}
    if test.joining is not None and test.joining.path is not None:
        normal = assembly.number(test.joining.path.tangent.turned())
        line = {j: test.sense * c for j, c in assembly.across(test.joining, normal).items()}
    size = max((abs(c * (solved.values[j] if j >= 0 else ONE)) for j, c in line.items()), default=ZERO) or ONE
    value = sum((c * solved.values[j] for j, c in line.items() if j >= 0), line.get(-1, ZERO))
    slopes = {
        free: sum((c * vector[j] for j, c in line.items() if j >= 0), ZERO) for free, vector in solved.null.items()
    }
    return value / size, {k: s / size for k, s in slopes.items() if abs(s) > CERTAIN * size}


def feasible(tests: list[tuple[Decimal, dict[int, Decimal], bool]]) -> bool:
    """Can all of value + Σ slope · free ≥ 0 (or > 0) hold at once? Fourier-Motzkin elimination, exact to all digits."""
    variables = sorted({k for _, slopes, _ in tests for k in slopes})
    current = tests
    for variable in variables:
        lower = [t for t in current if t[1].get(variable, ZERO) > 0]
        upper = [t for t in current if t[1].get(variable, ZERO) < 0]
        rest = [t for t in current if not t[1].get(variable)]
        for low in lower:
            for up in upper:
                a, b = low[1][variable], -up[1][variable]
                slopes = {
                    k: b * low[1].get(k, ZERO) + a * up[1].get(k, ZERO) for k in {*low[1], *up[1]} if k != variable
                }
                value = b * low[0] + a * up[0]
                rest.append((value, {k: s for k, s in slopes.items() if abs(s) > CERTAIN}, low[2] or up[2]))
        current = rest
        if len(current) > MOST_INEQUALITIES:
            raise Undecided(
                "whether some distribution of the reactions satisfies every contact is too large a question"
            )
    return all(_holds(value, strict) for value, _, strict in current)
