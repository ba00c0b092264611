"""The base units in which all numbers of a file are counted, so that its formulas need no factors: m, kg, s, or ft,
slug, s where it is in US customary units.
"""

from __future__ import annotations

import math
from decimal import Decimal, localcontext
from fractions import Fraction
from functools import lru_cache

from planar_cli.units import ATOMS, Unit

ROOT_DIGITS = 80


@lru_cache(maxsize=1024)
def factor_to_base(unit: Unit, us: bool) -> Fraction:
    """What one of a unit is in the base units of a file, but for its powers of π. `us`: these are ft, slug, s."""
    if not us:
        return unit.factor
    length, mass = unit.dimension.length, unit.dimension.mass
    return unit.factor / (_to_the(ATOMS["ft"].factor, length) * _to_the(ATOMS["slug"].factor, mass))


def _to_the(factor: Fraction, power: Fraction) -> Fraction:
    """A power of a factor; a broken one to more digits than any result has."""
    if power.denominator == 1:
        return factor**power.numerator
    with localcontext(prec=ROOT_DIGITS):
        root = (Decimal(factor.numerator) / factor.denominator) ** (Decimal(1) / power.denominator)
        return Fraction(root) ** power.numerator


def in_base(unit: Unit, us: bool) -> float:
    """What one of a unit is in the base units of a file."""
    return float(factor_to_base(unit, us)) * math.pi**unit.pi_power
