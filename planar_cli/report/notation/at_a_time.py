"""A function of the time alone, of a law that is written in numbers, at a time that is a plain number: its sines and
cosines stay as they are where their angles are parts of π.

α_1 = 3 π/8 sin(π/4)        for 1.178 sin(π · 1 / 4)
"""

from __future__ import annotations

from decimal import Decimal
from fractions import Fraction

import sympy as sp

from planar_cli.equation.values.ledger import Kind
from planar_cli.solve.between.trace.trace import MotionTrace

WHOLE = (-1, 0, 1)
"""Values of a sine or cosine that are put in."""
CLOSE = Decimal("1e-25")
LARGEST = 100
"""Of larger numerators and denominators a time is no plain number."""


def at_a_time(formula: sp.Expr, found: MotionTrace) -> sp.Expr | None:
    """The function there; None: it is none, or its angles or its time are other numbers."""
    waves = formula.atoms(sp.sin, sp.cos)
    if not waves or len(formula.free_symbols) != 1:
        return None
    (time,) = formula.free_symbols
    role = found.ledger.roles.get(found.general.get(time, time))
    value = found.value.known(time)
    number = None if value is None or role is None or role.kind is not Kind.TIME else _plain(value)
    if number is None:
        return None
    put = {w: _wave(w, w.args[0].xreplace({time: number})) for w in waves}
    return None if None in put.values() else formula.xreplace(put).xreplace({time: number})


def _plain(value: Decimal) -> sp.Rational | None:
    """A value as the fraction that it is but for its last digits; None: it is no plain one."""
    near = Fraction(value).limit_denominator(LARGEST)
    same = abs(value - Decimal(near.numerator) / Decimal(near.denominator)) <= CLOSE * abs(value)
    return sp.Rational(near.numerator, near.denominator) if same and abs(near.numerator) <= LARGEST else None


def _wave(wave: sp.Expr, angle: sp.Expr) -> sp.Expr | None:
    """The sine or cosine of a part of π, as it is written; None: the angle is no such part."""
    if not (angle / sp.pi).is_Rational:
        return None
    value = wave.func(angle)
    return value if value in WHOLE else wave.func(angle, evaluate=False)
