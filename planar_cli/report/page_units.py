"""The units in which the lines of a page are worked out: those in which its formulas need no factors."""

from __future__ import annotations

import re

from planar_cli.units import Dimension, Unit, default_unit, parse_unit


def coherent_unit(dimension: Dimension, angle: bool = False, us: bool = False) -> Unit:
    """The SI unit, or in US customary units that of feet, slugs, seconds and pounds of force."""
    usual = default_unit(dimension, angle, us)
    if not us:
        return usual
    return parse_unit(re.sub(r"\blb\b", "slug", usual.text).replace("psi", "lbf/ft^2"))
