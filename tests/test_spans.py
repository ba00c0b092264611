"""Quantities over spans of a motion, and states that are never reached."""

from __future__ import annotations

import math
from pathlib import Path

import pytest
import sympy as sp
from answered import BRAKED, solved
from answered import first as number
from worked import page_of_text

from planar_cli.errors import NoSolution
from planar_cli.formats.terminal import Terminal
from planar_cli.problem.structure import load_text
from planar_cli.report.page.narrate import narrate
from planar_cli.solve.run import solve_problem

SPRING = """
title: Block on a spring
plane: vertical
{names}
coordinates: {{x: m}}
points: {{W: [-d, 0], P: [x, 0]}}
bodies: {{block: {{particle: P, mass: m}}}}
joints:
  - guide: {{point: P, along: 0 deg, name: rail}}
loads:
  - spring: {{between: [W, P], stiffness: k, relaxed_at: [x = 0], name: coil}}
states:
  1: [t = 0, x = a, at rest]
  2: [x = 0]
  3: [t = T]
find: {{{find}}}
"""
NUMBERS = "given: {m: 2 kg, k: 200 N/m, a: 0.1 m, d: 1 m, T: 1 s}"
LETTERS = "symbols: {m: kg, k: N/m, a: m, d: m}\nassume: [a < d]"

DISK = (
    f"{BRAKED}find: {{W: work(brake) @ 1->2, H: impulse(brake/O) @ 1->2, "
    "all_of_it: work(disk) @ 1->2, turn: mean(omega(disk)) @ 1->2}\n"
)

SHOT = """
title: Shot
plane: vertical
given: {m: 2 kg, v_0: 10 m/s}
bodies: {ball: {particle: [0, 0], mass: m}}
states:
  1: [t = 0, v(ball).mag = v_0, v(ball).angle = 60 deg]
  2: [t = 1 s]
find:
  J: impulse(ball) @ 1->2
  J_y: impulse(ball).y @ 1->2
  way: path_length(ball) @ 1->2
  v: mean(v(ball)) @ 1->2
  tops: count(v(ball).y = 0) @ 1->2
  falls: count(v(ball).y < 0) @ 1->2
"""

SLIDE = """
title: Block thrown along a floor
plane: vertical
given: {m: 2 kg, mu: 0.2, v_0: 4 m/s}
coordinates: {s: m}
points: {O: [0, 0], P: [s, 0]}
surfaces: {floor: {through: O, angle: 0 deg}}
bodies: {block: {particle: P, mass: m}}
joints:
  - contact: {between: [block, floor], at: P, mu: mu}
states:
  1: [t = 0, s = 0, v(P).x = v_0]
  2: [block at rest]
find: {Q: heat(P) @ 1->2, Q_all: heat(all) @ 1->2, W: work(P) @ 1->2, J: impulse(P).x @ 1->2, s_2: s @ 2}
"""

DAMPED = """
title: Damped block
plane: vertical
given: {m: 2 kg, k: 200 N/m, c: 100 N*s/m}
coordinates: {x: m}
points: {W: [-0.5 m, 0], P: [x, 0]}
bodies: {block: {particle: P, mass: m}}
joints:
  - guide: {point: P, along: 0 deg}
loads:
  - spring: {between: [W, P], stiffness: k, relaxed_at: [x = 0]}
  - damper: {between: [W, P], coefficient: c}
states:
  1: [t = 0, x = 0.1 m, at rest]
  cross: [x = 0]
  later: [t = 0.25 s]
find: {FIND}
"""


def spring(find: str, names: str = NUMBERS) -> str:
    text = SPRING.format(names=names, find=find)
    return text if names == NUMBERS else text.replace("  3: [t = T]\n", "")


def test_the_work_of_a_spring(tmp_path: Path) -> None:
    found = solved(tmp_path, spring("W: work(coil) @ 1->2, W_all: work(all) @ 1->2, W_rail: work(rail) @ 1->2"))
    assert number(found["W"]) == pytest.approx(1)
    assert number(found["W_all"]) == pytest.approx(1)
    assert number(found["W_rail"]) == 0


