"""Small oscillations as blocks: the equation of motion, linearised about the equilibrium, and what it tells."""

from __future__ import annotations

from collections.abc import Iterator
from decimal import Decimal
from typing import Any

import sympy as sp

from planar_cli.equation.algebra.plain import longer, simplified
from planar_cli.equation.values.exact import Valuation
from planar_cli.problem.language.expression import Quantity
from planar_cli.report.document.blocks import Block, Equation, Inline, Line, Math, Paragraph, Result, Value, line
from planar_cli.report.in_numbers.put_in import Writer
from planar_cli.report.notation.formula import is_negative
from planar_cli.report.oscillation.linearised import DEVIATION, at_rest_there, near_equilibrium
from planar_cli.report.oscillation.modes import mode_blocks
from planar_cli.report.oscillation.near_rest import SOLVED, differences
from planar_cli.report.words.words import Phrases
from planar_cli.solve.between.trace.oscillation_trace import OscillationTrace, Verdict
from planar_cli.solve.between.trace.trace import MotionTrace

CRITICAL = "It is critically damped, ζ = 1."
LONG = 40
"""A formula of more operations is told by its number, if it has one."""
RATES = tuple(sp.Symbol(f"delta_{dots}", real=True) for dots in ("dot", "ddot"))


def periods_told(motion: MotionTrace) -> dict[str, str]:
    """The names of finds that ask for a period which the analysis of its equilibrium tells, by the state."""
    told = {o.state for o in motion.oscillations if len(o.motion) == 1 and _swings(o, motion.value)}
    asked = ((r.find.name, r.find.found.what) for r in motion.requests)
    periods = {q.things[0]: name for name, q in asked if isinstance(q, Quantity) and q.word == "period"}
    return {state: name for state, name in periods.items() if state in told}


def _swings(found: OscillationTrace, value: Valuation) -> bool:
    """Does it go to and fro about the equilibrium, with a period that the linear part tells?"""
    verdict = found.verdict
    return verdict.stable and verdict.power <= 1 and (found.damping == 0 or value(found.square) > 0)


def by_frequency(expr: sp.Expr, motion: MotionTrace, phrases: Phrases) -> list[Math]:
    """What is a number times the one circular frequency that was told, by its letter: f = ω_0/(2 π); with its number.
    Empty: it is something else.
    """
    (found, *more) = motion.oscillations or (None,)
    if found is None or more or len(found.motion) > 1 or not _swings(found, motion.value):
        return []
    factor = simplified(expr / sp.sqrt(found.square))
    if not factor.is_number or expr.is_number:
        return []
    letter = sp.Symbol("omega_d" if found.damping != 0 else "omega_0", real=True)
    size = {} if phrases.symbolic else {letter: motion.value(sp.sqrt(found.square))}
    put = phrases.numbers(factor * letter, size) if size and factor != 1 else None
    return [phrases.math(factor * letter), *([] if put is None else [put])]


def by_damping(what: Any, motion: MotionTrace, phrases: Phrases) -> list[Math]:
    """A decrement δ = π c/ω_d or damping ratio ζ = c/(2 ω_0), c the factor of the rate in the linear part, with its
    numbers. Empty: it is something else, or no such part was told.
    """
    word = what.word if isinstance(what, Quantity) else ""
    found = next((o for o in motion.oscillations if word and o.state in what.things and len(o.motion) == 1), None)
    if found is None or word not in ("decrement", "damping_ratio") or found.damping == 0 or found.verdict.power > 1:
        return []
    whole = word == "decrement"
    letter = sp.Symbol("omega_d" if whole else "omega_0", real=True)
    expr = phrases.neat(sp.pi * found.damping / letter if whole else found.damping / (2 * letter))
    size = {} if phrases.symbolic else {letter: motion.value(sp.sqrt(found.square if whole else found.stiffness))}
    put = phrases.numbers(expr, size) if size else None
    return [phrases.math(expr), *([] if put is None else [put])]


def oscillation_blocks(
    found: OscillationTrace,
    value: Valuation,
    phrases: Phrases,
    symbolic: bool,
    period: str = "T",
    general: Line = (),
    linear: bool = False,
    ratio: bool = True,
) -> Iterator[Block]:
    """How one equilibrium was examined. `symbolic`: letters remain, so that no numbers are printed; `period`: how the
    file calls the period; `general`: what it is called where frequency and period stay formulas, as they have to tell
    a constant first; `linear`: the sums above are told to the first order in the deviation; `ratio`: the damping ratio
    is told here, as nothing asks for it.
    """
    state = found.state
    laws = [(rate, _law(law, value, phrases, symbolic)) for rate, law in found.motion]
    if not linear and any(longer(law.expr, LONG) for _, law in laws):
        yield Paragraph(line(f"Small oscillations about the equilibrium {state}, from the equations above."))
    elif not linear:
        yield Paragraph(line(f"Small oscillations about the equilibrium {state}. The equation of motion:"))
        for rate, law in laws:
            yield Equation((phrases.math(rate), law))
        if symbolic and (still := at_rest_there(found, value, phrases)) is not None:
            lead, there, why = still
            yield Equation((phrases.math(laws[0][0]), there, phrases.math(sp.S.Zero)), None, lead, why)
    if len(found.motion) == 1:
        yield from _single(found, value, phrases, symbolic, period, general, linear, ratio)
    else:
        if found.modes is None or not found.modes.matrix:
            yield from _several(found)
        if found.modes is not None:
            yield from mode_blocks(found, found.modes, value, phrases, symbolic)
    yield Result(_verdict(found, value, phrases, linear))


