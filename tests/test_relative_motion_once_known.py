"""The relative velocity and the Coriolis acceleration have numbers on a page only once the speeds in them are told."""

from __future__ import annotations

from planar_cli.formats.terminal import Terminal
from planar_cli.problem.structure import load_text
from planar_cli.report.narrate import narrate
from planar_cli.solve.run import solve_problem

FORK = """
title: Ball that a fork drives round a cardioid
points: {O: [0, 0], A: [-1 m, 0]}
surfaces: {cardioid: {r: 0.5 m * (1 - cos(theta))}}
bodies:
  fork: {rod: [O, 180 deg], length: 1.5 m}
  ball: {particle: A}
joints:
  - pin: {at: O, between: [ground, fork]}
  - guide: {point: A, along: cardioid, name: slot}
  - guide: {point: A, along: fork, name: prongs}
instant: [v(ball).mag = 4 m/s, omega(fork) > 0, alpha(fork) > 0, SIZE]
find: {omega: omega(fork), alpha: alpha(fork)}
"""


def page(text: str) -> str:
    problem, wrong = load_text(text)
    assert problem is not None, wrong
    return " ".join(Terminal().render(narrate(solve_problem(problem))).split())


def test_a_velocity_that_is_found_last_has_no_number_before() -> None:
    told = page(FORK.replace("SIZE", "a(ball).mag = 30 m/s^2"))
    before, after = told.split("(1): ω")
    assert after.startswith(" = 4 rad/s")
    assert "α = 18 rad/s²" in after
    assert "v_A′ = ω × r_A/O r_A/O = [-1, 0] m" in before
    assert "a_cor =" not in before
    assert "a_A = a_A′ + a_rel + 2 ω × v_rel" in before
