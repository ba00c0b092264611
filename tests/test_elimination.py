"""Sparse elimination in terms and dense least squares: the right numbers, few operations, rank told."""

from __future__ import annotations

import math
import random

import pytest
from hypothesis import given
from hypothesis import strategies as st

from planar_cli.motion.terms.dense import least_squares, null_space
from planar_cli.motion.terms.elimination import chosen, factor
from planar_cli.motion.terms.source import Singular, compiled
from planar_cli.motion.terms.terms import Graph, Term


def symmetric(graph: Graph, masses: list[float], joints: list[list[float]]) -> tuple[list[dict[int, Term]], list[Term]]:
    """[M Jᵀ; J 0], the entries of J as variables."""
    n = len(masses)
    rows: list[dict[int, Term]] = [{i: graph.number(m)} if m else {} for i, m in enumerate(masses)]
    rows += [{} for _ in joints]
    variables = []
    for k, joint in enumerate(joints):
        for i, value in enumerate(joint):
            if value:
                entry = graph.variable(f"j{k}_{i}", value)
                variables.append(entry)
                rows[n + k][i] = rows[i][n + k] = entry
    return rows, variables


def product(rows: list[dict[int, Term]], x: list[float]) -> list[float]:
    return [sum(t.value * x[j] for j, t in row.items()) for row in rows]


@given(seed=st.integers(0, 10**6), bodies=st.integers(1, 6), massless=st.booleans())
def test_the_solution_fulfils_the_equations(seed: int, bodies: int, massless: bool) -> None:
    draw = random.Random(seed)
    masses = [0.0 if massless and i == 0 else draw.uniform(0.5, 2.0) for i in range(bodies)]
    count = draw.randint(1 if massless else 0, bodies)
    joints = [[draw.choice([0.0, 1.0, draw.uniform(-1, 1)]) for _ in masses] for _ in range(count)]
    for k, joint in enumerate(joints):
        joint[k] = 2.0 * bodies
    graph = Graph()
    rows, variables = symmetric(graph, masses, joints)
    right = [graph.number(draw.uniform(-1, 1)) for _ in rows]
    solved = factor(graph, rows)
    assert not solved.order.rows
    code = compiled(solved.solve(right), variables, checks=solved.checks())
    found = code.function(0.0, [v.value for v in variables])
    assert product(rows, found) == pytest.approx([t.value for t in right], abs=1e-9)


def test_a_symmetric_system_costs_half() -> None:
    graph = Graph()
    n = 6
    entries = {
        (i, j): graph.variable(f"m{i}{j}", 5.0 if i == j else 1 / (1 + i + j)) for i in range(n) for j in range(i + 1)
    }
    rows = [{j: entries[max(i, j), min(i, j)] for j in range(n)} for i in range(n)]
    right = [graph.variable(f"b{i}", 1.0) for i in range(n)]
    solved = factor(graph, rows)
    code = compiled(solved.solve(right), [*entries.values(), *right], checks=solved.checks())
    # n³/6 products and as many sums, and what the right side takes.
    assert code.operations <= n**3 / 3 + 2.5 * n**2


def test_a_redundant_equation_is_left_open() -> None:
    graph = Graph()
    rows, _ = symmetric(graph, [1.0, 2.0], [[1.0, 1.0], [2.0, 2.0]])
    order = chosen(rows)
    assert len(order.rows) == 1
    assert order.rows[0] in (2, 3)
    zero = graph.number(0.0)
    a, b, *_ = (t.value for t in factor(graph, rows, order).solve([graph.number(1.0), zero, zero, zero]))
    assert [a, b] == pytest.approx([1 / 3, -1 / 3])


def test_a_pivot_that_vanishes_is_met_by_another_order() -> None:
    graph = Graph()
    a, b = graph.variable("a", 2.0), graph.variable("b", 1.0)
    one = graph.number(1.0)
    rows = [{0: a, 1: b}, {0: b, 1: graph.number(0.5)}]
    solved = factor(graph, rows, chosen(rows, {a: 2.0, b: 1.5}))
    code = compiled(solved.solve([one, one]), [a, b], checks=solved.checks())
    with pytest.raises(Singular):
        code.function(0.0, [0.0, 1.5])
    other = factor(graph, rows, chosen(rows, {a: 0.0, b: 1.5}))
    found = compiled(other.solve([one, one]), [a, b], checks=other.checks()).function(0.0, [0.0, 1.5])
    assert found == pytest.approx([4 / 9, 2 / 3])


@pytest.mark.parametrize("delta", [1e-3, 1e-9, 1e-12])
def test_two_cables_nearly_in_line(delta: float) -> None:
    s, c = math.sin(delta), math.cos(delta)
    fit = least_squares([[c, -c], [s, s]], [0.0, 1.0])
    assert fit.rank == 2
    assert fit.unknowns == pytest.approx([1 / (2 * s)] * 2, rel=10 * 2.3e-16 / delta)


def test_of_redundant_supports_the_shortest_solution_is_taken() -> None:
    fit = least_squares([[1.0, 1.0, 1.0], [0.0, 1.0, 2.0]], [3.0, 3.0])
    assert fit.unknowns == pytest.approx([1.0, 1.0, 1.0])
    assert fit.rank == 2
    clash = least_squares([[1.0, 0.0], [1.0, 0.0]], [1.0, 2.0])
    assert clash.unknowns == pytest.approx([1.5, 0.0])
    assert clash.misfit > 0.1
    (vector,) = null_space([[1.0, 1.0, 1.0], [0.0, 1.0, 2.0]], 3)
    assert vector[0] + vector[1] + vector[2] == pytest.approx(0.0, abs=1e-15)


def test_large_systems_too() -> None:
    n = 70
    matrix = [[1.0 / (1 + abs(i - j)) for j in range(n)] for i in range(n)]
    fit = least_squares(matrix, [sum(row) for row in matrix])
    assert fit.unknowns == pytest.approx([1.0] * n, abs=1e-9)
