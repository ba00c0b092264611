"""How a cord acts just after a blow: the page stays that of impulse and momentum, and says why the cord is slack."""

from __future__ import annotations

from planar_cli.formats.terminal import Terminal
from planar_cli.problem.structure import load_text
from planar_cli.report.page.narrate import narrate
from planar_cli.solve.run import solve_problem

HANGING_PLATE = """
title: Bullet that stays in a hanging plate
plane: vertical
given: {m: 8 kg, m_P: 0.02 kg, b: 0.4 m, h: 50 mm, v_0: 260 m/s, l: 0.5 m}
points:
  G: [0, 0]
  A: [-b/2, b/2]
  B: [b/2, b/2]
  A_1: {from: A, distance: l, angle: 90 deg}
  B_1: {from: B, distance: l, angle: 90 deg}
  P: [-b/2, -h]
bodies:
  plate: {plate: G, width: b, height: b, mass: m, points: [A, B]}
  bullet: {particle: P, mass: m_P}
joints:
  - rope: {path: [A_1, A], name: cord_A}
  - rope: {path: [B_1, B], name: cord_B}
  - weld: {at: P, between: [plate, bullet], during: 1->2}
states:
  1: [plate at rest, v(bullet).x = v_0, v(bullet).y = 0]
  2: [just after 1]
find:
  omega: omega(plate) @ 2
  S_A: impulse(cord_A/plate).y @ 1->2
"""


def _page(text: str) -> str:
    return Terminal().render(narrate(solve_problem(load_text(text, "plate.yaml")[0])))


def test_a_mode_after_a_blow_leaves_the_page_of_the_blow() -> None:
    plain = _page(HANGING_PLATE)
    asked = _page(HANGING_PLATE + "  slack: mode(cord_B) @ 2\n  taut: mode(cord_A) @ 2 = taut\n")
    assert "Impulse and momentum" in asked
    assert "integrated numerically" not in asked
    assert "slack: slack" in asked
    assert "taut: yes" in asked
    assert "slack, taut read off the motion that is followed in numbers · all else checked" in asked
    told = {line for line in plain.splitlines() if "=" in line}
    assert told <= set(asked.splitlines())


def test_a_line_shows_why_a_cord_is_slack() -> None:
    page = _page(HANGING_PLATE)
    assert "After the blow the ends of the cord B approach each other, so that it stays slack, at:" in page
    assert "b ω_2 = 0.4 · 0.4862 = 0.1945 m/s" in page


OVER_A_PULLEY = """
title: Bar on two cords, one over a pulley, struck
plane: vertical
given: {m: 2 kg, b: 1 m, J: 4 N*s}
points: {A: [0, 0], B: [b, 0], C: [0, 1 m], D: [b, 1 m], E: [3 m, 0]}
bodies: {bar: {rod: [A, B], mass: m}}
joints:
  - rope: {path: [A, C], name: left}
  - rope: {path: [B, over D, E], name: right}
loads:
  - impulse: {body: bar, at: B, magnitude: J, angle: 90 deg, during: 1->2}
states: {1: [at rest], 2: [just after 1]}
find: {w: omega(bar) @ 2}
"""


def test_over_a_pulley_ends_come_nearer_along_the_rope() -> None:
    """B goes up, past E and no nearer to it."""
    page = _page(OVER_A_PULLEY)
    assert "After the blow the ends of the rope right approach each other along it, so that it stays slack, at:" in page
    assert "b ω_2 = 1 · 6 = 6 m/s" in page
