"""A constant that is sought is never answered by its own letter, and of two equal extremes the positive one counts."""

from __future__ import annotations

import pytest
import sympy as sp
from answered import first, solve

from planar_cli.errors import NoSolution

BLOCK = """
title: Block that is driven
plane: horizontal
{known}
unknowns: {{{unknown}}}
coordinates: {{x: m}}
points: {{O: [-3 m, 0], P: [x, 0]}}
bodies: {{b: {{particle: P, mass: m}}}}
joints:
  - guide: {{point: P, along: 0 deg}}
loads:
  - spring: {{between: [O, P], stiffness: k, relaxed_at: [x = 0]}}
  - force: {{body: b, magnitude: F*sin(w*t), angle: 0 deg}}
motion: [{law}]
find: {{{find}}}
"""
LETTERS, NUMBERS = "symbols: {m: kg, k: N/m, w: rad/s, ", "given: {m: 2 kg, k: 80 N/m, w: 3 rad/s, "


@pytest.mark.parametrize(("known", "unknown", "law", "find"), [
    (LETTERS + "F: N}", "X: m", "x = X*sin(w*t)", "X: X"),
    (NUMBERS + "F: 5 N}", "X: m", "x = X*sin(w*t)", "X: X"),
    (LETTERS + "X: m}", "F: N", "x = X*sin(w*t)", "E: F*X, F: 2*F"),
    (NUMBERS + "X: 2 cm}", "F: N", "x = X*sin(w*t)", "v: v(b).x, F: F"),
])  # fmt: skip
def test_what_nothing_tells_is_named(known: str, unknown: str, law: str, find: str) -> None:
    with pytest.raises(NoSolution) as caught:
        solve(BLOCK.format(known=known, unknown=unknown, law=law, find=find))
    (why,) = caught.value.diagnostics
    assert why.code == "PL623"
    assert f"{unknown[0]} is open" in why.message
    assert "kept up by a force of its own" in why.hint


def test_a_formula_that_does_not_need_it_is_told() -> None:
    text = BLOCK.format(known=LETTERS + "X: m}", unknown="F: N", law="x = X*sin(w*t)", find="v: v(b).x")
    (formula,) = solve(text)["v"].expressions or ()
    assert sorted(s.name for s in formula.free_symbols) == ["X", "t", "w"]


RESONANCE = """
title: Circular frequency of the largest amplitude
plane: horizontal
{known}
unknowns: {{w: rad/s, X: m}}
{assume}
points: {{P: [0, 0]}}
bodies: {{b: {{particle: P, mass: m}}}}
instant: [X = F/sqrt((k - m*w^2)^2 + (c*w)^2), X is largest]
find: {{w: w, X: X}}
"""


def test_of_two_equal_extremes_the_positive_one_counts() -> None:
    numbers = "given: {m: 2 kg, k: 800 N/m, c: 16 N*s/m, F: 12 N}"
    found = solve(RESONANCE.format(known=numbers, assume=""))
    assert first(found["w"]) == pytest.approx((400 - 32) ** 0.5)
    letters = "symbols: {m: kg, k: N/m, c: N*s/m, F: N}"
    (formula,) = solve(RESONANCE.format(known=letters, assume="assume: [c^2 < 2*m*k]"))["w"].expressions or ()
    values = {"m": 2, "k": 800, "c": 16}
    assert float(formula.xreplace({s: sp.Integer(values[s.name]) for s in formula.free_symbols})) == pytest.approx(
        (400 - 32) ** 0.5
    )


def test_the_logarithm_of_an_exponential_is_its_exponent() -> None:
    text = """
title: Logarithmic decrement
plane: horizontal
symbols: {m: kg, k: N/m, c: N*s/m, x_0: m}
assume: [c^2 < 4*m*k]
coordinates: {x: m}
points: {O: [-3 m, 0], P: [x, 0]}
bodies: {b: {particle: P, mass: m}}
joints:
  - guide: {point: P, along: 0 deg}
loads:
  - spring: {between: [O, P], stiffness: k, relaxed_at: [x = 0]}
  - damper: {between: [O, P], coefficient: c}
states: {0: [t = 0, at rest, x = x_0], 1: [x is smallest], 2: [x is largest]}
find: {delta: log(x_0/(x @ 2))}
"""
    (formula,) = solve(text)["delta"].expressions or ()
    assert not formula.has(sp.log, sp.exp)
    values = {"m": 2, "k": 50, "c": 12}
    number = formula.xreplace({s: sp.Integer(values[s.name]) for s in formula.free_symbols})
    assert float(number) == pytest.approx(3 * 2 * 3.141592653589793 / 4)
