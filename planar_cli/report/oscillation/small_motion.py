"""The motion of one small deviation by its linear equation, before the whole equation is integrated in numbers.

    θ̈ + 3 c θ̇/(4 m) + 3 k θ/m = 0,  ω_0 = √(3 k/m) = 14.14 rad/s,  ζ = 3 c/(8 m ω_0) = 0.1768     light damping
    let go from rest:  θ = θ_1 exp(-ζ ω_0 t) (cos(ω_d t) + ζ ω_0 sin(ω_d t)/ω_d),  ω_d = ω_0 √(1 - ζ²)
    θ = 0 at t_2 ≈ (π - arccos ζ)/ω_d,  turns at θ_3 ≈ -θ_1 exp(-π ζ/√(1 - ζ²))

Heavy damping (ζ > 1) lets it fall to zero without passing it. All of it is told only where the values come near those
of the integration.
"""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping, Sequence
from dataclasses import replace
from decimal import Decimal
from typing import Any

import sympy as sp

from planar_cli.equation.algebra.plain import longer, simplified
from planar_cli.equation.values.exact import Unvalued
from planar_cli.errors import NoValue
from planar_cli.problem.language.expression import Quantity
from planar_cli.records import record
from planar_cli.report.document.blocks import Block, Equation, Line, Paragraph, Value, line
from planar_cli.report.words.words import Phrases
from planar_cli.solve.between.trace.trace import MotionTrace, Result
from planar_cli.solve.law import Law

LONG = 24
"""A coefficient of more operations makes no simple equation."""
SMALL = Decimal("0.36")
"""Of an angle, in rad: about 20°; there sin θ is θ but for two parts in a hundred."""
NEAR = Decimal("0.05")
"""By so much of the start, or of a time, the linear motion may be off."""
LINEAR = " the equation of motion is linear"
NATURAL, RATIO, DAMPED = sp.symbols("omega_0 zeta omega_d", positive=True)


@record
class Linear:
    """q̈ + c q̇ + w² q = 0, let go from rest. `start`: the letter of q there; `frequency`: ω_0 [1/s]."""

    law: Law
    damping: sp.Expr
    square: sp.Expr
    start: sp.Symbol
    frequency: Decimal
    ratio: Decimal


def small_motion(found: MotionTrace, phrases: Phrases, results: Sequence[Result]) -> list[Block]:
    """The linear equation, and its values of what is integrated; empty where it is none, or says something else."""
    if found.symbolic or len(found.regimes) > 1 or len(found.regimes[0].laws) > 1 or found.oscillations:
        return []
    try:
        linear = _linear(found, phrases)
        if linear is None or abs(linear.ratio - 1) < NEAR:
            return []
        open_ = {r.unknown for r in results}
        told = [t for r in results if (t := _value(r, linear, found, open_)) is not None]
        off = max((_off(t, linear, phrases) for t in told), default=NEAR)
        return list(_told(linear, told, off, found, phrases)) if off < NEAR else []
    except (NoValue, Unvalued):
        return []


def _linear(found: MotionTrace, phrases: Phrases) -> Linear | None:
    """The linear part about q = 0, where it is at rest there and is let go from rest."""
    stretches = found.stretches
    if not stretches or any(len(laws) != 1 for _, _, laws in stretches):
        return None
    # One regime has one law, from wherever it is followed.
    (first, _, (law,)) = stretches[0]
    q, v = law.coordinate.symbol, law.v
    own = {general: s for s, general in found.general.items() if found.ledger.roles[s].at == first}
    start, rate = own.get(q), own.get(law.speed) if law.speed is not None else None
    if law.order != 2 or law.factor != 1 or start is None or rate is None or not law.f.has(q):
        return None
    if phrases.value(rate) != 0 or not 0 < abs(phrases.value(start)) <= SMALL or not found.ledger.units[q].angle:
        return None
    still = {q: sp.S.Zero, v: sp.S.Zero}
    if not phrases.value.is_zero(simplified(law.f.xreplace(still))):
        return None
    square, damping = (simplified(-sp.diff(law.f, s).xreplace(still)) for s in (q, v))
    if longer(square, LONG) or longer(damping, LONG) or phrases.value(square) <= 0 or phrases.value(damping) <= 0:
        return None
    frequency = phrases.value(square).sqrt()
    return Linear(law, damping, square, start, frequency, phrases.value(damping) / (2 * frequency))


