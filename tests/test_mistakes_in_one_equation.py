"""Mistakes in one equation of several: a crate hauled up a ramp by a hanging block, and a pendulum given by weights."""

from __future__ import annotations

from pathlib import Path

import pytest
from homework_made import GATE, graded, homework_of, set_of

from planar_cli.homework.checking.answers import compare
from planar_cli.homework.sets.ready import Homework
from planar_cli.problem.structure import load_text
from planar_cli.solve.run import solve_problem

HAUL = """
plane: vertical
given: {m: 10 kg, beta: 30 deg, mu: 0.15, M: 6 kg, d: 350 mm, m_B: 18 kg}
points:
  C: [0, 0]
  T: {from: C, distance: 3 m, angle: beta}
  O: {from: T, distance: d/2, angle: beta - 90 deg}
  S: {from: O, distance: d/2, angle: 0 deg}
  B: {from: S, distance: 1 m, angle: -90 deg}
surfaces: {ramp: {through: C, angle: beta}}
bodies:
  crate: {particle: C, mass: m}
  pulley: {disk: O, radius: d/2, mass: M}
  block: {particle: B, mass: m_B}
joints:
  - contact: {between: [crate, ramp], at: C, mu: mu}
  - pin: {at: O, between: [ground, pulley]}
  - rope: {path: [C, T on pulley], name: rope1}
  - rope: {path: [B, S on pulley], name: rope2}
instant: [at rest]
find: {a: a(crate).along(beta), T_1: tension(rope1)}
"""
# By hand: a = (m_B g - m g sin β - μ m g cos β)/(m + m_B + M/2) = 3.703 m/s², T_1 = m (a + g sin β) + μ m g cos β.
# Of the gate by hand: ω = 5.667 rad/s.


@pytest.fixture(scope="module")
def homework(tmp_path_factory: pytest.TempPathFactory) -> Homework:
    return homework_of(set_of(tmp_path_factory.mktemp("one"), haul=HAUL, gate=GATE))


CRATE = "the equation of crate along the contact at C"


@pytest.mark.parametrize(
    ("place", "typed", "mistake", "said"),
    [
        ("haul.a", "2.544 m/s^2", "sine-for-cosine", f"sine and cosine of β are exchanged in {CRATE}"),
        ("haul.a", "2.718 m/s^2", "sine-for-cosine", "sine and cosine of β are exchanged"),
        ("haul.a", "5.285 m/s^2", "weight-left-out", f"this is the result without the weight in {CRATE}"),
        # It is 1.7 % off.
        ("haul.a", "3.639 m/s^2", "normal-force-is-weight", "the whole weight stands where its component"),
        ("haul.T_1", "86.08 N", "friction-left-out", f"this is the result without friction in {CRATE}"),
        ("haul.T_1", "73.33 N", "friction-reversed", f"the friction acts the other way in {CRATE}"),
        ("haul.T_1", "49.77 N", "weight-left-out", f"this is the result without the weight in {CRATE}"),
        ("gate.A", "52.35 lbf up", "weight-left-out", "the weight is missing in the forces"),
        ("gate.A", "22.0 lbf up", "centripetal-left-out", "the normal acceleration (ω² r or v²/ρ) is missing"),
        ("gate.omega", "4.138 rad/s cw", "weight-left-out", "this is the result without the weight of arm"),
        ("gate.omega", "5.523 rad/s cw", "diameter-for-radius", "D where D/2 belongs"),
        ("gate.omega", "3.128 rad/s cw", "gravity-in-metres", "g was put in as 9.81"),
    ],
)
def test_it_is_named(homework: Homework, place: str, typed: str, mistake: str, said: str) -> None:
    one = graded(homework, place, typed)
    assert one.verdict == "wrong"
    assert one.mistakes == (mistake,)
    assert said in one.feedback


def test_a_zero_component_that_is_solved_has_no_sign() -> None:
    problem, wrong = load_text(f"{GATE}answers: {{A: [0 lbf, 74.4 lbf]}}\n")
    assert problem is not None
    assert not wrong
    (verdict,) = compare(solve_problem(problem))
    assert verdict.agrees
    assert verdict.solved == "[0, 74.3523] lbf"


PULLED = """
plane: vertical
given: {m: 40 kg, F: 200 N, beta: 30 deg, gamma: 10 deg, mu: 0.25}
points: {P: [0, 0]}
surfaces: {floor: {through: P, angle: gamma}}
bodies: {sled: {particle: P, mass: m}}
joints:
  - contact: {between: [sled, floor], at: P, mu: mu}
loads:
  - force: {body: sled, magnitude: F, angle: beta + gamma}
instant: [at rest]
find: {N: N(P), a: a(sled).mag}
"""


@pytest.mark.parametrize(
    ("typed", "said"),
    [
        # m g cos γ without F sin β, and m g.
        ("386.4 N", "another force acts along the normal too"),
        ("392.4 N", "another force acts along the normal too"),
        # m g - F sin β.
        ("292.4 N", "the whole weight stands where its component along the normal belongs"),
    ],
)
def test_a_pull_that_is_forgotten_in_the_normal_force(typed: str, said: str, tmp_path: Path) -> None:
    made = homework_of(set_of(tmp_path, "tolerance: 0.005", sled=PULLED))
    one = graded(made, "sled.N", typed)
    assert one.mistakes == ("normal-force-is-weight",)
    assert said in one.feedback
