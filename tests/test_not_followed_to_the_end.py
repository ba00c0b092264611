"""A motion that is not followed to its end shows of no state that it never comes."""

from __future__ import annotations

import pytest

from planar_cli.errors import Undecided
from planar_cli.problem.structure import load_text
from planar_cli.solve.following import traced
from planar_cli.solve.run import solve_problem

PENDULUMS = """
title: Double pendulum let go
plane: vertical
points: {A: [0, 0], B: [1 m, 0], C: [2 m, 0]}
bodies: {p: {rod: [A, B], mass: 3 kg}, q: {rod: [B, C], mass: 3 kg}}
joints:
  - pin: {at: A, between: [p, ground]}
  - pin: {at: B, between: [p, q]}
states: {1: [t = 0, at rest], 2: [theta(q) = 10000 rad]}
find: {value: ASKED}
"""


@pytest.mark.parametrize("asked", ["t @ 2", "reached(2)"])
def test_it_is_not_decided(asked: str, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(traced, "SEARCHED_STEPS", 100)
    problem, wrong = load_text(PENDULUMS.replace("ASKED", asked))
    assert problem is not None, wrong
    with pytest.raises(Undecided, match=r"state 2 \(`theta\(q\) = 10000 rad`\) is not found: more than 100 steps"):
        solve_problem(problem)
