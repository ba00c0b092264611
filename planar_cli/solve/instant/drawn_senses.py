"""Senses in which forces and accelerations count: as they are asked; where nobody asks, those in which they act.

A weight that goes down on a cord counts downward, m g - T = m a. A joint counts friction along its surface one way for
all loads. With numbers it is drawn as it acts, so that it comes out positive. In letters, where F is asked up the slope
it is drawn up the slope, so that the answer is F and not the opposite of what stands in the diagram.
"""

from __future__ import annotations

from collections.abc import Iterable
from decimal import Decimal

import sympy as sp

from planar_cli.equation.algebra.expansion import expanded
from planar_cli.equation.algebra.form import Nonlinear, linear_form
from planar_cli.equation.algebra.plain import trigonometric
from planar_cli.equation.system.known_turns import turns_as_loaded
from planar_cli.problem.scene.going import Going
from planar_cli.solve.instant.instant import Instant, Trial
from planar_cli.solve.instant.worked import unknowns_of

DOWN = Going(0.0, -1.0, False)


def in_evident_sense(instant: Instant, trial: Trial, asked: Iterable[sp.Expr]) -> Trial:
    """The same choice of modes with its friction and its falling particle counted so. `asked`: what the finds ask, in
    the unknowns of the trial.

    Friction that slips is known by its law; that of a sense which rests on letters stays as its joint has it.
    """
    asked = [sp.sympify(e) for e in asked]
    names, sinking = _against(trial, asked), _sinking(instant, trial, asked)
    if not (names or sinking):
        return trial
    before = instant.turned, instant.builder.going
    instant.turned, instant.builder.going = before[0] ^ names, dict.fromkeys(sinking, DOWN)
    found = instant.try_choice(trial.choice, instant.scene.valuations)
    if found.objection == trial.objection:
        return found
    instant.turned, instant.builder.going = before
    return trial


def turning_as_loaded(instant: Instant, trial: Trial) -> Trial:
    """The same choice of modes, in which the only body counts the way in which its loads turn it about the contact
    over which it rolls in that choice.
    """
    if len(instant.modes) != 1 or len(instant.modes[0][1]) == 1:
        return trial
    modes = trial.system.modes.values()
    before = instant.builder.clockwise, instant.builder.known_senses
    if not turns_as_loaded(instant.builder, instant.scene, instant.statements, modes):
        return trial
    found = instant.try_choice(trial.choice, instant.scene.valuations)
    if found.objection == trial.objection:
        return found
    instant.builder.clockwise, instant.builder.known_senses = before
    return trial


def _against(trial: Trial, asked: list[sp.Expr]) -> frozenset[str]:
    """The names of the frictions that count against how they act; in letters against what is asked."""
    system = trial.system
    told = {law.push for law in system.laws}
    frictions = [p.name for p in system.pushes if p.kind == "friction" and p.name not in told]
    if not frictions:
        return frozenset()
    held = set().union(*(e.free_symbols for e in asked))
    numbers = [unknowns_of(system, outcome) for outcome in trial.outcomes]
    found = set[str]()
    for name in frictions:
        symbol = system.symbols[name]
        factors = [_factor(e, symbol, trial) for e in asked if symbol in e.free_symbols]
        alone = bool(factors) and all(f is not None for f in factors)
        opposed = alone and all(f is not None and f < 0 for f in factors)
        backward = bool(numbers) and all(n.get(symbol, 0) < 0 for n in numbers)
        if alone and not system.scene.ledger.symbolic and any(n.get(symbol, 0) for n in numbers):
            opposed = False
        else:
            backward = backward and symbol not in held
        if opposed or backward:
            found.add(name)
    return frozenset(found)


def _sinking(instant: Instant, trial: Trial, asked: list[sp.Expr]) -> frozenset[str]:
    """The one particle that nothing carries, where it starts from rest straight downward and nobody asks how fast."""
    if not instant.at_rest or instant.scene.displacement is not None:
        return frozenset()
    free = [e for e in trial.system.tree.edges if e.rise_rate is not None]
    if len(free) != 1 or trial.system.scene.rigid(free[0].body):
        return frozenset()
    along, up = free[0].slide_rate, free[0].rise_rate
    numbers = [unknowns_of(trial.system, outcome) for outcome in trial.outcomes]
    falls = bool(numbers) and all(n.get(along) == 0 and n.get(up, 0) < 0 for n in numbers)
    held = set().union(*(e.free_symbols for e in asked))
    return frozenset((free[0].body,)) if falls and not held & {along, up} else frozenset()


def _factor(asked: sp.Expr, symbol: sp.Symbol, trial: Trial) -> Decimal | None:
    """The number by which what is asked is this friction alone; None: it is more than that."""
    try:
        form = linear_form(asked, {symbol})
    except Nonlinear:
        return None
    value = trial.outcomes[0].value
    alone = asked.free_symbols & set(trial.system.symbols.values()) == {symbol}
    return value.known(form.terms[symbol]) if alone and value.known(form.constant) == 0 else None


def as_one_letter(asked: sp.Expr, letters: Iterable[sp.Symbol]) -> sp.Expr:
    """What is asked as the force that it is, F for F cos² β + F sin² β; else as it stands."""
    own = sp.sympify(asked).free_symbols & set(letters)
    if len(own) != 1 or asked.is_Symbol:
        return asked
    (symbol,) = own
    try:
        form = linear_form(asked, {symbol})
    except Nonlinear:
        return asked
    factor = trigonometric(expanded(form.terms[symbol])) if symbol in form.terms else sp.S.Zero
    return factor * symbol if factor in (1, -1) and form.constant == 0 else asked
