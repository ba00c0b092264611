"""The numbers that the fast model is written in: values, derivatives, one object for one expression."""

from __future__ import annotations

import math

import pytest
from hypothesis import given
from hypothesis import strategies as st

from planar_cli.motion.terms.terms import Graph, Term, evaluate

FORMULAS = [
    "x*y",
    "x/y + y**3",
    "sin(x*y)",
    "sqrt(x*x + y*y)",
    "atan2(y, x)",
    "exp(x/y)*log(y)",
    "x**y",
    "abs(x - 4*y)",
]
NUMBERS = st.floats(0.3, 3.0)


def made(graph: Graph, text: str, x: Term, y: Term) -> Term:
    """A formula written in Python, as a term."""
    functions = {n: lambda *a, n=n: graph.call(n, *a) for n in ("sin", "sqrt", "atan2", "exp", "log", "abs")}
    term: Term = eval(text, {"x": x, "y": y, **functions})
    return term


@pytest.mark.parametrize("text", FORMULAS)
@given(x=NUMBERS, y=NUMBERS)
def test_gradients_and_rates_are_those_of_differences(text: str, x: float, y: float) -> None:
    graph = Graph()
    a, b = graph.variable("x", x), graph.variable("y", y)
    term = made(graph, text, a, b)
    step = 1e-6

    def at(dx: float, dy: float) -> float:
        return evaluate([term], {a: x + dx, b: y + dy})[0]

    slopes = graph.gradient(term)
    expected = [(at(step, 0) - at(-step, 0)) / (2 * step), (at(0, step) - at(0, -step)) / (2 * step)]
    assert [slopes[a].value, slopes[b].value] == pytest.approx(expected, rel=1e-6, abs=1e-6)
    rate = graph.rate(term, {a: graph.number(2.0), b: graph.number(-1.0)})
    assert rate.value == pytest.approx(2 * expected[0] - expected[1], rel=1e-6, abs=1e-6)


def test_the_same_expression_is_one_object() -> None:
    graph = Graph()
    x, y = graph.variable("x", 1.0), graph.variable("y", 2.0)
    assert x * y + 1 is y * x + 1
    assert (x - x).zero
    assert (x * 0).constant


def test_zero_is_decided_on_the_scale_of_what_was_subtracted() -> None:
    graph = Graph()
    small, large = graph.variable("a", 1e-9), graph.variable("b", 1e9)
    assert not small.zero
    assert (large + small - large - small).zero
    assert graph.call("sin", graph.number(math.pi) + graph.variable("t", 0.0)).zero


def test_a_table_is_straight_in_between_and_constant_outside() -> None:
    graph = Graph()
    t = graph.variable("t", 1.0)
    force = graph.call(graph.table([(0.0, 0.0), (2.0, 50.0)]), t)
    assert evaluate([force, graph.gradient(force)[t]], {t: 1.0}) == [25.0, 25.0]
    assert evaluate([force], {t: 9.0}) == [50.0]
