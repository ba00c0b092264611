"""Why nothing can hold where friction at two contacts shares what is needed: with as much as the one can give the other
would need more than it has.

even with |F_B| = μ_B N_B = 6.3 N it would need |F_A| = 55.1 N > μ_A N_A = 0.2 · 141.2 = 28.2 N
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from decimal import Decimal
from itertools import permutations

import sympy as sp

from planar_cli.equation.exact import ZERO
from planar_cli.problem.facts import Test
from planar_cli.report.blocks import Line, Math, line
from planar_cli.report.decisions import limits_of, needed
from planar_cli.report.presses import bounded_in
from planar_cli.report.words import Phrases
from planar_cli.solve.instant.instant import Trial
from planar_cli.solve.instant.study import measure

Straight = tuple[Decimal, Decimal]
"""Value and slope of what a test measures, over the one reaction that is free."""
TINY = Decimal("1e-20")


def at_best(trial: Trial, phrases: Phrases) -> Line:
    """The comparison; empty where more than one reaction is free, or no two contacts share friction so."""
    outcome = trial.outcomes[0]
    if phrases.symbolic or len(outcome.solved.null) != 1 or outcome.value is None:
        return ()
    tests: dict[str, list[Test]] = {}
    for mode in trial.system.modes.values():
        for test in mode.tests:
            name = bounded_in(trial.system, test)
            if name is not None and not test.strict and not test.within:
                tests.setdefault(name, []).append(test)
    for helping, other in permutations(reversed(tests), 2):
        for free in _ends([_straight(trial, t) for t in tests[helping]]):
            told = _told(trial, (helping, other), tests[other], free, phrases)
            if told:
                return told
    return ()


def _straight(trial: Trial, test: Test) -> Straight:
    outcome = trial.outcomes[0]
    value, slopes = measure(test, outcome.assembly, outcome.solved)
    return value, sum(slopes.values(), ZERO)


def _ends(bounds: list[Straight]) -> Iterator[tuple[Decimal, Decimal]]:
    """Both ends of what is allowed, each with what lies a little inside; nothing where that is not bounded."""
    low = [-value / slope for value, slope in bounds if slope > 0]
    high = [-value / slope for value, slope in bounds if slope < 0]
    if low and high and max(low) < min(high):
        least, most = max(low), min(high)
        inside = (most - least) / 1000
        yield from ((least, least + inside), (most, most - inside))


def _told(
    trial: Trial, names: tuple[str, str], tests: list[Test], free: tuple[Decimal, Decimal], phrases: Phrases
) -> Line:
    """Where the other friction is nearest to enough at this end, and still has too little."""
    at_end, inside = free
    bounds = [_straight(trial, t) for t in tests]
    missing, before = (min(value + slope * s for value, slope in bounds) for s in (at_end, inside))
    if missing >= -TINY or before > missing:
        return ()
    settled = _settled(trial, at_end)
    found = {bounded_in(settled.system, t): n for _, t in limits_of(settled) if (n := needed(settled, t)) is not None}
    helping, other = (found.get(name) for name in names)
    pushes = [p for p in settled.system.pushes if p.kind == "normal"]
    presses = all((settled.outcomes[0].push(p.name) or ZERO) >= 0 for p in pushes)
    if helping is None or other is None or not presses or other.size <= other.limit:
        return ()
    whole = line("|", Math(helping.symbol), "| = ", phrases.math(helping.formula), " = ", helping.shown(phrases)[1])
    shown, most = other.shown(phrases)
    needs = line("|", Math(other.symbol), "| = ", shown, " > ", phrases.math(sp.sympify(other.formula)), " = ", most)
    return line("even with ", *whole, " it would need ", *needs)


def _settled(trial: Trial, free: Decimal) -> Trial:
    """The same with this value of what is free."""
    outcome = trial.outcomes[0]
    ((_, vector),) = outcome.solved.null.items()
    values = [v + free * vector[j] for j, v in enumerate(outcome.solved.values)]
    return replace(trial, outcomes=(replace(outcome, solved=replace(outcome.solved, values=values, null={})),))