def _law(law: sp.Expr, value: Valuation, phrases: Phrases, symbolic: bool) -> Math:
    """The equation of motion; a long one with numbers for all but coordinates and speeds."""
    if not symbolic and longer(law, 2 * LONG):
        writer = Writer([s for s in law.free_symbols if value.known(s) is None], phrases)
        written = writer.written(law)
        if written is not None:
            return Math(written, writer.texts)
    return phrases.math(law)


def tells_formula(found: OscillationTrace, value: Valuation) -> bool:
    """Is its period that of one undamped freedom, with a formula that is short?"""
    return len(found.motion) == 1 and found.damping == 0 and _swings(found, value) and not longer(found.period, LONG)


def period_line(found: OscillationTrace, value: Valuation, phrases: Phrases, name: str) -> Equation:
    """The period by its own formula, with the numbers."""
    shown = Value(value(found.period), "s")
    formula = found.period
    return Equation((phrases.math(sp.Symbol(name)), phrases.math(formula), *phrases.substituted(formula, shown), shown))


def _single(
    found: OscillationTrace,
    value: Valuation,
    phrases: Phrases,
    symbolic: bool,
    name: str,
    general: Line,
    linear: bool,
    ratio: bool,
) -> Iterator[Block]:
    w2, c = _stiffness(found, linear), found.damping
    speed, rate = RATES
    yield Paragraph(_linear_words(found, value, phrases, linear))
    texts: dict[sp.Symbol, str] = {}
    left: list[Any] = [phrases.math(rate)]
    for coefficient, factor in ((c, speed), (w2, DEVIATION)):
        if coefficient != 0:
            told = coefficient
            if not symbolic and longer(coefficient, LONG):
                told = Writer((), phrases, texts).written(coefficient) or coefficient
            # The highest derivative first, as the course writes it.
            term, other = (phrases.math(e * factor) for e in (told, -told))
            less = is_negative(term.expr) and not is_negative(other.expr)
            term = other if less else term
            left += [" - " if less else " + ", Math(term.expr, {**(term.values or {}), **texts})]
    yield Equation((line(*left), phrases.math(sp.S.Zero)))
    if not found.verdict.stable or found.verdict.power > 1:
        return
    square = found.square
    natural = sp.Symbol("omega_0", real=True)
    if general:
        yield Equation((phrases.math(natural), phrases.math(sp.sqrt(w2))))
        sides = (phrases.math(2 * sp.pi / natural), phrases.math(found.period))
        yield Equation((general, *sides))
        return
    yield _line("omega_0", sp.sqrt(w2), value, "rad/s", phrases, symbolic)
    if c != 0:
        if value.is_zero(square):
            yield Paragraph(line(CRITICAL))
        elif ratio:
            yield _damping_ratio(c, value(w2).sqrt(), value, phrases, symbolic)
        if value(square) <= 0:
            return
        if ratio and not symbolic:
            yield _damped_by_ratio(value(w2).sqrt(), value(c), value(square).sqrt(), phrases)
        else:
            yield _line("omega_d", sp.sqrt(square), value, "rad/s", phrases, symbolic)
        natural = sp.Symbol("omega_d", real=True)
    yield _line(name, found.period, value, "s", phrases, symbolic, (2 * sp.pi / natural, value(sp.sqrt(square))))


def _damped_by_ratio(natural: Decimal, c: Decimal, damped: Decimal, phrases: Phrases) -> Equation:
    """ω_d = ω_0 √(1 - ζ²) = numbers = value; all in 1/s."""
    letters = sp.symbols("omega_0 zeta omega_d", positive=True)
    formula = sp.Mul(letters[0], sp.sqrt(1 - letters[1] ** 2), evaluate=False)
    put = phrases.numbers(formula, {letters[0]: natural, letters[1]: c / (2 * natural)}, turns=False)
    sides = (phrases.math(letters[2]), phrases.math(formula), *(() if put is None else (put,)))
    return Equation((*sides, Value(damped, "rad/s")))


def tells_ratio(motion: MotionTrace, state: str) -> bool:
    """Is the damping ratio told with the oscillations, as nothing asks for it and nothing else has its letter?"""
    asked = (r.find.found.what for r in motion.requests)
    alone = not any(isinstance(q, Quantity) and q.word == "damping_ratio" and state in q.things for q in asked)
    return alone and "zeta" not in motion.ledger.reserved


