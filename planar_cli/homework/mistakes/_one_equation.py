"""One equation in which something is wrong while the others are right, as it happens on paper."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import replace

import sympy as sp

from planar_cli.homework.sets.printed_names import printed
from planar_cli.problem.nodes.reading import listed
from planar_cli.replay.equations import Asked, Equations, Step

FORCES = ("force", "moment")
"""Kinds of equations of which the bodies, and the direction or the point, are told."""


def told(step: Step, i: int) -> str:
    """Which equation it is: `the equation of crate along x`; "" where nobody can say."""
    if step.kinds[i] not in FORCES or not step.bodies[i]:
        return ""
    bodies = listed([printed(b) for b in step.bodies[i]], "and")
    what = "equation of moments of" if step.kinds[i] == "moment" else "equation of"
    way = step.ways[i] if step.ways else ""
    return f"the {what} {bodies}{f' {way}' if way else ''}"


def in_last_equation(
    equations: Equations, is_meant: Callable[[sp.Expr], bool], factor: int = 1
) -> Iterator[tuple[str, Equations]]:
    """Each find that is an unknown beside others, as one equation gives it without some of its terms where all else in
    it is right: T = m a + m g sin β, without friction. `factor`: 1 without them, 2 with the other sign. With the
    equation in words.
    """
    for step in equations.steps:
        for i, residual in enumerate(step.residuals if len(step.residuals) > 1 else ()):
            words = told(step, i)
            meant = sp.Add(*(t for t in sp.Add.make_args(sp.expand(residual)) if is_meant(t))) if words else sp.S.Zero
            for unknown in step.unknowns if meant != 0 else ():
                coefficient = sp.diff(residual, unknown)
                inside = coefficient.free_symbols
                if coefficient == 0 or unknown in inside | meant.free_symbols:
                    continue
                wrong = unknown + factor * meant / coefficient
                asked = {n: replace(a, parts=(wrong,)) for n, a in _alone(equations, unknown)}
                if asked:
                    yield words, replace(equations, asked={**equations.asked, **asked})


def _alone(equations: Equations, unknown: sp.Symbol) -> Iterator[tuple[str, Asked]]:
    """The finds that are an unknown itself."""
    yield from ((n, a) for n, a in equations.asked.items() if a.parts == (unknown,))
