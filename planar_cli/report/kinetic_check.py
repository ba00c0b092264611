"""A check that a person can make of work and energy: the speeds that were found, put into T body by body.

T_2 = 1/2 m v_G² + 1/2 I ω² = 1/2 · 10 · 1.704² + 1/2 · 0.1333 · 8.521² = 19.36 J;  T_1 + U = 13.87 + 5.490 = 19.36 J

The solution puts all of T into one square of one speed; this goes back over the mass centre and the turning of each.
"""

from __future__ import annotations

from decimal import Decimal

import sympy as sp

from planar_cli.equation.exact import Sample
from planar_cli.equation.ledger import display
from planar_cli.principles.base import Moving
from planar_cli.report.alike import WEIGHT
from planar_cli.report.blocks import Line, Name, line
from planar_cli.report.component_sums import Power, sum_of_products
from planar_cli.report.page_units import coherent_unit
from planar_cli.report.sums import added, agree, chain, counting
from planar_cli.report.words import Phrases
from planar_cli.solve.between.trace import BalanceTrace, MotionTrace
from planar_cli.units import ENERGY, INERTIA, MASS, RATE, VELOCITY, Dimension

MOST, FEW = 6, 3
"""Terms of a side that fits a line; so many products do."""
HALF = (Decimal("0.5"), 1)
Energy = tuple[Decimal, tuple[Power, ...]]
"""Its size, J, and its factors in the units of the page."""


def kinetic_check(motion: MotionTrace, phrases: Phrases) -> Line:
    """The last balance by which a speed was found; empty where T is that of one particle or of one axis, whose only
    square was solved for.
    """
    if motion.symbolic or (isinstance(motion.value, Sample) and motion.value.drawn):
        return ()
    balances = [e.source for leg in motion.route.steps for e in leg.relations if isinstance(e.source, BalanceTrace)]
    return next((told for b in reversed(balances) if b.law.letter and (told := _told(b, phrases))), ())


def _told(balance: BalanceTrace, phrases: Phrases) -> Line:
    parts = balance.parts.moving if balance.parts is not None else ()
    found = [_energies(made, phrases) for made in parts]
    energies = [e for own in found if own is not None for e in own]
    if None in found or not 2 <= len(energies) <= MOST:
        return ()
    weights = sp.Add(*(x for words, x in balance.brought if words.startswith(WEIGHT)))
    exprs = [balance.before, weights, *(x for words, x in balance.brought if not words.startswith(WEIGHT))]
    known = [phrases.value.known(e) for e in exprs]
    if None in known:
        return ()
    before = counting([k for k in known if k is not None])
    if not 1 <= len(before) <= MOST or not agree(before, [size for size, _ in energies]):
        return ()
    unit = coherent_unit(ENERGY, False, phrases.ledger.us)
    first, last = (Name(f"{balance.law.letter}__{state}") for state in (balance.since, balance.stop))
    squares = (
        line(sum_of_products([(1, factors) for _, factors in energies], phrases.figures))
        if len(energies) <= FEW
        else tuple(added([size for size, _ in energies], unit, phrases))
    )
    formula = "Σ (1/2 m v² + 1/2 I ω²)" if len(parts) > 1 else "1/2 m v² + 1/2 I ω²"
    whole = chain([sum(before, Decimal(0))], unit, phrases, "J")
    head = line(last, f" = {formula} = ", *squares, " = ", *whole, "; ", first, " + ", Name(balance.law.bring), " = ")
    return line(*head, *chain(before, unit, phrases, "J"))


def _energies(made: Moving, phrases: Phrases) -> list[Energy] | None:
    """What the mass centre and the turning of a body add to T; None: a speed has no number."""
    known = [phrases.value.known(e) for e in (made.vx, made.vy, made.omega, made.mass, made.inertia)]
    if None in known:
        return None
    vx, vy, omega, mass, inertia = (Decimal(0) if k is None else k for k in known)
    found: list[Energy] = []
    speed = (vx * vx + vy * vy).sqrt()
    kinds = ((mass, MASS, speed, VELOCITY, False), (inertia, INERTIA, abs(omega), RATE, True))
    for weight, kind, rate, of_rate, angle in kinds:
        size = weight * rate**2 / 2
        if size:
            factors = (HALF, (_shown(weight, kind, phrases), 1), (_shown(rate, of_rate, phrases, angle), 2))
            found.append((size, factors))
    return found


def _shown(value: Decimal, dimension: Dimension, phrases: Phrases, angle: bool = False) -> Decimal:
    return display(value, coherent_unit(dimension, angle, phrases.ledger.us), phrases.ledger.us)
