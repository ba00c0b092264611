"""What is asked of a force at an equilibrium, where all is a letter: which place was put in the line above.

(1):   S = m (g cos θ + l θ̇²)
with θ = 180°, θ̇ = 0:   S_top = m g cos 180° = -m g
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from decimal import Decimal

import sympy as sp

from planar_cli.equation.algebra.plain import by_name, identically_zero
from planar_cli.equation.values.exact import PI
from planar_cli.report.document.blocks import Line, Math, line
from planar_cli.report.words.words import Phrases
from planar_cli.solve.between.trace.trace import MotionTrace, RegimeTrace

NEAR = Decimal("1e-20")
"""A place is a whole number of degrees when it is so near to one."""


def place_put_in(name: str, closed: sp.Expr, found: MotionTrace, phrases: Phrases) -> tuple[Line, tuple[Math, ...]]:
    """The words before a find that is an unknown of the equations at an equilibrium, and its formula with the angles
    of the place put in, where that says more; empty: it is no such find, or the place is no whole number of degrees,
    or its formula holds more than what varies there.
    """
    if not found.symbolic or closed.free_symbols & set(found.general):
        return (), ()
    states = {o.state for o in found.oscillations}
    asked = ((r, state, own) for r in found.regimes for state, finds in r.asked.items() for own in [finds.get(name)])
    for regime, state, letters in asked:
        if state in states and letters is not None and len(letters) == 1 and letters[0].is_Symbol:
            formula = _formulas(regime).get(letters[0], sp.S.Zero)
            inside = by_name(formula.free_symbols & found.varying)
            place = _place(inside, state, found)
            if inside and place is not None and identically_zero(formula.xreplace(place) - closed):
                return _words(inside, place), with_angles(formula, place, phrases)
    return (), ()


def with_angles(formula: sp.Expr, place: Mapping[sp.Symbol, sp.Expr], phrases: Phrases) -> tuple[Math, ...]:
    """`m g cos 180°`, without the rates that are zero; empty where no sine or cosine holds an angle of the place."""
    still = formula.xreplace({s: e for s, e in place.items() if s.name.endswith("_dot")})
    texts = {s: _number(s, e) for s, e in place.items() if s in still.free_symbols}
    turned = any(f.args[0] in texts and f.args[0].is_Symbol for f in still.atoms(sp.sin, sp.cos))
    return (Math(phrases.neat(still), texts),) if turned else ()


def _formulas(regime: RegimeTrace) -> dict[sp.Symbol, sp.Expr]:
    return {x.symbol: x.formula for s in regime.solution.stages for b in s.blocks for x in b.lines}


def _place(letters: Iterable[sp.Symbol], state: str, found: MotionTrace) -> dict[sp.Symbol, sp.Expr] | None:
    """Angles and speeds at an equilibrium; None: one of them is no such number."""
    place: dict[sp.Symbol, sp.Expr] = {}
    for s in letters:
        value = found.value.known(sp.Symbol(f"{s.name}__{state}", real=True))
        degrees = Decimal(0) if s.name.endswith("_dot") or value is None else value * 180 / PI
        whole = degrees.to_integral_value()
        if abs(degrees - whole) > NEAR or (value is None and not s.name.endswith("_dot")):
            return None
        place[s] = sp.Integer(int(whole)) * sp.pi / 180
    return place


def _words(letters: Iterable[sp.Symbol], place: dict[sp.Symbol, sp.Expr]) -> Line:
    told = [p for s in letters for p in (", ", Math(s), " = ", _number(s, place[s]))]
    return line("with ", *told[1:], ":")


def _number(letter: sp.Symbol, value: sp.Expr) -> str:
    return "0" if letter.name.endswith("_dot") else f"{sp.deg(value)}°"
