"""What is taken for granted of the letters of a file: that bodies approach each other before they strike, or do not."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator

import sympy as sp

from planar_cli.equation.algebra.plain import derivative, simplified
from planar_cli.solve.between.branches.solved_motion import SolvedMotion
from planar_cli.solve.between.equations.oscillation import periods_asked
from planar_cli.solve.between.told.answers import put_in
from planar_cli.solve.between.trace.derivation import Route
from planar_cli.solve.impulsive.impact import Blow
from planar_cli.solve.instant.conditions import without_factors
from planar_cli.solve.regimes.equations import DATA


def presumed(found: SolvedMotion, routes: Iterable[Route]) -> tuple[sp.Expr, ...]:
    """Expressions in letters of the file that are positive in this motion, and need not be."""
    scene, told, ways = found.course.scene, [], tuple(routes)

    def in_letters(expr: sp.Expr) -> sp.Expr:
        for route in ways:
            expr = put_in(expr, route)
        return expr

    blows = tuple(found.course.blows.values())
    signs = [e for blow in blows for e in _approaches(blow)]
    limits = (e for blow in blows for e in _limits(found, blow, in_letters))
    letters = scene.ledger.known_letters()
    open_ = [e for e in (*map(in_letters, signs), *limits) if e.free_symbols]
    for expr in (e if (found.value.known(e) or 0) > 0 else -e for e in open_):
        told += [without_factors(scene, expr)] if expr.free_symbols <= letters else []
    named = periods_asked(found.course)
    squares = [s.square for s in found.oscillations if s.single and s.stop.name in named]
    told += [e for e in squares if e.free_symbols and e.free_symbols <= letters]
    return tuple(scene.not_always_positive(told))


def _limits(found: SolvedMotion, blow: Blow, in_letters: Callable[[sp.Expr], sp.Expr]) -> Iterator[sp.Expr]:
    """What friction demands of the impulses of a blow, with these, and the speeds that nothing else needs, from the
    equations that tell them.
    """
    limits = blow.limits()
    data = [e for e in found.course.equations if limits and e.kind in DATA and e.stop == blow.since.name]
    blows = [e for e in blow.equations if limits and e.kind == "blow"]
    residuals = [in_letters(e.residual) for e in (*data, *blows)]
    known, told = found.course.scene.ledger.known_letters(), dict[sp.Symbol, sp.Expr]()
    grows = True
    while grows:
        grows = False
        for residual in (r.xreplace(told) for r in residuals):
            (letter, *more) = residual.free_symbols - known or (None,)
            rate = sp.S.Zero if letter is None or more else derivative(residual, letter)
            if letter is not None and rate != 0 and letter not in rate.free_symbols:
                told[letter] = simplified(letter - residual / rate)
                grows = True
    yield from (simplified(in_letters(blow.here(e)).xreplace(told)) for e in limits)


def _approaches(blow: Blow) -> Iterator[sp.Expr]:
    """How fast what may strike parts beforehand, in letters of the state before."""
    for joint in blow.scene.problem.joints:
        for mode in joint.blows(blow.scene) if joint.strikes else ():
            if mode.name == "apart":
                yield from (blow.here(sp.sympify(t.constant)) for t in mode.tests if t.constant != 0)
