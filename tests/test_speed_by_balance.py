"""A speed at any time by a balance of momentum: likewise only below that balance, and once from one state."""

from __future__ import annotations

from planar_cli.formats.terminal import Terminal
from planar_cli.problem.structure import load_text
from planar_cli.report.narrate import narrate
from planar_cli.solve.run import solve_problem

WAGON = """
title: Wagon into which sand falls
plane: vertical
given: {M: 800 kg, q: 40 kg/s, F: 500 N}
points: {P: [0, 0]}
bodies: {wagon: {particle: P, mass: M + q*t}}
joints:
  - guide: {point: P, along: 0 deg, name: rails}
loads:
  - force: {body: wagon, at: P, magnitude: F, angle: 0 deg, name: pull}
  - stream: {body: wagon, rate: q, enters: {at: P, speed: v(wagon).x, angle: 180 deg}, name: sand}
states:
  1: [t = 0, at rest]
  2: [t = 15 s]
  3: [t = 20 s]
find: {FINDS}
"""


def _page(finds: str) -> str:
    problem, wrong = load_text(WAGON.replace("FINDS", finds))
    assert problem is not None, wrong
    return " ".join(Terminal(200).render(narrate(solve_problem(problem))).split())


def test_it_is_told_once_from_one_state() -> None:
    page = _page("v: v(wagon).x @ 2, s: x(wagon) @ 2, far: x(wagon) @ 3")
    assert "Likewise at any time, with t for t_2: v_P = F t / (M + q t)" in page
    assert page.count("v_P = F t / (M + q t)") == 1


def test_where_no_balance_stands_above_it_says_its_own() -> None:
    page = _page("s: x(wagon) @ 2, v: v(wagon).x @ 2")
    assert "Impulse and momentum from 1 to any time t: v_P = F t / (M + q t)" in page
    assert "Likewise" not in page
