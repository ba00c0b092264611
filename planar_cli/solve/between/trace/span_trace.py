"""What is said of a quantity over a span of a motion."""

from __future__ import annotations

from decimal import Decimal

import sympy as sp

from planar_cli.problem.language.expression import Quantity
from planar_cli.records import record


@record
class Piece:
    """Part of a span in one regime, between two states."""

    since: str
    """The state at its beginning."""
    until: str
    """The state at its end."""
    limits: tuple[sp.Symbol, sp.Symbol]
    """The times of both."""
    integrand: sp.Expr
    """What is integrated over time."""
    how: str
    """difference, integral, quadrature, flow or blow; change: of the momentum of what the impulse acts on."""
    number: Decimal
    """Its number."""
    formula: sp.Expr | None = None
    """The result in symbols of states; None: in numbers alone."""
    antiderivative: sp.Expr | None = None
    """A function of the general position of which the integrand is the rate; None: there is none."""
    over_time: sp.Expr | None = None
    """The integrand over time, where the motion is known as a function of it."""
    turns: tuple[Decimal, ...] = ()
    """Of a path length: the instants at which the velocity vanishes, s."""
    letter: sp.Expr | None = None
    """The integrand where it is an unknown of the general position that stays what it is, or its opposite."""


@record
class SpanIntegral:
    """A quantity over a span worked out."""

    symbol: sp.Symbol
    """What stands for it in other expressions."""
    quantity: Quantity
    """What the file asks."""
    pieces: tuple[Piece, ...]
    """Its parts, one for each regime."""
    number: Decimal
    """Its number."""
    formula: sp.Expr | None
    """The result in symbols of states; None: in numbers alone."""
    duration: sp.Expr = sp.S.One
    """What a mean is divided by, s; else 1."""
    events: tuple[Decimal, ...] = ()
    """Of a count: the times of what is counted, s."""
    dated: bool = True
    """Do its times tell more than a slight touch by which the motion began?"""
