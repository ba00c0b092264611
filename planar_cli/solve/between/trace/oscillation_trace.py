"""What is said of small oscillations about an equilibrium, as frozen data."""

from __future__ import annotations

import mpmath
import sympy as sp

from planar_cli.records import record


@record
class Verdict:
    """Does a small deviation from an equilibrium stay small?"""

    kind: str
    """stable, unstable or indifferent."""
    power: int = 1
    """The power of the deviation in the term that decides (1: linear)."""

    @property
    def stable(self) -> bool:
        return self.kind == "stable"


@record
class LinearPart:
    """What a formula is near an equilibrium: constant + slope δ + damping δ̇."""

    of: sp.Expr
    """The formula, or the letter of a force that has one."""
    constant: sp.Expr
    slope: sp.Expr
    damping: sp.Expr


@record
class NearRest:
    """The one sum of moments or forces near an equilibrium, to the first order: slope δ = inertia."""

    of: sp.Expr
    """Its left side in a general position."""
    slope: sp.Expr
    inertia: sp.Expr
    """Its right side in the equilibrium: a factor times the acceleration."""
    square: sp.Expr
    """ω₀² by it, 1/s²: negative where the equilibrium is unstable."""
    places: tuple[tuple[sp.Symbol, sp.Expr], ...]
    """The coordinates and free speeds in the equilibrium, by the letters of the general position."""


@record
class Modes:
    """Several freedoms that swing: s̈ + A s = 0 without damping, s = a cos ωt, det(A - ω² I) = 0."""

    matrix: tuple[tuple[sp.Expr, ...], ...]
    """A, row by row, 1/s²; empty with damping that changes the modes."""
    rates: tuple[tuple[sp.Expr, ...], ...]
    """C of s̈ + C ṡ + A s = 0, 1/s, where damping leaves the modes as they are; else empty."""
    decays: tuple[sp.Expr, ...]
    """c/2 of every mode, 1/s, which dies away as e^(-c t/2); empty without damping."""
    polynomial: tuple[sp.Expr, ...]
    """p and q of ω⁴ - p ω² + q = 0 of two freedoms; empty: no formula."""
    squares: tuple[sp.Expr, ...]
    """Its roots ω², without damping; empty: no formula."""
    frequencies: tuple[sp.Expr, ...]
    """ω of every mode, rad/s, the lowest first."""
    words: frozenset[str]
    """What is asked of them: period, frequency, decrement, damping_ratio; with `circular` in rad/s alone."""


@record
class OscillationTrace:
    """Small oscillations about one equilibrium: s̈ + c ṡ + ω₀² s = 0 where there is one freedom."""

    state: str
    """The state of equilibrium."""
    motion: tuple[tuple[sp.Symbol, sp.Expr], ...]
    """The acceleration of every freedom, and its law in the general position."""
    stiffness: sp.Expr
    """ω₀² of the first freedom, 1/s²."""
    damping: sp.Expr
    """c of the first freedom, 1/s."""
    square: sp.Expr
    """The square of its circular frequency, 1/s²."""
    period: sp.Expr
    """Its period, s."""
    roots: tuple[mpmath.mpc, ...]
    """With several freedoms: the roots λ of the characteristic equation, 1/s."""
    verdict: Verdict
    """Is it stable?"""
    linear: tuple[LinearPart, ...] = ()
    """Of its forces and sums of forces, where they are long in a general position."""
    near: NearRest | None = None
    """Of its one sum, where squares of speeds stand in it, which are of the second order."""
    modes: Modes | None = None
    """The modes of several freedoms, where their periods or frequencies are asked."""
    energies: tuple[sp.Expr, sp.Expr] | None = None
    """M and K of the energies T = M δ̇²/2 and V = K δ²/2 of one freedom, in base units; None: not told."""
