"""The acceleration of gravity of a problem, for answers that are given in g."""

from __future__ import annotations

from collections.abc import Mapping

from planar_cli.base_units import in_base
from planar_cli.replay.equations import Equations
from planar_cli.units import parse_unit

GRAVITY = "g"


def gravity_of(equations: Equations | None, own: Mapping[str, float], us: bool) -> float:
    """In m/s^2; 0 where none stands in its equations. `own`: the data of a variant, by their names, in base units."""
    symbol = equations.inputs.get(GRAVITY) if equations is not None else None
    if equations is None or symbol is None:
        return 0.0
    return float(own.get(GRAVITY, equations.value[symbol])) / in_base(parse_unit("m/s^2"), us)
