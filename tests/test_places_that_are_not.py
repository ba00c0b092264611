"""Places that no point can have, and letters that no numbers fulfil: which, by how much, and what to write."""

from __future__ import annotations

from pathlib import Path

import pytest

from planar_cli.commands._limit import WORK, at_work
from planar_cli.errors import FileProblem
from planar_cli.homework.checking.checking import read
from planar_cli.solve.run import solve_problem

ROD = """plane: vertical
given: {l: 3 m, d: 5 m, k: 1 m}
POINTS
bodies: {rod: {rod: [A, B], mass: 2 kg}}
joints:
  - pin: {at: A, between: [ground, rod]}
instant: [at rest]
find: {al: alpha(rod)}
"""
PLACES = {
    "C: [0, 0], B: {from: A, towards: C, distance: l}": (
        "PL510",
        "B: A and C are the same place, which gives no direction",
        "name another point, or write `{from: A, distance: …, angle: 30 deg}`",
    ),
    "C: [d, 0], B: {y: 1 m, line: [C, 0 deg]}": (
        "PL512",
        "B: the line of that y and the line through C are parallel, and meet nowhere",
        "turn the line",
    ),
    "C: [d, 0], B: {distances: {A: k, C: 2 m}}": (
        "PL513",
        "B: A and C are 5 m apart, and 1 m and 2 m reach only 3 m",
        "make a distance larger",
    ),
    "C: [1 m, 0], B: {distances: {A: d, C: 200 cm}}": (
        "PL513",
        "B: A and C are only 1 m apart, and 5 m and 2 m differ by 3 m",
        "make the larger distance smaller",
    ),
    "B: {y: 4 m, distances: {A: l}}": (
        "PL513",
        "B: the line of that y passes A at 4 m, and the distance is only 3 m",
        "make a distance larger",
    ),
    "C: [d, 0], B: {distances: {A: l, C: 4 m}}": (
        "PL514",
        "B: two places fit, above and below of each other",
        "add `side: above`, or below",
    ),
    "C: [d, 0], B: {distances: {A: l, C: 4 m}, side: left}": (
        "PL515",
        "B: two places fit, above and below of each other, and none is left of the other",
        "write `side:` with `above` or `below`",
    ),
}


def refused(folder: Path, points: str, more: str = "") -> tuple[str, str, str]:
    path = folder / "rod.yaml"
    path.write_text(ROD.replace("POINTS", f"{more}points: {{A: [0, 0], {points}}}"), encoding="utf-8")
    with pytest.raises(FileProblem) as told:
        solve_problem(read(str(path)))
    (diagnostic,) = told.value.diagnostics
    assert diagnostic.mark.line > 1
    return diagnostic.code, diagnostic.message, diagnostic.hint


@pytest.mark.parametrize("points", PLACES)
def test_places(points: str, tmp_path: Path) -> None:
    code, message, hint = refused(tmp_path, points)
    expected, said, repair = PLACES[points]
    assert (code, message) == (expected, said.replace("200 cm", "2 m"))
    assert repair in hint


@pytest.mark.slow
@pytest.mark.parametrize(
    ("assumed", "said"),
    [
        ("[x < y, y < x]", "no numbers were found for which `y < x` holds beside `x < y`"),
        ("[x > 3 m, x < 2 m]", "no numbers were found for which `x < 2 m` holds beside `x > 3 m`"),
        ("[x^2 + y^2 < 0*x]", "no numbers were found for which `x^2 + y^2 < 0*x` holds"),
    ],
)
def test_assumptions(assumed: str, said: str, tmp_path: Path) -> None:
    code, message, _ = refused(tmp_path, "B: [x + y, 0]", f"assume: {assumed}\nsymbols: {{x: m, y: m}}\n")
    assert (code, message) == ("PL532", said)


def test_an_equation_gives_a_letter(tmp_path: Path) -> None:
    path = tmp_path / "rod.yaml"
    text = ROD.replace("POINTS", "symbols: {x: m, y: m}\nassume: [x = 2*y, y > 1 m]\npoints: {A: [0, 0], B: [x, 0]}")
    path.write_text(text + "answers: {al: -3*g/(4*y)}\n", encoding="utf-8")
    problem = read(str(path))
    assert [s.name for s in problem.symbols] == ["y"]
    assert solve_problem(problem).parts[0].found[0].expressions is not None


def test_what_was_being_worked_on() -> None:
    assert at_work(None) == "the file was being worked on"
    assert all(words and hint for _, words, hint in WORK)