def _damping_ratio(c: sp.Expr, frequency: Decimal, value: Valuation, phrases: Phrases, symbolic: bool) -> Equation:
    """ζ = c/(2 ω_0) = numbers = value, and of which kind the damping is by it. `c`: the factor of the rate in the
    linear equation, 1/s; `frequency`: ω_0, 1/s.
    """
    natural = sp.Symbol("omega_0", real=True)
    formula, ratio = phrases.neat(c / (2 * natural)), value(c) / (2 * frequency)
    sides = [phrases.math(sp.Symbol("zeta")), phrases.math(formula)]
    put = None if symbolic else phrases.numbers(formula, {natural: frequency}, turns=False)
    shown = () if symbolic else (Value(ratio, ""),)
    note = line("ζ < 1: light damping" if ratio < 1 else "ζ > 1: heavy damping")
    return Equation((*sides, *([] if put is None else [put]), *shown), None, (), note)


def _stiffness(found: OscillationTrace, linear: bool) -> sp.Expr:
    """ω₀², by the one sum of the page where that is the shorter formula."""
    own = [found.near.square] if linear and found.near is not None else []
    return min((*own, found.stiffness), key=sp.count_ops)


def _linear_words(found: OscillationTrace, value: Valuation, phrases: Phrases, linear: bool) -> Line:
    """What the linear equation of motion comes from."""
    if linear:
        return line(SOLVED, phrases.math(RATES[1]), ", this is the equation of motion:")
    near = near_equilibrium(found, value, phrases)
    there = line(", ", *near, ",") if near else ()
    return line("For a small deviation ", phrases.math(DEVIATION), " from there", *there, " its linear part is:")


def _line(
    name: str,
    expr: sp.Expr,
    value: Valuation,
    unit: str,
    phrases: Phrases,
    symbolic: bool,
    by: tuple[sp.Expr, Decimal] | None = None,
) -> Equation:
    """name = formula = numbers = value. `by`: a formula in one frequency before it, with the value of this."""
    sides: list[Inline | Line] = [phrases.math(sp.Symbol(name))]
    if by is not None:
        sides.append(phrases.math(by[0]))
    shown = Value(value(expr), unit)
    if by is not None and not symbolic:
        (frequency,) = by[0].free_symbols
        put = phrases.numbers(by[0], {frequency: by[1]}, turns=False)
        sides += [] if put is None else [put]
    elif symbolic or not longer(expr, LONG):
        sides.append(phrases.math(expr))
        sides += [] if symbolic else phrases.substituted(expr, shown)
    if not symbolic:
        sides.append(shown)
    return Equation(tuple(sides))


def _several(found: OscillationTrace) -> Iterator[Block]:
    """The roots of the characteristic equation."""
    yield Paragraph(line(f"{len(found.motion)} freedoms, linearised, move as e^(λ t); the roots λ are, in 1/s:"))
    for root in found.roots:
        if root.imag >= 0:
            parts = (Value(Decimal(str(root.real)), ""), " ± i ", Value(Decimal(str(root.imag)), ""))
            yield Result(line(*parts))


def _verdict(found: OscillationTrace, value: Valuation, phrases: Phrases, linear: bool) -> Line:
    """Is it stable, and why: y_G < r decides it where that difference is all that can be negative."""
    decides = differences(found.near) if linear and found.near is not None and found.verdict.power == 1 else []
    why: list[Any] = []
    if len(decides) == 1:
        one, other = sorted(decides[0], key=str, reverse=True)
        why = [", as ", phrases.math(one), " < " if value(one) < value(other) else " > ", phrases.math(other)]
    elif (
        len(found.motion) == 1
        and found.verdict.power == 1
        and (found.damping == 0 or value(_stiffness(found, linear)) < 0)
    ):
        sign = {"stable": "positive", "unstable": "negative"}.get(found.verdict.kind)
        why = [] if sign is None else [", as the coefficient of ", phrases.math(DEVIATION), f" is {sign}"]
    said = f"The equilibrium {found.state} is {found.verdict.kind}"
    return line(said, *why, f"{_because(found.verdict)}", *_how(found, value, phrases), ".")


def _how(found: OscillationTrace, value: Valuation, phrases: Phrases) -> Line:
    """How it returns where it is damped: its amplitude falls as e^(-c t/2), or it does not swing."""
    if len(found.motion) != 1 or found.damping == 0 or not found.verdict.stable or found.verdict.power > 1:
        return ()
    if value(found.square) <= 0:
        return line(" without swinging")
    fall = sp.exp(-found.damping * sp.Symbol("t", positive=True) / 2)
    return line(", and its amplitude falls as ", phrases.math(fall))


def _because(verdict: Verdict) -> str:
    if verdict.kind == "indifferent":
        return ": no force or moment arises when it is displaced"
    if verdict.power > 1:
        return f": the linear part vanishes, the power {verdict.power} of the deviation decides"
    return f": displaced, it {'returns' if verdict.stable else 'moves further away'}"
