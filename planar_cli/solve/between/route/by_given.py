"""Energies by what the file gives, where that is shorter: m_A v²/2 for m_A R² ω_2²/2 where v = R ω_2 is given, and T h
for T R θ_2.
"""

from __future__ import annotations

from collections.abc import Collection, Iterable, Mapping, Sequence
from dataclasses import replace

import sympy as sp

from planar_cli.equation.algebra.counting import operations
from planar_cli.equation.algebra.plain import by_name, derivative, letters, longer, simplified
from planar_cli.solve.between.equations.balances import StateBalance
from planar_cli.solve.between.roots.substitution import STATE, TIME
from planar_cli.solve.regimes.equations import Equation

GIVEN, LINK = "given", "link"
"""The kinds of equations that tie speeds, and places, to what the file gives."""
SHORT = 24
"""A formula of more operations is left as it is."""

Formulas = Mapping[sp.Symbol, sp.Expr]


def by_given(equations: Sequence[Equation], unknowns: Collection[sp.Symbol], plain: Formulas) -> list[Equation]:
    """The same equations; balances of energies in letters of the file where that makes a part shorter. `plain`: data
    that are put in at once.
    """
    formulas = _formulas(equations, unknowns, plain)
    return [_in_given(e, formulas, plain) for e in equations]


def beginnings(equations: Sequence[Equation]) -> frozenset[str]:
    """The states from which motions go on and to which none comes."""
    spans = [e for e in equations if e.since]
    return frozenset(e.since for e in spans) - {e.stop for e in spans}


def by_its_name(
    e: Equation, residual: sp.Expr, inside: frozenset[sp.Symbol], begins: Collection[str]
) -> frozenset[sp.Symbol]:
    """The velocity or place with which a motion begins, of two unknowns of a datum of which the other one is a constant
    that is sought: v_1 = v_0 is no equation to be solved, but its name.
    """
    if e.kind != GIVEN or e.told or e.stop not in begins or len(inside) != 2:
        return inside
    own = [s for s in inside if STATE in s.name and not s.name.startswith(TIME)]
    said = e.words.partition("=")[2].strip(" -")
    named = len(own) == 1 and residual.is_Add and len(residual.args) == 2 and said in {s.name for s in inside}
    return frozenset(own) if named and all(a.is_Symbol or (-a).is_Symbol for a in residual.args) else inside


def with_constants(targets: Iterable[sp.Symbol], plain: Formulas, unknowns: Collection[sp.Symbol]) -> list[sp.Symbol]:
    """The targets; after one that is called by the name of a constant that is sought, this constant."""
    return list(dict.fromkeys(s for t in targets for s in (t, *by_name(letters(plain.get(t, t)) & set(unknowns)))))


def _formulas(
    equations: Sequence[Equation], unknowns: Collection[sp.Symbol], plain: Formulas
) -> dict[sp.Symbol, sp.Expr]:
    """Speeds that follow from what is given of them by one relation, ω_2 = v/R, and places that go with given ones,
    θ_2 = h/R.
    """
    found: dict[sp.Symbol, sp.Expr] = {}
    speeds = _speeds(equations)
    for e in equations:
        if e.kind not in (GIVEN, LINK) or longer(e.residual, SHORT):
            continue
        residual = e.residual.xreplace(dict(plain))
        inside = letters(residual) & set(unknowns)
        if len(inside) != 1:
            continue
        (x,) = inside
        rate = derivative(residual, x)
        if x in letters(rate) or rate == 0 or x in found or (x in speeds) != (e.kind == GIVEN):
            continue
        formula = simplified(-residual.xreplace({x: sp.S.Zero}) / rate)
        if formula.free_symbols and not formula.is_Add:
            found[x] = formula
    return found


def _speeds(equations: Sequence[Equation]) -> set[sp.Symbol]:
    """Those of the states between which there are balances."""
    stops = [stop for e in equations if isinstance(e.source, StateBalance) for stop in (e.source.since, e.source.stop)]
    return {stop.letters[s] for stop in stops for s in stop.speeds}


def _in_given(e: Equation, formulas: Formulas, plain: Formulas) -> Equation:
    """A balance of energies with what is given in every part that gets shorter by it."""
    b = e.source
    if not formulas or not isinstance(b, StateBalance) or not b.law.letter:
        return e
    inside = e.residual.free_symbols
    if not inside & formulas.keys():
        return e
    amounts = tuple((body, _shorter(x, formulas, plain)) for body, x in b.amounts)
    brought = tuple((words, _shorter(x, formulas, plain)) for words, x in b.brought)
    if amounts == b.amounts and brought == b.brought:
        return e
    given = {body: formulas for (body, x), (_, own) in zip(amounts, b.amounts, strict=True) if x != own}
    after = sp.Add(*(x for _, x in amounts))
    told = replace(b, after=after, amounts=amounts, brought=brought, given=given)
    return replace(e, residual=told.after - told.before - told.gain, source=told)


def _shorter(expr: sp.Expr, formulas: Formulas, plain: Formulas) -> sp.Expr:
    """In letters of the file; as it is where that is no shorter, or none of them is in it."""
    put = expr.xreplace(dict(plain))
    if longer(put, SHORT) or not put.free_symbols & formulas.keys():
        return expr
    found = simplified(put.xreplace(dict(formulas)))
    return found if operations(found) < operations(put) else expr
