"""Inequalities of a first or later state: none is passed over, and the one that is false is told with its numbers."""

from __future__ import annotations

from pathlib import Path

import pytest

from planar_cli.errors import NoSolution
from planar_cli.homework.checking.checking import read
from planar_cli.problem.structure import load
from planar_cli.solve.run import solve_problem

CRATE = """plane: vertical
points: {P: [0, 0]}
surfaces: {floor: {through: P, angle: 0 deg}}
bodies: {crate: {particle: P, mass: 2 kg}}
joints:
  - contact: {between: [crate, floor], at: P, mu: 0.3}
states:
  1: [t = 0, v(crate).x = 5 m/s, v(crate).y = 0 FIRST]
  2: [v(crate).x = 0 SECOND]
find: {d: x(crate) @ 2 - x(crate) @ 1}
"""


def solved(folder: Path, first: str = "", second: str = "") -> None:
    path = folder / "crate.yaml"
    shown = CRATE.replace(" FIRST", f", {first}" if first else "").replace(" SECOND", f", {second}" if second else "")
    path.write_text(shown, encoding="utf-8")
    solve_problem(read(str(path)))


@pytest.mark.parametrize(
    ("first", "said"),
    [
        ("N(P) > 100 N", "does not hold"),
        ("t > 0", "state 1: `t > 0` does not hold: the sides are equal"),
        ("v(crate).x > 7 m/s", "state 1: `v(crate).x > 7 m/s` does not hold: the sides differ by 2 m/s"),
        ("x(crate) > 1 m", "state 1: `x(crate) > 1 m` does not hold: the sides differ by 1 m"),
        ("a(crate).x > 0", "does not hold at 1: the sides are -2.943 m/s^2 and 0 m/s^2"),
        ("friction(P).x > 0", "does not hold at 1: the sides are -5.886 N and 0 N"),
        ("2 m > 3 m", "`2 m > 3 m` does not hold: the sides are 2 m and 3 m"),
    ],
)
def test_false_at_the_first_state(first: str, said: str, tmp_path: Path) -> None:
    with pytest.raises(NoSolution) as told:
        solved(tmp_path, first)
    (diagnostic,) = told.value.diagnostics
    assert said in diagnostic.message
    assert diagnostic.code in ("PL616", "PL617")
    assert (diagnostic.mark.line, diagnostic.mark.column) == (8, 50)


@pytest.mark.parametrize(
    ("second", "code", "said"),
    [
        ("a(crate).x > 0", "PL617", "`a(crate).x > 0` does not hold at 2"),
        ("N(P) > 100 N", "PL617", "`N(P) > 100 N` does not hold"),
        ("x(crate) < 0", "PL621", "state 2 is never reached: v(crate).x = 0; x(crate) < 0"),
    ],
)
def test_false_at_a_later_state(second: str, code: str, said: str, tmp_path: Path) -> None:
    with pytest.raises(NoSolution) as told:
        solved(tmp_path, second=second)
    assert told.value.diagnostics[0].code == code
    assert said in told.value.diagnostics[0].message


@pytest.mark.parametrize("first", ["N(P) < 100 N", "x(crate) < 1 m", "a(crate).x < 0", "t >= 0", "2 m < 3 m"])
def test_true_ones_change_nothing(first: str, tmp_path: Path) -> None:
    solved(tmp_path, first, "a(crate).x <= 0")


MOTIONS = {
    "states: {1: [t = 0, v(b).x = 3 m/s, v(b).y = 0], 2: [x(b) = 30 m]}": (
        "PL621",
        "state 2 is never reached: x(b) = 30 m",
        "from t = 1.529 s on `x(b) = 30 m` stays as far off: the sides differ by 27.71 m",
    ),
}


@pytest.mark.parametrize("states", MOTIONS)
def test_states_that_never_come(states: str, tmp_path: Path) -> None:
    text = f"""plane: vertical
bodies: {{b: {{particle: [0, 0], mass: 2 kg}}}}
surfaces: {{floor: {{through: [0, 0], angle: 0 deg}}}}
joints:
  - contact: {{between: [b, floor], mu: 0.2}}
{states}
find: {{t: t @ 2}}
"""
    path = tmp_path / "block.yaml"
    path.write_text(text, encoding="utf-8")
    with pytest.raises(NoSolution) as told:
        solve_problem(read(str(path)))
    (diagnostic,) = told.value.diagnostics
    assert (diagnostic.code, diagnostic.message, diagnostic.hint) == MOTIONS[states]


PAIR = """bodies: {A: {particle: [0, 0]}}
motion: [MOTION]
states: {1: [t = 0], 2: [t = 5 s]}
find: {y: y(A) @ 2}
"""


def test_a_start_that_holds_both_ways(tmp_path: Path) -> None:
    path = tmp_path / "pair.yaml"
    path.write_text(PAIR.replace("MOTION", "v(A).mag = 3 m/s, v(A).x = 1 m/s"), encoding="utf-8")
    with pytest.raises(NoSolution) as told:
        solve_problem(read(str(path)))
    (diagnostic,) = told.value.diagnostics
    assert diagnostic.mark.line == 2
    assert diagnostic.code == "PL618"


def test_two_sizes_of_one_velocity(tmp_path: Path) -> None:
    path = tmp_path / "pair.yaml"
    path.write_text(PAIR.replace("MOTION", "v(A).mag = 3 m/s, v(A).mag = 4 m/s, v(A).angle = 30 deg"), encoding="utf-8")
    with pytest.raises(NoSolution) as told:
        solve_problem(read(str(path)))
    (diagnostic,) = told.value.diagnostics
    assert diagnostic.mark.line == 2
    assert "remains off" in diagnostic.message


def test_two_modes_of_one_joint(tmp_path: Path) -> None:
    path = tmp_path / "crate.yaml"
    path.write_text(
        CRATE.replace(" FIRST", ", mode(P) = slip, mode(P) = stick").replace(" SECOND", ""), encoding="utf-8"
    )
    found = load(str(path))[1]
    assert [(d.code, d.message) for d in found] == [("PL437", "`mode(P) = stick` contradicts `mode(P) = slip`")]