def _value(r: Result, x: Linear, found: MotionTrace, open_: Collection[sp.Symbol]) -> tuple[Result, sp.Expr] | None:
    """What the linear motion has for a letter of a state, by ω_0, ζ and ω_d: where it passes zero the first time, where
    it turns the first time, or where it is at a given time; None of anything else.
    """
    state = found.ledger.roles[r.unknown].at or ""
    own = {general: s for s, general in found.general.items() if found.ledger.roles[s].at == state}
    q, v = own.get(x.law.coordinate.symbol), own.get(x.law.speed) if x.law.speed is not None else None
    time, later = own.get(found.ledger.symbols["t"]), [n for n in found.states if n != found.states[0]]
    if q is None or v is None or time is None:
        return None
    if x.ratio < 1 and found.value.is_zero(q) and later[:1] == [state]:
        angle = sp.pi - sp.acos(RATIO)
        if r.unknown == time:
            return r, angle / DAMPED
        return (r, -x.start * NATURAL * sp.exp(-RATIO * angle / sp.sqrt(1 - RATIO**2))) if r.unknown == v else None
    if x.ratio < 1 and r.unknown == q and found.value.is_zero(v) and state in later[:2]:
        return r, -x.start * sp.exp(-sp.pi * RATIO / sp.sqrt(1 - RATIO**2))
    return (r, _motion(x, time)) if r.unknown == q and time not in open_ else None


def _motion(x: Linear, t: sp.Expr) -> sp.Expr:
    """q at a time, let go from rest at q_1."""
    fall = RATIO * NATURAL
    if x.ratio < 1:
        wave = sp.cos(DAMPED * t) + fall / DAMPED * sp.sin(DAMPED * t)
        return x.start * sp.exp(-fall * t) * wave
    slow, fast = _rates()
    return x.start * (fast * sp.exp(-slow * t) - slow * sp.exp(-fast * t)) / (fast - slow)


def _rates() -> tuple[sp.Symbol, sp.Symbol]:
    slow, fast = sp.symbols("lambda_1 lambda_2", positive=True)
    return slow, fast


def _sizes(x: Linear) -> dict[sp.Symbol, Decimal]:
    """The numbers of ω_0, ζ, and ω_d or both rates."""
    found = {NATURAL: x.frequency, RATIO: x.ratio}
    root = abs(1 - x.ratio**2).sqrt()
    if x.ratio < 1:
        return {**found, DAMPED: x.frequency * root}
    slow, fast = _rates()
    return {**found, slow: x.frequency * (x.ratio - root), fast: x.frequency * (x.ratio + root)}


def _off(told: tuple[Result, sp.Expr], x: Linear, phrases: Phrases) -> Decimal:
    """By how much the linear value is off: of the start for an angle, of the start in ω_0 for its rate, of a time."""
    r, formula = told
    own = phrases.value.extended(_sizes(x))(formula)
    start = abs(phrases.value(x.start))
    whole = start * x.frequency if _is_rate(r, x) else start if _is_angle(r, phrases) else abs(r.value)
    return abs(own - r.value) / whole


