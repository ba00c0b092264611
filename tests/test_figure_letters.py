"""What a textbook's figure names beside a scene: letters of springs, lengths, angles, bodies."""

from __future__ import annotations

import math
from decimal import Decimal

import pytest
import sympy as sp
from conftest import PROBLEMS
from worked import worked

from planar_cli.errors import Mark
from planar_cli.figures.drawn import brief, named_body
from planar_cli.figures.illustrated import figures_of, illustrated
from planar_cli.formats._alike import table_of
from planar_cli.formats._paper import runs_of
from planar_cli.problem.language.parser import parse_side
from planar_cli.problem.structure import load_text
from planar_cli.report.document import marks as drawn_marks
from planar_cli.report.document.blocks import Forces, Line, Math, Name, Text, Value, line
from planar_cli.report.document.marks import Angle, Arrow, Coil, Dashpot, Dimension, Hatched, Polyline, Symbol
from planar_cli.report.page.narrate import narrate
from planar_cli.solve.run import solve_problem


def scene(text: str) -> tuple[drawn_marks.Mark, ...]:
    """The marks of the scene of a problem."""
    problem, wrong = load_text(text, "x.yaml")
    assert problem is not None, wrong
    solution = solve_problem(problem)
    return dict(figures_of(illustrated(narrate(solution), solution)))["scene"].panels[0].marks


def scene_of(name: str) -> tuple[drawn_marks.Mark, ...]:
    """The marks of the scene of a problem file."""
    solution = worked(next(p for p in PROBLEMS if p.match(f"{name}.yaml")))[0]
    return dict(figures_of(illustrated(narrate(solution), solution)))["scene"].panels[0].marks


def told(mark: drawn_marks.Mark) -> str:
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


ROLLING = """
title: Rolling disk
symbols: {r: m}
coordinates: {phi: rad}
points:
  O: [0, 0]
  G: [r*phi, r]
  P: {from: G, distance: r, angle: 270 deg - phi}
surfaces: {floor: {through: O, angle: 0 deg}}
bodies: {disk: {disk: G, radius: r, points: [P]}}
find: {r_P: r(P)}
"""


def test_the_angle_of_a_point_on_a_rim_lies_between_the_radii() -> None:
    marks = scene(ROLLING)
    (angle,) = (m for m in marks if isinstance(m, Angle))
    (radius,) = (m for m in marks if isinstance(m, Dimension) and told(m) == "r")
    assert told(angle) == "φ"
    assert math.remainder(angle.start + math.pi / 2, 2 * math.pi) == pytest.approx(0.0)
    assert angle.sweep < 0
    way = math.atan2(radius.end[1] - radius.start[1], radius.end[0] - radius.start[0])
    assert math.remainder(angle.start + angle.sweep - way, 2 * math.pi) == pytest.approx(0.0)


LADDER = """
title: Ladder
plane: vertical
given: {l: 4 m, beta: 50 deg}
points:
  A: [l*cos(beta), 0]
  B: [0, l*sin(beta)]
surfaces:
  floor: {through: A, angle: 0 deg}
  wall: {through: B, angle: 90 deg}
bodies: {ladder: {rod: [A, B], mass: 15 kg}}
joints:
  - contact: {between: [ladder, floor], at: A, mu: 0.1}
  - contact: {between: [ladder, wall], at: B, mu: 0.1}
instant: [at rest]
find: {alpha: alpha(ladder)}
"""


def test_letters_of_coordinates_are_drawn_where_they_are_seen() -> None:
    marks = scene(LADDER)
    assert [told(m) for m in marks if isinstance(m, Dimension)] == ["l"]
    (angle,) = (m for m in marks if isinstance(m, Angle))
    assert told(angle) == "β"
    assert (angle.start, angle.sweep) == (pytest.approx(math.pi), pytest.approx(-math.radians(50)))


def test_the_angle_of_a_face_stands_at_the_corner_of_its_wedge() -> None:
    marks = scene(
        """
title: Block on a wedge
plane: vertical
given: {beta: 30 deg}
points: {A: [0, 0], B: [0.2 m, 0.2 m]}
surfaces:
  floor: {through: A, angle: 0 deg}
  face: {through: B, angle: -beta, body: wedge}
bodies: {wedge: {particle: A, mass: 2 kg}, block: {particle: B, mass: 1 kg}}
joints:
  - contact: {between: [wedge, floor], mu: 0.1}
  - contact: {between: [block, face], mu: 0.1}
instant: [at rest]
find: {a: a(wedge).x}
"""
    )
    (angle,) = (m for m in marks if isinstance(m, Angle))
    (wedge,) = (m for m in marks if isinstance(m, Polyline) and m.closed)
    assert told(angle) == "β"
    assert min(math.dist(angle.vertex, corner) for corner in wedge.places) < 1e-9
    assert math.remainder(angle.start - math.pi, 2 * math.pi) == pytest.approx(0.0)


