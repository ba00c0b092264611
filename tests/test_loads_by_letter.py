"""A force without a name is called by its letter where its work is told."""

from __future__ import annotations

import pytest

from planar_cli.formats.terminal import Terminal
from planar_cli.problem.structure import load_text
from planar_cli.report.document.blocks import Equation, Name, line
from planar_cli.report.page.narrate import narrate
from planar_cli.report.words.loads_by_letter import with_loads_by_letter
from planar_cli.solve.run import solve_problem

PUSHED = """
title: Block that is pushed along a smooth floor
plane: horizontal
given: {m: 2 kg, F: 6 N, Q: 2 N, d: 3 m}
bodies: {block: {particle: [0, 0], mass: m}}
joints:
  - guide: {body: block, along: 0 deg}
loads:
  - force: {body: block, magnitude: F, angle: 0 deg}
states:
  1: [at rest]
  2: [x(block) = d]
find: {v: v(block).x @ 2}
"""


def _page(text: str) -> str:
    problem, wrong = load_text(text, "scene.yaml")
    assert problem is not None, wrong
    return " ".join(Terminal(width=200).render(narrate(solve_problem(problem))).split())


@pytest.mark.parametrize(
    ("named", "told"), [("angle: 0 deg}", "U of F = F d"), ("angle: 0 deg, name: push}", "U of the push = F d")]
)
def test_work_of_a_force(named: str, told: str) -> None:
    assert told in _page(PUSHED.replace("angle: 0 deg}", named))


@pytest.mark.parametrize(("named", "told"), [
    ("angle: 0 deg, name: gravity}", "U of gravity = 3 Q d"),
    ("angle: 0 deg, name: S}", "U of S = 3 Q d"),
    ("angle: 0 deg}", "U of the force on block = 3 Q d"),
])  # fmt: skip
def test_a_force_without_a_letter_is_called_by_what_it_is(named: str, told: str) -> None:
    text = PUSHED.replace("magnitude: F", "magnitude: 3 * Q").replace(" F: 6 N,", "")
    assert told in _page(text.replace("angle: 0 deg}", named))


@pytest.mark.parametrize(("other", "told"), [("Q", " of F"), ("F", " of the force block"), ("2 N", " of F")])
def test_a_letter_of_one_force(other: str, told: str) -> None:
    """Of two forces with the same letter it would be said of neither which is meant."""
    text = PUSHED.replace(
        "  - force", f"  - force: {{body: block, magnitude: {other}, angle: 180 deg, name: back}}\n  - force"
    )
    problem, wrong = load_text(text, "scene.yaml")
    assert problem is not None, wrong
    (equation,) = with_loads_by_letter([Equation((line(Name("U"), " of the force block"), line("1 J")))], problem)
    assert isinstance(equation, Equation)
    assert "".join(p.name if isinstance(p, Name) else p.text for p in equation.sides[0]) == f"U{told}"
