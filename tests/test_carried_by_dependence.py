"""Own values are carried by what rests on what in the equations, in whatever order the finds are asked."""

from __future__ import annotations

from pathlib import Path

import pytest
from homework_made import SLOPE, homework_of, set_of

from planar_cli.homework.grading.dependence import behind_each, in_turn
from planar_cli.homework.grading.grading_made import grading_of
from planar_cli.homework.sets.paper import Submission
from planar_cli.homework.variants.worked_problem import read_and_solve

ACCELERATION = "{a: a(block).mag}"
NORMAL_LAST, NORMAL_FIRST = "{a: a(block).mag, N: N(A)}", "{N: N(A), a: a(block).mag}"
CRANK = """
given: {r: 120 mm, l: 400 mm, n: 120 rpm, phi: 60 deg}
points: {O: [0, 0], A: {from: O, distance: r, angle: phi}, B: {y: 0 m, distances: {A: l}, side: right}}
bodies: {crank: {rod: [O, A]}, rod: {rod: [A, B]}}
joints:
  - pin: {at: O, between: [ground, crank]}
  - pin: {at: A, between: [crank, rod]}
  - guide: {point: B, along: 0 deg}
motion: [omega(crank) = -n]
find: {v_B: v(B).x, omega_AB: omega(rod), v_A: v(A)}
"""
SWING = """
plane: vertical
given: {l: 2 m, beta: 60 deg, m: 1 kg}
points: {O: [0, 0], A: {from: O, distance: l, angle: beta - 90 deg}}
bodies: {rod: {rod: [O, A], mass: m}}
joints: [{pin: {at: O, between: [ground, rod]}}]
cases:
  swing:
    states:
      1: [t = 0, at rest]
      2: [theta(rod) = -90 deg]
    find: {T: t @ 2}
  after:
    given: {w: 3 rad/s / (1 s) * swing.T}
    instant: [omega(rod) = w]
    find: {v: v(A).mag}
"""


def verdicts(folder: Path, text: str, answers: dict[str, str]) -> dict[str, tuple[str, tuple[str, ...]]]:
    homework_set = set_of(folder, p=text)
    homework = homework_of(homework_set)
    handed = Submission("ann", 0, tuple(("p", find, typed) for find, typed in answers.items()))
    graded = grading_of(homework_set, homework)()(handed).graded
    return {one.find: (one.told, one.carried) for one in graded}


@pytest.mark.parametrize("finds", [NORMAL_LAST, NORMAL_FIRST])
def test_the_order_of_the_finds_does_not_matter(finds: str, tmp_path: Path) -> None:
    """N = m g sin β is wrong, and a = g sin β - μ N/m follows from it."""
    found = verdicts(tmp_path, SLOPE.replace(ACCELERATION, finds), {"N": "9.81 N", "a": "3.924 m/s^2"})
    assert found == {"N": ("wrong", ()), "a": ("carried", ("N",))}


def test_an_own_vector_is_carried_into_finds_before_it(tmp_path: Path) -> None:
    """v_A with sine and cosine exchanged: ω = -v_Ay/(l cos ψ), v_B = v_Ax + v_Ay tan ψ."""
    found = verdicts(
        tmp_path, CRANK, {"v_B": "1.105 m/s", "omega_AB": "3.380 rad/s ccw", "v_A": "[0.7540, -1.306] m/s"}
    )
    assert found["v_A"] == ("wrong", ())
    assert found["omega_AB"] == ("carried", ("v_A",))
    assert found["v_B"][0] == "carried"


def test_what_rests_on_each_other_is_carried_in_the_order_of_the_file(tmp_path: Path) -> None:
    (tmp_path / "p.yaml").write_text(CRANK.replace("{v_B", "{v: v(A).mag, omega: omega(crank), v_B"))
    behind = dict(behind_each(read_and_solve(str(tmp_path / "p.yaml"), "p")))
    assert behind["omega"] == ("v",)
    assert "omega" not in behind.get("v", ())


def test_what_is_followed_in_numbers_is_carried_into_a_case_that_uses_it(tmp_path: Path) -> None:
    """T is a number of the motion alone; v = 3 T l follows from it."""
    found = verdicts(tmp_path, SWING, {"T": "1.00 s", "v": "6.00 m/s"})
    assert found == {"T": ("wrong", ()), "v": ("carried", ("T",))}


def test_each_find_comes_behind_those_on_which_it_rests() -> None:
    assert list(in_turn(["a", "F", "N"], {"a": ("F", "N"), "F": ("N",)})) == [2, 1, 0]
    assert list(in_turn(["a", "b"], {})) == [0, 1]


BLOW = """
plane: horizontal
given: {m: 0.4 kg, M: 1.6 kg, u: 6 m/s, e: 0.7}
points: {A: [0, 0], B: [1 m, 0]}
bodies: {ball: {particle: A, mass: m}, block: {particle: B, mass: M}}
joints:
  - impact: {between: [ball, block], normal: 0 deg, restitution: e}
states:
  1: [v(ball).x = u, v(ball).y = 0, block at rest]
  2: [just after 1]
find: {v_ball: v(ball).x @ 2, v_block: v(block).x @ 2, p: momentum(block).x @ 2}
"""


@pytest.mark.parametrize(
    ("block", "told"),
    [("1.2 m/s", "carried"), ("2.25 m/s", "carried"), ("1.7 m/s", "wrong"), ("2.04 m/s", "right")],
)
def test_of_two_equations_either_may_carry(block: str, told: str, tmp_path: Path) -> None:
    """With v_ball = -3 m/s: by restitution v_block = v_ball + e u, by momentum m (u - v_ball)/M."""
    found = verdicts(tmp_path, BLOW, {"v_ball": "-3 m/s", "v_block": block, "p": "3.264 N*s"})
    assert found["v_ball"] == ("wrong", ())
    assert found["v_block"] == (told, ("v_ball",) if told == "carried" else ())


PULLED = """
plane: vertical
given: {m: 40 kg, F: 200 N, beta: 30 deg, mu: 0.25, d: 6 m}
points: {P: [0, 0]}
surfaces: {floor: {through: P, angle: 0 deg}}
bodies: {sled: {particle: P, mass: m}}
joints:
  - contact: {between: [sled, floor], at: P, mu: mu}
loads:
  - force: {body: sled, magnitude: F, angle: beta}
states:
  1: [t = 0, at rest]
  2: [x(sled) = d]
find: {v: v(sled).x @ 2, t_d: t @ 2, a: a(sled).x @ 1}
"""


def test_what_follows_from_one_wrong_value_is_carried_beside_other_wrong_ones(tmp_path: Path) -> None:
    """With a = 3.2 m/s²: t = √(2 d/a) = 1.936 s, whatever v is; v = 6 m/s follows from nothing."""
    found = verdicts(tmp_path, PULLED, {"a": "3.200 m/s^2", "v": "6.000 m/s", "t_d": "1.936 s"})
    assert found == {"a": ("wrong", ()), "v": ("wrong", ()), "t_d": ("carried", ("a",))}
