"""A page in feet and pounds: no newton, joule or metre in any of its values, and every line is true in feet."""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import fields, is_dataclass
from pathlib import Path
from typing import Any

import pytest
from conftest import ROOT
from printed import Page, equations
from worked import name_of, worked

from planar_cli.homework.checking.checking import solve_and_compare
from planar_cli.problem.implied.customary import ATOM, NEUTRAL_ATOMS, US_ATOMS
from planar_cli.problem.structure import load_text
from planar_cli.report.document.blocks import Equation, Math, Text, Value
from planar_cli.report.motion.motion import MotionTelling
from planar_cli.report.notation.notation import plain
from planar_cli.report.page.narrate import Voice, narrate
from planar_cli.report.words.motion_phrases import motion_phrases
from planar_cli.solve.solved_problem import Solution

IN_FEET = re.compile(r"\d[* ]*(?:lbf|lb|ft)\b")
FILES = sorted(
    p
    for p in (ROOT / "problems").rglob("*.yaml")
    if p.parent.name != "hard" and IN_FEET.search(p.read_text(encoding="utf-8").partition("given:")[2])
)
OFTEN = 3
SHARED_OUT = [p if i % OFTEN == 0 else pytest.param(p, marks=pytest.mark.slow) for i, p in enumerate(FILES)]
IN_WORDS = re.compile(r"\d (?:N|J|kg|N·m|m/s|m/s²)(?![\w·/])")


def _parts(block: Any) -> Iterator[Any]:
    """All values and texts in a block, at any depth."""
    if isinstance(block, Value | Text):
        yield block
    elif isinstance(block, tuple):
        for part in block:
            yield from _parts(part)
    elif is_dataclass(block):
        for field in fields(block):
            yield from _parts(getattr(block, field.name))


@pytest.mark.parametrize("path", SHARED_OUT, ids=map(name_of, FILES))
def test_no_other_system_of_units(path: Path) -> None:
    solution = worked(path)[0]
    assert solution.problem.us
    for part in _parts(narrate(solution).blocks):
        if isinstance(part, Value):
            assert set(ATOM.findall(part.unit)) <= US_ATOMS | NEUTRAL_ATOMS, part
        else:
            assert not IN_WORDS.search(part.text), part


# --- every line in feet is true in feet ------------------------------------------------------------------------------

WRITTEN = {
    "collar": """
plane: vertical
given: {g: 32.2 ft/s^2, W: 10 lbf, k: 20 lbf/ft, l_0: 2 ft}
points: {C: [0, 4 ft], Q: [3 ft, 0]}
bodies: {collar: {particle: C, weight: W}}
joints: [{guide: {point: C, along: 90 deg, name: rod}}]
loads: [{spring: {between: [Q, C], stiffness: k, natural_length: l_0}}]
states: {top: [at rest], level: [y(collar) = 0], fast: [v(collar).mag is largest], low: [v(collar).y = 0]}
find: {a_0: a(collar).y @ top, v_level: v(collar).mag @ level, v_max: v(collar).mag @ fast, y_low: y(collar) @ low}
answers: {a_0: -186.76 ft/s^2, v_level: 27.79928 ft/s, v_max: 28.58540 ft/s, y_low: -66.56934 in}
tolerance: 0.0001
""",
    "rope": """
given: {u: 4 ft/s}
points: {D: [0, 16 ft], H: [0, 60 in], L: [-0.5 ft, 0]}
bodies: {crate: {particle: L}, hand: {particle: H}}
joints:
  - guide: {point: H, along: 0 deg}
  - guide: {point: L, along: 90 deg}
  - rope: {path: [H, D, [-0.5 ft, 16 ft], L], name: rope}
motion: [v(H).x = u]
states: {start: [t = 0], up: [y(crate) = 2 yd]}
find: {t_up: t @ up, v: v(crate).y @ up, a: a(crate).y @ up, v_mean: mean(v(crate).y) @ start->up}
answers: {t_up: 3.24037 s, v: 3.04976 ft/s, a: 0.394057 ft/s^2, v_mean: 1.85164 ft/s}
tolerance: 0.0001
""",
    "block": """
plane: vertical
given: {W: 644 lbf, mu: 0.3}
points: {A: [0, 0]}
surfaces: {floor: {through: A, angle: 0 deg}}
bodies: {block: {particle: A, weight: W}}
joints: [{contact: {between: [block, floor], mu: mu, name: slide}}]
states: {1: [v(block).x = 60 mi/h, t = 0], 2: [at rest]}
find: {s: x(block) @ 2, t: t @ 2, m: W/g}
answers: {s: 401.014 ft, t: 9.11396 s, m: 20.0092 slug}
tolerance: 0.0001
""",
}
FIGURES, ROUNDED = 6, 1e-3


def _wrong(solution: Solution) -> list[str]:
    """The lines that do not hold for the numbers of their letters in ft, slug, s."""
    found = []
    for part in solution.parts:
        if part.motion is not None:
            page = Page(part.motion.value, us=True)
            told = tuple(MotionTelling(part.motion, motion_phrases(part.motion, FIGURES), 1).blocks(1))
        elif len(solution.parts) == len(part.instants) == 1:
            page, told = Page(part.instants[0].value, us=True), narrate(solution, Voice(figures=FIGURES)).blocks
        else:
            continue
        found += [w for e in equations(told) for w in page.wrong(e, ROUNDED)]
    return found


@pytest.mark.parametrize("path", SHARED_OUT, ids=map(name_of, FILES))
def test_lines_are_true_in_feet(path: Path) -> None:
    assert not _wrong(worked(path)[0])


@pytest.mark.parametrize("name", WRITTEN)
def test_numbers_written_with_units_are_in_feet(name: str) -> None:
    problem, wrong = load_text(WRITTEN[name])
    assert problem is not None, wrong
    solution, verdicts = solve_and_compare(problem)
    assert all(v.agrees for v in verdicts), verdicts
    assert not _wrong(solution)


def test_a_length_beside_a_letter_is_in_feet() -> None:
    problem, _ = load_text(WRITTEN["collar"])
    assert problem is not None
    lines = [
        plain(s.expr, s.values) for e in equations(narrate(solve_and_compare(problem)[0]).blocks) for s in _maths(e)
    ]
    assert any("√(9 + " in text for text in lines)
    assert not any("0.836" in text or "0.9144" in text for text in lines)


def _maths(block: Any) -> Iterator[Math]:
    if isinstance(block, Math):
        yield block
    elif isinstance(block, tuple):
        for part in block:
            yield from _maths(part)
    elif isinstance(block, Equation):
        yield from _maths(block.sides)


def test_all_cases_count_in_the_same_units() -> None:
    """Numbers of one case are used in others."""
    one, two = "one: {given: {l: 2 ft}, find: {x: l}}", "two: {given: {l: 1 m}, find: {y: one.x + l}}"
    text = f"points: {{A: [0, 0]}}\ncases: {{{one}, {two}}}"
    problem, wrong = load_text(text)
    assert problem is not None, wrong
    assert [case.problem.us for case in problem.cases] == [False, False]


@pytest.mark.parametrize(
    ("given", "place", "feet"),
    [("{T: 2 s}", "[7 ft, -1 ft]", True), ("{T: 2 s}", "[7 ft, 0.3 m]", False), ("{l: 2 m}", "[7 ft, 1 ft]", False)],
)
def test_units_of_the_scene_count_where_none_are_given(given: str, place: str, feet: bool) -> None:
    problem, wrong = load_text(f"given: {given}\npoints: {{A: {place}}}\nfind: {{x: x(A)}}")
    assert problem is not None, wrong
    assert problem.us is feet
