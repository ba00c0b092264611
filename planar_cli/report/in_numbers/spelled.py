"""Equations of forces and moments in letters, with the units that the numbers among them hold: 2 m/s² m."""

from __future__ import annotations

from collections.abc import Collection

import sympy as sp

from planar_cli.equation.values.ledger import Ledger
from planar_cli.report.document.blocks import Math
from planar_cli.report.in_numbers.with_units import with_units
from planar_cli.report.notation.clean import is_clean
from planar_cli.report.words.words import Phrases
from planar_cli.solve.instant.stages import Stage
from planar_cli.solve.instant.written import Written
from planar_cli.units import ACCELERATION, ENERGY, FORCE

UNITS = {"force": FORCE, "moment": ENERGY}
"""What the sides of these equations are."""


def is_spelled(stages: Collection[Stage], general: Phrases) -> bool:
    """Do the equations of forces and moments stay in letters, with the units that their numbers hold? Not where
    relations of kinematics hide a unit.
    """
    ledger, written = general.ledger, [w for s in stages for b in s.blocks for w in b.equations if not w.given]
    named = [x for s in stages for x in s.lines]
    if not all(is_clean(ledger, x.symbol, x.expression, dimension=ACCELERATION) for x in named):
        return False
    if not all(is_clean(ledger, w.left, w.right) for w in written if w.law not in UNITS):
        return False
    return all(_is_clean(w, ledger) or spelled(w, (w.left, w.right), general) for w in written if w.law in UNITS)


def _is_clean(w: Written, ledger: Ledger) -> bool:
    return is_clean(ledger, w.left, w.right, dimension=UNITS[w.law])


def spelled(w: Written, sides: Collection[sp.Expr], general: Phrases) -> tuple[Math, ...]:
    """The sides of an equation of forces or moments in letters, with the units of the numbers among them. Empty: there
    are none, or they are not told so.
    """
    dimension = UNITS.get(w.law)
    if dimension is None or _is_clean(w, general.ledger):
        return ()
    found = [with_units(general.neat(general.met(sp.sympify(e))), dimension, general) for e in sides]
    return tuple(e for e in found if e is not None) if all(e is not None for e in found) else ()
