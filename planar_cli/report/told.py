"""What a telling of vector equations offers to what is told beside them."""

from __future__ import annotations

from decimal import Decimal
from typing import Protocol

import sympy as sp

from planar_cli.equation.motion import Motion
from planar_cli.equation.system import System
from planar_cli.report.words import Phrases
from planar_cli.units import ACCELERATION, VELOCITY

RATES = {"velocity": VELOCITY, "acceleration": ACCELERATION}
"""The dimension of what is told on each level."""


class Told(Protocol):
    """A telling of vector equations. `given`: unknowns that the file gives as numbers; `late`: those that only the
    equations of accelerations and forces tell, speeds among them; `valued`: what has its value on
    the page; `zero`: unknowns that are zero; `components`: what the page tells last of known components.
    """

    given: set[sp.Symbol]
    late: set[sp.Symbol]
    zero: frozenset[sp.Symbol]
    components: tuple[Decimal, ...]
    valued: set[str]
    phrases: Phrases
    system: System

    @property
    def motion(self) -> Motion: ...
