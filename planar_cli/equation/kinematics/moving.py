"""What loads may ask once velocities are settled: the scene, its motion, and magnitudes that depend on it."""

from __future__ import annotations

from collections.abc import Container, Iterable
from dataclasses import replace
from itertools import pairwise
from typing import Any

import sympy as sp

from planar_cli.equation.algebra.counting import operations
from planar_cli.equation.algebra.expansion import expanded
from planar_cli.equation.algebra.factoring import factored
from planar_cli.equation.algebra.plain import MANY, by_name, longer, simplified
from planar_cli.equation.kinematics.motion import Motion
from planar_cli.equation.kinematics.quantities import quantities_of
from planar_cli.equation.kinematics.struck import StruckScene
from planar_cli.equation.scene.growth import growth
from planar_cli.equation.scene.scene import Scene
from planar_cli.equation.values.evaluate import demand_time
from planar_cli.errors import Mark, NoValue, Undecided, refuse
from planar_cli.loads.base import Load
from planar_cli.problem.language.expression import Side
from planar_cli.problem.scene.acting import acting_loads, kind_of
from planar_cli.problem.scene.facts import Skid, Wrench
from planar_cli.problem.scene.geometry import Vec
from planar_cli.problem.scene.keys import Table
from planar_cli.problem.scene.scene import GROUND


