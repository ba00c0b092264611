"""What is largest or smallest over a constant that is sought: as a formula of it, before its derivative is taken."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import sympy as sp

from planar_cli.equation.algebra.plain import identically_zero, longer
from planar_cli.equation.values.ledger import Kind
from planar_cli.report.document.blocks import Block, Equation, Line, Math, Paragraph, Text, line
from planar_cli.report.in_numbers.put_in import partly
from planar_cli.report.motion.between import BetweenTelling
from planar_cli.report.notation.page_units import coherent_unit
from planar_cli.report.words.spoken import spoken
from planar_cli.report.words.state_words import at
from planar_cli.report.words.turning_values import SAME, over_time
from planar_cli.report.words.words import Phrases
from planar_cli.solve.between.trace.trace import AimTrace, MotionTrace, Relation, RouteStep
from planar_cli.units import FORCE, PURE, pretty_unit

WAVE = sp.Dummy("wave", real=True)
FORCES = ("the tension", "the normal force", "the friction")
LONGEST, SHORT, DEEP = 24, 12, 6
"""A longer function of the time, or formula of a force, is not told; so many formulas stand one in another."""


def aims_told(e: Relation, leg: RouteStep, telling: Any) -> Iterator[Block]:
    """What is largest or smallest, as a formula of a constant, in the telling of a motion."""
    if e.aim is not None and e.aim.law is None:
        yield from timed_blocks(e.aim, e.stop, telling.found, telling.numeric)
    elif e.aim is not None:
        telling.aims.append((e.aim.law, telling.next))
        yield from aim_blocks(e.aim, leg, telling.found, telling.between, telling.number())
    elif e.of is not None and over_time(e):
        yield from _force_over_time(e, telling)


def _force_over_time(e: Relation, telling: Any) -> Iterator[Block]:
    """A force that is largest or smallest in time as a function of the time, which no line has told by then: the
    tension in rope = 2943 + 141.4 sin(π t/4). Nothing of what depends on other letters of the state too.
    """
    found, quantity = telling.found, e.of
    words = spoken(e.words.rpartition(" is ")[0], found.ledger.symbols)
    if quantity is None or not isinstance(words[0], Text) or not words[0].text.startswith(FORCES):
        return
    own = quantity.free_symbols & found.general.keys()
    time = found.general[next(iter(own))] if len(own) == 1 else None
    if time is None or longer(quantity, LONGEST) or found.ledger.roles[time].kind is not Kind.TIME:
        return
    formula = quantity.xreplace(dict.fromkeys(own, time))
    shown = partly(formula, {time}, telling.numeric) or telling.phrases.math(formula)
    unit = pretty_unit(coherent_unit(FORCE, us=found.ledger.us).text)
    yield Paragraph(line("At any time:"))
    by, sides = _by_acceleration(formula, time, telling)
    yield from by
    yield Equation((words, *sides, shown), None, (), line(f"in {unit}") if shown.values else ())
    (own_time,) = own
    if (sine := _extreme_sine(formula, time, found.value.extended({time: found.value(own_time)}))) is not None:
        yield Paragraph(line(f"{e.words.rpartition(' ')[2]} where ", telling.phrases.math(sine), " = 1"))


def _extreme_sine(formula: sp.Expr, time: sp.Symbol, there: Any) -> sp.Expr | None:
    """The sine or cosine which alone varies in a formula, as c_0 + c_1 sin(π t/4), where it is 1 at this time:
    there one sees at once which kind of extreme value it is. `there`: the values at the time.
    """
    waves = formula.atoms(sp.sin, sp.cos)
    if len(waves) != 1:
        return None
    (wave,) = waves
    slope = sp.diff(formula.xreplace({wave: WAVE}), WAVE)
    steady = not slope.has(time, WAVE) and not formula.xreplace({wave: sp.S.Zero}).has(time)
    return wave if steady and abs(there(wave) - 1) < SAME else None


def _by_acceleration(formula: sp.Expr, time: sp.Symbol, telling: Any) -> tuple[list[Block], list[Math]]:
    """a = R α = 0.4712 sin(π t/4), and the force by it, m (g + a), as the equations have given both; nothing where the
    force rests on more than one acceleration. `formula`: of the force, in the time.
    """
    found = telling.found
    solved = {x.symbol: x.formula for r in found.regimes for s in r.solution.stages for b in s.blocks for x in b.lines}

    def over_time_alone(expr: sp.Expr) -> sp.Expr:
        for _ in range(DEEP):
            expr = expr.xreplace(solved)
        return expr

    if len(found.regimes) > 1:
        return [], []
    units = found.ledger.units
    forces = (s for s in solved if s in units and units[s].dimension == FORCE)
    own = next((s for s in forces if identically_zero(over_time_alone(solved[s]) - formula)), None)
    moving = [s for s in solved[own].free_symbols if s in solved] if own is not None else []
    if own is None or len(moving) != 1 or longer(solved[own], SHORT):
        return [], []
    (a,) = moving
    numbers = partly(over_time_alone(solved[a]), {time}, telling.numeric)
    if numbers is None or found.ledger.roles[a].kind is not Kind.ACCELERATION:
        return [], []
    unit = pretty_unit(coherent_unit(found.ledger.units[a].dimension, us=found.ledger.us).text)
    sides = (Math(a), telling.phrases.math(solved[a]), numbers)
    return [Equation(sides, None, (), line(f"in {unit}") if numbers.values else ())], [
        telling.phrases.math(solved[own])
    ]


def aim_blocks(
    aim: AimTrace, leg: RouteStep, found: MotionTrace, between: BetweenTelling, number: int
) -> Iterator[Block]:
    """The balance that tells it, in the letters that are not known yet, and it as a formula. `leg`: the step whose
    condition this is; `number`: that of the balance.
    """
    assert aim.law is not None
    steps = [step for step in found.route.steps if any(r.source == aim.law for r in step.relations)]
    unknowns = {x for step in (leg, *steps) for x in step.unknowns} | aim.quantity.free_symbols
    between.plain, between.unknowns = found.route.plain, tuple(unknowns)
    yield from between.blocks(aim.law, number)
    formula = aim.formula.xreplace(dict(found.route.plain))
    yield Equation((between.phrases.math(aim.quantity), between.phrases.math(formula)), None, line(f"({number}):"))


def timed_blocks(aim: AimTrace, stop: str, found: MotionTrace, phrases: Phrases) -> Iterator[Block]:
    """The equations of a motion that hold the time of a state, and what they say of a constant without it."""
    plain = dict(found.route.plain)
    times = {s for residual in aim.timed for s in residual.free_symbols if s.name.startswith("t__")}
    if aim.timed:
        yield Paragraph(line(at(stop, "by the laws of motion")))
    for residual in aim.timed:
        terms = sp.Add.make_args(residual.xreplace(plain))
        left = sp.Add(*(t for t in terms if not t.could_extract_minus_sign()))
        right = left - sp.Add(*terms)
        note = _counted_in(left - right, phrases) if _has_numbers(residual, phrases) else ()
        yield Equation((phrases.math(left), phrases.math(right)), None, (), note)
    named = [x for t in sorted(times, key=str) for x in (", ", Math(t))][1:]
    formula = aim.formula.xreplace(plain)
    free = sorted(formula.free_symbols & found.unknowns, key=str)
    of = ("(", phrases.math(free[0]), ")") if len(free) == 1 and not aim.quantity.is_Add else ()
    own = line(phrases.math(aim.quantity), *of)
    numeric = any(_has_numbers(residual.xreplace(plain), phrases) for residual in aim.timed)
    note = _counted_in(aim.quantity, phrases) if numeric else ()
    # As a function of the constant: what it comes to at the extreme follows below.
    lead = line("without ", *named, ":") if named else line(at(stop, "by the equations below"))
    yield Equation((own, phrases.math(formula)), None, lead, note)


def _counted_in(left: sp.Expr, phrases: Phrases) -> Line:
    """In which unit an equation counts that has numbers of the file in it: that of its first term of letters."""
    for term in sp.Add.make_args(left):
        powers = [f.as_base_exp() for f in sp.Mul.make_args(term)]
        lettered = [(base, power) for base, power in powers if base.is_Symbol]
        if lettered and all(p.is_Integer and base in phrases.ledger.units for base, p in lettered):
            dimension = PURE
            for base, power in lettered:
                dimension = dimension * phrases.ledger.units[base].dimension ** int(power)
            return line(f"in {pretty_unit(coherent_unit(dimension, us=phrases.ledger.us).text)}")
    return ()


def _has_numbers(residual: sp.Expr, phrases: Phrases) -> bool:
    """Does a number of the file stand as a term of its own, so that it hides its unit?"""
    return not phrases.symbolic and any(t.is_number and t != 0 for t in sp.Add.make_args(residual))
