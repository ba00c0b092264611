"""The start of a swing that takes so long to an angle stands inside the integral of the time: it is found by trial."""

from __future__ import annotations

import math

from planar_cli.formats.terminal import Terminal
from planar_cli.problem.structure import load_text
from planar_cli.report.page.narrate import narrate
from planar_cli.solve.run import solve_problem

PENDULUM = """
title: Pendulum set in motion so that it reaches an angle at a given time
plane: vertical
unknowns: {w: rad/s}
points: {O: [0, 0], B: {from: O, distance: 1 m, angle: -90 deg}}
bodies: {rod: {rod: [O, B], mass: 2 kg}}
joints: [pin: {at: O, between: [ground, rod]}]
states:
  1: [t = 0, omega(rod) = w]
  2: [t = 0.4 s, theta(rod) = -30 deg]
find: {w: w}
"""


def test_the_integral_stands_before_the_value() -> None:
    problem, wrong = load_text(PENDULUM)
    assert problem is not None, wrong
    solution = solve_problem(problem)
    page = Terminal().render(narrate(solution))
    assert "(2)  t_2 = ∫[θ_1 → θ_2] (1/√(w² - 29.43 - 29.43 sin θ)) dθ" in page
    assert "(2), by trial values:   w = 3.870 rad/s" in page
    # θ̈ = -3/2 g cos θ by Simpson's rule over 20 000 steps of θ = -90° + s, with ω² = ω_1² - 3 g (1 - cos s).
    omega = float((solution.parts[0].found[0].values or ())[0])
    assert abs(_time(omega) - 0.4) < 1e-9


def _time(omega: float, steps: int = 20_000) -> float:
    width = math.radians(60) / steps
    rates = [1 / math.sqrt(omega**2 - 3 * 9.81 * (1 - math.cos(k * width))) for k in range(steps + 1)]
    return width / 3 * (rates[0] + rates[-1] + 4 * sum(rates[1:-1:2]) + 2 * sum(rates[2:-1:2]))
