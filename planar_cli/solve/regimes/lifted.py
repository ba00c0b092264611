"""Equations of a general position, taken at one drawn instant: for principles that need coordinates to vary."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from typing import Any

import sympy as sp

from planar_cli.equation.scene.displacement import CoordinateNames
from planar_cli.equation.system.system import System
from planar_cli.principles.base import Family, Premise, Principle, Single
from planar_cli.problem.scene.scene import Problem
from planar_cli.records import record
from planar_cli.solve.principled import position_of
from planar_cli.solve.regimes.general import General, drawn_instant, make_general

DEPTH = 40
"""So deep named intermediates may rest on each other."""


@record
class Lift:
    """Lifts the instants of one problem into a general position."""

    problem: Problem
    always: tuple[Any, ...]
    """What `motion` says."""
    earlier: Mapping[str, Any]
    """Finds of earlier cases."""

    def __call__(self, principle: Principle, system: System, choice: tuple[int, ...]) -> tuple[Family, ...]:
        """What a principle offers in one choice of modes, in the unknowns of the drawn system."""
        drawn = drawn_instant(self.problem, self.always, self.earlier)
        general = make_general(
            self.problem, self.always, self.earlier, drawn, choice, frozenset(), CoordinateNames(), {}
        )
        if general.trial.system.reactions is None:
            return ()
        position = position_of(general.trial.system, general.value, general.coordinates)
        names = _names(general, system)
        return tuple(_put(f, names) for f in principle.at_instant(position) if isinstance(f, Single))


def _names(general: General, system: System) -> dict[sp.Symbol, sp.Expr]:
    """What symbols of the general position are at the instant: unknowns of the same name, coordinates as drawn."""
    ours, theirs = general.instant.scene.ledger, system.scene.ledger
    mine = {s.name: s for s in (*system.tree.velocity_unknowns(), *system.tree.acceleration_unknowns())}
    mine |= {s.name: s for s in (*system.symbols.values(), *theirs.symbols.values())}
    found: dict[sp.Symbol, sp.Expr] = {}
    for s in (*general.trial.system.rates().items(), *((x, x) for x in general.trial.system.symbols.values())):
        found |= {x: mine[x.name] for x in s if x.name in mine}
    # What keeps a prescribed motion going may be needed there, and be no unknown here.
    found |= {s: sp.S.Zero for name, s in general.trial.system.symbols.items() if name not in system.symbols}
    found |= {s: mine[name] for name, s in ours.symbols.items() if name in mine}
    for s, expr in ours.definitions.items():
        if s.name not in mine:
            found[s] = expr
    for c in general.coordinates:
        if c.drawn is not None:
            own = mine.get(c.symbol.name)
            known = own is not None and own in theirs.definitions
            title = f"{c.words} as drawn"
            value = _through(c.drawn, found)
            found[c.symbol] = own if known else theirs.define(c.symbol.name, value, c.shown, title)
    return found


def _through(expr: sp.Expr, names: Mapping[sp.Symbol, sp.Expr]) -> sp.Expr:
    """An expression in the symbols of the instant."""
    for _ in range(DEPTH):
        inside = {s: names[s] for s in expr.free_symbols if names.get(s, s) != s}
        if not inside:
            break
        expr = expr.xreplace(inside)
    return expr


def _put(single: Single, names: Mapping[sp.Symbol, sp.Expr]) -> Single:
    premises = tuple(Premise(p.name, _through(p.formula, names), p.words) for p in single.premises)
    left, right = _through(single.left, names), _through(single.right, names)
    return replace(single, left=left, right=right, premises=premises)
