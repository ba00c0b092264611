"""A mass centre that begins at rest keeps its place along a direction without a force: of a man who walks on a boat.

Σ m x_G at the second state = Σ m x_G at the first
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping

import sympy as sp

from planar_cli.equation.algebra.expansion import expanded
from planar_cli.equation.algebra.plain import simplified
from planar_cli.solve.between.equations.balances import StateBalance
from planar_cli.solve.regimes.equations import Equation
from planar_cli.solve.regimes.regime import Regime
from planar_cli.solve.regimes.timeline import Stop

AXES = {"→": "x", "↑": "y"}
"""Directions of linear momenta, by their arrows."""


def mass_centre_equations(
    balances: Iterable[Equation], regime: Regime, first: Stop, begun: Mapping[sp.Symbol, sp.Expr]
) -> Iterator[Equation]:
    """One for each momentum that is zero all the time. `begun`: what is known of letters of the first state."""
    for e in balances:
        b = e.source
        if not isinstance(b, StateBalance) or b.law.letter or b.law.about or b.brought or b.since is not first:
            continue
        axis = AXES.get(b.law.lead.strip())
        if axis is None or simplified(b.before.xreplace(dict(begun))) != 0:
            continue
        residual = _moved(b, axis, regime, first)
        inside = residual.free_symbols & set(b.stop.letters.values())
        # Of one body whose place is a coordinate of its own its law says that at once.
        if len(inside) > 1 or (inside and len(b.law.bodies) > 1):
            yield Equation(
                residual, "mass centre", _words(b.law.bodies, axis), b.stop.name, first.name, offered=e.offered
            )


def _moved(b: StateBalance, axis: str, regime: Regime, first: Stop) -> sp.Expr:
    """Σ m (x_G at the second state - x_G at the first)."""
    scene = regime.general.instant.scene
    starts = {c.start: first.letters[c.symbol] for c in regime.coordinates if c.drawn is None}
    moments = []
    for name in b.law.bodies:
        place = regime.closed(getattr(scene.center(name), axis)).xreplace(starts)
        moments.append(scene.bodies[name].mass * (b.stop.at(place) - first.at(place)))
    return expanded(sp.Add(*moments))


def _words(bodies: tuple[str, ...], axis: str) -> str:
    group = ", ".join(bodies)
    if len(bodies) == 1:
        return f"no force acts on {group} along {axis}, and it starts from rest: its mass centre keeps its {axis}"
    return f"no force acts on {group} along {axis}, and they start from rest: their mass centre keeps its {axis}"
