"""A speed that the file states at a state, in the letter of the one speed that drives the motion: v_A/tan θ_3."""

from __future__ import annotations

from decimal import Decimal

import sympy as sp

from planar_cli.problem.language.expression import Quantity, Relation
from planar_cli.report.given.as_stated import Stated, in_base
from planar_cli.report.words.sides import number_of
from planar_cli.solve.between.trace.trace import MotionTrace
from planar_cli.solve.between.trace.trace import Relation as Found
from planar_cli.units import RATE, VELOCITY, Dimension

SPEEDS = {"v": VELOCITY, "omega": RATE}


def by_driving_speed(stated: Stated, e: Found, found: MotionTrace) -> tuple[sp.Expr, Decimal, Dimension] | None:
    """The speed, its number and its dimension. All speeds are multiples of the one that drives; None: there is no such
    one, or the file states more than a number.
    """
    constants = {letter: formula for r in found.regimes for letter, (formula, _) in r.constants.items()}
    if not isinstance(stated, Relation) or not isinstance(stated.left, Quantity) or len(constants) != 1:
        return None
    number, dimension = number_of(stated.right), SPEEDS.get(stated.left.word)
    whole = in_base(number, found.ledger.us)
    ((letter, formula),) = constants.items()
    unit = found.ledger.units.get(letter)
    if dimension is None or not whole or unit is None or unit.dimension not in SPEEDS.values():
        return None
    apart, rest = sp.sympify(e.residual).as_coeff_Add()
    if not formula.is_number or formula == 0 or not apart or abs(sp.Abs(apart) - abs(sp.Rational(str(whole)))) > 0:
        return None
    speeds = {s for s in rest.free_symbols if found.ledger.units[s].dimension in SPEEDS.values()}
    time = any(found.general.get(s, s).name == "t" for s in rest.free_symbols)
    if speeds or time or not rest.free_symbols:
        return None
    sense = -sp.Rational(str(whole)) / apart
    return sense * rest * letter / formula, whole, dimension
