"""Kinematics needs no plane, though the bodies have masses; where weight has a part in it, it must be named."""

from __future__ import annotations

import pytest
from answered import first, solve

from planar_cli.errors import FileProblem, NoSolution
from planar_cli.problem.structure import load_text

WHEEL = """
title: Wheel that rolls faster and faster
points: {C: [0, 0], G: [0, 0.3 m], T: [0, 0.6 m]}
surfaces: {floor: {through: C, angle: 0 deg}}
bodies: {wheel: {disk: G, radius: 0.3 m, mass: 5 kg, points: [T]}}
joints:
  - rolling: {between: [wheel, floor], at: C}
instant: [v(G).x = 2 m/s, a(G).x = 1 m/s^2]
find: {a: a(T).y, alpha: alpha(wheel)}
"""
TRAIN = """
title: Train that gains speed
bodies: {train: {particle: [0, 0], mass: 1000 kg}}
motion: [a(train).x = 2 m/s^2]
states:
  1: [t = 0, v(train).x = 3 m/s]
  2: [v(train).x = 20 m/s]
find: {s: x(train) @ 2}
"""
TOLD = """
title: Particle on a curve
coordinates: {x: m, y: m}
points: {A: [x, y]}
bodies: {P: {particle: A, mass: 2 kg}}
motion: ["x = 2 m/s^2 * t^2", "y = 1 m/s^3 * t^3"]
instant: [t = 1 s]
find: {a: a(P).mag, T: KE(P)}
"""
HANGS = """
title: Bob that hangs on a crank
points: {O: [0, 0], A: [0.1 m, 0], P: [0.3 m, -0.3 m]}
bodies: {crank: {rod: [O, A], mass: 1 kg}, bob: {particle: P, mass: 2 kg}}
joints:
  - pin: {at: O, between: [ground, crank]}
  - link: {between: [A, P]}
motion: [omega(crank) = 3 rad/s]
instant: [v(P).x = 0]
find: {a: a(P).mag}
"""


def test_accelerations_of_a_motion_that_is_told() -> None:
    found = solve(WHEEL)
    assert first(found["a"]) == pytest.approx(-(2**2) / 0.3)
    assert first(found["alpha"]) == pytest.approx(-1 / 0.3)
    assert first(solve(TRAIN)["s"]) == pytest.approx((400 - 9) / 4)


def test_an_energy_of_a_motion_that_is_told() -> None:
    found = solve(TOLD)
    assert first(found["a"]) == pytest.approx((16 + 36) ** 0.5)
    assert first(found["T"]) == pytest.approx(25)


def test_where_weight_has_a_part_the_plane_is_asked_for() -> None:
    with pytest.raises(NoSolution) as refused:
        solve(HANGS)
    (why,) = refused.value.diagnostics
    assert (why.code, why.mark.line) == ("PL450", 4)
    assert "the file does not say in which plane" in why.message


@pytest.mark.parametrize("asked", ["reaction(C).y", "N(C)"])
def test_forces_need_it_at_once(asked: str) -> None:
    _, wrong = load_text(WHEEL.replace("alpha(wheel)", asked))
    assert [d.code for d in wrong] == ["PL450"]


PENDULUM = """
title: Pendulum made of a rod and a disk
points: {O: [0, 0], E: [0, -1 m], K: [0, -1.2 m]}
bodies: {pendulum: {parts: [{rod: [O, E], mass: 2 kg}, {disk: K, radius: 0.2 m, mass: 3 kg}]}}
joints:
  - pin: {at: O, between: [ground, pendulum]}
instant: [omega(pendulum) = 1 rad/s, alpha(pendulum) = 2 rad/s^2]
find: {FIND}
"""


def test_an_acceleration_that_is_stated_of_a_composite_body() -> None:
    """Its masses tell where its mass centre is, and no more."""
    found = solve(PENDULUM.replace("FIND", "x: a(K).x, y: a(K).y, G: a(pendulum).mag, T: KE(pendulum)"))
    inertia = 2 / 3 + 3 * 0.2**2 / 2 + 3 * 1.2**2
    expected = (2.4, 1.2, 0.92 * 5**0.5, inertia / 2)
    assert [float(found[n].values[0]) for n in ("x", "y", "G", "T")] == pytest.approx(expected)


def test_a_reaction_is_another_matter() -> None:
    with pytest.raises(FileProblem) as raised:
        solve(PENDULUM.replace("FIND", "R: reaction(O).y"))
    assert raised.value.diagnostics[0].code == "PL450"
