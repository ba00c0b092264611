"""A check that a person can make of a motion that was found without energies: its kinetic energy against the work done.

T_1 + U = 32 - 23.5 = 8.5 J = T_2
"""

from __future__ import annotations

from collections.abc import Collection
from decimal import Decimal

import sympy as sp

from planar_cli.equation.exact import Sample
from planar_cli.equation.ledger import Kind, display
from planar_cli.report.blocks import Inline, Line, Name, Text, Value, line
from planar_cli.report.page_units import coherent_unit
from planar_cli.report.words import Phrases, told_unit
from planar_cli.solve.between.trace import BalanceTrace, MotionTrace
from planar_cli.units import ENERGY

SMALL = Decimal("1e-9")
"""In parts of the largest energy: what is smaller is rounding."""
MOST = 5
"""Terms that fit a line."""


def energy_check(motion: MotionTrace, phrases: Phrases) -> Line:
    """The balance of the first stretch on which energies with numbers change; empty where there is none."""
    if motion.symbolic or (isinstance(motion.value, Sample) and motion.value.drawn):
        return ()
    found = {r.unknown for leg in motion.route.steps for r in leg.results} | set(motion.route.plain)
    return next((told for b in motion.unused if (told := _told(b, found, phrases))), ())


def _told(balance: BalanceTrace, found: Collection[sp.Symbol], phrases: Phrases) -> Line:
    """`found`: what has its value on the page; a speed that has none would be no check."""
    exprs = [balance.before, *(e for _, e in balance.brought), balance.after]
    speeds = {s for e in (balance.before, balance.after) for s in e.free_symbols if s in phrases.ledger.roles}
    own = {s for s in speeds if phrases.ledger.roles[s].kind is Kind.STATE and s not in found}
    if any(phrases.value.known(s) != 0 for s in own):
        return ()
    known = [phrases.value.known(e) for e in exprs]
    *left, after = [k for k in known if k is not None]
    if len(known) != len(left) + 1 or not left:
        return ()
    largest = max(abs(v) for v in (*left, after))
    # From rest the sum begins with nought.
    terms = [v if abs(v) > largest * SMALL else Decimal(0) for v in left]
    terms = [terms[0], *(v for v in terms[1:] if v)]
    if not 2 <= len(terms) <= MOST or abs(sum(left) - after) > largest * SMALL:
        return ()
    unit = coherent_unit(ENERGY, False, phrases.ledger.us)
    shown = [Value(display(v, unit, phrases.ledger.us), "1", phrases.figures) for v in terms]
    total: list[Inline] = [shown[0]]
    for value in shown[1:]:
        total += [Text(" - " if value.number < 0 else " + "), Value(abs(value.number), "1", phrases.figures)]
    first, last = (Name(f"{balance.law.letter}_{state}") for state in (balance.since, balance.stop))
    result = Value(display(after, unit, phrases.ledger.us), told_unit(unit, True), phrases.figures)
    head = line("work and energy: ", first, " + ", Name(balance.law.bring), " = ")
    return line(head, *total, " = ", result, " = ", last)
