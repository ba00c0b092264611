"""A motion that is solved: its course, the branch of its equations that happens, and all that is told of it."""

from __future__ import annotations

import math

import sympy as sp

from planar_cli.equation.values.exact import Valuation
from planar_cli.records import record
from planar_cli.solve.between.equations.asked_finds import AskedFind
from planar_cli.solve.between.equations.motion_equations import MotionEquations
from planar_cli.solve.between.equations.oscillation import Oscillation
from planar_cli.solve.between.roots.chain import Branch
from planar_cli.solve.between.roots.followed import Followed
from planar_cli.solve.between.trace.span_trace import SpanIntegral

ALIKE = 1e-6
"""Times that differ by this part of them are the same, as of departures to either side of a symmetrical scene."""


@record
class SolvedMotion:
    """The branch of the equations of a motion that happens."""

    course: MotionEquations
    """The equations."""
    finds: tuple[AskedFind, ...]
    """What is asked."""
    branch: Branch
    """The roots that happen."""
    followed: Followed | None
    """How it was followed in numbers; None: it could not be."""
    value: Valuation
    """Numbers of everything."""
    guessed: frozenset[sp.Symbol] = frozenset()
    """Symbols whose values come from following it alone."""
    integrated: bool = False
    """Do its equations of motion, integrated by themselves, give these too?"""
    checks: tuple[str, ...] = ()
    """What was compared, in phrases."""
    spans: tuple[SpanIntegral, ...] = ()
    """Quantities over spans, once they are worked out."""
    oscillations: tuple[Oscillation, ...] = ()
    """About equilibrium states that are asked about, once the places of these are known."""


def ended(motion: SolvedMotion) -> float:
    """When the last state of a motion is passed, as far as it was followed [s]; infinity: it was not followed."""
    followed = motion.followed
    return followed.segments[-1].t1 if followed is not None and followed.segments else math.inf


def sooner(first: SolvedMotion, other: SolvedMotion) -> SolvedMotion:
    """Of two motions that begin at the same time the one that passes all states first; `first` where both take the same
    time.
    """
    return other if ended(other) < ended(first) * (1 - ALIKE) < math.inf else first
