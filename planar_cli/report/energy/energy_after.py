"""The kinetic energy that is lost as sliding bodies are stopped on what they turn with: T_2 less that of turning alone.

T_3 = 1/2 I_O,2 ω_3² = 1/2 · 0.7923 · 2.080² = 1.714 lbf·ft
lost = T_2 - T_3 = 4.944 - 1.714 = 3.230 lbf·ft
"""

from __future__ import annotations

from collections.abc import Mapping
from decimal import Decimal
from typing import Any

import sympy as sp

from planar_cli.problem.language.expression import Binary, Quantity, Side
from planar_cli.problem.scene.scene import ALL
from planar_cli.report.document.blocks import Block, Equation, Inline, Line, Math, Name, line
from planar_cli.report.energy.turning_groups import CLOSE, HALF, Turning
from planar_cli.report.words.words import Phrases
from planar_cli.solve.between.trace.trace import BalanceTrace, MotionTrace, Request
from planar_cli.units import ENERGY

KINETIC, LETTER = "KE", "T"


def energy_after(asked: Request, found: MotionTrace, groups: Mapping[str, Turning], phrases: Phrases) -> list[Block]:
    """The lines of a find KE(all) @ 2 - KE(all) @ 3, where a balance has told T_2 and all turn together afterwards;
    empty of any other find. `groups`: what turns together, by the state.
    """
    states = _states(asked.find.found.what)
    group = None if states is None else groups.get(states[0])
    if states is None or group is None or phrases.symbolic or not group.spin.is_Symbol or asked.unit is None:
        return []
    since, until = states
    balances = (r.source for leg in found.route.steps for r in leg.relations if isinstance(r.source, BalanceTrace))
    before = next((b.after for b in balances if b.law.letter == LETTER and b.stop == since), None)
    spin = next((s for s, g in found.general.items() if g == found.general.get(group.spin) and _at(s) == until), None)
    if before is None or spin is None:
        return []
    energy = HALF * group.inertia[0] * spin**2
    first, lost = phrases.value.known(before), phrases.value.known(asked.parts[0])
    last = phrases.value.extended(dict([group.inertia])).known(energy)
    if first is None or lost is None or last is None or abs(first - last - lost) > CLOSE * abs(first):
        return []
    shown = phrases.of_dimension(last, ENERGY)
    put = phrases.numbers(energy, dict([group.inertia]))
    told = line(Name(f"{LETTER}__{until}"))
    difference = line(Name(f"{LETTER}__{since}"), " - ", Name(f"{LETTER}__{until}"))
    less: list[Inline | Line] = [*_numbers(first, last, phrases), phrases.of_dimension(lost, ENERGY)]
    return [
        Equation((told, phrases.math(energy), *([] if put is None else [put]), shown)),
        Equation((line(Name(asked.find.name)), difference, *less)),
    ]


def _numbers(first: Decimal, last: Decimal, phrases: Phrases) -> list[Math]:
    """4.944 - 1.714"""
    one, other = sp.symbols("energy_before energy_after", positive=True)
    put = phrases.numbers(one - other, {one: first, other: last})
    return [] if put is None else [put]


def _states(what: Any) -> tuple[str, str] | None:
    """The states between which all kinetic energies are compared."""
    match what:
        case Binary("-", left, right):
            one, other = _state(left), _state(right)
            return (one, other) if one and other else None
    return None


def _state(side: Side) -> str:
    match side:
        case Quantity(word=word, things=things, at=str() as at) if word == KINETIC and things == (ALL,):
            return at
    return ""


def _at(symbol: sp.Symbol) -> str:
    return str(symbol.name.partition("__")[2])
