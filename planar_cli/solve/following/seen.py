"""What came of following the motions of several branches of the equations."""

from __future__ import annotations

from dataclasses import field
from decimal import Decimal

import sympy as sp

from planar_cli.records import changing
from planar_cli.solve.between.branches.solved_motion import SolvedMotion
from planar_cli.solve.between.roots.chain import Branch
from planar_cli.solve.regimes.mode_sequence import ModeSequence


@changing
class Seen:
    """What came of following the branches of the equations."""

    far: dict[int, frozenset[str]]
    """By the stretch that ends with them: impacts whose bodies are apart."""
    fits: list[SolvedMotion] = field(default_factory=list)
    """Branches that happen so."""
    again: list[SolvedMotion] = field(default_factory=list)
    """Such as pass a state before it is meant."""
    changed: ModeSequence | None = None
    """Other modes that the first of the others has."""
    lost: Branch | None = None
    """The first that can not be followed."""
    otherwise: set[tuple[tuple[sp.Symbol, Decimal], ...]] = field(default_factory=set)
    """Starts, with the constants that are sought, from which the motion has other modes."""
