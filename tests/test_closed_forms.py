"""Pages of letters: every answer has a line that ends with its formula in the letters of the file."""

from __future__ import annotations

from decimal import Decimal

import pytest
import sympy as sp
from conftest import ROOT
from worked import worked

from planar_cli.equation.values.exact import Valuation
from planar_cli.formats.terminal import Terminal
from planar_cli.homework.checking.checking import solve_and_compare
from planar_cli.problem.structure import load_text
from planar_cli.report.answers.plain_answers import with_plain_answers
from planar_cli.report.document.blocks import Equation, Math
from planar_cli.report.notation.notation import plain
from planar_cli.report.page.narrate import narrate, phrases_of
from planar_cli.solve.between.roots.closed import closed_roots

X = sp.Symbol("x", real=True)


@pytest.mark.parametrize("name", ["impact/billiard-ball", "motion/throw-up-a-slope", "motion/pendulum-from-rest"])
def test_every_answer_ends_a_line(name: str) -> None:
    solution, _ = worked(ROOT / "problems" / f"{name}.yaml")
    lines = [b.sides for b in narrate(solution).blocks if isinstance(b, Equation)]
    ends = {plain(sides[-1].expr) for sides in lines if isinstance(sides[-1], Math)}
    for part in map(with_plain_answers, solution.parts):
        phrases = phrases_of(part.instants[-1], 4)
        asked = [f for f in part.found if f.kind == "number" and f.values is None and f.expressions]
        assert asked
        assert not [f.name for f in asked if plain(phrases.neat(f.expressions[0])) not in ends]


def test_an_equation_is_not_its_own_solution() -> None:
    """v = μ g t was printed for t: the formula of v in the letters of the file stands where v is found."""
    solution, _ = worked(ROOT / "problems/momentum/spinning-wheel-set-down.yaml")
    lines = [b for b in narrate(solution).blocks if isinstance(b, Equation)]
    sides = [(b.number, *(plain(s.expr) for s in b.sides if isinstance(s, Math))) for b in lines]
    assert [number for number, *told in sides if told == ["v_G,2", "1/3 R w"]] == [None]


TUBE = """
title: Ball that leaves a rotating tube
plane: horizontal
symbols: {m: kg, l: m, r_0: m, w: rad/s}
assume: [r_0 < l]
points: {O: [0, 0], A: [l, 0], P: [r_0, 0]}
bodies: {tube: {rod: [O, A]}, ball: {particle: P, mass: m}}
joints:
  - pin: {at: O, between: [ground, tube]}
  - guide: {point: P, along: tube}
motion: [omega(tube) = w]
states:
  start: [t = 0, v(ball/tube).mag = 0]
  exit: [r(ball).mag = l]
find: {v_r: v(ball).r @ exit, t_e: t @ exit}
answers: {v_r: w*sqrt(l^2 - r_0^2), t_e: log((l + sqrt(l^2 - r_0^2))/r_0)/w}
"""


def test_a_time_under_a_hyperbolic_cosine() -> None:
    problem, wrong = load_text(TUBE)
    assert problem is not None, wrong
    solution, verdicts = solve_and_compare(problem)
    assert [v.agrees for v in verdicts] == [True, True]
    assert "arcosh(" in Terminal(110).render(narrate(solution))


@pytest.mark.parametrize(
    ("residual", "roots"),
    [
        (2 * sp.cosh(X) - 5, [-1.5668, 1.5668]),
        (4 * sp.tanh(X) - 2, [0.5493]),
        (sp.cosh(X) + 2 * sp.sinh(X) - 4, [1.0247]),
        (sp.cosh(X) - sp.Rational(1, 2), []),
    ],
)
def test_hyperbolic_functions(residual: sp.Expr, roots: list[float]) -> None:
    found = closed_roots(residual, X, Valuation({}), Decimal(1), True)
    assert [float(r.value) for r in found] == pytest.approx(roots, abs=1e-4)
    assert all(r.expression is not None for r in found)


TRACK = """
title: Car on a circular track, whose acceleration grows with its speed
symbols: {R: m, b: m/s^2, c: m/s^2}
assume: [c > b]
points: {O: [0, 0], C: [R, 0]}
surfaces: {track: {center: O, radius: R}}
bodies: {car: {particle: C}}
joints:
  - guide: {point: C, along: track}
motion: [a(car).across(C/O) = b]
states:
  start: [t = 0, at rest]
  then: [a(car).mag = c]
find: {t_c: t @ then, v_c: v(car).mag @ then, s_c: path_length(car) @ start->then}
answers: {t_c: (R^2*(c^2 - b^2))^(1/4)/b, v_c: (R^2*(c^2 - b^2))^(1/4), s_c: R*sqrt(c^2 - b^2)/(2*b)}
"""


def test_a_power_of_the_unknown() -> None:
    """v^4/R^2 = c^2 - b^2: a root in letters, and no datum of the file."""
    problem, wrong = load_text(TRACK)
    assert problem is not None, wrong
    _, verdicts = solve_and_compare(problem)
    assert [v.agrees for v in verdicts] == [True] * 3
    numbers = TRACK.replace("symbols: {R: m, b: m/s^2, c: m/s^2}", "given: {R: 90 m, b: 2 m/s^2, c: 2.5 m/s^2}")
    problem, wrong = load_text(numbers.partition("answers")[0])
    assert problem is not None, wrong
    assert "given: v_C,then" not in Terminal(110).render(narrate(solve_and_compare(problem)[0]))


K = sp.Symbol("k", positive=True)


@pytest.mark.parametrize(("residual", "truth"), [
    (sp.log(sp.cosh(K * X)) - 2, sp.acosh(sp.exp(2)) / K),
    (3 - sp.log(1 + sp.sinh(K * X - 1)), (1 + sp.asinh(sp.exp(3) - 1)) / K),
    (sp.log(sp.cos(K * X)) + K, sp.acos(sp.exp(-K)) / K),
    (sp.exp(sp.sqrt(X)) - 1 - K, sp.log(1 + K) ** 2),
])  # fmt: skip
def test_one_function_inside_another(residual: sp.Expr, truth: sp.Expr) -> None:
    """The way down against the air is ln cosh of the time."""
    value = Valuation({K: Decimal("0.7")})
    found = closed_roots(residual, X, value, value(truth), True)
    assert any(abs(r.value - value(truth)) < Decimal("1e-30") for r in found)
    assert all(r.expression is not None and value.extended({X: value(r.expression)}).is_zero(residual) for r in found)
