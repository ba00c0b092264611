"""Lagrange's equations."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import ClassVar, final

import sympy as sp

from planar_cli.equation.algebra.plain import longer, simplified
from planar_cli.equation.kinematics.moving import Moving
from planar_cli.equation.scene.displacement import Coordinate
from planar_cli.principles.base import Integrated, Position, Premise, Principle, Single
from planar_cli.problem.scene.acting import acting_loads
from planar_cli.problem.scene.facts import Action, Wrench
from planar_cli.problem.scene.geometry import Vec
from planar_cli.records import record

LONGEST = 200
"""Longer expressions are left as they come."""


@final
class Lagrange(Principle):
    """The Lagrangian L = T - V gives one equation for each coordinate.

    Meaning
        The scene is described by the coordinates of its general position: those of the file, and one for each freedom
        that its joints leave. Kinetic and potential energy as functions of them and of their rates give the equations
        of motion, without a free-body diagram: ideal joints do no work and do not enter. Where coordinates are bound to
        each other (a closed loop, a rope, rolling that the coordinates do not build in) the reactions that bind them
        enter as Lagrange's multipliers. Other reactions are not reached.

    YAML
        title: Pendulum
        plane: vertical
        given: {l: 2 m, m: 3 kg}
        points: {O: [0, 0], B: [l, 0]}
        bodies: {rod: {rod: [O, B], mass: m}}
        joints:
          - pin: {at: O, between: [ground, rod]}
        instant: [at rest]
        method: lagrange
        find: {alpha: alpha(rod)}

    Equations
        d/dt ∂L/∂q' - ∂L/∂q = Q      for every coordinate q, q' its rate; L = T - V
        Q = Σ F · ∂r/∂q + M ∂θ/∂q    of loads without a potential, friction that slips, and what binds coordinates

    Signs
        Q is positive where it pushes the coordinate on.

    Valid when
        No mass comes or goes, and no joint takes hold on the way.

    Reference
        An Introduction to Planar Dynamics, 4.7; Goldstein, Classical Mechanics, 1.4, 2.4.
    """

    kind: ClassVar[str] = "lagrange"
    diagram: ClassVar[str] = "Lagrange's equations"
    general: ClassVar[bool] = True

    def at_instant(self, position: Position) -> Iterator[Single]:
        scene = position.system.scene
        if position.system.reactions is None or any(b.varies for b in scene.bodies.values()):
            return
        if any(c.speed not in dict(position.rates) for c in position.coordinates):
            # A joint has taken hold that the coordinates do not know of.
            return
        energies = _Energies.of(position)
        for c in position.coordinates:
            yield energies.equation(c)

    def over(self, position: Position, chosen: bool) -> tuple[Integrated]:
        return (Integrated(),)


@record
class _Energies:
    """T and V of a scene in its coordinates and their rates, and what the rates are called."""

    position: Position
    rates: Mapping[sp.Symbol, sp.Symbol]
    """A letter for the rate of every coordinate."""
    kinetic: sp.Expr
    potential: sp.Expr
    left: tuple[Wrench, ...]
    """The loads without a potential."""

    @staticmethod
    def of(position: Position) -> _Energies:
        scene = position.system.scene
        rates = {c.symbol: sp.Dummy(f"{c.symbol.name}_dot", real=True) for c in position.coordinates}

        def rate(expr: sp.Expr) -> sp.Expr:
            moved = (sp.diff(expr, q) * v for q, v in rates.items() if expr.has(q))
            return sp.Add(sp.diff(expr, position.time), *moved)

        kinetic = []
        for body in scene.bodies.values():
            vx, vy, omega = rate(body.center.x), rate(body.center.y), rate(body.theta)
            kinetic.append(body.mass * (vx**2 + vy**2) / 2 + body.inertia * omega**2 / 2)
        setting = Moving(scene, position.motion, position.value)
        # Several of one kind may be called alike.
        every = acting_loads(scene.problem, position.system.idle())
        stored = [(x.kind, x.name, x.potential(setting)) for x in every]
        told = {(kind, name) for kind, name, e in stored if e is not None}
        left = tuple(w for w in position.system.wrenches if (w.kind, w.name) not in told)
        potential = sp.Add(*(e for _, _, e in stored if e is not None))
        return _Energies(position, rates, _neat(sp.Add(*kinetic)), _neat(sp.sympify(potential)), left)

    def equation(self, c: Coordinate) -> Single:
        """d/dt ∂L/∂q' - ∂L/∂q = Q of one coordinate."""
        q, v = c.symbol, self.rates[c.symbol]
        momentum = sp.diff(self.kinetic, v)
        left = self._derivative(momentum) - sp.diff(self.kinetic - self.potential, q)
        name = c.speed.name if c.factor == 1 and c.extra == 0 else f"{q.name}_dot"
        premises = (
            Premise("T", self._named(self.kinetic), "kinetic energy"),
            Premise("V", self.potential, "potential energy"),
        )
        return Single(
            left=_neat(self._named(left)),
            right=self._force(c),
            words=f"Lagrange's equation for {c.words}",
            lead=f"d/dt ∂L/∂`{name}` - ∂L/∂`{q.name}`",
            cost=1.0,
            premises=premises if self.potential != 0 else premises[:1],
        )

    def _derivative(self, expr: sp.Expr) -> sp.Expr:
        """The rate of an expression in coordinates and the letters of their rates."""
        parts = [sp.diff(expr, self.position.time)]
        parts += [sp.diff(expr, q) * v for q, v in self.rates.items() if expr.has(q)]
        second = {c.symbol: self._second(c) for c in self.position.coordinates}
        parts += [sp.diff(expr, v) * second[q] for q, v in self.rates.items() if expr.has(v)]
        return sp.Add(*parts)

    def _second(self, c: Coordinate) -> sp.Expr:
        """The second rate of a coordinate in the unknowns of the instant."""
        parts = [sp.diff(c.rate, self.position.time)]
        parts += [sp.diff(c.rate, u) * a for u, a in self.position.rates if c.rate.has(u)]
        parts += [sp.diff(c.rate, q) * v for q, v in self.rates.items() if c.rate.has(q)]
        return sp.Add(*parts)

    def _named(self, expr: sp.Expr) -> sp.Expr:
        """With the velocity unknowns for the letters of rates."""
        return expr.xreplace({self.rates[c.symbol]: c.rate for c in self.position.coordinates})

    def _force(self, c: Coordinate) -> sp.Expr:
        """The generalized force Q of what has no potential."""
        terms = [_neat(self._virtual(w.body, w.point, w.force, w.couple, c.symbol)) for w in self.left]
        reactions = self.position.system.reactions
        assert reactions is not None
        for push, size in reactions.pushes:
            terms.append(_neat(sp.Add(*(self._of(action, c.symbol) for action in push.actions))) * size)
        return sp.Add(*terms)

    def _of(self, action: Action, q: sp.Symbol) -> sp.Expr:
        return self._virtual(action.body, action.point, action.force, action.couple, q)

    def _virtual(self, body: str, point: Vec, force: Vec | None, couple: sp.Expr, q: sp.Symbol) -> sp.Expr:
        """The work of a force and a couple on a body for a unit of growth of one coordinate."""
        model = self.position.system.scene.bodies.get(body)
        if model is None:
            return sp.S.Zero
        turn = sp.diff(model.theta, q)
        moved = Vec(sp.diff(model.center.x, q), sp.diff(model.center.y, q))
        work = sp.sympify(couple) * turn
        return work if force is None else work + force.dot(moved + (point - model.center).turned() * turn)


def _neat(expr: sp.Expr) -> sp.Expr:
    return expr if longer(expr, LONGEST) else simplified(expr)
