"""Which given lengths only place what is drawn: nothing that the page works out rests on them."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import replace

import sympy as sp

from planar_cli.equation.values.ledger import Ledger
from planar_cli.problem.checks.unused import unused
from planar_cli.problem.language.expression import Number
from planar_cli.solve.between.trace.trace import MotionTrace
from planar_cli.solve.solved_problem import PartSolution


def drawing_only(parts: Iterable[PartSolution]) -> frozenset[str]:
    """The names that only place what is drawn, in every part; none where the way to an answer can not be looked
    through.
    """
    found = [_of_part(part) for part in parts]
    return frozenset.intersection(*found) if found else frozenset()


def _of_part(part: PartSolution) -> frozenset[str]:
    motion = part.motion
    if motion is None or part.tale or part.followed or motion.guessed:
        # What is read off a motion that is followed in numbers may rest on anything.
        return frozenset()
    if motion.spans or motion.oscillations or motion.passing:
        return frozenset()
    problem = motion.problem
    nowhere = set(unused(problem))
    placing = {name for name in unused(replace(problem, points=())) if name not in nowhere}
    names = {s.name for s in problem.given if s.name in placing and isinstance(s.value, Number)}
    behind = _behind(_worked_out(motion), motion.ledger) if names else set()
    return frozenset(names - {s.name for s in behind})


def _worked_out(motion: MotionTrace) -> Iterator[sp.Expr]:
    """The relations and results on the way to the answers, and what is asked."""
    for leg in motion.route.steps:
        yield from (e.residual for e in leg.relations)
        yield from (r.formula for r in leg.results if r.formula is not None)
    yield from (part for r in motion.requests for part in r.parts)


def _behind(exprs: Iterable[sp.Expr], ledger: Ledger) -> set[sp.Symbol]:
    """All letters of formulas, down to those of the file."""
    found: set[sp.Symbol] = set()
    left = {s for e in exprs for s in sp.sympify(e).free_symbols}
    while left:
        found |= left
        left = {t for s in left for t in ledger.behind(s).free_symbols} - found
    return found
