"""No moment is taken of what slides somewhere on a table, held by a cord: where it lies does not matter."""

from __future__ import annotations

import pytest
from answered import first, solve

from planar_cli.formats.terminal import Terminal
from planar_cli.problem.structure import load_text
from planar_cli.report.page.narrate import narrate
from planar_cli.solve.run import solve_problem

TABLE = """
title: Block on a table, heavy pulley, hanging block
plane: vertical
given: {m_1: 4 kg, m_2: 3 kg, M: 2 kg, R: 0.1 m, mu: 0.2}
points: {P: [0, 0], T: [1 m, 0], O: [1 m, -R], S: [1 m + R, -R], Q: [1 m + R, -1 m]}
surfaces: {table: {through: P, angle: 0 deg}}
bodies: {A: {particle: P, mass: m_1}, B: {particle: Q, mass: m_2}, pulley: {disk: O, radius: R, mass: M}}
joints:
  - contact: {between: [A, table], at: P, mu: mu}
  - pin: {at: O, between: [ground, pulley]}
  - rope: {path: [P, T on pulley], name: rope1}
  - rope: {path: [Q, S on pulley], name: rope2}
instant: [v(A).x > 0]
find: {a: a(A).x, T_1: tension(rope1), T_2: tension(rope2)}
"""


def test_the_pulley_and_what_hangs_without_the_block_on_the_table() -> None:
    problem, wrong = load_text(TABLE)
    assert problem is not None, wrong
    page = Terminal(120).render(narrate(solve_problem(problem)))
    assert "A, B, pulley" not in page
    assert "A, pulley" not in page
    a = (3 - 0.2 * 4) * 9.81 / (4 + 3 + 1)
    found = solve(TABLE)
    assert [first(found[n]) for n in ("a", "T_1", "T_2")] == pytest.approx([a, 0.2 * 4 * 9.81 + 4 * a, 3 * (9.81 - a)])
