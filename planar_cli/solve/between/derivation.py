"""The way through the equations of a motion to what is asked, as data: derivations in order, and their lines."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import field

import sympy as sp

from planar_cli.records import record
from planar_cli.solve.between.trace import Result
from planar_cli.solve.regimes.equations import Equation

Edge = tuple[tuple[Equation, ...], tuple[sp.Symbol, ...], frozenset[sp.Symbol], float]
"""Equations, the unknowns that they fix, what must be known for that, and what it costs."""


@record
class Derivation:
    """Unknowns from equations, all else in them being known."""

    equations: tuple[Equation, ...]
    unknowns: tuple[sp.Symbol, ...]
    needs: frozenset[sp.Symbol]
    cost: float


@record
class DerivedStep:
    """One derivation worked out. `datum`: it only says what is given."""

    derivation: Derivation
    results: tuple[Result, ...]
    datum: bool


@record
class Route:
    """The way to the targets."""

    steps: tuple[DerivedStep, ...]
    """Derivations in their order."""
    formulas: Mapping[sp.Symbol, sp.Expr]
    """Everything that was derived."""
    plain: Mapping[sp.Symbol, sp.Expr] = field(default_factory=dict)
    """Data that are put in at once: zeros and names of the file."""
