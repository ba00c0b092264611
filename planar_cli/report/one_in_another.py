"""Equations of a state that are put into one of them: 3/4 x + y = 0 with x = v t and y = u t - g t²/2 gives the time t,
and with it the places.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from decimal import Decimal
from typing import Any

import sympy as sp

from planar_cli.equation.expansion import expanded
from planar_cli.equation.ledger import Kind
from planar_cli.equation.plain import by_name, longer, simplified
from planar_cli.records import record
from planar_cli.report.blocks import Block, Equation, Math, line
from planar_cli.report.origins import needed_results
from planar_cli.report.results import numbered
from planar_cli.report.words import Phrases
from planar_cli.solve.between.trace import MotionTrace, Result, RouteStep

LONGEST = 40
"""Longer equations are not put into each other."""
SAME = Decimal("1e-20")


@record
class Inserted:
    """How the unknowns of several equations follow one after the other. `put`, `into`: which equations are put into
    which; `residual`: what they give; `divided`: is it divided by its unknown?
    """

    put: tuple[int, ...]
    into: int
    residual: sp.Expr
    divided: bool
    time: Result
    others: tuple[tuple[int, Result], ...]
    """With the equation that gives each."""


def one_in_another(leg: RouteStep, found: MotionTrace, plain: Mapping[sp.Symbol, sp.Expr]) -> Inserted | None:
    """The time at which several equations hold, from the one into which all others are put; None: they are others."""
    roles = found.ledger.roles
    times = [x for x in leg.unknowns if x in found.general and roles[found.general[x]].kind is Kind.TIME]
    if len(times) != 1 or len(leg.relations) != len(leg.unknowns) or len(leg.unknowns) < 2:
        return None
    (time,) = times
    residuals = [e.residual.xreplace(dict(plain)) for e in leg.relations]
    if any(longer(e, LONGEST) or e.has(sp.Integral) for e in residuals):
        return None
    formulas, left = _explicit(residuals, set(leg.unknowns) - {time}, time)
    if len(left) != 1:
        return None
    (into,) = left
    whole = residuals[into]
    for _ in formulas:
        whole = whole.xreplace({x: f for x, (_, f) in formulas.items()})
    solved = _solved(expanded(whole), time, found)
    if solved is None:
        return None
    values = {r.unknown: r.value for r in leg.results}
    asked = {r.unknown for r in needed_results(leg, found)}
    rest = tuple((i, Result(x, f, values[x])) for x, (i, f) in _ordered(formulas) if x in asked)
    put = tuple(sorted(i for _, (i, _) in formulas.items()))
    return Inserted(put, into, whole, solved[1], Result(time, solved[0], values[time]), rest)


def told_inserted(
    found: Inserted, numbers: Sequence[int], phrases: Phrases, chain: Callable[[Result], tuple[Any, ...]]
) -> Iterator[Block]:
    """(8), (9) in (7): the equation in the time; the time; and all else by it. `numbers`: of the equations."""
    put = numbered([numbers[i] for i in found.put])
    terms = sp.Add.make_args(expanded(found.residual))
    left = sp.Add(*(t for t in terms if not t.could_extract_minus_sign()))
    sides = (phrases.math(left), phrases.math(left - sp.Add(*terms)))
    yield Equation(sides, None, line(f"{put} in ({numbers[found.into]}):"))
    lead = line("divided by ", Math(found.time.unknown), " ≠ 0:") if found.divided else ()
    yield Equation(chain(found.time), None, lead)
    for i, result in found.others:
        yield Equation(chain(result), None, line(f"({numbers[i]}):"))


Formulas = dict[sp.Symbol, tuple[int, sp.Expr]]


def _explicit(residuals: list[sp.Expr], letters: set[sp.Symbol], time: sp.Symbol) -> tuple[Formulas, list[int]]:
    """Letters with the equation that gives each and its formula; the equations that are left. Those in which the time
    stands come first.
    """
    found: Formulas = {}
    left = sorted(range(len(residuals)), key=lambda i: (time not in residuals[i].free_symbols, i))
    for i in tuple(left):
        for x in by_name(residuals[i].free_symbols & (letters - found.keys())):
            slope = sp.diff(residuals[i], x)
            if slope in (1, -1):
                formula = expanded(x - residuals[i] / slope)
                if not formula.free_symbols & letters - found.keys():
                    found[x] = (i, formula)
                    left.remove(i)
                    break
    return found, left


def _ordered(formulas: Formulas) -> list[tuple[sp.Symbol, tuple[int, sp.Expr]]]:
    return sorted(formulas.items(), key=lambda item: item[1][0])


def _solved(whole: sp.Expr, time: sp.Symbol, found: MotionTrace) -> tuple[sp.Expr, bool] | None:
    """The time as a formula, and whether the equation was divided by it; None: it is no such polynomial."""
    if not whole.is_polynomial(time):
        return None
    powers = sp.Poly(whole, time).all_coeffs()[::-1]
    divided = len(powers) > 2 and powers[0] == 0
    powers = powers[1:] if divided else powers
    if len(powers) == 2:
        roots = [-powers[0] / powers[1]]
    elif len(powers) == 3 and powers[1] == 0:
        roots = [sp.sqrt(simplified(-powers[0] / powers[2]))]
    else:
        return None
    value = found.value
    own = value.known(time)
    for root in roots:
        there = value.known(root)
        if own is not None and there is not None and abs(there - own) <= SAME * abs(own):
            return simplified(root), divided
    return None
