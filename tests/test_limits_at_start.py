"""A constant that is smallest or largest in the first state of a motion is found there, and given to the motion."""

from __future__ import annotations

from math import radians, sin, sqrt, tan

import pytest
from answered import first, solve

from planar_cli.formats.terminal import Terminal
from planar_cli.problem.structure import load_text
from planar_cli.report.page.narrate import narrate
from planar_cli.solve.run import solve_problem

DISK = """
title: Disk that only just rolls
plane: vertical
unknowns: {mu: 1}
points: {C: [0, 0], G: {from: C, distance: 0.2 m, angle: 60 deg}}
surfaces: {slope: {through: C, angle: -30 deg}}
bodies: {disk: {disk: G, radius: 0.2 m, mass: 4 kg}}
joints:
  - contact: {between: [disk, slope], at: C, mu: mu}
states:
  start: [at rest, mode(C) = stick, mu is smallest]
  end: [r(disk).along(-30 deg) = 3 m]
find: {mu_min: mu, v: v(G).mag @ end}
"""
TRUCK = """
title: Crate on a truck
plane: vertical
unknowns: {a: m/s^2}
points: {C: [0, 1 m]}
bodies: {truck: {particle: [0, 0], mass: 1000 kg}, crate: {particle: C, mass: 50 kg}}
surfaces: {floor: {through: [0, 0], angle: 0 deg}, bed: {through: C, angle: 0 deg, body: truck}}
joints:
  - guide: {body: truck, along: floor}
  - contact: {between: [crate, bed], at: C, mu: 0.4}
motion: [a(truck).x = a]
cases:
  off:
    states: {start: [at rest, mode(C) = stick, a is largest], end: [x(truck) = 20 m]}
    find: {t_1: t @ end}
  brake:
    states:
      start: [v(truck).x = 10 m/s, v(crate).x = 10 m/s, mode(C) = stick, a is smallest]
      end: [v(truck).x = 0]
    find: {a_b: a, s: x(truck) @ end}
"""
HELD = """
title: Block that is only just held, and then struck
plane: vertical
unknowns: {mu: 1}
points: {A: [0, 0]}
surfaces: {slope: {through: A, angle: -20 deg}}
bodies: {block: {particle: A, mass: 10 kg}}
joints:
  - contact: {between: [block, slope], at: A, mu: mu}
loads:
  - impulse: {body: block, at: A, magnitude: 30 N*s, angle: 160 deg, during: 1->2}
states:
  1: [at rest, mode(A) = stick, mu is smallest]
  2: [just after 1]
  3: [v(block).mag = 0]
find: {d: r(block).mag @ 3}
"""
G = 9.81


def page(text: str) -> str:
    problem, _ = load_text(text)
    assert problem is not None
    return Terminal().render(narrate(solve_problem(problem)))


def test_a_disk_that_only_just_rolls() -> None:
    """F = m g sin β/3; v² = 4/3 g h. The two parts stand on the page one after the other."""
    found = solve(DISK)
    assert first(found["mu_min"]) == pytest.approx(tan(radians(30)) / 3)
    assert first(found["v"]) == pytest.approx(sqrt(4 / 3 * G * 1.5))
    told = page(DISK)
    assert told.index("CASE  at start") < told.index("At the smallest μ") < told.index("CASE  from start on")
    assert "μ = μ_min = 0.1925" in told


def test_each_case_has_a_limit_of_its_own() -> None:
    """μ g forwards and backwards; a constant that is not asked for is found all the same."""
    found = solve(TRUCK)
    assert first(found["a"]) == pytest.approx(0.4 * G)
    assert first(found["t_1"]) == pytest.approx(sqrt(40 / (0.4 * G)))
    assert first(found["a_b"]) == pytest.approx(-0.4 * G)
    assert first(found["s"]) == pytest.approx(100 / (0.8 * G))
    assert "a = a =" not in page(TRUCK)


def test_before_a_blow() -> None:
    """μ = tan β; up the slope g (sin β + μ cos β) slows it."""
    found = solve(HELD)
    assert first(found["mu"]) == pytest.approx(tan(radians(20)))
    assert first(found["d"]) == pytest.approx(9 / (4 * G * sin(radians(20))))