def test_a_path_there_and_back(tmp_path: Path) -> None:
    """One second of a motion 0.1 cos 10 t: three times past a turning point."""
    found = solved(tmp_path, spring("way: path_length(P) @ 1->3, turns: count(v(P).x = 0) @ 1->3"))
    assert number(found["turns"]) == 3
    assert number(found["way"]) == pytest.approx(0.6 + 0.1 * (1 + math.cos(10)), abs=1e-12)


def test_letters_give_formulas(tmp_path: Path) -> None:
    asked = "W: work(coil) @ 1->2, J: impulse(coil).x @ 1->2, way: path_length(P) @ 1->2"
    found = solved(tmp_path, spring(asked, LETTERS))
    m, k, a = sp.symbols("m k a", positive=True)
    for name, expected in (("W", k * a**2 / 2), ("J", -a * sp.sqrt(k * m)), ("way", a)):
        expressions = found[name].expressions
        assert expressions is not None
        assert sp.simplify(expressions[0] - expected) == 0, name


def test_a_torque_and_its_angular_impulse(tmp_path: Path) -> None:
    found = solved(tmp_path, DISK)
    inertia = 0.5 * 4 * 0.25
    angle = 10 * 2 - 2**2 / (2 * inertia)
    assert number(found["W"]) == pytest.approx(-angle)
    assert number(found["all_of_it"]) == pytest.approx(-angle)
    assert number(found["H"]) == pytest.approx(-2)
    assert number(found["turn"]) == pytest.approx(angle / 2)


def test_a_shot(tmp_path: Path) -> None:
    found = solved(tmp_path, SHOT)
    vx, vy = 5.0, 10 * math.sin(math.pi / 3)
    assert found["J"].values is not None
    assert [float(v) for v in found["J"].values] == pytest.approx([0, -2 * 9.81])
    assert number(found["J_y"]) == pytest.approx(-2 * 9.81)
    steps = 20000
    speeds = (math.hypot(vx, vy - 9.81 * (i + 0.5) / steps) for i in range(steps))
    assert number(found["way"]) == pytest.approx(sum(speeds) / steps, rel=1e-8)
    assert found["v"].values is not None
    assert [float(v) for v in found["v"].values] == pytest.approx([vx, vy - 9.81 / 2])
    assert number(found["tops"]) == 1
    assert number(found["falls"]) == 1


def test_heat_of_friction(tmp_path: Path) -> None:
    found = solved(tmp_path, SLIDE)
    assert number(found["Q"]) == pytest.approx(16)
    assert number(found["Q_all"]) == pytest.approx(16)
    assert number(found["W"]) == pytest.approx(-16)
    assert number(found["J"]) == pytest.approx(-8)


def test_a_state_that_is_never_reached(tmp_path: Path) -> None:
    found = solved(tmp_path, DAMPED.replace("FIND", "crosses: reached(cross), x_later: x @ later"))
    assert found["crosses"].word == "false"
    assert number(found["x_later"]) == pytest.approx(0.0620492, rel=1e-5)


def test_what_is_asked_of_a_state_that_is_never_reached(tmp_path: Path) -> None:
    with pytest.raises(NoSolution, match="never reached"):
        solved(tmp_path, DAMPED.replace("FIND", "crosses: reached(cross), t_c: t @ cross"))


def test_a_path_length_fixes_a_state(tmp_path: Path) -> None:
    text = SLIDE.replace("2: [block at rest]", "2: [path_length(P) @ 1->2 = 3 m]")
    text = text[: text.index("find:")] + "find: {v: v(P).x @ 2}\n"
    assert number(solved(tmp_path, text)["v"]) == pytest.approx(math.sqrt(16 - 2 * 0.2 * 9.81 * 3))


