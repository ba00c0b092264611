"""The friction impulse of a blow against its limit, where what touches does not slide at its end: |J_F| ≤ μ J_N."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import sympy as sp

from planar_cli.equation.algebra.plain import longer, simplified
from planar_cli.problem.scene.facts import Test
from planar_cli.report.document.blocks import Block, Equation, Line, Math, line
from planar_cli.report.friction.lasting_presses import lasting_presses
from planar_cli.report.friction.presses import bounded_in, sum_of_forces
from planar_cli.report.momentum.slack_in_blows import slackened
from planar_cli.report.words.words import Phrases
from planar_cli.solve.between.trace.trace import Impact, ImpactEquation, MotionTrace
from planar_cli.solve.solution import InstantSolution
from planar_cli.units import IMPULSE

SHORT = 16
"""An impulse of more operations decides nothing that a reader sees."""


def limits_of_motion(
    motion: MotionTrace, instants: Sequence[InstantSolution], phrases: Phrases, settled: Phrases
) -> tuple[Line, ...]:
    """What the assumptions of blows and of contacts that last ask for. `settled`: constants have values there."""
    return (*blow_limits(motion, phrases), *lasting_presses(instants, settled))


def blow_limits(motion: MotionTrace, phrases: Phrases) -> Iterator[Line]:
    """One line for each contact that sticks in a blow, where both of its impulses have values."""
    for impact in _impacts(motion) if not phrases.symbolic else ():
        if impact.solution is not None:
            for mode in impact.solution.trial.system.modes.values():
                tests = [t for t in mode.tests if bounded_in(impact.solution.trial.system, t) and not t.strict]
                yield from _against(impact.solution, tests[:1], phrases)


def ends_of_blows(motion: MotionTrace, phrases: Phrases) -> Iterator[Block]:
    """What shows that the modes of blows hold, behind their results."""
    yield from grips_in_letters(motion, phrases)
    for impact in _impacts(motion) if not phrases.symbolic else ():
        if impact.solution is not None:
            yield from slackened(impact.solution, phrases)


def _impacts(motion: MotionTrace) -> tuple[Impact, ...]:
    """The blows on which the results rest, each once."""
    sources = [e.source for leg in motion.route.steps for e in leg.relations]
    return tuple({s.impact.since: s.impact for s in sources if isinstance(s, ImpactEquation)}.values())


def grips_in_letters(motion: MotionTrace, phrases: Phrases) -> Iterator[Block]:
    """Both impulses of each contact that sticks in a blow, and when the one of friction is within its limit, where
    everything is a letter: J_F = 2/7 m v_x, J_N = (1 + e) m v_y; no sliding if J_F < μ J_N.
    """
    for impact in _impacts(motion) if phrases.symbolic else ():
        blow = impact.solution
        tests = [] if blow is None else [t for m in blow.trial.system.modes.values() for t in m.tests if not t.strict]
        names: set[str] = set()
        for test in tests:
            name = bounded_in(blow.trial.system, test) if blow is not None else None
            if name is not None and name not in names and blow is not None and test.constant == 0:
                names.add(name)
                yield from _grip(blow, test, name, motion, phrases)


def _grip(blow: InstantSolution, test: Test, name: str, motion: MotionTrace, phrases: Phrases) -> Iterator[Block]:
    """The impulses by the velocities before and after, then in the letters of the file."""
    system = blow.trial.system
    pushes = {p.name: p for p in system.pushes}
    told: dict[str, sp.Expr] = {}
    lines: list[Block] = []
    for own in (name, *(n for n, _ in test.pushes if n != name)):
        formula = next(sum_of_forces(blow, pushes[own], system.symbols[own]), None)
        if formula is None:
            return
        put = formula
        for _ in motion.route.formulas:
            put = put.xreplace(dict(motion.route.formulas))
        told[own] = simplified(put)
        if longer(told[own], SHORT) or told[own] == 0:
            return
        plain = formula.xreplace(dict(motion.route.plain))
        middle, last = phrases.math(plain), phrases.math(told[own])
        lines.append(Equation((phrases.math(system.symbols[own]), *((middle,) if middle != last else ()), last)))
    limit = sp.Add(*(factor * told[n] for n, factor in test.pushes if n != name))
    letters = sp.Add(*(factor * system.symbols[n] for n, factor in test.pushes if n != name))
    size = told[name] if phrases.certain(told[name]) > 0 else -told[name]
    yield from lines
    needs = line("|", Math(system.symbols[name]), "| < ", phrases.math(letters), ":")
    sides = (phrases.math(size), phrases.math(simplified(limit)))
    yield Equation(sides, None, line("They do not slide on each other, as ", *needs), relation="<")


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
