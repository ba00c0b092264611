"""Terms written out as Python: the same numbers, each operation once, and pivots that are looked at."""

from __future__ import annotations

import math
from collections.abc import Callable

import pytest
from hypothesis import given
from hypothesis import strategies as st

from planar_cli.motion.terms.source import Check, Singular, compiled
from planar_cli.motion.terms.terms import Graph, Term, evaluate

PARTS = st.recursive(
    st.sampled_from(["x", "y", "t", "2.0", "-0.5"]),
    lambda inner: st.one_of(
        st.tuples(st.sampled_from("+-*/"), inner, inner), st.tuples(st.sampled_from(["sin", "neg"]), inner)
    ),
    max_leaves=40,
)


def built(graph: Graph, tree: object, leaves: dict[str, Term]) -> Term:
    """A drawn tree of operations as a term."""
    if isinstance(tree, str):
        return leaves[tree] if tree in leaves else graph.number(float(tree))
    assert isinstance(tree, tuple)
    op, *parts = tree
    args = [built(graph, part, leaves) for part in parts]
    operations: dict[str, Callable[..., Term]] = {
        "+": lambda a, b: a + b,
        "-": lambda a, b: a - b,
        "*": lambda a, b: a * b,
        "/": lambda a, b: a / (b * b + 1.0),
        "sin": lambda a: graph.call("sin", a),
        "neg": lambda a: -a,
    }
    return operations[op](*args)


@given(trees=st.lists(PARTS, min_size=1, max_size=4), x=st.floats(-2, 2), y=st.floats(-2, 2), t=st.floats(0, 3))
def test_the_code_gives_what_the_terms_are(trees: list[object], x: float, y: float, t: float) -> None:
    graph = Graph()
    leaves = {name: graph.variable(name, value) for name, value in (("x", 0.7), ("y", -1.3), ("t", 0.0))}
    terms = [built(graph, tree, leaves) for tree in trees]
    code = compiled(terms, [leaves["x"], leaves["y"]], leaves["t"])
    expected = evaluate(terms, {leaves["x"]: x, leaves["y"]: y, leaves["t"]: t})
    assert code.function(t, [x, y]) == pytest.approx(expected, rel=1e-9, abs=1e-9)


def test_every_operation_is_done_once() -> None:
    graph = Graph()
    x, y = graph.variable("x", 1.0), graph.variable("y", 2.0)
    sine = graph.call("sin", x)
    code = compiled([sine * y + sine, -sine, x * y - 3.0 * sine], [x, y])
    assert code.text.count("sin(") == 1
    assert code.operations == 7


def test_long_sums_do_not_nest_too_deep() -> None:
    graph = Graph()
    x = graph.variable("x", 0.5)
    term = x
    for _ in range(2000):
        term = graph.call("sin", term + 1.0)
    assert compiled([term], [x]).function(0.0, [0.5]) == [pytest.approx(term.value)]


def test_a_small_pivot_is_refused() -> None:
    graph = Graph()
    x = graph.variable("x", 1.0)
    pivot = x - 0.5
    code = compiled([1.0 / pivot], [x], checks=[Check(pivot, 1e-6)])
    assert code.function(0.0, [0.75]) == [4.0]
    with pytest.raises(Singular):
        code.function(0.0, [0.5 + 1e-7])


def test_angles_go_on_over_many_turns() -> None:
    graph = Graph()
    x = graph.variable("x", 0.0)
    angle = graph.turning(graph.call("sin", x), graph.call("cos", x))
    (turning,) = graph.turnings.values()
    code = compiled([angle], [x])
    for step in range(50):
        (found,) = code.function(0.0, [step * 1.5])
        assert found == pytest.approx(step * 1.5)
        turning.last = found
    assert graph.rate(angle, {x: graph.number(2.0)}).value == pytest.approx(2.0)
    assert math.isclose(angle.value, 0.0, abs_tol=1e-15)


def test_a_power_that_is_not_real_is_outside() -> None:
    """Steps of an integrator try values beyond those that a motion has: v^(3/2) of a negative v is no number."""
    graph = Graph()
    x = graph.variable("x", 4.0)
    code = compiled([graph.power(x, graph.number(1.5)), graph.power(x, graph.number(5.0))], [x])
    assert code.function(0.0, [4.0]) == [8.0, 1024.0]
    with pytest.raises(ValueError, match="not real"):
        code.function(0.0, [-4.0])
    with pytest.raises(ValueError, match="not real"):
        evaluate([graph.power(x, graph.number(1.5))], {x: -4.0})
