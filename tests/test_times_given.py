"""The time that is given for a state stands on the page, also where an answer would be the same at another one."""

from __future__ import annotations

from conftest import ROOT
from worked import worked

from planar_cli.formats.terminal import Terminal
from planar_cli.problem.structure import load_text
from planar_cli.report.page.narrate import narrate
from planar_cli.solve.run import solve_problem

BLOCK = """
title: Block that slides to rest
plane: vertical
points: {P: [0, 0]}
surfaces: {floor: {through: P, angle: 0 deg}}
bodies: {block: {particle: P, mass: 2 kg}}
joints:
  - contact: {between: [block, floor], at: P, mu: 0.4}
states: {1: [t = 0, v(P).x = 3 m/s], stop: [v(P).x = 0], late: [t = 2.5 s]}
find: {mode: mode(P) @ late, d: x(P) @ late}
"""


def test_a_time_on_which_no_number_rests() -> None:
    problem, wrong = load_text(BLOCK)
    assert problem is not None, wrong
    page = Terminal().render(narrate(solve_problem(problem)))
    assert "t_late = 2.5 s" in " ".join(page.split())


def test_times_stand_in_the_order_of_states() -> None:
    told = Terminal(100).render(narrate(worked(ROOT / "problems" / "hard" / "comet.yaml")[0]))
    assert 0 < told.index("t_2 =") < told.index("t_3 =")