def test_a_state_that_only_the_way_gone_tells() -> None:
    """Where no equation leads to it, it is found step by step: 102.5 kg a = m g sin 30° - 3 μ m g cos 30°."""
    text = """
title: Spool on a slope, held by its cord
plane: vertical
points:
  C: [0, 0]
  G: {from: C, distance: 0.4 m, angle: 120 deg}
  T: {from: G, distance: 0.2 m, angle: 120 deg}
  Q: {from: T, distance: 5 m, angle: 30 deg}
surfaces: {slope: {through: C, angle: 30 deg}}
bodies: {spool: {disk: G, radius: 0.4 m, hub: 0.2 m, mass: 40 kg, radius_of_gyration: 0.25 m}}
joints:
  - rope: {path: [Q, T on spool]}
  - contact: {between: [spool, slope], at: C, mu: 0.15}
states:
  1: [t = 0, at rest]
  2: [path_length(G) @ 1->2 = 3 m]
find: {v: v(G).mag @ 2}
"""
    problem, wrong = load_text(text)
    assert not wrong
    assert problem is not None
    (found,) = (f for part in solve_problem(problem).parts for f in part.found)
    a = 40 * 9.81 * (math.sin(math.pi / 6) - 3 * 0.15 * math.cos(math.pi / 6)) / 102.5
    assert number(found) == pytest.approx(math.sqrt(2 * a * 3))


STICKING = """
title: Block on a spring that comes to rest on a rough floor
plane: vertical
given: {m: 2 kg, k: 200 N/m, mu: 0.15, x_0: 120 mm}
points: {W: [-0.4 m, 0], P: [x_0, 0]}
surfaces: {floor: {through: P, angle: 0 deg}}
bodies: {block: {particle: P, mass: m}}
joints:
  - contact: {between: [block, floor], at: P, mu: mu}
loads:
  - spring: {between: [W, P], stiffness: k, natural_length: 0.4 m}
states:
  1: [t = 0, at rest]
  2: [t = infinity]
find: {way: path_length(P) @ 1->2, Q: heat(P) @ 1->2, passes: count(x(P) = 0) @ 1->2}
"""


def test_a_span_that_never_ends(tmp_path: Path) -> None:
    """Each half swing is shorter by 2 μ m g/k = 29.43 mm on either side; after the fourth it stays at 2.28 mm."""
    found = solved(tmp_path, STICKING)
    assert number(found["way"]) == pytest.approx(0.48912)
    assert number(found["Q"]) == pytest.approx(100 * (0.12**2 - 0.00228**2))
    assert number(found["passes"]) == 4


def test_a_mean_over_a_time_without_end() -> None:
    text = STICKING[: STICKING.index("find:")] + "find: {v: mean(v(P).x) @ 1->2}\n"
    problem, wrong = load_text(text)
    assert [d.code for d in wrong] == ["PL434"]
    assert problem is None


def test_a_half_swing_to_the_left_is_a_positive_way(tmp_path: Path) -> None:
    """The page adds the ways from turn to turn, each as it is positive."""
    text = STICKING.replace("2: [t = infinity]", "2: [v(P).x = 0]\n  3: [v(P).x = 0]")
    problem, _ = load_text(text[: text.index("find:")] + "find: {way: path_length(P) @ 1->3}\n")
    assert problem is not None
    page = Terminal().render(narrate(solve_problem(problem)))
    assert "way = (x_1 - x_2) + (x_3 - x_2) = 0.2106 + 0.1517 = 0.3623 m" in page


def test_heat_goes_on_from_a_length_of_path_that_stands_above_it(tmp_path: Path) -> None:
    text = """\
title: Block that slides up and back
plane: vertical
given: {m: 2 kg, b: 20 deg, mu: 0.1, v: 4 m/s}
points: {A: [0, 0]}
surfaces: {slope: {through: A, angle: b}}
bodies: {block: {particle: A, mass: m}}
joints:
  - contact: {between: [block, slope], at: A, mu: mu}
states:
  1: [v(block).along(b) = v]
  2: [v(block) = 0]
  3: [y(block) = -0.1 m]
"""
    heat, way = "Q: heat(A) @ 1->3", "s: path_length(block) @ 1->3"
    assert "Q = μ m g cos(b) s = " in page_of_text(tmp_path, f"{text}find: {{{way}, {heat}}}")
    assert "cos(b) s" not in page_of_text(tmp_path, f"{text}find: {{{heat}, {way}}}")