class Moving:
    """Delegates to the scene; adds velocities. `numbers`: a valuation that knows the velocities as well."""

    def __init__(self, scene: Scene, motion: Motion, numbers: Any) -> None:
        self._scene, self._motion, self._numbers = scene, motion, numbers

    def __getattr__(self, name: str) -> Any:
        return getattr(self._scene, name)

    def sign(self, expr: Any) -> int:
        if self._numbers.is_zero(expr):
            return 0
        return 1 if self._numbers(expr) > 0 else -1

    def is_zero(self, expr: Any) -> bool:
        return expr == 0 or bool(self._numbers.is_zero(expr))

    def vanishes(self, expr: Any) -> bool:
        """Is it zero in all that this motion may be?"""
        return self.is_zero(expr)

    def length(self, v: Vec) -> sp.Expr:
        """|v| of a vector that may hold velocities."""
        for one, other in ((v.x, v.y), (v.y, v.x)):
            if self.is_zero(other):
                moves = sp.sympify(one).free_symbols & self._speeds()
                return one * (self.sign(one) or 1) if moves else self.on_side(sp.sympify(one), self.sign(one) or 1)
        return self._distance(sp.sqrt(v.dot(v)))

    def lettered_length(self, reach: Vec, name: str, words: str) -> sp.Expr:
        """|r|; a letter for it where the drawing gives it as a number, which would stand bare beside letters."""
        scene, length = self._scene, self.length(reach)
        if scene.displacement is not None or scene.ledger.symbolic or not length.is_number:
            return length
        parts = [p for p in (reach.x, reach.y) if not self.is_zero(p)]
        shown = sp.sqrt(sp.Add(*(sp.Pow(p, 2, evaluate=False) for p in parts), evaluate=False), evaluate=False)
        told = length if len(parts) == 1 or not all(p.is_Rational for p in parts) else shown
        title, ledger = f"length of {words}", scene.ledger
        known = next((s for s, t in ledger.titles.items() if t == title and ledger.definitions[s] == told), None)
        return ledger.define(name, told, "m", title, positive=True) if known is None else known

    def _distance(self, root: sp.Expr) -> sp.Expr:
        """|r| of a place is r on the side where it is drawn; a speed may change its sign."""
        if longer(root, MANY) or root.free_symbols & self._speeds():
            return root
        square = simplified(root**2)
        plain = sp.sqrt(square)
        if not plain.atoms(sp.Abs) and square.is_Add:
            whole = sp.sqrt(factored(square))
            plain = whole if whole.atoms(sp.Abs) else plain
        sides = plain.atoms(sp.Abs)
        if sides:
            return plain.xreplace({a: self.on_side(a.args[0], self.sign(a.args[0]) or 1) for a in sides})
        return plain if 2 * operations(plain) < operations(root) else root

    def against(self, velocity: Vec, size: sp.Expr) -> Vec:
        """A force of a given size against a velocity. In a general position it is right whichever way things move."""
        if self._scene.displacement is None:
            return Vec(*(-p * (size / self.length(velocity)) for p in (velocity.x, velocity.y)))
        speeds = [s for s in velocity.x.free_symbols | velocity.y.free_symbols if s in self._speeds()]
        if len(speeds) == 1:
            u = speeds[0]
            along = Vec(sp.diff(velocity.x, u), sp.diff(velocity.y, u))
            if all(expanded(p - e * u) == 0 for p, e in ((velocity.x, along.x), (velocity.y, along.y))):
                reach = sp.sqrt(simplified(along.dot(along)))
                found: Vec = -along * (_with_sign(u, sp.expand(simplified(size))) / reach)
                return found
        if (line := self._on_a_line(velocity, speeds)) is not None:
            along, pace = line
            way = simplified(self.one_way(pace) / pace)
            force: Vec = -along * (way * size / sp.sqrt(simplified(along.dot(along))))
            return force
        return Vec(*(-p * (size / sp.sqrt(simplified(velocity.dot(velocity)))) for p in (velocity.x, velocity.y)))

    def _on_a_line(self, velocity: Vec, speeds: list[sp.Symbol]) -> tuple[Vec, sp.Expr] | None:
        """A direction in which no speed stands, and how fast it goes along that; None: the direction varies with the
        speeds.
        """
        for u in by_name(speeds):
            along = Vec(sp.diff(velocity.x, u), sp.diff(velocity.y, u))
            if {*along.x.free_symbols, *along.y.free_symbols} & self._speeds():
                return None
            pace = simplified(velocity.dot(along) / along.dot(along))
            if all(expanded(simplified(p - e * pace)) == 0 for p, e in ((velocity.x, along.x), (velocity.y, along.y))):
                return along, pace
        return None

    def _speeds(self) -> set[sp.Symbol]:
        rates = self._scene.evaluator.speeds
        return {*self._motion.tree.velocity_unknowns(), *rates}

    def velocity(self, point: Vec, body: str) -> Vec:
        return self._motion.velocity(point, body)

    def acceleration(self, point: Vec, body: str) -> Vec:
        """Of the body's point, in the unknowns of the tree."""
        return self._motion.acceleration(point, body)

    def turn(self, body: str) -> sp.Expr:
        return self._motion.velocities[body].angular

    def size(self, magnitude: Side | Table, mark: Mark) -> sp.Expr:
        """A magnitude, which may use velocities, or a table over time."""
        if isinstance(magnitude, Table):
            return self._over_time(magnitude, mark)
        value = quantities_of(self._scene, self._motion, None).evaluator.value(magnitude)
        demand_time(self._scene.ledger, value, mark, "what depends on t")
        return value

    def heading(self, angle: sp.Expr) -> Vec:
        """The unit vector in a direction that may vary with the motion."""
        return self._scene.ledger.heading(angle)

    def _over_time(self, table: Table, mark: Mark) -> sp.Expr:
        """Straight lines between the instants of a table, constant before the first and after the last."""
        scene = self._scene
        time = scene.ledger.symbols["t"]
        demand_time(scene.ledger, time, mark, "a table over time")
        rows = [(scene.value(when), scene.value(value)) for when, value in table.rows]
        pieces: list[tuple[sp.Expr, Any]] = [(rows[0][1], time < rows[0][0])]
        for (t0, v0), (t1, v1) in pairwise(rows):
            if self.sign(t1 - t0) <= 0:
                raise refuse(table.mark, "PL592", "the instants of a table must follow each other", "sort its rows")
            pieces.append((v0 + (v1 - v0) / (t1 - t0) * (time - t0), time < t1))
        return sp.Piecewise(*pieces, (rows[-1][1], True))


def all_wrenches(
    scene: Scene, motion: Motion, numbers: Any, skids: Iterable[Skid] = (), idle: Container[str] = ()
) -> tuple[Wrench, ...]:
    """Weights of all bodies, every load of the file that is not idle, and the friction of bodies that skid; in a blow
    the impulses and the momenta with which bodies arrive.
    """
    setting = Moving(scene, motion, numbers)
    if isinstance(scene, StruckScene):
        return scene.blows(setting)
    found: list[Wrench] = []
    for load in acting_loads(scene.problem, idle):
        try:
            found += [w for w in load.wrenches(setting) if w.body != GROUND]
        except NoValue as error:
            text = f"the {load.kind} has no real value here: {error}"
            raise refuse(load.mark, "PL593", text, "look at its roots, logarithms and divisors") from error
    for body in scene.bodies:
        found += _growing(scene, motion, body)
    for skid in skids:
        found += _skid(skid, setting, found)
    return tuple(_named(w, scene, setting) for w in found)


