"""The roots of equations between states, and the cheapest way through them; both from equations written by hand."""

from __future__ import annotations

from decimal import Decimal

import pytest
import sympy as sp

from planar_cli.equation.values.exact import Valuation
from planar_cli.solve.between.roots.chain import Branch, Chain
from planar_cli.solve.between.route.route import Router
from planar_cli.solve.between.trace.derivation import Route
from planar_cli.solve.regimes.equations import Equation

X, Y, Z, T = sp.symbols("x__2 y__2 z__2 t__2", real=True)
A, B = sp.symbols("a b", positive=True)
UNKNOWNS = frozenset((X, Y, Z, T))
KNOWN = Valuation({A: Decimal(3), B: Decimal(5)})


def equation(residual: sp.Expr, kind: str = "loop", words: str = "by hand") -> Equation:
    return Equation(residual, kind, words, "2")


def branches(*residuals: sp.Expr, positive: bool = False) -> list[Branch]:
    def possible(values: dict[sp.Symbol, Decimal]) -> bool:
        return not positive or all(v > 0 for v in values.values())

    sizes = dict.fromkeys(UNKNOWNS, Decimal(1))
    chain = Chain(UNKNOWNS, {T: None}, {}, KNOWN, False, possible, natural=sizes)
    return list(chain.branches([equation(r) for r in residuals]))


def route(*equations: Equation, targets: tuple[sp.Symbol, ...], **values: int) -> Route:
    numbers = {s: Decimal(values[s.name[0]]) for s in UNKNOWNS if s.name[0] in values}
    return Router(equations, UNKNOWNS, KNOWN.extended(numbers), False).route(targets)


# --- roots -----------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("residual", "first"),
    [(sp.cos(A * X / B) + 1, sp.pi * B / A), (sp.sin(A * X / B), sp.S.Zero), (2 * sp.cos(A * X) - 1, sp.pi / (3 * A))],
)
def test_an_angle_that_grows_evenly_with_the_unknown(residual: sp.Expr, first: sp.Expr) -> None:
    """In letters, with the turns of the angle, not of the unknown."""
    chain = Chain(frozenset((X,)), {}, {X: None}, KNOWN, True, natural={X: Decimal(1)})
    found = [b.formulas[X] for b in chain.branches([equation(residual)])]
    assert any(sp.simplify(f - first) == 0 for f in found)
    assert all(KNOWN.is_zero(residual.xreplace({X: f})) for f in found)


def test_one_unknown_after_the_other() -> None:
    (branch,) = branches(Y - X - B, X - A, Z * Y - 16)
    assert branch.values == {X: 3, Y: 8, Z: 2}
    assert not branch.left


def test_every_root_is_a_branch() -> None:
    found = branches(X**2 - 9, Y - 2 * X)
    assert sorted((b.values[X], b.values[Y]) for b in found) == [(-3, -6), (3, 6)]


def test_what_is_impossible_is_no_branch() -> None:
    (branch,) = branches(X**2 - 9, Y - 2 * X, positive=True)
    assert branch.values == {X: 3, Y: 6}


def test_equations_that_hold_together_are_solved_together() -> None:
    found = branches(X + Y - 7, X * Y - 12)
    assert sorted((b.values[X], b.values[Y]) for b in found) == [(3, 4), (4, 3)]


def test_equations_that_contradict_each_other_have_no_branch() -> None:
    assert not branches(X - 1, X - 2)


def test_a_redundant_equation_does_no_harm() -> None:
    (branch,) = branches(X - A, Y - X, Y - A)
    assert branch.values == {X: 3, Y: 3}


def test_what_is_open_is_left() -> None:
    (branch,) = branches(X - A, Y + Z - 1)
    assert branch.values == {X: 3}
    assert [e.residual for e in branch.left] == [Y + Z - 1]


# --- the way through them --------------------------------------------------------------------------------------------


def test_the_cheapest_way_is_taken() -> None:
    dear, cheap = equation(Y - 2 * X, "t(q)", "dear"), equation(Y - 2 * A, "given", "cheap")
    found = route(equation(X - A), dear, cheap, targets=(Y,), x=3, y=6)
    assert [e.words for step in found.steps for e in step.derivation.equations] == ["cheap"]


def test_only_what_is_needed_is_derived() -> None:
    found = route(equation(X - A - B), equation(Y - 2 * X), equation(Z - X - Y), targets=(Y,), x=8, y=16, z=24)
    assert [r.unknown for step in found.steps for r in step.results] == [X, Y]
    assert found.formulas[Y].xreplace({X: found.formulas[X]}) == 2 * (A + B)


@pytest.mark.parametrize("root", [3, -3])
def test_of_several_roots_the_one_that_happens_is_told(root: int) -> None:
    found = route(equation(X**2 - A**2), targets=(X,), x=root)
    ((result,),) = (step.results for step in found.steps)
    assert result.value == root
    assert sorted(r.value for r in result.roots) == [-3, 3]


def test_equations_are_put_together_where_none_leads_on_alone() -> None:
    found = route(equation(X + Y - 7), equation(X - Y - 1), targets=(X, Y), x=4, y=3)
    (step,) = found.steps
    assert len(step.derivation.equations) == 2
    assert {r.unknown: r.value for r in step.results} == {X: 4, Y: 3}


def test_an_equation_that_holds_for_any_value_fixes_nothing() -> None:
    found = route(equation(X * Y), equation(Y, "given"), targets=(X,), x=3, y=0)
    assert not found.steps


def test_zeros_need_no_line() -> None:
    found = route(equation(X, "given"), equation(Y - X - A), targets=(Y,), x=0, y=3)
    assert found.plain == {X: 0}
    assert [r.unknown for step in found.steps for r in step.results] == [Y]
