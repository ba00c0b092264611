"""The relative velocity and the Coriolis acceleration have numbers on a page only once the speeds in them are told."""

from __future__ import annotations

from planar_cli.formats.terminal import Terminal
from planar_cli.problem.structure import load_text
from planar_cli.report.page.narrate import narrate
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

FAR_END = """
title: Crank pin at the far end of a slot
points: {C: [0, 0], O: [0.4 m, 0.3 m], P: [0.56 m, 0.42 m]}
bodies: {crank: {rod: [O, P]}, arm: {rod: [C, P]}}
joints:
  - pin: {at: O, between: [ground, crank]}
  - pin: {at: C, between: [ground, arm]}
  - guide: {point: P, along: arm}
motion: [omega(crank) = 4 rad/s ccw]
find: {omega: omega(arm), alpha: alpha(arm)}
"""
PRINCIPLE = "Motion relative to a turning body: v_P = v_P′ + v_rel, a_P = a_P′ + a_rel + 2 ω × v_rel."


def page(text: str) -> str:
    problem, wrong = load_text(text)
    assert problem is not None, wrong
    return " ".join(Terminal().render(narrate(solve_problem(problem))).split())


def test_a_velocity_that_is_found_last_has_no_number_before() -> None:
    told = page(FORK.replace("SIZE", "a(ball).mag = 30 m/s^2"))
    assert PRINCIPLE in told
    before, after = told.split("(1): ω")
    assert after.startswith(" = 4 rad/s")
    assert "α = 18 rad/s²" in after
    assert "v_A′ = ω × r_A/O r_A/O = [-1, 0] m" in before
    assert "a_cor =" not in before
    assert "a_A = a_A′ + a_rel + 2 ω × v_rel" in before


def test_the_principle_is_named_where_the_pin_is_at_rest_in_its_slot() -> None:
    told = page(FAR_END)
    assert "a_P = a_P′ + a_rel e + a_cor" in told
    assert "a_cor · n" not in told
    assert PRINCIPLE in told