def _told(
    x: Linear, told: Sequence[tuple[Result, sp.Expr]], off: Decimal, found: MotionTrace, phrases: Phrases
) -> Iterator[Block]:
    q, sizes = x.law.coordinate.symbol, _sizes(x)
    speed, rate = (sp.Symbol(f"{q.name}_{dots}", real=True) for dots in ("dot", "ddot"))
    near = ((sp.sin(q), q), (sp.cos(q), sp.S.One))
    said = [line(phrases.math(f), " ≈ ", phrases.math(to)) for f, to in near if x.law.f.has(f.func)]
    ones = (piece for i, one in enumerate(said) for piece in line(" and " if i else ", as ", *one))
    yield Paragraph(line("For small ", phrases.math(q), LINEAR, *ones, "."))
    parts = (" + ", phrases.math(x.damping * speed), " + ", phrases.math(x.square * q))
    yield Equation((line(phrases.math(rate), *parts), phrases.math(sp.S.Zero)))
    yield _line(NATURAL, sp.sqrt(x.square), sizes, "rad/s", phrases)
    light = x.ratio < 1
    ratio = _line(RATIO, x.damping / (2 * NATURAL), sizes, "", phrases)
    yield replace(ratio, note=line("ζ < 1: light damping" if light else "ζ > 1: heavy damping"))
    if light:
        yield _line(DAMPED, NATURAL * sp.sqrt(1 - RATIO**2), sizes, "rad/s", phrases)
    else:
        root = sp.sqrt(RATIO**2 - 1)
        for letter, factor in zip(_rates(), (RATIO - root, RATIO + root), strict=True):
            yield _line(letter, NATURAL * factor, sizes, "1/s", phrases)
    yield Paragraph(line("Let go from rest it moves by this as"))
    yield Equation((phrases.math(q), phrases.math(_motion(x, found.ledger.symbols["t"]))))
    if not light:
        yield Paragraph(line("so that ", phrases.math(q), " falls to zero without passing it", _unreached(found), "."))
    for r, formula in told:
        number = phrases.value.extended(sizes)(formula)
        shown = phrases.shown(r.unknown, number)
        put = phrases.numbers(formula, sizes, turns=_is_angle(r, phrases))
        sides: list[Any] = [phrases.math(r.unknown), phrases.math(formula), *([] if put is None else [put]), shown]
        yield Equation(tuple(sides), relation="≈")
    percent = max(1, int((off * 100).to_integral_value(rounding="ROUND_CEILING")))
    yield Paragraph(_agreement(f"at most {percent} %", [r for r, _ in told], x, phrases))


def _agreement(most: str, told: Sequence[Result], x: Linear, phrases: Phrases) -> Line:
    """By how much the values of the whole equation are off, each kind of what it is measured by."""
    rates = [r for r in told if _is_rate(r, x)]
    angles = [r for r in told if r not in rates and _is_angle(r, phrases)]
    start, natural = phrases.math(x.start), phrases.math(NATURAL)
    of_angles = [line(f"the angle{'s' * (len(angles) > 1)}", " by ", most, " of ", start)] if angles else []
    of_rates = [line("the angular velocity by ", most, " of ", natural, " ", start)] if rates else []
    times = [line("the time by ", most)] if len(rates) + len(angles) < len(told) else []
    parts = [*times, *of_angles, *of_rates]
    if len(parts) > 2:
        parts = [line("each by ", most, ", angles of ", start, ", the angular velocity of ", natural, " ", start)]
    joined = (p for i, part in enumerate(parts) for p in (" and " if i else "", *part))
    return line("The whole equation, below, changes ", *joined, ".")


def _is_rate(r: Result, x: Linear) -> bool:
    return str(r.unknown.name).startswith(f"{x.law.coordinate.symbol.name}_dot")


def _is_angle(r: Result, phrases: Phrases) -> bool:
    return phrases.ledger.units[r.unknown].angle


def _line(
    letter: sp.Symbol, formula: sp.Expr, sizes: Mapping[sp.Symbol, Decimal], unit: str, phrases: Phrases
) -> Equation:
    """letter = formula = numbers = value."""
    put = phrases.numbers(formula, sizes if formula.free_symbols & sizes.keys() else None, turns=False)
    sides: list[Any] = [phrases.math(letter), phrases.math(formula), *([] if put is None else [put])]
    return Equation((*sides, Value(sizes[letter], unit)))


def _unreached(found: MotionTrace) -> str:
    """That a state of which it is asked whether it is reached is not, as the integration found."""
    asked = [r.find.found.what for r in found.requests]
    states = [q.things[0] for q in asked if isinstance(q, Quantity) and q.word == "reached"]
    missed = [name for name in states if name not in found.states]
    return f"; nor does it in the integration below: state {missed[0]} is not reached" if missed else ""
