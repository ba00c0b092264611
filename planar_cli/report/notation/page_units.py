"""The units in which the lines of a page are worked out: the base units of the file and what they make, in which
formulas need no factors.
"""

from __future__ import annotations

import re

from planar_cli.units import Dimension, Unit, default_unit, parse_unit


def in_base_units(unit: Unit, us: bool) -> Unit:
    """What numbers of the kind of a unit are in inside formulas."""
    return coherent_unit(unit.dimension, unit.angle, us)


def coherent_unit(dimension: Dimension, angle: bool = False, us: bool = False) -> Unit:
    """The SI unit, or in US customary units that of feet, slugs, seconds and pounds of force."""
    usual = default_unit(dimension, angle, us)
    if not us:
        return usual
    return parse_unit(re.sub(r"\blb\b", "slug", usual.text).replace("psi", "lbf/ft^2"))
