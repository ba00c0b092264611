"""A check of small oscillations that a person can make: by their energies.

E_k = M δ̇²/2 and V = K δ²/2 near the equilibrium, of which neither forces nor accelerations tell anything:  ω_0² = K/M
"""

from __future__ import annotations

from decimal import Decimal

import sympy as sp

from planar_cli.equation.algebra.plain import identically_zero, longer
from planar_cli.equation.values.exact import Sample
from planar_cli.report.document.blocks import Line, Name, Value, line
from planar_cli.report.notation.page_units import coherent_unit
from planar_cli.report.oscillation.linearised import DEVIATION
from planar_cli.report.oscillation.oscillation import RATES, tells_ratio
from planar_cli.report.words.words import Phrases
from planar_cli.solve.between.trace.oscillation_trace import OscillationTrace
from planar_cli.solve.between.trace.trace import MotionTrace
from planar_cli.units import ENERGY, pretty_unit

NEAR = Decimal("1e-12")
LONG = 24
"""Energies of more operations do not fit a line."""
ENERGY_OF_MOTION = Name("E_k")
"""T is the period."""
NATURAL = sp.Symbol("omega_0", real=True)


def oscillation_check(motion: MotionTrace, phrases: Phrases) -> Line:
    """Of the first equilibrium that swings and has such energies; empty where there is none."""
    found = (o for o in motion.oscillations if o.energies is not None and o.verdict.stable and o.verdict.power == 1)
    return next((told for o in found if (told := _told(o, motion, phrases))), ())


def _told(found: OscillationTrace, motion: MotionTrace, phrases: Phrases) -> Line:
    assert found.energies is not None
    mass, stiffness = found.energies
    if motion.symbolic or (isinstance(motion.value, Sample) and motion.value.drawn):
        return _in_letters(mass, stiffness, found, phrases)
    known = [motion.value.known(e) for e in (mass, stiffness, found.stiffness)]
    m, k, square = (Decimal(0) if x is None else x for x in known)
    if min(m, k, square) <= 0 or abs(k / m - square) > NEAR * square:
        return ()
    one, other = (Value(x, "1", phrases.figures) for x in (m, k))
    unit = pretty_unit(coherent_unit(ENERGY, us=True).text) if phrases.ledger.us else "J"
    return line(
        "energies near the equilibrium: ",
        ENERGY_OF_MOTION,
        " = 1/2 · ",
        one,
        " ",
        *_square(RATES[0], phrases),
        ", V = 1/2 · ",
        other,
        " ",
        *_square(DEVIATION, phrases),
        f" in {unit}; ",
        phrases.math(NATURAL),
        " = √(",
        other,
        "/",
        one,
        ") = ",
        Value(square.sqrt(), "rad/s", phrases.figures),
        *_damped(found, motion, square.sqrt(), phrases),
    )


def _damped(found: OscillationTrace, motion: MotionTrace, natural: Decimal, phrases: Phrases) -> Line:
    """ω_d from ω_0 and the damping ratio, where it swings in spite of its damping and the page has another formula."""
    if tells_ratio(motion, found.state):
        return ()
    c, square = motion.value.known(found.damping), motion.value.known(found.square)
    ratio = Decimal(0) if c is None else c / (2 * natural)
    if not ratio or square is None or square <= 0:
        return ()
    zeta, damped = sp.symbols("zeta omega_d", positive=True)
    formula = sp.Mul(NATURAL, sp.sqrt(1 - zeta**2), evaluate=False)
    put = phrases.numbers(formula, {NATURAL: natural, zeta: ratio}, turns=False)
    shown = () if put is None else (" = ", put)
    size = Value(square.sqrt(), "rad/s", phrases.figures)
    return line(", ", phrases.math(damped), " = ", phrases.math(formula), *shown, " = ", size)


def _square(symbol: sp.Symbol, phrases: Phrases) -> Line:
    return line(phrases.math(symbol**2))


def _in_letters(mass: sp.Expr, stiffness: sp.Expr, found: OscillationTrace, phrases: Phrases) -> Line:
    if longer(mass + stiffness, LONG) or not identically_zero(stiffness - mass * found.stiffness):
        return ()
    energies = (phrases.math(e * s**2 / 2) for e, s in ((mass, RATES[0]), (stiffness, DEVIATION)))
    kinetic, stored = energies
    ratio = phrases.math(found.stiffness)
    words = line("energies near the equilibrium: ", ENERGY_OF_MOTION, " = ", kinetic, ", V = ", stored, "; ")
    return line(*words, phrases.math(NATURAL**2), " = ", ratio)
