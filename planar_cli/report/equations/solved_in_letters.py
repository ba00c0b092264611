"""Whether the equations of a step are solved in letters, so that numbers are put in last: then none of what they are
made of is told with a number beside an unknown, T_2 = 3/4 m r² ω_2² rather than = 0.015 ω_2² in J.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from planar_cli.report.document.blocks import Math, Value
from planar_cli.report.equations.eliminated import with_others_put_in
from planar_cli.report.equations.one_in_another import one_in_another
from planar_cli.report.in_numbers.in_numbers import solved_for
from planar_cli.report.words.origins import sides_of
from planar_cli.report.words.words import Phrases
from planar_cli.solve.between.trace.trace import BalanceTrace, MotionTrace, Result, RouteStep, RouteTrace


def solved_in_letters(
    leg: RouteStep, route: RouteTrace, found: MotionTrace, phrases: Phrases, told: Callable[[Result], bool]
) -> bool:
    """`told`: has a result a formula on the page?"""
    if all(map(told, leg.results)) or one_in_another(leg, found, route.plain) is not None:
        return True
    return bool(with_others_put_in(leg, route, range(len(leg.relations)), phrases, told))


def solved_in_numbers(leg: RouteStep, r: Result, route: RouteTrace, shown: Any, phrases: Phrases) -> list[Math]:
    """The numbers that give a letter, where its equation is linear in it or in its square. `shown`: its value."""
    (e, *more) = leg.relations
    if more or len(leg.unknowns) > 1 or not isinstance(shown, Value) or shown.unit == "deg":
        return []
    balance = isinstance(e.source, BalanceTrace) and bool(e.source.law.letter)
    found = solved_for(r.unknown, sides_of(e, route), leg.unknowns, phrases, balance)
    return [] if found is None else [found]
