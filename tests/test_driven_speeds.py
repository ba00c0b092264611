"""A speed that `motion` prescribes without its sense: both are asked about, and the sense that is stated drives."""

from __future__ import annotations

import math

import pytest
from answered import solve

from planar_cli.errors import FileProblem, NoSolution

ROD = """
title: Light rod between two guides
plane: vertical
points: {{A: [0, 0.8 m], B: [0.6 m, 0]}}
bodies: {{AB: {{rod: [A, B]}}}}
joints:
  - guide: {{point: A, along: 90 deg}}
  - guide: {{point: B, along: 0 deg}}
motion: [v(A).mag = 2 m/s]
instant: [{sense}]
find: {{v: v(B).x, w: omega(AB)}}
"""


def test_a_speed_without_its_sense() -> None:
    with pytest.raises(NoSolution, match="holds both ways"):
        solve(ROD.format(sense=""))


def test_a_speed_with_its_sense() -> None:
    """The rod keeps its length: v_B · 0.6 = v_A · 0.8; ω = v_A / 0.6."""
    found = solve(ROD.format(sense="v(A).y < 0"))
    assert [float((found[n].values or ())[0]) for n in ("v", "w")] == pytest.approx([2 * 0.8 / 0.6, 2 / 0.6])


ACCELERATED = """
title: Particle whose acceleration has a given size
plane: horizontal
given: {v: 3 m/s}
bodies: {p: {particle: [0, 0], mass: 1 kg}}
motion: [a(p).mag = 2 m/s^2, v(p).x = v]
states: {1: [t = 0, v(p).y = 0], 2: [t = 2 s]}
find: {y: y(p) @ 2}
"""


def test_an_acceleration_of_a_given_size_may_go_either_way() -> None:
    with pytest.raises(FileProblem) as refused:
        solve(ACCELERATED)
    (found,) = refused.value.diagnostics
    assert found.code == "PL716"


ROADS = """
title: A car in a bend, gathering speed
given: {{rho: 80 m}}
points: {{O: [0, 0], T: {{from: O, distance: rho, angle: {angle} deg}}}}
surfaces: {{bend: {{center: O, radius: rho}}}}
bodies: {{taxi: {{particle: T}}}}
joints: [{{guide: {{point: taxi, along: bend}}}}]
instant: [v(taxi).mag = 10 m/s, v(taxi).x > 0, a(taxi).t = 2 m/s^2]
find: {{v: v(taxi).x, a: a(taxi).mag}}
"""


@pytest.mark.parametrize("angle", [30, 60, 150, 210, 300])
def test_a_speed_and_its_growth_anywhere_in_a_bend(angle: int) -> None:
    """The acceleration along the velocity rests on the sense of the speed, wherever the car is."""
    found = solve(ROADS.format(angle=angle))
    assert float((found["v"].values or ())[0]) == pytest.approx(10 * abs(math.sin(math.radians(angle))))
    assert float((found["a"].values or ())[0]) == pytest.approx(math.hypot(2, 100 / 80))


TOP_SPEED = """
title: Car at its top speed
plane: vertical
given: {m: 1600 kg, c: 0.47 kg/m, P: 76.3 kW}
unknowns: {F: N}
bodies: {car: {particle: [0, 0], mass: m}}
joints:
  - guide: {point: car, along: 0 deg}
loads:
  - drag: {body: car, quadratic: c}
  - force: {body: car, magnitude: F, angle: 0 deg, name: drive}
instant: [v(car).x > 0, a(car).x = 0, power(drive) = P]
find: {v: v(car).x}
"""


def test_a_speed_that_a_power_tells() -> None:
    """F = c v² and F v = P: the relation of the power has no acceleration for the second road to find."""
    assert float((solve(TOP_SPEED)["v"].values or ())[0]) == pytest.approx((76300 / 0.47) ** (1 / 3))
