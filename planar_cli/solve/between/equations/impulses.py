"""Impulse and momentum with unknown impulses of reactions: Newton's equations of a regime integrated over time.

Where every coefficient of an equation of the plan is constant, Σ F = m a turns into Σ ∫F dt = m (v_2 - v_1), one letter
for the impulse of each reaction. (An Introduction to Planar Dynamics, 4.6, Example 4-18.)
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from decimal import Decimal

import sympy as sp

from planar_cli.equation.algebra.expansion import expanded
from planar_cli.equation.algebra.form import Nonlinear, linear_form
from planar_cli.equation.algebra.plain import identically_zero
from planar_cli.equation.scene.arrows import vector_arrow
from planar_cli.equation.system.led import led, rolls
from planar_cli.equation.system.system import System
from planar_cli.equation.values.exact import Valuation
from planar_cli.principles.base import Balance, Impulses, Moving
from planar_cli.solve.between.equations.balances import StateBalance
from planar_cli.solve.instant.written import Written
from planar_cli.solve.regimes.constant_rates import constants_of
from planar_cli.solve.regimes.equations import Equation
from planar_cli.solve.regimes.potential import potential
from planar_cli.solve.regimes.regime import Regime
from planar_cli.solve.regimes.regime_sequence import RegimeSequence
from planar_cli.solve.regimes.timeline import Stop

ImpulseLetter = Callable[[sp.Symbol, Stop, Stop, str], sp.Symbol]
"""The letter for the impulse of a reaction between two states, in a unit."""
UNITS = {"N": "N*s", "N*m": "N*m*s"}


def impulse_equations(
    course: RegimeSequence, principle: str, offer: Impulses, letter_of: ImpulseLetter, k: int
) -> Iterator[Equation]:
    """The equations between state k and the one before it, which a principle offers. `letter_of`: the letter for the
    impulse of a reaction.
    """
    if k < 1 or course.is_impulsive(k - 1) or not course.regimes[k - 1].runs:
        return
    regime = course.regimes[k - 1]
    a, b = (course.stops[course.states[i].name] for i in (k - 1, k))
    stage = next((s for s in reversed(regime.general.stages) if s.level == "acceleration"), None)
    explicit = {} if stage is None else {x.symbol: x.expression for x in stage.lines}
    for block in stage.blocks if stage is not None else ():
        for w in block.equations:
            if w.law in ("force", "moment"):
                told = _integrated(course, offer, letter_of, regime, w, explicit, a, b)
                if told is not None:
                    residual = expanded(told.after - told.before - told.gain)
                    whose = frozenset((principle,))
                    yield Equation(
                        residual,
                        principle,
                        offer.words,
                        b.name,
                        a.name,
                        source=told,
                        surcharge=offer.cost,
                        offered=whose,
                    )


def _integrated(
    course: RegimeSequence,
    offer: Impulses,
    letter_of: ImpulseLetter,
    regime: Regime,
    w: Written,
    explicit: Mapping[sp.Symbol, sp.Expr],
    a: Stop,
    b: Stop,
) -> StateBalance | None:
    """One equation integrated; None: some coefficient varies, or a force is no function of place and time."""
    system = regime.general.trial.system
    rates = {rate: speed for speed, rate in system.rates().items()}
    pushes = {system.symbols[p.name]: p for p in system.pushes}
    sides = [e.xreplace(dict(explicit)) for e in (w.left, w.right)]
    try:
        forces, inertia = (linear_form(expanded(e), {*rates, *pushes}) for e in sides)
    except Nonlinear:
        return None
    varying = set(regime.letters)
    if any(c.free_symbols & varying for form in (forces, inertia) for c in form.terms.values()):
        return None
    if set(forces.terms) - set(pushes) or set(inertia.terms) - set(rates) or not identically_zero(inertia.constant):
        return None
    function = potential(regime.closed(forces.constant), regime)
    if function is None or function.has(sp.Integral):
        return None
    impulse = b.at(function) - a.at(function)
    constants = constants_of(regime, course.given())
    for symbol, c in forces.terms.items():
        # It counts as it acts, where that does not change.
        sense = -1 if symbol in constants and constants[symbol][1] < 0 else 1
        impulse += sense * c * letter_of(symbol, a, b, UNITS[pushes[symbol].unit])
    before, after = (sp.Add(*(c * s.at(regime.closed(rates[x])) for x, c in inertia.terms.items())) for s in (a, b))
    about = w.lead if w.law == "moment" else ""
    turn = system.tree.turn(w.bodies) if about else 1
    law = Balance(
        words=offer.words,
        name=f"H_{about}" if about else "",
        amounts=(),
        sources=(),
        cost=offer.cost,
        bodies=w.bodies,
        heading=f"angular {offer.words} about " if about else "",
        about=about,
        moving=tuple(_moving(system, w.bodies)),
        lead=f"{_arrow(w.along, regime.general.value)} " if w.along is not None else "↺ " if turn > 0 else "↻ ",
    )
    return StateBalance(law, a, b, turn * before, turn * after, (("", turn * impulse),))


def _moving(system: System, bodies: tuple[str, ...]) -> Iterator[Moving]:
    """How the bodies of an equation move, and why."""
    motion = system.motion
    for body in bodies if motion is not None else ():
        assert motion is not None
        made, omega = system.scene.bodies[body], motion.velocities[body].angular * system.tree.turn((body,))
        v = motion.velocity(made.center, body)
        why = f"{body} rolls without slipping" if rolls(system, body) else led(system, body)
        yield Moving(body, made.mass, made.inertia, v.x, v.y, omega, system.scene.center_name(body), why)


def _arrow(direction: tuple[sp.Expr, sp.Expr], value: Valuation) -> str:
    """The sense in which momenta count as positive."""
    x, y = (Decimal(0) if value.is_zero(c) else value(c) for c in direction)
    return vector_arrow(x, y)
