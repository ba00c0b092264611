"""A weight that goes down by a cord from a drum: m a with the wrong sign in one equation, W in place of W/g."""

from __future__ import annotations

import pytest
from homework_made import graded, homework_of, set_of

from planar_cli.homework.sets.ready import Homework

HOIST = """
plane: vertical
given: {W: 80 lbf, W_A: 40 lbf, R: 10 in, k_O: 8 in, M: 5 lbf*ft, h: 4 ft, g: 32.2 ft/s^2}
points: {O: [0, 0], S: [-R, 0], A: [-R, -h]}
bodies:
  drum: {disk: O, radius: R, weight: W, radius_of_gyration: k_O}
  A: {particle: A, weight: W_A}
joints:
  - pin: {at: O, between: [ground, drum]}
  - rope: {path: [S on drum, A], name: cord_A}
loads:
  - torque: {body: drum, moment: -M}
instant: [at rest]
find: {T_A: tension(cord_A), alpha: alpha(drum)}
"""
# By hand: α = (R W_A - M) g/(W k² + W_A R²) = 14.40 rad/s², T_A = W_A (1 - R α/g) = 25.09 lbf.


@pytest.fixture(scope="module")
def homework(tmp_path_factory: pytest.TempPathFactory) -> Homework:
    return homework_of(set_of(tmp_path_factory.mktemp("hoist"), hoist=HOIST))


@pytest.mark.parametrize(
    ("find", "typed"),
    [
        # W_A (1 + R α/g), with the right α.
        ("T_A", "54.91 lbf"),
        # (R W_A - M) g/(W k² - W_A R²), as the wrong T_A goes into the moments about O.
        ("alpha", "117.3 rad/s^2"),
    ],
)
def test_the_acceleration_has_the_wrong_sign(homework: Homework, find: str, typed: str) -> None:
    one = graded(homework, f"hoist.{find}", typed)
    assert one.mistakes == ("acceleration-reversed",)
    assert one.feedback == "the acceleration has the wrong sign in the equation of A along y"


@pytest.mark.parametrize(
    "typed",
    [
        # (R W_A - M)/(W k² + W_A R²): the weight in place of the mass, and the weights as they are.
        "0.4474 rad/s^2",
        # Pounds are taken for a mass: (R W_A g - M)/(W k² + W_A R²).
        "16.87 rad/s^2",
    ],
)
def test_the_weight_for_the_mass(homework: Homework, typed: str) -> None:
    one = graded(homework, "hoist.alpha", typed)
    assert one.mistakes == ("mass-for-weight",)
    assert one.feedback == "the weight stands where the mass W/g belongs"


@pytest.mark.parametrize(
    ("find", "typed", "letter"),
    [
        # (R W_A - M)/(W k²/g + W_A R²): the weight of A in place of its mass, that of the drum divided by g.
        ("alpha", "0.9810 rad/s^2", "m_A"),
        # (R W_A - M)/(W k² + W_A R²/g).
        ("alpha", "0.7780 rad/s^2", "m_drum"),
        # W_A (1 - R α/g) with that α.
        ("T_A", "7.300 lbf", "m_A"),
    ],
)
def test_the_weight_for_the_mass_of_one_body(homework: Homework, find: str, typed: str, letter: str) -> None:
    one = graded(homework, f"hoist.{find}", typed)
    assert one.mistakes == ("mass-for-weight",)
    assert one.feedback == f"the weight stands where the mass {letter} = W/g belongs"