def _growing(scene: Scene, motion: Motion, body: str) -> list[Wrench]:
    """The couple -(dI/dt) ω on a body whose moment of inertia changes with its mass: d(I ω)/dt = I α + (dI/dt) ω."""
    change = growth(scene, quantities_of(scene, motion, None).evaluator, body)[1].rate
    assert change is not None
    couple = -change * motion.velocities[body].angular
    return [] if couple == 0 else [Wrench("", "stream", body, scene.center(body), None, couple, couple)]


def _named(wrench: Wrench, scene: Scene, setting: Moving) -> Wrench:
    """A long magnitude gets a letter and a line of its own, F_s = k (l - l_0), so that equations stay short; that of
    a spring which is compressed at the one instant is its push, F_s = k (l_0 - l).
    """
    magnitude = sp.sympify(wrench.magnitude)
    pieced = magnitude.has(sp.Piecewise)
    long = pieced or (wrench.force is not None and longer(magnitude, 3))
    if not long or scene.rests_on_sought(magnitude):
        return wrench
    kind = kind_of(wrench) or Load
    own = next((x for x in scene.problem.loads if (x.kind, x.name) == (wrench.kind, wrench.name)), None)
    ledger = scene.ledger
    pushes = bool(kind.pushing) and not magnitude.free_symbols & set(ledger.letters) and setting.sign(magnitude) < 0
    if own is None:
        title = (kind.pushing if pushes else kind.line).format(wrench.name, called=kind.phrase(wrench.name))
    else:
        title = own.by_line(own.pushing) if pushes else own.beside
    magnitude = -magnitude if pushes else magnitude
    symbol = next((s for s, t in ledger.titles.items() if t == title and ledger.definitions[s] == magnitude), None)
    if symbol is None:
        unit = "N*m" if wrench.force is None else "N"
        symbol = ledger.define(f"{kind.letter}_{wrench.name}", magnitude, unit, title)
    if wrench.force is None:
        return replace(wrench, couple=wrench.couple.xreplace({magnitude: symbol}), magnitude=symbol)
    if pieced:
        # SymPy divides every piece, also those that are zero.
        force = Vec(*(p.xreplace({magnitude: symbol}) for p in (wrench.force.x, wrench.force.y)))
    else:
        force = wrench.force / wrench.magnitude * (-symbol if pushes else symbol)
    return replace(wrench, force=force, magnitude=-symbol if pushes else symbol)


def open_direction(scene: Scene, motion: Motion, numbers: Any, skids: Iterable[Skid]) -> str:
    """What begins to slide from rest on what accelerates in a way that is only worked out: its friction is left out,
    as its direction is not told. In words; "" where nothing does.
    """
    setting = Moving(scene, motion, numbers)
    for skid in skids:
        relative = setting.velocity(skid.point, skid.body) - setting.velocity(skid.point, skid.base)
        if setting.is_zero(relative.dot(relative)) and _is_open(setting.acceleration(skid.point, skid.base)):
            return f"in which direction {skid.body} begins to slide on {skid.base} is not told"
    return ""


def _is_open(acceleration: Vec) -> bool:
    return bool(sp.sympify(acceleration.x).free_symbols | sp.sympify(acceleration.y).free_symbols)


def _skid(skid: Skid, setting: Moving, others: list[Wrench]) -> list[Wrench]:
    """Friction against the relative velocity; from rest, against what pushes the body."""
    relative = setting.velocity(skid.point, skid.body) - setting.velocity(skid.point, skid.base)
    if setting.rigid(skid.body) and not setting.is_zero(setting.turn(skid.body) - setting.turn(skid.base)):
        raise Undecided(f"{skid.body} turns on {skid.base} as it slides: how the pressure is spread is not known")
    if setting.is_zero(relative.dot(relative)):
        carried = setting.acceleration(skid.point, skid.base)
        if _is_open(carried):
            return []
        relative = -carried * setting.mass(skid.body)
        for w in others:
            if w.body == skid.body and w.force is not None:
                relative = relative + w.force
        if setting.is_zero(relative.dot(relative)):
            return []
    force = setting.against(relative, skid.size)
    on_body = Wrench(skid.joint, "skid", skid.body, skid.point, force, 0, skid.size)
    if skid.base == GROUND:
        return [on_body]
    return [on_body, Wrench(skid.joint, "skid", skid.base, skid.point, -force, 0, skid.size)]


def _with_sign(u: sp.Symbol, size: sp.Expr) -> sp.Expr:
    """sign(u) times a size; |u| sign(u) = u, which has a slope where u passes zero."""
    terms = (t.as_independent(sp.Abs(u), as_Add=False) for t in sp.Add.make_args(size))
    return sp.Add(*(k * u if power == sp.Abs(u) else k * power * sp.sign(u) for k, power in terms))
