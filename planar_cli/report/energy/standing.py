"""Bodies that stand still in the position of a state, however fast the others go: v_B = l ω sin θ = 0 at θ = 180°."""

from __future__ import annotations

from collections.abc import Iterator

import sympy as sp

from planar_cli.equation.algebra.plain import longer, simplified
from planar_cli.principles.base import Moving
from planar_cli.report.document.blocks import Equation, Math, line
from planar_cli.report.energy.energy_pieces import SHORT, STATE, EnergyPieces, has_root
from planar_cli.units import RATE, VELOCITY


def standing(pieces: EnergyPieces) -> dict[str, sp.Expr]:
    """The kinetic energies at the end, by their bodies, which vanish there though what is sought does not."""
    value, units = pieces.phrases.value, pieces.phrases.ledger.units
    found = {}
    for body, amount in pieces.balance.amounts:
        speeds = [s for s in amount.free_symbols if s in units and units[s].dimension in (RATE, VELOCITY)]
        sought = amount.free_symbols.intersection(pieces.unknowns)
        # Where the place is still to be found, no place has made it vanish yet.
        if sought and sought <= set(speeds) and value.vanishes(amount) and all(value.known(s) for s in speeds):
            found[body] = pieces.put(amount)
    return found


def standing_lines(pieces: EnergyPieces) -> Iterator[Equation]:
    """Why these vanish: the speed of the mass centre, or that of turning."""
    bodies = standing(pieces)
    for made in pieces.balance.parts.moving if bodies and pieces.balance.parts is not None else ():
        if made.body in bodies:
            own, expr = _speed(pieces, made)
            told = () if has_root(expr) or longer(expr, SHORT) else (pieces.phrases.math(expr),)
            note = line(f"{made.body} has no kinetic energy there")
            yield Equation((Math(own), *told, pieces.phrases.math(sp.S.Zero)), None, note=note)


def _speed(pieces: EnergyPieces, made: Moving) -> tuple[sp.Symbol, sp.Expr]:
    """A name and a formula of the speed that says so, with the letters of the position from which it vanishes."""

    def formula(expr: sp.Expr) -> sp.Expr:
        put = pieces.put(expr)
        return sp.sympify(expr) if put == 0 else put

    vx, vy = formula(made.vx), formula(made.vy)
    # Along an axis with the sign that it has in the kinematics.
    v = vx + vy if 0 in (vx, vy) else sp.sqrt(simplified(vx**2 + vy**2))
    turning = v == 0 or made.mass == 0
    name, expr = (f"omega_{made.body}", formula(made.omega)) if turning else (f"v_{pieces.centre(made)}", v)
    expr = expr.replace(lambda x: isinstance(x, sp.Abs), lambda x: x.args[0])
    return sp.Symbol(f"{name}{STATE}{pieces.balance.stop}", real=True), expr
