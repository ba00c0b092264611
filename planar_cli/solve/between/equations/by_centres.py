"""What an equilibrium state says of mass centres, in the letters of their coordinates: y_G = r, and how y_G is found is
told before it.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import sympy as sp

from planar_cli.equation.algebra.plain import simplified
from planar_cli.solve.between.equations.stated_motion import StatedMotion
from planar_cli.solve.between.trace.derivation import at_right_angles
from planar_cli.solve.between.trace.trace import RouteStep
from planar_cli.solve.regimes.equations import Equation
from planar_cli.solve.regimes.regime import Regime

CENTRE = " of the mass centre of "


def by_centres(regime: Regime) -> set[sp.Symbol]:
    """The letters of coordinates of mass centres."""
    ledger = regime.general.instant.scene.ledger
    return {s for s in ledger.definitions if CENTRE in ledger.titles[s]}


def in_centres(course: StatedMotion, e: Equation, level: Mapping[sp.Symbol, sp.Expr]) -> sp.Expr | None:
    """A relation of an equilibrium state in these letters; None: it has none of them."""
    if e.kind != "given" or e.stop not in course.beside:
        return None
    regime, stop = course.readers[e.stop].regime, course.stops[e.stop]
    ledger, letters = regime.general.instant.scene.ledger, by_centres(regime)
    known = {*letters, *ledger.values, *ledger.letters, *ledger.sought, *stop.letters.values()}
    for statement, parts in course.beside[e.stop]:
        residual = sp.sympify(parts[1]).xreplace(dict(stop.letters)) if parts[0] == "=" else sp.S.Zero
        said = getattr(statement, "text", "") == e.words
        if said and residual.free_symbols & letters and not residual.free_symbols - known:
            return simplified(at_right_angles(residual, level))
    return None


def without_places(steps: Sequence[RouteStep]) -> tuple[RouteStep, ...]:
    """Without the drawn places on which only relations rest that are told without them."""
    told = [e for step in steps for e in step.relations if e.told is not None]
    idle = {x for e in told if e.told is not None for x in e.residual.free_symbols - e.told.free_symbols}
    others = [e for step in steps for e in step.relations if e.told is None and e.kind != "drawn"]
    formulas = [r.formula for step in steps for r in step.results if r.formula is not None]
    idle -= {x for e in (*(o.residual for o in others), *formulas) for x in e.free_symbols}
    return tuple(s for s in steps if not (idle.issuperset(s.unknowns) and all(e.kind == "drawn" for e in s.relations)))
