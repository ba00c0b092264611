"""What a solution of a motion says: headings with a subject, units on every line, numbers of steps, no idle repeats."""

from __future__ import annotations

import re

from answered import BRAKED, BUFFER

from planar_cli.formats.terminal import Terminal
from planar_cli.problem.structure import load_text
from planar_cli.report.page.narrate import narrate
from planar_cli.report.words.origins import kept
from planar_cli.solve.run import solve_problem

BRAKE = (
    f"{BRAKED}find: {{H: impulse(brake/O) @ 1->2, turn: mean(omega(disk)) @ 1->2, lost: KE(all) @ 1 - KE(all) @ 2}}\n"
)
OBLIQUE = """
title: Oblique impact
plane: horizontal
given: {r: 0.1 m, e: 0.7, w: 1 m/s}
points: {A: [0, 0], B: {from: A, distance: 2*r, angle: 30 deg}}
bodies:
  DA: {disk: A, radius: r, mass: 2 kg}
  DB: {disk: B, radius: r, mass: 3 kg}
joints:
  - impact: {between: [DA, DB], restitution: e, during: 1->2, name: hit}
states:
  1: [v(A).x = 4 m/s, v(A).y = 0, v(B).x = -w, v(B).y = 0.5 m/s, omega(DA) = 0, omega(DB) = 0]
  2: [just after 1]
find: {v_A: v(A) @ 2, omega: omega(DA) @ 2, J: impulse(hit/DB).mag @ 1->2}
"""
BULLET = """
title: Bullet into a rod
plane: vertical
points: {O: [0, 0], E: [0, -1 m], P: [0, -0.8 m]}
bodies:
  rod: {rod: [O, E], mass: 3 kg}
  bullet: {particle: P, mass: 0.02 kg}
joints:
  - pin: {at: O, between: [ground, rod]}
  - weld: {at: P, between: [rod, bullet], during: 1->2}
states:
  1: [rod at rest, v(bullet).x = 200 m/s, v(bullet).y = 0]
  2: [just after 1]
find: {omega: omega(rod) @ 2, v_P: v(bullet) @ 2}
"""

THROWN = """
title: Thrown from a cliff
plane: vertical
bodies: {P: {particle: [0, 0], mass: any}}
states:
  1: [v(P).x = 4 m/s, v(P).y = 3 m/s]
  2: [y(P) = -5 m]
find: {t: t @ 2, x: x(P) @ 2}
"""


def told(text: str) -> str:
    """The solution of a file as it is printed, in one line of single spaces."""
    problem, wrong = load_text(text)
    assert not wrong
    return " ".join(Terminal().render(narrate(solve_problem(problem))).split())


def test_units_of_integrals_and_energies() -> None:
    found = told(BRAKE)
    assert "= -2 N·m·s" in found
    assert "turn = θ_2/t_2 = 16/2 = 8 rad/s" in found
    lines = found[found.index("Hence:") : found.index("Answer")]
    assert "= 16 J" in lines
    assert not re.search(r"N·m(?!·s)", lines)


def test_a_blow_names_its_bodies_and_components() -> None:
    found = told(OBLIQUE)
    assert "From 1 to 2, :" not in found
    assert "DA, angular momentum about A, zero before, and no impulse changes it:" in found
    assert "DA, momentum across the line of J:" in found
    assert "in the blow from" not in found
    assert "J = 8.323 N·s" in found
    assert "DB: m_DB w ← at B" in found


def test_what_a_blow_leaves_is_told_in_velocities() -> None:
    found = told(BULLET)
    diagram = found[found.index("Just after 1") : found.index("angular momentum about")]
    assert not re.search(r"\ba_", diagram)
    assert found.count("the velocities after the blow:") <= 1


def test_an_assumption_holds_up_to_its_end() -> None:
    found = told(BUFFER)
    assert re.search(r"Up to t_touch = 0\.4(000)? s \(state touch\) the spring buffer is not compressed; there", found)
    steps = re.findall(r"STEP (\d+)", found)
    assert steps == [str(i + 1) for i in range(len(steps))]


def test_what_a_joint_keeps() -> None:
    assert kept("B: distance from the edge") == "B is still on its line"
    assert kept("hook: place on ground and rod") == "hook belongs to the ground and to rod"
    assert kept("tip: stays on profile") == "tip stays on profile"
    assert kept("odd title") == "odd title"


def test_what_is_constant_needs_no_integral() -> None:
    found = told(THROWN)
    assert "constant velocity of P along x: (" in found
    assert "constant acceleration of P along y: y = y_0 + v_0 t + 1/2 a t²" in found
    assert "∫" not in found


ROLLS_OFF = """\
title: Cylinder rolls off a cylinder
plane: vertical
given: {R: 300 mm, r: 100 mm}
points: {O: [0, 0], C: [0, R], G: [0, R + r]}
surfaces: {drum: {center: O, radius: R}}
bodies: {roller: {disk: G, radius: r, mass: 2 kg}}
joints:
  - rolling: {between: [roller, drum], at: C}
states:
  top: [at rest]
  leaves: [N(C) = 0]
find: {phi: r(G).angle @ leaves in deg, omega: abs(omega(roller) @ leaves)}
"""


def test_a_condition_of_forces_is_no_geometry() -> None:
    """The work of the weight is that of the height, whatever N = 0 says of it; both equations are solved in letters."""
    found = told(ROLLS_OFF)
    assert "U of the weight of roller = m g (y_G,top - y_G,leaves)" in found
    assert "(1 - cos φ_leaves)" in found
    assert "cos φ_leaves = 4/7" in found
    assert "solved numerically" not in found


FALLS = """\
title: Rod that falls on a smooth floor
plane: vertical
symbols: {l: m}
points: {A: [0, 0], B: {from: A, distance: l, angle: 60 deg}}
surfaces: {floor: {through: A, angle: 0 deg}}
bodies: {rod: {rod: [A, B], mass: any}}
joints: [{contact: {between: [rod, floor], at: A, mu: 0}}]
states: {1: [at rest], 2: [theta(rod) = 0]}
find: {omega: omega(rod) @ 2}
"""


def test_an_angle_has_an_angular_velocity_in_its_law() -> None:
    """ω dω = α dθ is linear in ω², not in v²."""
    assert "linear in v²" not in told(FALLS)
