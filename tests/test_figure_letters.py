"""What a textbook's figure names beside a scene: letters of springs, lengths, angles, bodies."""

from __future__ import annotations

import pytest

from planar_cli.figures.drawn import named_body
from planar_cli.figures.illustrated import figures_of, illustrated
from planar_cli.formats._paper import runs_of
from planar_cli.problem.structure import load_text
from planar_cli.report.marks import Coil, Dashpot, Mark
from planar_cli.report.narrate import narrate
from planar_cli.solve.run import solve_problem


def scene(text: str) -> tuple[Mark, ...]:
    """The marks of the scene of a problem."""
    solution = solve_problem(load_text(text, "x.yaml")[0])
    return dict(figures_of(illustrated(narrate(solution), solution)))["scene"].panels[0].marks


def told(mark: Mark) -> str:
    return "".join(run.text for run in runs_of(getattr(mark, "words", ())))


def test_springs_and_dampers_have_their_letters_and_nothing_stands_beside_what_a_case_leaves_out() -> None:
    marks = scene(
        """
title: Block between spring and dampers
plane: horizontal
given: {k: 200 N/m}
points: {O: [0, 0], P: [0.5 m, 0]}
bodies: {block: {particle: P, mass: 2 kg}}
joints:
  - guide: {point: P, along: 0 deg}
loads:
  - spring: {between: [O, P], stiffness: k, natural_length: 0.3 m}
  - damper: {between: [O, P], coefficient: 20 N*s/m, name: one}
  - damper: {between: [O, P], coefficient: 0 N*s/m, name: other}
instant: [v(P).x = 3 m/s]
find: {a: a(block).x}
"""
    )
    assert [told(m) for m in marks if isinstance(m, Coil)] == ["k"]
    assert [told(m) for m in marks if isinstance(m, Dashpot)] == ["c", ""]


@pytest.mark.parametrize(
    ("name", "runs"),
    [("gear_A", [("gear", False), ("A", True)]), ("front_wheel", [("front wheel", False)]), ("B", [("B", False)])],
)
def test_a_short_last_piece_of_a_name_is_an_index(name: str, runs: list[tuple[str, bool]]) -> None:
    assert [(r.text, r.index) for r in runs_of(named_body(name))] == runs
