"""A tension that is asked after two states of work and energy follows from the work on the body that the rope pulls."""

from __future__ import annotations

from planar_cli.formats.terminal import Terminal
from planar_cli.problem.structure import load_text
from planar_cli.report.page.narrate import narrate
from planar_cli.solve.run import solve_problem

WINCH = """
title: Winch
plane: vertical
given: {m: 10 kg, M: 20 kg, R: 0.2 m, h: 2 m, v: 3 m/s}
unknowns: {C: N*m}
points: {O: [0, 5 m], T: [R, 5 m]}
bodies:
  drum: {disk: O, radius: R, mass: M}
  load: {particle: [R, 0], mass: m}
joints:
  - pin: {at: O, between: [ground, drum]}
  - rope: {name: cord, path: [T on drum, load]}
loads:
  - torque: {name: motor, body: drum, moment: C}
states:
  1: [at rest]
  2: [y(load) = h, v(load).y = v]
find: {C: C, S: tension(cord) @ 2}
"""


def _page(text: str) -> str:
    return Terminal(200).render(narrate(solve_problem(load_text(text)[0])))


def test_the_tension_follows_from_the_work_on_the_load() -> None:
    """(S - m g) h = m v²/2, and of the whole C h/R = m g h + m v²/2 + I ω²/2 with I = M R²/2."""
    page = _page(WINCH)
    assert "ΣF" not in page
    assert "ΣM" not in page
    assert "From 1 to 2, load: work and kinetic energy:" in page
    assert "U of the tension in the cord = T_cord h" in page
    assert "S = T_cord = 120.6 N" in " ".join(page.split())
    assert "C = 28.62 N·m" in " ".join(page.split())


def test_the_energy_of_the_load_is_told_by_the_speed_that_is_given() -> None:
    assert "T_2 of load = 1/2 m v² = 1/2 · 10 · 3² = 45 J" in _page(WINCH)


def test_where_the_acceleration_is_asked_too_the_tension_follows_from_newtons_law() -> None:
    page = _page(WINCH.replace("S: tension(cord) @ 2", "S: tension(cord) @ 2, a: a(load).y @ 2"))
    assert "ΣF_y:   T_cord - m g = m a" in page
    assert "U of the tension" not in page


def test_what_a_spring_pulls_with_is_not_the_same_all_the_way() -> None:
    """The tension varies: no one number of it works on the load."""
    spring = "loads:\n  - spring: {name: coil, between: [load, E], stiffness: 50 N/m, natural_length: 1 m}"
    page = _page(WINCH.replace("loads:", spring).replace("T: [R, 5 m]", "T: [R, 5 m], E: [R, -1 m]"))
    assert "U of the tension" not in page
    assert "ΣF_y" in page


ATWOOD = """
title: Atwood machine
plane: vertical
given: {m_A: 3 kg, m_B: 2 kg, h: 0.5 m, u: 2 m/s}
points: {O: [0, 0]}
bodies:
  A: {particle: [-0.2 m, -1 m], mass: m_A}
  B: {particle: [0.2 m, -3 m], mass: m_B}
joints:
  - rope: {path: [A, O, B], along: 90 deg, name: cord}
states:
  1: [t = 0, at rest]
  2: [y(A) = -1 m - h]
find: {v: v(A).mag @ 2, T: tension(cord) @ 2}
"""
DRUMS = """
title: Two drums with a moment between them
plane: horizontal
given: {m: 3 kg, R: 0.2 m, M: 5 N*m, M_0: 2 N*m}
points: {O: [0, 0], Q: [1 m, 0], S: [0, R], U: [1 m, R]}
bodies:
  d1: {disk: O, radius: R, mass: m}
  d2: {disk: Q, radius: R, mass: m}
joints:
  - pin: {at: O, between: [ground, d1]}
  - pin: {at: Q, between: [ground, d2]}
  - rope: {path: [S on d1, U on d2], name: cord}
loads:
  - torque: {body: d1, moment: M}
  - torque: {between: [d1, d2], moment: M_0}
states:
  1: [t = 0, at rest]
  2: [theta(d1) = 2 rad]
find: {omega: omega(d2) @ 2, T: tension(cord) @ 2}
"""


def test_a_tension_that_work_tells_is_not_told_again_by_newtons_law() -> None:
    page = _page(ATWOOD)
    assert page.count("U of the tension in the cord = -T h") == 1
    assert "ΣF_y" not in page


def test_a_tension_does_no_work_on_what_has_come_back() -> None:
    back = ATWOOD.replace("at rest", "v(A).y = u").replace("y(A) = -1 m - h", "v(A).y = -u")
    page = _page(back.replace("v: v(A).mag @ 2", "y: y(A) @ 2"))
    assert "U of the tension" not in page
    assert "T = 23.54 N" in page
    assert "()" not in page


def test_a_moment_between_two_bodies_has_work_on_one_of_them() -> None:
    """I α = T R + M_0 of the second drum, with α = M/(m R²) of both: T = (M/2 - M_0)/R."""
    page = _page(DRUMS)
    assert "T = 2.5 N" in " ".join(page.split())
    assert "M_0 - T R = I_d1 α_d1" in page
    assert "U of the tension" not in page
