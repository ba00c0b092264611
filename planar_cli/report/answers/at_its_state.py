"""What is asked of forces and accelerations at a state, where all is a letter: the solution of the equations at that
place before its closed form.

α_2 = -m g l / (1/2 m l² + I_AB + I_BC) = -3 g/(2 l)
"""

from __future__ import annotations

import sympy as sp

from planar_cli.equation.algebra.expansion import expanded
from planar_cli.equation.algebra.plain import identically_zero, longer, simplified
from planar_cli.solve.between.trace.trace import MotionTrace, RegimeTrace

LONGEST = 18
"""A longer solution is left to its line above."""


def at_its_state(name: str, closed: sp.Expr, found: MotionTrace) -> sp.Expr | None:
    """The solution for the letter that a find is, with its place put in. None: the closed form holds letters of a
    state, as it is told by these; it is the same, or long; or it does not follow by substitution alone.
    """
    if not found.symbolic or closed.free_symbols & set(found.general) or closed.is_number:
        return None
    for regime in found.regimes:
        for state, asked in regime.asked.items():
            letters = asked.get(name, ())
            if len(letters) == 1 and letters[0].is_Symbol:
                return _put_in(letters[0], state, closed, regime, found)
    return None


def _put_in(letter: sp.Symbol, state: str, closed: sp.Expr, regime: RegimeTrace, found: MotionTrace) -> sp.Expr | None:
    formulas = {x.symbol: x.formula for s in regime.solution.stages for b in s.blocks for x in b.lines}
    roles, plain = found.ledger.roles, found.route.plain
    place = {
        general: plain[own]
        for own, general in found.general.items()
        if roles[own].at == state and own in plain and plain[own].is_number
    }
    if letter not in formulas or longer(formulas[letter], 6 * LONGEST):
        return None
    told = sp.sympify(formulas[letter]).xreplace(place)
    # What another letter is by one alone, α_BC = -α_AB, is put in; the others have their lines.
    alike = {s: f for s, f in formulas.items() if s != letter and (f / f.as_coeff_Mul()[0]).is_Symbol}
    put = told.xreplace(alike)
    # Multiplied out, as a force is solved for: 1/2 m g + 1/6 m l α.
    told = told if put == formulas[letter] else expanded(simplified(put))
    if told.free_symbols & found.varying or longer(told, LONGEST) or told == closed or told.is_Symbol:
        return None
    whole = told
    for _ in formulas:
        whole = whole.xreplace({s: f.xreplace(place) for s, f in formulas.items()})
    whole = whole.xreplace(dict(found.ledger.definitions)).xreplace(dict(found.ledger.definitions))
    return told if identically_zero(whole - closed) else None
