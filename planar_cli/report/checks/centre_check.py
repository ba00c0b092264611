"""A check of a kinetic energy that was told about the mass centre: the same about the instantaneous centre.

about B:  I_B = 1/12 m l² + 1/4 m l² = 0.5333 kg·m²;  1/2 I_B ω_2² = 19.36 J = U
"""

from __future__ import annotations

import sympy as sp

from planar_cli.equation.algebra.plain import longer, simplified
from planar_cli.principles.base import Moving
from planar_cli.report.document.blocks import Line, Name, line
from planar_cli.report.in_numbers.sums import agree, chain
from planar_cli.report.notation.page_units import coherent_unit
from planar_cli.report.words.words import Phrases
from planar_cli.solve.between.trace.trace import BalanceTrace, MotionTrace
from planar_cli.units import ENERGY, INERTIA

CENTRE = " is the instantaneous centre of "
SHORT = 12
"""Operations of a distance."""


def centre_check(motion: MotionTrace, phrases: Phrases) -> Line:
    """Of the first balance in which a single body turns so; empty where there is none, or where letters stay."""
    if motion.symbolic:
        return ()
    sources = [e.source for leg in motion.route.steps for e in leg.relations]
    balances = [b for b in sources if isinstance(b, BalanceTrace) and b.parts is not None]
    return next((told for b in balances if (told := _about(b, motion, phrases))), ())


def _about(balance: BalanceTrace, motion: MotionTrace, phrases: Phrases) -> Line:
    assert balance.parts is not None
    (m, *more) = balance.parts.moving or (None,)
    if m is None or more or CENTRE not in m.why or m.center == m.why.partition(CENTRE)[0]:
        return ()
    point, plain = m.why.partition(CENTRE)[0], dict(motion.route.plain)
    away = _distance(m, point, balance, motion)
    if away is None:
        return ()
    inertia, omega = simplified(m.inertia.xreplace(plain)), m.omega.xreplace(plain)
    whole = inertia + m.mass * away**2
    sizes = [phrases.certain(e) for e in (whole, whole * omega**2 / 2, balance.before, balance.gain)]
    if not agree(sizes[1:2], sizes[2:]):
        return ()
    about, us = Name(f"I_{point}"), phrases.ledger.us
    number = chain([sizes[0]], coherent_unit(INERTIA, False, us), phrases)
    shown = line(about, " = ", phrases.math(m.inertia), " + ", phrases.math(m.mass * away**2), " = ", *number)
    number = chain([sizes[1]], coherent_unit(ENERGY, False, us), phrases, "J")
    energy = line("1/2 ", about, " ", phrases.math(omega**2), " = ", *number)
    given = (Name(f"{balance.law.letter}__{balance.since}"), " + ") if sizes[2] else ()
    return line(f"about {point}: ", *shown, "; ", *energy, " = ", *given, Name(balance.law.bring))


def _distance(m: Moving, point: str, balance: BalanceTrace, motion: MotionTrace) -> sp.Expr | None:
    """How far the mass centre is from that point at the end, by their places alone, as the velocities are what is
    checked; None: its formula is long.
    """
    regime = next((r for r in motion.regimes if (balance.since, balance.stop) in r.stretches), None)
    if regime is None:
        return None
    scene, roles = regime.solution.instant.scene, motion.ledger.roles
    there = {general: x for x, general in motion.general.items() if roles[x].at == balance.stop}
    arm = scene.bodies[m.body].center - scene.point(point)
    away = simplified(sp.sqrt(simplified(arm.dot(arm).xreplace(there).xreplace(dict(motion.route.plain)))))
    return None if longer(away, SHORT) or motion.value.known(away) is None else away
