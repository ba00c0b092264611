"""A motion that no formula gives: its equation of motion, the start and the method by which it is integrated."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from typing import Any

import sympy as sp

from planar_cli.equation.plain import longer
from planar_cli.report.blocks import Block, Equation, Line, Math, Paragraph, line
from planar_cli.report.put_in import put_in
from planar_cli.report.words import Phrases
from planar_cli.solve.between.trace import MotionTrace, RegimeTrace, Result
from planar_cli.solve.instant.used import used_blocks

NAMED = 6
"""More letters are not listed by name."""
MOST = 70
"""A law with more operations is not written out: the equations before it give it, state by state."""


def integration_blocks(found: MotionTrace, phrases: Phrases, results: Iterable[Result]) -> Iterator[Block]:
    """What is integrated to find letters of states, and constants. `results`: these letters."""
    letters = [r.unknown for r in results]
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
    shown = [e for rate, law in laws.items() if (e := _law(found, phrases, rate, law)) is not None]
    start = _start(found, phrases, [*laws.values()], [*laws])
    whole = len(shown) == len(laws)
    what = "the equation of motion is" if len(laws) == 1 else "the equations of motion are"
    if not whole:
        what = "the equations above, solved for the accelerations at every step, are"
    told = tried or (letters if len(letters) <= NAMED else [])
    several = " are" if len(told) > 1 else " is"
    named = line(*_names(told), several) if told else line("What follows is")
    how = " with trial values, until the motion passes all states" if tried else ""
    words = f" found by numerical integration: {what} integrated{how} (by a Runge–Kutta method)"
    begun = (f" from state {found.states[0]} on, where ", *start) if start else ()
    yield Paragraph(line(*named, words, *begun, ":"))
    yield from shown if whole else ()


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


def _start(found: MotionTrace, phrases: Phrases, laws: Iterable[sp.Expr], rates: Iterable[sp.Symbol]) -> Line:
    """The places and speeds from which it starts."""
    first = found.states[0]
    roles = found.ledger.roles
    moving = {s for law in laws for s in law.free_symbols} & found.varying
    parts: list[Any] = []
    for own, general in found.general.items():
        if roles[own].at == first and general in moving and general.name != "t" and found.value.known(own) is not None:
            parts += [", " if parts else "", phrases.math(own), " = ", phrases.shown(own)]
    return tuple(line(*parts))
