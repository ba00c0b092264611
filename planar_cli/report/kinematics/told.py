"""What a telling of vector equations offers to what is told beside them."""

from __future__ import annotations

from decimal import Decimal
from typing import Any, Protocol

import sympy as sp

from planar_cli.equation.kinematics.motion import Motion
from planar_cli.equation.system.system import System
from planar_cli.problem.scene.geometry import Vec
from planar_cli.records import record
from planar_cli.report.document.blocks import Block, Line
from planar_cli.report.words.words import Phrases
from planar_cli.units import ACCELERATION, VELOCITY

RATES = {"velocity": VELOCITY, "acceleration": ACCELERATION}
"""The dimension of what is told on each level."""


@record
class Across:
    """Components across a line of a body: their `sizes`, in the unit of the page, and what they give for the rate with
    which the body turns, (v_P · n)/AP; empty where its own part is no length times that. `product`, `known`: the sides
    of that relation, ω AP and v_P · n, with its numbers in `put`; empty where they count the other way. `as_told`: the
    relation counts as the components do, whatever the sign of its unknown.
    """

    sizes: tuple[Decimal, ...]
    quotient: Line
    product: Line = ()
    known: Line = ()
    put: tuple[Any, ...] = ()
    as_told: bool = False


class Told(Protocol):
    """A telling of vector equations. `given`: unknowns that the file gives as numbers; `late`: those that only the
    equations of accelerations and forces tell, speeds among them; `valued`: what has its value on
    the page; `zero`: unknowns that are zero; `components`: what the page tells last of known components; `centres`: the
    instantaneous centres of bodies by which their velocities are told; `preface`: lines that stand before the first
    velocity.
    """

    given: set[sp.Symbol]
    late: set[sp.Symbol]
    zero: frozenset[sp.Symbol]
    components: Across | None
    valued: set[str]
    centres: dict[str, Any]
    preface: list[Block]
    phrases: Phrases
    system: System

    @property
    def motion(self) -> Motion: ...

    def arm_told(self, place: str, reference: str, arm: Vec) -> Line: ...
