"""The friction impulse of a blow against its limit, where what touches does not slide at its end: |J_F| ≤ μ J_N."""

from __future__ import annotations

from collections.abc import Iterator

import sympy as sp

from planar_cli.problem.facts import Test
from planar_cli.report.blocks import Line, Math, line
from planar_cli.report.presses import bounded_in
from planar_cli.report.words import Phrases
from planar_cli.solve.between.trace import ImpactEquation, MotionTrace
from planar_cli.solve.solution import InstantSolution
from planar_cli.units import IMPULSE


def blow_limits(motion: MotionTrace, phrases: Phrases) -> Iterator[Line]:
    """One line for each contact that sticks in a blow, where both of its impulses have values."""
    sources = [e.source for leg in motion.route.steps for e in leg.relations]
    impacts = {s.impact.since: s.impact for s in sources if isinstance(s, ImpactEquation)}
    for impact in impacts.values() if not phrases.symbolic else ():
        if impact.solution is not None:
            for mode in impact.solution.trial.system.modes.values():
                tests = [t for t in mode.tests if bounded_in(impact.solution.trial.system, t) and not t.strict]
                yield from _against(impact.solution, tests[:1], phrases)


def _against(blow: InstantSolution, tests: list[Test], phrases: Phrases) -> Iterator[Line]:
    """|J_F| = 0.34 N·s ≤ μ J_N = 0.84 N·s."""
    system, value = blow.trial.system, blow.value
    for test in tests:
        name = bounded_in(system, test)
        letters = {n: system.symbols[n] for n, _ in test.pushes if n in system.symbols}
        if name is None or len(letters) < len(test.pushes) or test.constant != 0:
            continue
        formula = sp.Add(*(factor * letters[n] for n, factor in test.pushes if n != name))
        size, limit = value.known(letters[name]), value.known(formula)
        if size is None or limit is None or not phrases.has_numbers(formula) or abs(size) > limit:
            continue
        shown = [phrases.of_dimension(x, IMPULSE) for x in (abs(size), limit)]
        yield line("|", Math(letters[name]), "| = ", shown[0], " ≤ ", phrases.math(formula), " = ", shown[1])
