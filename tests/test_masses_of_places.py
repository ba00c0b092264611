"""Masses that are written with places: chains that are lifted, drums that wind up. By hand: d(m v)/dt = ΣF, with what
comes up from rest.
"""

from __future__ import annotations

from math import sqrt

import numpy as np
import pytest
from answered import assert_close, solve

from planar_cli.errors import FileProblem
from planar_cli.problem.structure import load_text
from planar_cli.simulate.run import Settings, simulate

CHAIN = """
title: Chain that is lifted out of a heap
plane: vertical
given: {rho: 2.5 kg/m, P: 60 N, y_0: 0.5 m}
bodies: {end: {particle: [0, y_0], mass: rho*y(end)}}
joints:
  - guide: {point: end, along: 90 deg}
loads:
  - force: {body: end, magnitude: P, angle: 90 deg, name: pull}
  - stream: {body: end, rate: rho*v(end).y, enters: {at: end, speed: v(end).y, angle: -90 deg}, name: links}
"""
STATES = """
states: {1: [t = 0, at rest], 2: [y(end) = 2 m], 3: [y(end) is largest]}
find:
  v: v(end).y @ 2
  top: y(end) @ 3
  m: mass(end) @ 2
  rate: dot(KE(end)) @ 2
  W: work(pull) @ 1->2
  KE: KE(all) @ 2
"""
DRUM = """
title: Drum that winds up a cable which comes without speed
plane: horizontal
given: {rho: 2 kg/m, M_0: 5 kg, R: 0.3 m, M: 4 N*m}
points: {O: [0, 0]}
bodies: {drum: {disk: O, radius: R, mass: M_0 + rho*R*theta(drum)}}
joints:
  - pin: {at: O, between: [ground, drum]}
loads:
  - torque: {body: drum, moment: M}
  - stream: {body: drum, rate: rho*R*omega(drum), enters: {at: O, speed: 0 m/s, angle: 0 deg}}
states: {1: [t = 0, at rest], 2: [theta(drum) = 10 rad]}
find: {omega: omega(drum) @ 2, I: I(drum) @ 2, growth: dot(I(drum)) @ 2}
"""
RHO, P, G, START = 2.5, 60.0, 9.81, 0.5


def written_with_a_coordinate(text: str) -> str:
    """The same, the place of the end called s."""
    named = text.replace(
        "bodies: {end: {particle: [0, y_0]", "coordinates: {s: m}\npoints: {E: [0, s]}\nbodies: {end: {particle: E"
    )
    return named.replace("mass: rho*y(end)", "mass: rho*s").replace("t = 0, at rest", "t = 0, s = y_0, at rest")


def square(y: float) -> float:
    """v² of the chain's end: (m v)²/2 is the integral of m times the force."""
    return 2 / (RHO * y) ** 2 * (RHO * P * (y**2 - START**2) / 2 - RHO**2 * G * (y**3 - START**3) / 3)


def by_steps(text: str) -> dict[str, float]:
    """The same by following the motion, whose balances of energy and momentum must add up."""
    problem, _ = load_text(text)
    assert problem is not None
    found = simulate(problem, Settings(momenta=True))
    assert not found.run.trajectory.outcome.refused
    return {a.name: a.values[0] for a in found.answers if a.values}


@pytest.mark.parametrize("text", [CHAIN + STATES, written_with_a_coordinate(CHAIN + STATES)])
def test_a_chain_is_lifted(text: str) -> None:
    v = sqrt(square(2.0))
    truth = {"v": v, "m": RHO * 2, "W": P * 1.5, "KE": RHO * v**2}
    truth["rate"] = v * (P - RHO * 2 * G - RHO * v**2) + RHO * v**3 / 2
    found, followed = solve(text), by_steps(text)
    for name, number in truth.items():
        assert_close(found[name], number)
        assert followed[name] == pytest.approx(number, rel=1e-9)
    top = [y for y in np.roots([-RHO * G / 3, P / 2, 0, RHO * G * START**3 / 3 - P * START**2 / 2]) if y > 2]
    assert followed["top"] == pytest.approx(top[0], rel=1e-9)
    assert_close(found["top"], top[0])


def test_a_pull_at_a_constant_speed_loses_as_much_as_the_links_gain() -> None:
    text = CHAIN.replace("magnitude: P", "magnitude: rho*g*y(end) + rho*v(end).y^2")
    text += "states: {1: [t = 0, v(end).y = 2 m/s], 2: [y(end) = 1.5 m]}\n"
    text += "find: {W: work(pull) @ 1->2, KE: KE(all) @ 2 - KE(all) @ 1, v: v(end).y @ 2}\n"
    lifted, gained = RHO * G * (1.5**2 - START**2) / 2, RHO * 1.0 * 2.0**2 / 2
    found, followed = solve(text), by_steps(text)
    for name, number in {"W": lifted + 2 * gained, "KE": gained, "v": 2.0}.items():
        assert_close(found[name], number)
        assert followed[name] == pytest.approx(number, rel=1e-9)


def test_the_force_at_an_instant() -> None:
    text = CHAIN.replace("P: 60 N, ", "").replace("given", "unknowns: {P: N}\ngiven")
    text += "instant: [v(end).y = 1.5 m/s, a(end).y = 0]\nfind: {P: P, growth: dot(mass(end))}\n"
    found = solve(text)
    assert_close(found["P"], RHO * START * G + RHO * 1.5**2)
    assert_close(found["growth"], RHO * 1.5)


def test_a_drum_winds_up_a_cable() -> None:
    """I ω d(I ω) = M I dθ."""
    m, r, turned = 5.0, 0.3, 10.0
    inertia = (m + 2 * r * turned) * r**2 / 2
    omega = sqrt(2 * 4 * (m * turned + 2 * r * turned**2 / 2) * r**2 / 2) / inertia
    found, followed = solve(DRUM), by_steps(DRUM)
    for name, number in {"omega": omega, "I": inertia, "growth": 2 * r**3 / 2 * omega}.items():
        assert_close(found[name], number)
        assert followed[name] == pytest.approx(number, rel=1e-9)


@pytest.mark.parametrize(
    ("old", "new", "code"),
    [
        ("rho*y(end)", "rho*v(end).y*(1 s)", "PL413"),
        ("rho*y(end)", "rho*y(end) @ 1", "PL413"),
        ("rho*y(end)", "rho*theta(end)", "PL224"),
        ("y_0: 0.5 m", "y_0: 0 m", "PL520"),
        ("y_0: 0.5 m", "y_0: -1 m", "PL520"),
        ("  - stream", "  - drag: {body: end, magnitude: 1 N}\n#", "PL464"),
    ],
)
def test_refused(old: str, new: str, code: str) -> None:
    text = CHAIN + "states: {1: [t = 0, at rest], 2: [t = 1 s]}\nfind: {y: y(end) @ 2}\n"
    assert old in text
    with pytest.raises(FileProblem) as error:
        solve(text.replace(old, new))
    assert code in {d.code for d in error.value.diagnostics}


def test_nothing_comes_where_nothing_moves() -> None:
    text = CHAIN.split("  - stream", maxsplit=1)[0].replace("P: 60 N, ", "").replace("given", "unknowns: {P: N}\ngiven")
    assert_close(solve(text + "instant: [at rest, a(end).y = 0]\nfind: {P: P}\n")["P"], RHO * START * G)
