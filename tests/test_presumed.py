"""What a solution takes for granted of letters is said, and `assume` decides it."""

from __future__ import annotations

import re

import pytest

from planar_cli.errors import PlanarError
from planar_cli.formats.terminal import Terminal
from planar_cli.problem.structure import load_text
from planar_cli.report.page.narrate import narrate
from planar_cli.solve.run import solve_problem

ROPE = """
title: Two blocks and a rope
plane: horizontal
symbols: {%s, m: kg, F: N}
%s
points: {A: [a, 0], B: [b, 0]}
bodies: {p: {particle: A, mass: m}, q: {particle: B, mass: 2*m}}
joints:
  - guide: {point: A, along: 0 deg}
  - guide: {point: B, along: 0 deg}
  - rope: {path: [A, B], name: line}
loads:
  - force: {body: q, magnitude: F, angle: 0 deg}
instant: [at rest]
find: {T: tension(line)}
"""
STRIKE = """
title: Letters that may not approach
plane: horizontal
symbols: {%s, m: kg, e: 1}
%s
bodies: {p: {particle: [0, 0], mass: m}, q: {particle: [1 m, 0], mass: m}}
joints:
  - impact: {between: [p, q], restitution: e}
states: {1: [v(p).x = a, v(p).y = 0, v(q).x = b, v(q).y = 0], 2: [just after 1]}
find: {v: v(p).x @ 2}
"""


def told(text: str) -> str:
    problem, wrong = load_text(text)
    assert problem is not None, wrong
    return " ".join(Terminal().render(narrate(solve_problem(problem))).split())


@pytest.mark.parametrize(("scene", "unit"), [(ROPE, "m"), (STRIKE, "m/s")])
@pytest.mark.parametrize("letters", ["ab", "ba"])
def test_a_sign_that_the_file_leaves_open_is_said(scene: str, unit: str, letters: str) -> None:
    """It goes with the answer: whichever is taken."""
    text = told(scene % (", ".join(f"{x}: {unit}" for x in letters), ""))
    above = "Assume a > b" in text
    assert above != ("Assume b > a" in text)
    free = "T = 0 N" if scene is ROPE else "= a to the right Check"
    assert (free in text) == (above == (scene is ROPE))


@pytest.mark.parametrize("scene", [(ROPE, "m"), (STRIKE, "m/s")])
@pytest.mark.parametrize("assumed", ["a < b", "a > b"])
def test_what_is_assumed_is_no_news(scene: tuple[str, str], assumed: str) -> None:
    text = told(scene[0] % (f"a: {scene[1]}, b: {scene[1]}", f"assume: [{assumed}]"))
    assert set(re.findall("[ab] [<>] [ab]", text)) == {assumed}


def test_letters_of_unlike_size() -> None:
    text = told(ROPE % ("a: m, b: m", "assume: [b > 50*a]"))
    assert re.findall("[ab] [<>] (?:50 )?[ab]", text) == ["b > 50 a"]


@pytest.mark.slow
def test_no_letters_at_all() -> None:
    with pytest.raises(PlanarError, match="no numbers were found for which `a < b` holds beside `b < a`"):
        told(ROPE % ("a: m, b: m", "assume: [b < a, a < b]"))
