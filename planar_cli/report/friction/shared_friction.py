"""Why nothing can hold where friction at two contacts shares what is needed: with as much as the one can give the other
would need more than it has.

even with |F_B| = μ_B N_B = 6.3 N it would need |F_A| = N_B = 55.1 N > μ_A N_A = 0.2 · 141.2 = 28.2 N

The normal forces stand before what rests on them: first of all, where friction does not enter them.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from decimal import Decimal
from itertools import permutations
from typing import TYPE_CHECKING

from planar_cli.equation.values.exact import ZERO
from planar_cli.problem.scene.facts import Test
from planar_cli.records import record
from planar_cli.report.document.blocks import Line, Math, line
from planar_cli.report.friction.decisions import Needed, limits_of, needed
from planar_cli.report.friction.presses import bounded_in
from planar_cli.report.friction.what_it_needs import listed, presses, working
from planar_cli.report.words.words import Phrases
from planar_cli.solve.instant.instant import Trial
from planar_cli.solve.instant.study import measure
from planar_cli.solve.solution import InstantSolution

if TYPE_CHECKING:
    from planar_cli.report.friction.what_it_needs import Presses, Working

Straight = tuple[Decimal, Decimal]
"""Value and slope of what a test measures, over the one reaction that is free."""
TINY = Decimal("1e-20")


@record
class Shared:
    """Two frictions by their `names` in the system: the `helping` one at its limit, and the `other`, which has too
    little.
    """

    names: tuple[str, str]
    helping: Needed
    other: Needed


def at_best(trial: Trial, instant: InstantSolution, phrases: Phrases) -> Line:
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
            if told := _told(trial, (helping, other), tests[other], free, phrases):
                way, pressed = _slipping(trial, told, instant)
                first = presses(trial, told.helping.formula + told.other.formula, instant)
                return _sentence(told, way, pressed if first is None else first, first is not None, phrases)
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
) -> Shared | None:
    """Where the other friction is nearest to enough at this end, and still has too little."""
    at_end, inside = free
    bounds = [_straight(trial, t) for t in tests]
    missing, before = (min(value + slope * s for value, slope in bounds) for s in (at_end, inside))
    if missing >= -TINY or before > missing:
        return None
    settled = _settled(trial, at_end)
    found = {bounded_in(settled.system, t): n for _, t in limits_of(settled) if (n := needed(settled, t)) is not None}
    helping, other = (found.get(name) for name in names)
    pushes = [p for p in settled.system.pushes if p.kind == "normal"]
    presses = all((settled.outcomes[0].push(p.name) or ZERO) >= 0 for p in pushes)
    if helping is None or other is None or not presses or other.size <= other.limit:
        return None
    return Shared(names, helping, other)


def _slipping(natural: Trial, shared: Shared, instant: InstantSolution) -> tuple[Working | None, Presses | None]:
    """How the other friction is worked out where the helping one has reached its limit: its contact slips then, as in
    one of the cases that were tried; and the normal forces behind its limit. None: the forces of that are other ones,
    or the way to them is long.
    """
    own = {p.name: p for p in natural.system.pushes}
    helping, other = (own[name] for name in shared.names)
    for trial in instant.rejected:
        modes = {n: m.name for n, m in trial.system.modes.items()}
        apart = [n for n, m in natural.system.modes.items() if modes.get(n) != m.name]
        if apart == [helping.joint] and modes[helping.joint] == "slip":
            found = working(trial, other, shared.other.size, instant)
            if found is not None:
                return found, None if found.senses else presses(trial, shared.other.formula, instant)
    return None, None


def _sentence(shared: Shared, way: Working | None, pressed: Presses | None, first: bool, phrases: Phrases) -> Line:
    """The comparison, with what it rests on. `first`: do the normal forces stand before all else?"""
    found, other = shared.helping, replace(shared.other, own=None if way is None else way.size, working=way)
    whole = line("|", Math(found.symbol), "| = ", phrases.math(found.formula), " = ", found.shown(phrases)[1])
    shown, most = other.shown(phrases)
    needs = line("|", Math(other.symbol), "|", *other.worked(phrases), " = ", shown)
    there = phrases if way is None else replace(phrases, value=way.value)
    put = () if way is None else there.substituted(other.formula, most)
    limit = line(" > ", there.math(other.formula), *(x for side in put for x in (" = ", side)), " = ", most)
    opening = line(*pressed.told(phrases), "; ") if first and pressed is not None else ()
    letters = dict(() if pressed is None else pressed.letters) | dict(() if way is None else way.before)
    if opening and pressed is not None:
        letters = {s: e for s, e in letters.items() if s not in dict(pressed.letters)}
    before = listed(letters.items(), way.value, phrases, way.senses) if way is not None else ()
    middle = line(": then ", *before, "; it would need ") if before else line(" it would need ")
    return line(*opening, "even with ", *whole, *middle, *needs, *limit)


def _settled(trial: Trial, free: Decimal) -> Trial:
    """The same with this value of what is free."""
    outcome = trial.outcomes[0]
    ((_, vector),) = outcome.solved.null.items()
    values = [v + free * vector[j] for j, v in enumerate(outcome.solved.values)]
    return replace(trial, outcomes=(replace(outcome, solved=replace(outcome.solved, values=values, null={})),))