@pytest.mark.parametrize(
    ("written", "shown"),
    [
        ("a + b", "a + b"),
        ("a - b + c", ""),
        ("-a", "a"),
        ("-a + b", ""),
        ("2*(a + b - c)", ""),
        ("a*cos(b)", "a cos b"),
    ],
)
def test_long_sums_and_what_begins_with_a_minus_measure_nothing(written: str, shown: str) -> None:
    side = parse_side(written, Mark("x", 1, 1))
    assert "".join(run.text for run in runs_of(brief(side))) == shown


def blocks(name: str) -> list[Symbol]:
    return [m for m in scene_of(name) if isinstance(m, Symbol) and m.kind == "block"]


@pytest.mark.parametrize(("name", "count"), [("motion/atwood-let-go", 2), ("particles/moving-pulley", 2)])
def test_loads_on_ropes_over_pulleys_are_blocks_that_hang(name: str, count: int) -> None:
    found = blocks(name)
    assert len(found) == count
    assert all(math.cos(block.angle) == pytest.approx(-1.0) for block in found)


def test_a_bob_on_a_thread_is_no_block() -> None:
    assert not blocks("energy/bob-on-a-thread-that-goes-slack")


def test_a_guide_along_the_rope_of_a_load_is_not_drawn() -> None:
    assert len(blocks("kinematics/three-blocks-on-one-cable")) == 3


@pytest.mark.parametrize(
    ("words", "indices"),
    [
        (line(Name("v0")), ["0"]),
        (line(Name("v0_x")), ["0,x"]),
        (line(Name("O1")), ["1"]),
        (line(Name("v_B/A")), ["B/A"]),
        (line(Math(sp.Symbol("m1") * sp.Symbol("v0") ** 2 / 2)), ["1", "0"]),
        (line(Text("polygon in state 12")), []),
        (line(Value(Decimal(30), "m/s^2", 3)), []),
    ],
)
def test_digits_behind_a_letter_are_an_index(words: Line, indices: list[str]) -> None:
    assert [run.text for run in runs_of(words) if run.index] == indices


def test_points_of_a_list_of_forces_are_names() -> None:
    row = Forces("gear_A", line(Math(sp.Symbol("N")), Text(" ↑ at G_AB, at O")), line("0"))
    ((body, entries),) = table_of([row]).rows
    assert body == (Text("gear A", "strong"),)
    assert Name("G_AB") in entries
    assert "".join(p.text for p in entries if isinstance(p, Text)) == " ↑ at , at O"


def test_a_throw_up_a_slope_has_the_slope_its_angle_and_the_distances_that_are_asked() -> None:
    marks = scene_of("motion/throw-up-a-slope")
    (slope,) = (m.places for m in marks if isinstance(m, Hatched))
    assert slope[0][1] < 0 < slope[1][1]
    assert {"α", "β"} <= {told(m) for m in marks if isinstance(m, Angle)}
    along, off = (m for m in marks if isinstance(m, Dimension) and told(m) in ("d", "h"))
    assert math.dist(along.start, along.end) > math.dist(off.start, off.end)
    assert off.start[0] > off.end[0], "from its foot on the slope"


def test_heights_count_from_the_ground_under_what_is_thrown_from_above_it() -> None:
    (ground,) = (m.places for m in scene_of("motion/throw-at-a-basketball-ring") if isinstance(m, Hatched))
    assert [y for _, y in ground] == [0.0, 0.0]
    assert not [m for m in scene_of("motion/jet-that-reaches-highest-on-a-wall") if isinstance(m, Hatched)]


def test_a_force_at_the_end_of_a_cord_begins_where_the_cord_ends() -> None:
    marks = scene_of("textbook/ex-4-05")
    (cord,) = (m.places for m in marks if isinstance(m, Polyline) and m.style == "rope")
    (pull,) = (m for m in marks if isinstance(m, Arrow) and m.style == "force")
    assert cord[1] == pull.at
    assert cord[0] != pull.at


def test_the_way_of_a_point_of_a_body_is_measured() -> None:
    assert "d" in [told(m) for m in scene_of("textbook/ex-4-08") if isinstance(m, Dimension)]
