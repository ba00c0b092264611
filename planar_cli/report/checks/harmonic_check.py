"""A check that a person can make of simple harmonic motion: its greatest speed is amplitude times natural frequency;
or, where that is how it was found, the work done makes its kinetic energy.

amplitude times natural frequency:  l √(k/m),  the size of ẋ_middle
work and energy:  U = 1/2 k l²;  T_middle = 1/2 m ẋ_middle² = 1/2 k l²
"""

from __future__ import annotations

import sympy as sp

from planar_cli.equation.algebra.plain import identically_zero, longer, simplified
from planar_cli.report.document.blocks import Line, Math, Name, line
from planar_cli.report.energy.energy_pieces import STATE
from planar_cli.report.words.words import Phrases
from planar_cli.solve.between.trace.trace import MotionTrace
from planar_cli.solve.law import Law

SHORT = 10
"""Operations of the product."""


def harmonic_check(motion: MotionTrace, phrases: Phrases) -> Line:
    """In letters, where the greatest speed was found in another way; empty where there is none, or no state of rest."""
    if not motion.symbolic:
        return ()
    laws = dict.fromkeys(law for _, _, laws in motion.stretches for law in laws)
    return next((told for law in laws if (told := _told(law, motion, phrases) or _energy(law, motion, phrases))), ())


def _energy(law: Law, motion: MotionTrace, phrases: Phrases) -> Line:
    """In letters, from rest, where the speed at the end followed from the place over time."""
    dated = {e.stop for leg in motion.route.steps for e in leg.relations if e.law == law and e.kind in ("q(t)", "v(t)")}
    for balance in motion.unused:
        gain, after = _closed(balance.gain, motion), _closed(balance.after, motion)
        own, start = balance.after.xreplace(dict(motion.route.plain)), _closed(balance.before, motion)
        letters = [s for s in own.free_symbols if motion.general.get(s) == law.speed]
        if balance.stop not in dated or start != 0 or not letters or longer(gain, SHORT) or longer(own, SHORT):
            continue
        if gain != 0 and identically_zero(gain - after):
            told = line("work and energy: ", Name(balance.law.bring), " = ", phrases.math(gain), "; ")
            kinetic = line(Name(f"{balance.law.letter}__{balance.stop}"), " = ", phrases.math(own))
            return line(*told, *kinetic, " = ", phrases.math(simplified(after)))
    return ()


def _told(law: Law, motion: MotionTrace, phrases: Phrases) -> Line:
    q, speed = law.coordinate.symbol, law.speed
    if law.order != 2 or law.factor != 1 or speed is None or law.f.has(law.v, phrases.ledger.symbols["t"]):
        return ()
    square = simplified(-law.f.diff(q))
    if not square.is_positive or square.has(q):
        return ()
    centre = simplified(q + law.f / square)
    places, speeds = _by_state(q, motion), _by_state(speed, motion)
    both = [s for s in places if s in speeds]
    still = [s for s in both if _closed(speeds[s], motion) == 0]
    middle = [s for s in both if identically_zero(_closed(places[s], motion) - centre)]
    for start in still:
        amplitude = sp.Abs(simplified(_closed(places[start], motion) - centre))
        for state in middle:
            product = simplified(amplitude * sp.sqrt(square))
            found = _closed(speeds[state], motion)
            # From the place over time the speed would be this product already.
            by_time = any(
                e.stop == state and e.kind in ("q(t)", "v(t)") for leg in motion.route.steps for e in leg.relations
            )
            if not by_time and not longer(product, SHORT) and identically_zero(found**2 - product**2):
                told = line("amplitude times natural frequency: ", phrases.math(product))
                return line(*told, ", the size of ", Math(speeds[state]))
    return ()


def _by_state(general: sp.Symbol, motion: MotionTrace) -> dict[str, sp.Symbol]:
    """The letters of a quantity in the states."""
    return {s.name.rpartition(STATE)[2]: s for s, own in motion.general.items() if own == general}


def _closed(expr: sp.Expr, motion: MotionTrace) -> sp.Expr:
    """In the letters of the file."""
    for _ in range(len(motion.route.steps) + 1):
        expr = expr.xreplace(dict(motion.route.plain)).xreplace(dict(motion.route.formulas))
    return expr
