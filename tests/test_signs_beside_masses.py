"""Whether a force has a sense, asked of a body whose mass is not given: the mass is positive, whatever it is."""

from __future__ import annotations

import sympy as sp
from answered import solve

from planar_cli.formats.terminal import Terminal
from planar_cli.problem.structure import load_text
from planar_cli.report.page.narrate import narrate
from planar_cli.solve.instant.truth import signed_alike
from planar_cli.solve.run import solve_problem

ROD = """
title: Rod let go on a rough floor
plane: vertical
given: {l: 0.8 m}
points: {A: [0, 0], B: {from: A, distance: l, angle: START}}
surfaces: {floor: {through: A, angle: 0 deg}}
bodies: {rod: {rod: [A, B], mass: any}}
joints:
  - contact: {between: [rod, floor], at: A, mu: 0.3}
states:
  up: [at rest]
  slips: [mode(A) = slip]
find: {back: friction(A).x @ slips > 0, phi: 90 deg - theta(rod) @ slips}
"""
"""While A holds, friction is 3/4 m g sin(phi) (3 cos(phi) - 2) towards the side of the fall."""


def test_a_positive_factor_without_a_number_is_left_out() -> None:
    m, x = sp.Symbol("m", positive=True), sp.Symbol("x", real=True)
    assert signed_alike(m * (x - 2) / 3, [m]) == (x - 2) / 3
    assert signed_alike(m * x - 2, [m]) == m * x - 2


def test_the_sense_of_friction_rests_on_no_mass() -> None:
    problem, wrong = load_text(ROD.replace("START", "80 deg"))
    assert problem is not None, wrong
    told = " ".join(Terminal().render(narrate(solve_problem(problem))).split())
    assert "back: yes" in told
    assert "N > 0" not in told, "a force that rests on a mass that was drawn"


def test_it_is_told_after_a_slight_touch_too() -> None:
    assert solve(ROD.replace("START", "90 deg"))["back"].word in ("true", "false")
