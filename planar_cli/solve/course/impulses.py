"""Impulse and momentum with unknown impulses of reactions: Newton's equations of a regime integrated over time.

Where every coefficient of an equation of the plan is constant, Σ F = m a turns into Σ ∫F dt = m (v_2 - v_1), one letter
for the impulse of each reaction. (An Introduction to Planar Dynamics, 4.6, Example 4-18.)
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping

import sympy as sp

from planar_cli.equation.form import Nonlinear, linear_form
from planar_cli.equation.plain import simplified
from planar_cli.solve.course.equations import Equation
from planar_cli.solve.course.impulse_momentum import ARROWS, Momentum
from planar_cli.solve.course.potential import potential
from planar_cli.solve.course.regime import Regime
from planar_cli.solve.course.regime_sequence import RegimeSequence
from planar_cli.solve.course.timeline import Stop
from planar_cli.solve.write import Written

ImpulseLetter = Callable[[sp.Symbol, Stop, Stop, str], sp.Symbol]
"""The letter for the impulse of a reaction between two states, in a unit."""
UNITS = {"N": "N*s", "N*m": "N*m*s"}


def impulse_equations(course: RegimeSequence, letter_of: ImpulseLetter, k: int) -> Iterator[Equation]:
    """The equations between state k and the one before it. `letter_of`: the letter for the impulse of a reaction."""
    if k < 1 or course.is_impulsive(k - 1) or not course.regimes[k - 1].runs:
        return
    regime = course.regimes[k - 1]
    a, b = (course.stops[course.states[i].name] for i in (k - 1, k))
    stage = next((s for s in reversed(regime.general.stages) if s.level == "acceleration"), None)
    explicit = {} if stage is None else {x.symbol: x.expression for x in stage.lines}
    for block in stage.blocks if stage is not None else ():
        for w in block.equations:
            if w.law in ("force", "moment"):
                told = _integrated(letter_of, regime, w, explicit, a, b)
                if told is not None:
                    residual = sp.expand(told.after - told.before - told.impulse)
                    yield Equation(residual, "momentum", "impulse and momentum", b.name, a.name, source=told)


def _integrated(
    letter_of: ImpulseLetter, regime: Regime, w: Written, explicit: Mapping[sp.Symbol, sp.Expr], a: Stop, b: Stop
) -> Momentum | None:
    """One equation integrated; None: some coefficient varies, or a force is no function of place and time."""
    system = regime.general.trial.system
    rates = _rates(regime)
    pushes = {system.symbols[p.name]: p for p in system.pushes}
    sides = [e.xreplace(dict(explicit)) for e in (w.left, w.right)]
    try:
        forces, inertia = (linear_form(sp.expand(e), {*rates, *pushes}) for e in sides)
    except Nonlinear:
        return None
    varying = set(regime.letters)
    if any(c.free_symbols & varying for form in (forces, inertia) for c in form.terms.values()):
        return None
    if set(forces.terms) - set(pushes) or set(inertia.terms) - set(rates) or simplified(inertia.constant) != 0:
        return None
    function = potential(regime.closed(forces.constant), regime)
    if function is None or function.has(sp.Integral):
        return None
    impulse = b.at(function) - a.at(function)
    for symbol, c in forces.terms.items():
        impulse += c * letter_of(symbol, a, b, UNITS[pushes[symbol].unit])
    before, after = (sp.Add(*(c * s.at(regime.closed(rates[x])) for x, c in inertia.terms.items())) for s in (a, b))
    about = w.lead if w.law == "moment" else ""
    return Momentum(a, b, w.bodies, about, ARROWS.get(w.lead, "↗ "), before, after, impulse)


def _rates(regime: Regime) -> dict[sp.Symbol, sp.Expr]:
    """Acceleration unknowns with the velocities of which they are the rates."""
    edges = regime.general.trial.system.tree.edges
    pairs = [p for e in edges for p in ((e.slide, e.slide_rate), (e.rise, e.rise_rate), (e.spin, e.spin_rate))]
    return {rate: speed for speed, rate in pairs if speed is not None and rate is not None}
