"""What a motion tells once it is known: equilibrium states beside it, oscillations, truths about states, spans."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from decimal import Decimal

import sympy as sp

from planar_cli.equation.values.exact import Valuation
from planar_cli.solve.between.branches.solved_motion import SolvedMotion
from planar_cli.solve.between.branches.span_integrals import solve_spans
from planar_cli.solve.between.equations.modes_of_oscillation import demand_modes, of_modes
from planar_cli.solve.between.equations.oscillation import check_oscillations, placed
from planar_cli.solve.between.roots.chain import Branch

AGREE = Decimal("1e-9")


def completed(found: SolvedMotion) -> SolvedMotion:
    """The branch with the equilibrium states in it, and whatever is asked about states."""
    course, branch = found.course, found.branch
    balanced = course.equilibria.branch
    if balanced is not branch:
        branch = Branch(
            {**balanced.values, **branch.values},
            {**balanced.formulas, **branch.formulas},
            (*balanced.steps, *branch.steps),
            branch.left,
        )
    value = found.value.extended(balanced.values)
    for letter in balanced.values:
        formula = _resolved(letter, balanced.formulas)
        if (course.swings or letter not in course.sought()) and not formula.free_symbols & set(balanced.values):
            course.told[letter] = formula
    check_oscillations(course, course.swings, value)
    spans = solve_spans(course, value, found.followed) if course.spanned else ()
    for s in spans:
        if s.formula is not None and _agrees(s.formula, s.number, value):
            course.told.setdefault(s.symbol, s.formula)
    # What was found first has been put into finds already, in this form.
    spans = tuple(replace(s, formula=course.told.get(s.symbol, s.formula)) for s in spans)
    value = value.extended({s.symbol: s.number for s in spans})
    oscillations = tuple(placed(course, found) for found in course.swings.values())
    about = {o.stop.name: o for o in oscillations}
    for what in (f.find.found.what for f in found.finds):
        if of_modes(what, course.swings):
            demand_modes(about[what.things[0]], what, value)
    # No one symbol stands for what each mode has of its own.
    finds = (replace(f, raw=()) if of_modes(f.find.found.what, course.swings) else f for f in found.finds)
    return replace(found, finds=tuple(finds), branch=branch, value=value, spans=spans, oscillations=oscillations)


def _agrees(formula: sp.Expr, number: Decimal, value: Valuation) -> bool:
    """Has the formula a number, and is it the one?"""
    found = value.known(formula)
    return found is not None and abs(found - number) <= AGREE * max(abs(number), value.size(formula))


def _resolved(expr: sp.Expr, formulas: Mapping[sp.Symbol, sp.Expr]) -> sp.Expr:
    """Formulas put into each other."""
    for _ in range(len(formulas) + 1):
        inside = {s: formulas[s] for s in expr.free_symbols if s in formulas}
        if not inside:
            break
        expr = expr.xreplace(inside)
    return expr
