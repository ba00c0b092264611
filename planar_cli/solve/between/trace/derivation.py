"""The way through the equations of a motion to what is asked, as data: derivations in order, and their lines."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import field

import sympy as sp

from planar_cli.equation.algebra.plain import MANY, longer, simplified
from planar_cli.records import record
from planar_cli.solve.between.trace.trace import Result
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


def each_once(order: Sequence[Derivation]) -> list[Derivation]:
    """Without derivations of what another one, of several unknowns together, tells besides; what is needed first."""
    kept = list(order)
    for one in order:
        own = set(one.unknowns)
        others = (d for d in kept if d is not one and own < set(d.unknowns))
        if any(not _rests_on(other, own, kept) for other in others):
            kept.remove(one)
    found: list[Derivation] = []
    while kept:
        open_unknowns = {x for d in kept for x in d.unknowns}
        ready = next((d for d in kept if not d.needs & open_unknowns - set(d.unknowns)), kept[0])
        found.append(ready)
        kept.remove(ready)
    return found


def _rests_on(derivation: Derivation, unknowns: set[sp.Symbol], order: Sequence[Derivation]) -> bool:
    """Does a derivation need one of these, itself or through others?"""
    reached, grows = set(derivation.needs), True
    while grows:
        more = {x for d in order if set(d.unknowns) & reached for x in d.needs} - reached
        reached |= more
        grows = bool(more)
    return bool(reached & unknowns)


def levels(formulas: Iterable[tuple[sp.Symbol, sp.Expr | None]]) -> dict[sp.Symbol, sp.Expr]:
    """The letters of angles, in the order in which they are found, that are those of directions along the axes."""
    found: dict[sp.Symbol, sp.Expr] = {}
    for letter, formula in formulas:
        angle = None if formula is None else found.get(formula, formula)
        if angle is not None and (angle == 0 or (angle.has(sp.pi) and (2 * angle / sp.pi).is_integer is True)):
            found[letter] = angle
    return found


def at_right_angles(expr: sp.Expr, known: Mapping[sp.Symbol, sp.Expr]) -> sp.Expr:
    """A formula with the sines and cosines of such angles put in; a long one is not made plainer."""
    inside = {f: f.xreplace(dict(known)) for f in expr.atoms(sp.sin, sp.cos, sp.tan) if f.free_symbols & known.keys()}
    put_in = expr.xreplace(inside)
    return simplified(put_in) if inside and not longer(put_in, 3 * MANY) else put_in
