"""A body that sways about an equilibrium with its mass centre off the path of its middle, as one that rolls on a round
end: its sum of moments to the first order in the deviation δ, in the letters of the page.

    E(q) ≈ ∂E/∂q δ,   R(q, ω, α) ≈ R(q_0, 0, α)          the terms with ω² are of the second order
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator

import sympy as sp

from planar_cli.equation.algebra.factoring import factored
from planar_cli.equation.algebra.plain import by_name, simplified
from planar_cli.equation.values.exact import PI, Valuation
from planar_cli.solve.between.equations.oscillation import Oscillation
from planar_cli.solve.between.trace.oscillation_trace import NearRest
from planar_cli.solve.instant.stages import Stage
from planar_cli.solve.instant.written import Written
from planar_cli.solve.solution import InstantSolution


def near_rest(found: Oscillation, value: Valuation) -> NearRest | None:
    """None: there is more than one sum, it has no square of a speed, or more than one acceleration in it is unknown."""
    solution = found.regime.general.solution
    assert solution is not None
    stage = next((s for s in solution.stages if s.level == "acceleration"), None)
    sums = [] if stage is None else list(_sums(stage))
    if not found.single or stage is None or len(sums) != 1 or not value.is_zero(found.damping[0][0]):
        return None
    (w,), (speed,) = sums, found.speeds
    unknowns, places = w.right.free_symbols & set(stage.algebra.unknowns), _right_angles(found, value)
    if len(unknowns) != 1 or places is None:
        return None
    (acceleration,) = unknowns
    following = _speeds(found, solution, w.residual.free_symbols - unknowns)
    if following is None or not w.right.xreplace(following).has(speed):
        return None
    still = {**dict.fromkeys(following, sp.S.Zero), **dict.fromkeys(found.regime.free, sp.S.Zero)}
    at_rest = {**places, **still}
    rates = {q: r for q, r in found.regime.rates.items() if w.left.has(q) and r.has(speed)}
    slope = simplified(sp.Add(*(sp.diff(w.left, q) * sp.diff(r, speed) for q, r in rates.items())).xreplace(at_rest))
    inertia = sp.Add(*(_shortest(term.xreplace(at_rest)) for term in sp.Add.make_args(w.right)))
    square = positive(-slope / sp.diff(inertia, acceleration), value)
    balanced = value.is_zero(w.left.xreplace(at_rest)) and value.is_zero(inertia.xreplace({acceleration: sp.S.Zero}))
    if slope == 0 or not balanced or not value.is_zero(square - found.stiffness[0][0]):
        return None
    return NearRest(w.left, restoring(slope), inertia, square, tuple(at_rest.items()))


def _speeds(
    found: Oscillation, solution: InstantSolution, inside: Iterable[sp.Symbol]
) -> dict[sp.Symbol, sp.Expr] | None:
    """Of the letters in a sum those that follow the free speeds, with their formulas; None: another one varies."""
    ledger, regime = solution.instant.scene.ledger, found.regime
    coordinates, constants = {c.symbol for c in regime.coordinates}, ledger.definitions
    speeds: dict[sp.Symbol, sp.Expr] = {}
    for s in by_name(inside):
        if s in coordinates or s in regime.free or s in ledger.letters:
            continue
        closed = regime.closed(s)
        if closed.free_symbols & set(regime.free) and not closed.free_symbols & coordinates:
            speeds[s] = closed
        elif closed.free_symbols & {*coordinates, *regime.free, regime.time} or s not in {*ledger.values, *constants}:
            return None
    return speeds


def _shortest(expr: sp.Expr) -> sp.Expr:
    return min((expr, simplified(expr), factored(expr)), key=sp.count_ops)


def positive(expr: sp.Expr, value: Valuation) -> sp.Expr:
    """A product that is positive without a minus in front, where a difference in it takes the minus: a (r - y)."""
    number, factors = expr.as_coeff_mul()
    turned = next((f for f in factors if f.is_Add and f.has(sp.S.NegativeOne)), None)
    if turned is None or number > 0 or value(expr) < 0:
        return expr
    return sp.Mul(-number, *(-f if f is turned else f for f in factors))


def restoring(slope: sp.Expr) -> sp.Expr:
    """The moment of what has turned, by its lever as a stable body has it: -m g (r - y_G) for m g (y_G - r)."""
    number, factors = slope.as_coeff_mul()
    levers = (f for f in factors if f.is_Add and len(f.args) == len(f.free_symbols) == 2)
    turned = next((f for f in levers if f.has(sp.S.NegativeOne)), None)
    if turned is None or number < 0:
        return slope
    return sp.Mul(-number, *(-f if f is turned else f for f in factors))


def _sums(stage: Stage) -> Iterator[Written]:
    return (w for b in stage.blocks for w in b.equations if w.law in ("force", "moment"))


def _right_angles(found: Oscillation, value: Valuation) -> dict[sp.Symbol, sp.Expr] | None:
    """Where the coordinates are in the equilibrium, by the letters of the general position; None: an angle is not
    right, or a length is not nought.
    """
    places: dict[sp.Symbol, sp.Expr] = {}
    for c in found.regime.coordinates:
        number = value.known(found.stop.letters[c.symbol])
        if number is None:
            return None
        turns = int((number * 2 / PI).to_integral_value())
        exact = turns * sp.pi / 2 if c.unit == "rad" else sp.S.Zero
        if not value.is_zero(found.stop.letters[c.symbol] - exact):
            return None
        places[c.symbol] = exact
    return places
