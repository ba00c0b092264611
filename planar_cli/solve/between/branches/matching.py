"""Which branch of the equations of a motion is the one that was followed in numbers."""

from __future__ import annotations

from dataclasses import replace

import sympy as sp

from planar_cli.solve.between.equations.asked_finds import AskedFind
from planar_cli.solve.between.equations.motion_equations import MotionEquations
from planar_cli.solve.between.equations.needed_times import ONLY_TIMES, needed_letters
from planar_cli.solve.between.equations.stated_motion import StatedMotion
from planar_cli.solve.between.roots.chain import Branch, Chain
from planar_cli.solve.between.roots.followed import Followed
from planar_cli.solve.regimes.equations import Equation
from planar_cli.solve.regimes.regime_sequence import RegimeSequence

AGREE, SMALL = 1e-6, 1e-3
"""Letters agree up to this part of their size, which is no smaller than that part of an ordinary one."""


def beside(course: MotionEquations, finds: tuple[AskedFind, ...], chain: Chain) -> tuple[MotionEquations, Branch]:
    """The branch beside the numbers that were followed, and the equations that it rests on; integrals for times only
    where something rests on them.
    """
    nothing = Branch({}, {}, (), ())
    quick = [e for e in course.equations if e.kind not in ONLY_TIMES]
    if len(quick) < len(course.equations):
        branch = next(iter(chain.branches(quick)), nothing)
        if needed_letters(course, finds) & chain.unknowns <= set(branch.values):
            return replace(course, equations=tuple(e for e in course.equations if _tells(e, chain, branch))), branch
    return course, next(iter(chain.branches(course.equations)), nothing)


def _tells(e: Equation, chain: Chain, branch: Branch) -> bool:
    """May an equation stand on the page? A time is told directly by its own integral where that has a closed form,
    t = ∫ dv/a or, where the speed is given by the place, t = ∫ dq/v: the formula over time would have to be solved.
    """
    if e.kind not in ONLY_TIMES:
        return True
    closed = e.span is not None and not e.span.unevaluated
    direct = e.kind == "t(v)" or (e.law is not None and e.law.order == 1)
    return closed and direct and e.residual.free_symbols & chain.unknowns <= branch.values.keys()


def same_motion(course: RegimeSequence, followed: Followed, branch: Branch) -> bool:
    """Do followed numbers and branch agree, measured by the largest value that a letter has in any state?"""
    sizes: dict[sp.Symbol, float] = {}
    natural = course.natural(followed.values)
    general = {own: s for stop in course.stops.values() for s, own in stop.letters.items()}
    for own, v in followed.values.items():
        letter = general.get(own, own)
        sizes[letter] = max(sizes.get(letter, SMALL * float(natural[own])), abs(v))
    for own, v in followed.values.items():
        off = abs(float(branch.values[own]) - v) if own in branch.values else 0.0
        if off > AGREE * sizes[general.get(own, own)]:
            return False
    return True


def onward(course: StatedMotion, branch: Branch) -> int:
    """How many coordinates move in their last state as they have moved from the state before."""
    count = 0
    for i in range(len(course.states) - 1):
        a, b = (course.stops[course.states[k].name] for k in (i, i + 1))
        values = course.base().extended(branch.values)
        for c in course.regimes[i].coordinates:
            rate = values.known(b.at(course.regimes[i].rates[c.symbol]))
            way = values.known(b.letters[c.symbol] - a.letters[c.symbol])
            count += rate is not None and way is not None and rate * way > 0
    return count
