"""A motion that no formula gives: its equation of motion, the start and the method by which it is integrated."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from typing import Any

import sympy as sp

from planar_cli.equation.algebra.plain import longer
from planar_cli.problem.language.expression import JustAfter
from planar_cli.report.document.blocks import Block, Equation, Line, Math, Paragraph, line
from planar_cli.report.in_numbers.put_in import put_in
from planar_cli.report.oscillation.small_motion import small_motion
from planar_cli.report.words.words import Phrases
from planar_cli.solve.between.trace.trace import MotionTrace, RegimeTrace, Result
from planar_cli.solve.instant.used import used_blocks

Blows = list[tuple[str, str]]
"""States just before and just after blows."""
NAMED = 6
"""More letters are not listed by name."""
MOST = 70
"""A law with more operations is not written out: the equations before it give it, state by state."""


def integration_blocks(found: MotionTrace, phrases: Phrases, results: Iterable[Result]) -> Iterator[Block]:
    """What is integrated to find letters of states, and constants. `results`: these letters."""
    results = list(results)
    letters = [r.unknown for r in results]
    yield from small_motion(found, phrases, results)
    stops = {at for s in letters if (at := found.ledger.roles[s].at) is not None}
    tried = [s for s in letters if found.ledger.roles[s].at is None]
    if tried:
        stops |= set(found.states[-1:])
    regimes = [r for r in found.regimes if _is_passed(found, r, stops)]
    laws = {rate: law for r in regimes for rate, law in r.laws if law != 0}
    if not laws:
        found_so = " are" if len(tried or letters) > 1 else " is"
        names = _names(tried or letters)
        yield Paragraph(line(*names, found_so, " found by trial, so that the motion passes all states."))
        return
    blows = _blows(found, stops)
    begun = [after for before, after in blows if before == found.states[0]]
    first = begun[0] if begun else found.states[0]
    shown, whole = _shown(found, phrases, regimes, blows)
    start = _start(found, phrases, first, [*laws.values()])
    what = "the equation of motion is" if len(laws) == 1 else "the equations of motion are"
    if not whole:
        what = "the equations above, solved for the accelerations at every step, are"
    told = tried or (letters if len(letters) <= NAMED else [])
    several = " are" if len(told) > 1 else " is"
    named = line(*_names(told), several) if told else line("What follows is")
    how = " with trial values, until the motion passes all states" if tried else ""
    words = f" found by numerical integration: {what} integrated{how} (by a Runge–Kutta method)"
    beginning = (f" from state {first} on, where ", *start) if start else ()
    yield Paragraph(line(*named, words, *beginning, ":"))
    yield from shown if whole else ()
    for before, after in blows:
        if tried or first not in (before, after):
            yield Paragraph(_across(found, before, after))


def _shown(
    found: MotionTrace, phrases: Phrases, regimes: Sequence[RegimeTrace], blows: Blows
) -> tuple[list[Block], bool]:
    """The laws, with the stretches where each set of them holds if there are several; and are these all of them?"""
    sets: dict[tuple[tuple[sp.Symbol, sp.Expr], ...], list[str]] = {}
    for r in regimes:
        moving = [(since, stop) for since, stop in r.stretches if since != stop and (since, stop) not in blows]
        spans = [f"from {since} to {stop}" if stop else f"from {since} on" for since, stop in moving]
        sets.setdefault(tuple((rate, law) for rate, law in r.laws), []).extend(spans)
    blocks: list[Block] = []
    whole = True
    for laws, spans in sets.items():
        told = [(rate, law) for rate, law in laws if law != 0]
        if not laws:
            continue  # What rests there is not integrated.
        rows = [e for rate, law in told if (e := _law(found, phrases, rate, law)) is not None]
        whole = whole and len(rows) == len(told)
        blocks += [Paragraph(line(", ".join(spans) + ":"))] if len(sets) > 1 else []
        blocks += rows or [Equation((phrases.math(rate), line("0"))) for rate, _ in laws]
    return blocks, whole


def _blows(found: MotionTrace, stops: set[str]) -> Blows:
    """The states just before and just after each blow that the integration passes."""
    names = found.states
    last = max((names.index(s) for s in stops if s in names), default=0)
    pairs = ((r.state, s.name) for s in found.problem.states for r in s.relations if isinstance(r, JustAfter))
    return [(before, after) for before, after in pairs if after in names and names.index(after) <= last]


def _across(found: MotionTrace, before: str, after: str) -> Line:
    """How the velocities after a blow follow from those before it."""
    struck = [j for j in found.problem.joints if j.strikes and getattr(j, "during", None) == (before, after)]
    elastic = any(getattr(j, "restitution", None) is not None for j in struck)
    rule = " and the law of restitution" if elastic else ""
    words = f"At {before} there is a blow: the velocities from {after} on follow from those before it"
    return line(f"{words} by the balance of momentum{rule}.")


def _names(letters: Sequence[sp.Symbol]) -> Line:
    """`u, v and w`."""
    parts: list[Any] = []
    for i, s in enumerate(letters):
        parts += [] if i == 0 else [" and " if i == len(letters) - 1 else ", "]
        parts.append(Math(s))
    return tuple(line(*parts))


def is_solved_in_steps(found: MotionTrace, regime: RegimeTrace) -> bool:
    """Are the equations of a regime told without their solution, as it is long and only numbers follow from it?"""
    followed = any(e.kind == "followed" for step in found.route.steps for e in step.relations)
    if found.symbolic or not followed or found.oscillations:
        return False
    stages = used_blocks(regime.solution.stages, regime.wanted)
    return any(longer(x.formula, MOST) for s in stages for b in s.blocks for x in b.lines)


def _is_passed(found: MotionTrace, regime: RegimeTrace, stops: set[str]) -> bool:
    """Does a regime act before one of these states?"""
    last = max((found.states.index(s) for s in stops if s in found.states), default=0)
    begun = [since for since, stop in regime.stretches if since != stop and since in found.states]
    return any(found.states.index(since) < last for since in begun)


def _law(found: MotionTrace, phrases: Phrases, rate: sp.Symbol, law: sp.Expr) -> Equation | None:
    """A law in letters where it is short, else with its numbers."""
    if longer(law, MOST) or not longer(law, MOST // 4):
        return None if longer(law, MOST) else Equation((phrases.math(rate), phrases.math(law)))
    numbers = put_in(rate, law, {rate, *found.varying}, phrases)
    if numbers is None:
        return Equation((phrases.math(rate), phrases.math(law)))
    return Equation((Math(rate), numbers.right), None, (), numbers.note)


def _start(found: MotionTrace, phrases: Phrases, first: str, laws: Iterable[sp.Expr]) -> Line:
    """The places and speeds from which it starts."""
    roles = found.ledger.roles
    moving = {s for law in laws for s in law.free_symbols} & found.varying
    parts: list[Any] = []
    for own, general in found.general.items():
        if roles[own].at == first and general in moving and general.name != "t" and found.value.known(own) is not None:
            parts += [", " if parts else "", phrases.math(own), " = ", phrases.shown(own)]
    return tuple(line(*parts))
