"""Velocities and accelerations of a general position by differentiating places: v = dr/dt, a = dv/dt.

The road of a course on kinematics (An Introduction to Planar Dynamics, 1.2, 1.4), independent of that along the tree of
joints, which only tells the rates of the coordinates.
"""

from __future__ import annotations

import sympy as sp

from planar_cli.equation.algebra.plain import simplified
from planar_cli.equation.kinematics.motion import Motion, Twist
from planar_cli.equation.kinematics.quantities import Quantities
from planar_cli.equation.values.evaluate import Evaluator
from planar_cli.equation.values.jets import Jet
from planar_cli.problem.language.expression import Quantity
from planar_cli.problem.scene.geometry import Vec
from planar_cli.solve.regimes.regime import Regime


class Differentiated(Motion):
    """The twists of all bodies of a regime whose rates are worked out, in t, coordinates and free speeds."""

    def __init__(self, regime: Regime) -> None:
        scene = regime.general.instant.scene
        super().__init__(regime.general.trial.system.tree, scene.center, scene.arms.between, {})
        for name, body in scene.bodies.items():
            place = Vec(regime.closed(body.center.x), regime.closed(body.center.y))
            turn = regime.closed(body.theta) if body.rigid else sp.S.Zero
            velocity = Vec(regime.derivative(place.x), regime.derivative(place.y))
            spin = regime.derivative(turn) if body.rigid else sp.S.Zero
            if body.rigid and spin == 0:
                spin = self._by_points(regime, name, place)
            bend = Vec(regime.derivative(velocity.x), regime.derivative(velocity.y))
            self.velocities[name] = Twist(body.center, velocity, spin)
            self.accelerations[name] = Twist(body.center, bend, regime.derivative(spin))

    @staticmethod
    def _by_points(regime: Regime, name: str, center: Vec) -> sp.Expr:
        """ω = r × ṙ / r² of another point of a body whose angle the file does not say."""
        scene = regime.general.instant.scene
        for point in sorted(scene.own_points):
            if scene.owner(point) != name:
                continue
            arm = Vec(regime.closed(scene.point(point).x), regime.closed(scene.point(point).y)) - center
            rate = Vec(regime.derivative(arm.x), regime.derivative(arm.y))
            if rate.x != 0 or rate.y != 0:
                return simplified(arm.cross(rate) / arm.dot(arm))
        return sp.S.Zero


def differentiated(regime: Regime) -> Quantities:
    """Quantities of places and motion, without forces."""
    scene = regime.general.instant.scene
    rates = {s: (r, regime.derivative(r)) for s, r in regime.rates.items()}
    motions = {**scene.evaluator.motions, **rates}

    def scalar(quantity: Quantity) -> Jet:
        return found.scalar(quantity)

    found = Quantities(scene, Differentiated(regime), None, Evaluator(scene.ledger, motions, scalar))
    return found


def rates_put_in(regime: Regime) -> dict[sp.Symbol, sp.Expr]:
    """What the rates of the file's coordinates are, by their symbols: θ̇, θ̈."""
    found: dict[sp.Symbol, sp.Expr] = {}
    for symbol, (rate, second) in regime.general.instant.scene.evaluator.motions.items():
        if symbol in regime.rates and isinstance(rate, sp.Symbol):
            found[rate] = regime.rates[symbol]
            if isinstance(second, sp.Symbol):
                found[second] = regime.derivative(regime.rates[symbol])
    return found
