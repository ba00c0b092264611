"""A motion that comes back to where it was repeats itself: what it has not reached by then it never reaches."""

from __future__ import annotations

import math

import pytest
from answered import solve

from planar_cli.errors import NoSolution
from planar_cli.motion.trajectory.trajectory import Trajectory
from planar_cli.problem.structure import load_text
from planar_cli.simulate.run import Settings, follow, simulate

SWING = """
title: A rod that swings
plane: vertical
given: {{m: 2 kg, l: 0.8 m, c: {damping} N*m*s}}
coordinates: {{theta: deg}}
points: {{O: [0, 0], A: [l*sin(theta), -l*cos(theta)]}}
bodies: {{rod: {{rod: [O, A], mass: m}}}}
joints: [{{pin: {{at: O, between: [ground, rod]}}}}]
loads: [{{torque: {{body: rod, moment: -c*dot(theta)}}}}]
states:
  1: [theta = 40 deg, at rest]
  2: [theta = {angle} deg]
find: {{omega: omega(rod) @ 2}}
"""

ORBIT = """
title: A body round a centre of force
plane: horizontal
given: {m: 2 kg, k: 8 N*m^2}
coordinates: {x: m, y: m}
points: {O: [0, 0], P: [x, y]}
bodies: {P: {particle: P, mass: m}}
loads: [{force: {body: P, magnitude: k/(x^2 + y^2), towards: O}}]
states:
  1: [x = 1 m, y = 0, v(P).x = 0, v(P).y = 1.5 m/s]
  2: [x = 2 m]
find: {v: v(P).mag @ 2}
"""


def trajectory(text: str) -> Trajectory:
    problem, wrong = load_text(text)
    assert problem is not None
    assert not wrong
    return simulate(problem, Settings(estimate=False)).run.trajectory


def test_a_swing_repeats_itself() -> None:
    outcome = trajectory(SWING.format(damping=0, angle=-60)).outcome
    # T = 2 π √(2 l/3g) / agm(1, cos 20°) of a uniform rod that is let go at 40 degrees.
    a, b = 1.0, math.cos(math.radians(20))
    while a - b > 1e-15:
        a, b = (a + b) / 2, math.sqrt(a * b)
    period = 2 * math.pi * math.sqrt(2 * 0.8 / (3 * 9.81)) / a
    assert outcome.kind == "repeats"
    assert outcome.t < 1.1 * period
    assert float(outcome.words.split()[-2]) == pytest.approx(period, rel=1e-5)


def test_what_loses_energy_does_not() -> None:
    assert trajectory(SWING.format(damping=1e-5, angle=-60)).outcome.kind != "repeats"
    assert trajectory(SWING.format(damping=0.05, angle=-20)).outcome.kind == "reached"


def test_an_orbit_repeats_itself() -> None:
    # A = 1/(2 - v² m r/k ...): the semi-axis is k r/(2 k - m r v²) = 16/(16 - 4.5) · 1/2 m, and T = 2 π √(m a³/k).
    axis = 8 / (16 - 4.5)
    outcome = trajectory(ORBIT).outcome
    assert outcome.kind == "repeats"
    assert float(outcome.words.split()[-2]) == pytest.approx(2 * math.pi * math.sqrt(2 * axis**3 / 8), rel=1e-5)


def test_what_never_comes_is_told_with_the_period_and_in_its_unit() -> None:
    with pytest.raises(NoSolution) as caught:
        solve(SWING.format(damping=0, angle=-60))
    (told,) = caught.value.diagnostics
    assert told.code == "PL621"
    assert "the sides differ by 20 deg; the motion repeats itself every 1.51" in told.hint


JUMPER = """
title: Jumper on an elastic cord
plane: vertical
points: {O: [0, 0], P: [0, 0]}
bodies: {man: {particle: P, mass: 70 kg}}
joints:
  - guide: {point: P, along: 90 deg}
loads:
  - spring: {between: [O, P], stiffness: 80 N/m, natural_length: 15 m, acts: pull}
states:
  1: [at rest]
  2: [y(man) = 5 m]
find: {v: v(man).y @ 2}
"""


def test_what_comes_back_through_other_modes_repeats_itself() -> None:
    """The cord is slack, taut and slack again; it never comes above the bridge."""
    problem, wrong = load_text(JUMPER)
    assert problem is not None, wrong
    trajectory = follow(problem, Settings(tolerance=1e-11)).trajectory
    assert trajectory.outcome.kind == "repeats"
    assert len(trajectory.segments) <= 6


def test_what_loses_energy_does_not_repeat_itself() -> None:
    text = JUMPER.replace("states:", "  - drag: {body: man, magnitude: (0.5 kg/s)*v(man).mag}\nstates:")
    problem, wrong = load_text(text)
    assert problem is not None, wrong
    assert follow(problem, Settings(tolerance=1e-11, most_steps=1500)).trajectory.outcome.kind != "repeats"
