"""Equations of a state in the time since an earlier one, of which no line tells when it is: y = -x tan β with x = v Δt
and y = u Δt - g Δt²/2 gives Δt, and with it the places.

(7), (8) in (9):   g Δt²/2 = (u + v tan β) Δt,   divided by Δt ≠ 0:   Δt = 2 (u + v tan β)/g
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from decimal import Decimal
from typing import Any

import sympy as sp

from planar_cli.equation.algebra.expansion import expanded
from planar_cli.equation.algebra.plain import by_name, simplified
from planar_cli.equation.values.ledger import NAMED, Kind
from planar_cli.records import record
from planar_cli.report.document.blocks import Block, Equation, Math, line
from planar_cli.report.equations.results import numbered
from planar_cli.report.words.words import Phrases
from planar_cli.solve.between.trace.trace import MotionTrace
from planar_cli.units import TIME, parse_unit

SPAN = sp.Symbol("Delta_t", positive=True)
CLOSE = Decimal("1e-20")


@record
class Since:
    """How the unknowns follow from the time since a state. `put`, `into`: which equations are put into which; `ends`:
    the times; `residual`: what they give in Δt; `span`: Δt; `others`: the rest, with the equation that gives each.
    """

    put: tuple[int, ...]
    into: int
    ends: tuple[sp.Symbol, sp.Symbol]
    residual: sp.Expr
    span: tuple[sp.Expr, Decimal]
    others: tuple[tuple[int, sp.Symbol, sp.Expr, Decimal], ...]


def since_a_state(
    whole: sp.Expr, time: sp.Symbol, formulas: dict[sp.Symbol, tuple[int, sp.Expr]], into: int, found: MotionTrace
) -> Since | None:
    """`whole`: an equation in the time alone; `formulas`: the other unknowns, with the equations that give them. None:
    it is no equation in a time since a state of which Δt = 0 is the other root.
    """
    roles, route = found.ledger.roles, found.route
    told = {x for step in route.steps for x in step.unknowns if time not in step.unknowns}
    times = [s for s in by_name(whole.free_symbols & set(found.general)) if roles[found.general[s]].kind is Kind.TIME]
    others = [s for s in times if s != time]
    if len(others) != 1 or others[0] in told or found.symbolic:
        return None
    (before,) = others
    residual = expanded(whole.xreplace({time: before + SPAN}))
    if before in residual.free_symbols or not residual.is_polynomial(SPAN):
        return None
    powers = sp.Poly(residual, SPAN).all_coeffs()[::-1]
    if len(powers) != 3 or powers[0] != 0:
        return None
    root = simplified(-powers[1] / powers[2])
    size, own = found.value.known(root), found.value.known(sp.sympify(time - before))
    if size is None or own is None or abs(size - own) > CLOSE * abs(own):
        return None
    rest = []
    for x, (i, formula) in sorted(formulas.items(), key=lambda item: "y" in item[0].name):
        rest.append((i, x, simplified(formula.xreplace({time: before + SPAN})), found.value(x)))
    put = tuple(sorted(i for i, _ in formulas.values()))
    return Since(put, into, (before, time), residual, (root, size), tuple(rest))


def told_since(found: Since, numbers: Sequence[int], phrases: Phrases) -> Iterator[Block]:
    """The equation in Δt, Δt, and the places by it. `numbers`: of the equations."""
    phrases.ledger.know(SPAN, parse_unit("s"), NAMED)
    put = numbered([numbers[i] for i in found.put])
    terms = sp.Add.make_args(found.residual)
    left = sp.Add(*(t for t in terms if not t.could_extract_minus_sign()))
    before, time = found.ends
    note = line(Math(SPAN), " = ", Math(time), " - ", Math(before))
    sides = phrases.math(left), phrases.math(left - found.residual)
    yield Equation(sides, None, line(f"{put} in ({numbers[found.into]}):"), note)
    root, size = found.span
    value = phrases.of_dimension(size, TIME)
    told: tuple[Any, ...] = (Math(SPAN), phrases.math(root), *phrases.substituted(root, value), value)
    yield Equation(told, None, line("divided by ", Math(SPAN), " ≠ 0:"))
    for i, x, formula, number in found.others:
        shown = phrases.numbers(formula, {SPAN: size})
        yield Equation(
            (phrases.math(x), Math(formula), *([shown] if shown else []), phrases.shown(x, number)),
            None,
            line(f"({numbers[i]}):"),
        )
