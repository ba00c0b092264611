"""What would hide something in a scene, or say nothing there: arrows on each other, a length that is zero."""

from __future__ import annotations

from pathlib import Path

from answered import GUN

from planar_cli.figures.illustrated import figures_of, illustrated
from planar_cli.formats._on_paper import Scale, in_rows
from planar_cli.homework.checking.checking import read, solve_and_compare
from planar_cli.report.document.blocks import line
from planar_cli.report.document.marks import Arrow, Dimension, Mark, Tag
from planar_cli.report.document.mentioned import pieces_of
from planar_cli.report.page.narrate import narrate

PUSHED = """
title: A block that is pushed
plane: horizontal
given: {m: 3 kg, F: 60 N, v_A: 0.8 m/s}
bodies: {A: {particle: [0, 0], mass: m}}
joints:
  - guide: {point: A, along: 0 deg}
loads:
  - force: {body: A, magnitude: F, angle: 0 deg}
instant: [v(A).x = v_A]
find: {a: a(A).x}
"""
LADDER = """
title: A rod on a wheel that slides down a wall
plane: vertical
given: {m: 12 kg, m_w: 4 kg, l: 1 m, R: 0.2 m}
coordinates: {phi: deg}
points: {A: [l*sin(phi), R], B: [0, R + l*cos(phi)], O: [0, 0]}
surfaces:
  floor: {through: O, angle: 0 deg}
bodies:
  AB: {rod: [A, B], mass: m}
  wheel: {disk: A, radius: R, mass: m_w}
joints:
  - guide: {point: B, along: 90 deg}
  - pin: {at: A, between: [AB, wheel]}
  - rolling: {between: [wheel, floor]}
states: {1: [phi = 30 deg, at rest], 2: [phi = 90 deg]}
find: {omega: omega(AB) @ 2}
"""


def scene(folder: Path, text: str) -> tuple[Mark, ...]:
    path = folder / "problem.yaml"
    path.write_text(text, encoding="utf-8")
    solution, _ = solve_and_compare(read(str(path)))
    return next(figures_of(illustrated(narrate(solution), solution)))[1].panels[0].marks


def test_a_velocity_lies_beside_the_force_along_it(tmp_path: Path) -> None:
    arrows = [m for m in scene(tmp_path, PUSHED) if isinstance(m, Arrow)]
    assert {m.style: m.aside > 0 for m in arrows} == {"force": False, "velocity": True}


def test_no_length_is_zero(tmp_path: Path) -> None:
    lengths = [m for m in scene(tmp_path, GUN) if isinstance(m, Dimension)]
    assert lengths
    assert not [m for m in lengths if "'0'" in repr(list(pieces_of(m.words)))]


def test_dimensions_of_one_direction_lie_in_rows() -> None:
    """The longer one farther out, but not where one follows the other, or lies on the other side."""
    word = line("l")
    short, long = Dimension((0, 0), (1, 1), word), Dimension((0, 0), (2, 2), word)
    after, below = Dimension((1, 1), (2, 2), word), Dimension((0, 0), (2, 2), word, side=-1)
    back = Dimension((2, 2), (0, 0), word, side=-1)

    def rows(*marks: Mark) -> list[int]:
        return [m.row for m in in_rows(marks, Scale(100.0)) if isinstance(m, Dimension)]

    assert rows(long, short) == [1, 0]
    assert rows(short, after, below) == [0, 0, 0]
    assert rows(short, back) == [0, 1]


def test_a_state_has_one_name_where_bodies_hang_together(tmp_path: Path) -> None:
    tags = [m.words for m in scene(tmp_path, LADDER) if isinstance(m, Tag)]
    assert [tags.count(line(state)) for state in "12"] == [1, 1]
