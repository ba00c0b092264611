"""What is taken for granted of the letters of a file: that bodies approach each other before they strike, or do not."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

import sympy as sp

from planar_cli.solve.between.answers import put_in
from planar_cli.solve.between.derivation import Route
from planar_cli.solve.between.oscillation import periods_asked
from planar_cli.solve.between.solved_motion import SolvedMotion
from planar_cli.solve.impulsive.impact import Blow


def presumed(found: SolvedMotion, routes: Iterable[Route]) -> tuple[sp.Expr, ...]:
    """Expressions in letters of the file that are positive in this motion, and need not be."""
    scene, told = found.course.scene, []
    for approach in (e for blow in found.course.blows.values() for e in _approaches(blow)):
        expr = approach
        for route in routes:
            expr = put_in(expr, route)
        if expr.free_symbols and expr.free_symbols <= set(scene.ledger.letters):
            told.append(expr if (found.value.known(expr) or 0) > 0 else -expr)
    named = periods_asked(found.course)
    squares = [s.square for s in found.oscillations if s.single and s.stop.name in named]
    told += [e for e in squares if e.free_symbols and e.free_symbols <= set(scene.ledger.letters)]
    return tuple(scene.not_always_positive(told))


def _approaches(blow: Blow) -> Iterator[sp.Expr]:
    """How fast what may strike parts beforehand, in letters of the state before."""
    for joint in blow.scene.problem.joints:
        for mode in joint.blows(blow.scene) if joint.strikes else ():
            if mode.name == "apart":
                yield from (blow.here(sp.sympify(t.constant)) for t in mode.tests if t.constant != 0)
