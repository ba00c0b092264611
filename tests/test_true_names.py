"""Letters and headings that say what they are: nothing has a name that means something else on the same page."""

from __future__ import annotations

import re

from planar_cli.formats.terminal import Terminal
from planar_cli.problem.structure import load_text
from planar_cli.report.page.narrate import narrate
from planar_cli.solve.run import solve_problem

DROPPED = """
title: Parcel dropped on a spring scale pan
plane: vertical
given: {m_1: 5 kg, m_2: 3 kg, k: 4 kN/m, h: 600 mm}
coordinates: {y: m, z: m}
points: {F: [0, -1 m], Q: [0, y], P: [0, z]}
bodies: {pan: {particle: Q, mass: m_2}, parcel: {particle: P, mass: m_1}}
joints:
  - guide: {point: Q, along: 90 deg}
  - weld: {at: Q, between: [pan, parcel], during: 2->4}
loads:
  - spring: {between: [F, Q], stiffness: k, relaxed_at: [y = m_2*g/k]}
states: {1: [t = 0, y = 0, z = h, at rest], 2: [z = 0], 3: [just after 2], 4: [v(pan).y = 0]}
find: {t_4: t @ 4 - t @ 3, t_2: t @ 2}
"""
JERKED = """
title: Two pucks and a slack cord
plane: horizontal
given: {m_A: 2 kg, m_B: 3 kg, l: 1.5 m}
points: {A: [0, 0], B: [0.9 m, 0]}
bodies: {A: {particle: A, mass: m_A}, B: {particle: B, mass: m_B}}
joints:
  - rope: {path: [A, B], name: cord, during: 2->3}
states:
  1: [t = 0, v(A).x = 0, v(A).y = -4 m/s, B at rest]
  2: [r(B/A).mag = l]
  3: [just after 2]
find: {v_A: v(A) @ 3, v_B: v(B) @ 3}
"""
ORBIT = """
title: Speed for an orbit through two points
plane: horizontal
given: {m: 1 kg, K: 398600 km^3/s^2, g_0: 9.81 m/s^2, r_1: 7000 km, r_2: 10000 km, beta: 120 deg}
unknowns: {v_1: km/s}
points: {O: [0, 0], P: [r_1, 0]}
bodies: {probe: {particle: P, mass: m}}
loads:
  - force: {body: probe, magnitude: K*m/r(probe/O).mag^2 * g_0/(9.81 m/s^2), towards: O, name: pull}
states:
  first: [t = 0, v(probe).x = 0, v(probe).y = v_1]
  second: [r(probe/O).mag = r_2, r(probe/O).angle = beta]
find: {v_1: v_1, v_2: v(probe).mag @ second in km/s}
"""
STRUCK = """
title: Block slides down, strikes a hanging rod, and the rod swings up
plane: vertical
given: {m_b: 3 kg, m_r: 4 kg, l: 1.2 m, s: 2 m, beta: 30 deg, mu: 0.2, e: 0.6}
points: {S: {from: K, distance: s, angle: 180 deg - beta}, K: [0, 0], B: [1 m, 0], O: [1 m, l]}
surfaces: {incline: {through: K, angle: -beta}, floor: {through: K, angle: 0 deg}}
bodies: {block: {particle: S, mass: m_b}, rod: {rod: [O, B], mass: m_r}}
joints:
  - contact: {between: [block, incline], at: S, mu: mu, during: top->knee}
  - contact: {between: [block, floor], mu: 0, during: knee->up}
  - pin: {at: O, between: [ground, rod]}
  - impact: {between: [block, rod], restitution: e, during: hit->apart}
states:
  top: [t = 0, at rest]
  knee: [x(block) = 0]
  hit: [x(block) = 1 m]
  apart: [just after hit]
  up: [omega(rod) = 0]
find: {v_2: v(block).x @ apart, phi: theta(rod) @ up - theta(rod) @ apart in deg}
"""
ON_TWO_CORDS = """
title: Bullet strikes a plate hung on two cords
plane: vertical
given: {M: 8 kg, m: 0.02 kg, b: 400 mm, v_0: 260 m/s}
points:
  G: [0, 0]
  L: [-b/2, b/2]
  N: [b/2, b/2]
  P: [-b/2, -50 mm]
  L0: [-b/2, 1 m]
  N0: [b/2, 1 m]
bodies: {plate: {plate: G, width: b, height: b, mass: M, points: [L, N]}, bullet: {particle: P, mass: m}}
joints:
  - rope: {path: [L0, L], name: left}
  - rope: {path: [N0, N], name: right}
  - weld: {at: P, between: [plate, bullet], during: 1->2}
states: {1: [plate at rest, v(bullet).x = v_0, v(bullet).y = 0], 2: [just after 1]}
find: {omega: omega(plate) @ 2}
"""


def _page(text: str) -> str:
    problem, wrong = load_text(text)
    assert problem is not None, wrong
    return re.sub(r"\s+", " ", Terminal(200).render(narrate(solve_problem(problem))))


def test_a_time_between_states_is_not_the_time_of_the_last() -> None:
    """t_4 is what the author calls so; the time of state 4, counted from the first, is another letter."""
    page = _page(DROPPED)
    assert "t_4 = t_4′ - t_2 = " in page
    assert "(t_4′ - t_2)" in page
    assert "t_2′" not in page, "the time of state 2 is what is asked as t_2"
    assert "MOTION from 1 to 2 " in page
    assert "from 2 to 3" not in page, "a blow is no motion"


def test_the_speed_of_what_is_placed_by_the_other() -> None:
    """v_B = v_A + v_B/A."""
    page = _page(JERKED)
    assert "v_B/A" in page
    assert "v_A/B" not in page


def test_an_equation_is_no_integration() -> None:
    page = _page(ORBIT)
    assert re.search(r"_second = √\(.* = 14\d\d m/s", page)
    assert "by numerical integration the" not in page
    assert ", g = 9.81" not in page, "g_0 is no g"


def test_a_blow_after_what_hung_still() -> None:
    """It stays in equilibrium over several states, so that nothing is to be integrated: momentum and restitution."""
    page = _page(STRUCK)
    assert "At knee, hit: θ_hit = θ_knee = θ_top = -90° it stays at rest in equilibrium" in page
    assert "Restitution between block and rod" in page
    assert "numerical integration" not in page
    assert "cos φ = 1 - l ω_apart²/(3 g)" in page


def test_a_cord_that_goes_slack_in_a_blow_is_told() -> None:
    page = _page(ON_TWO_CORDS)
    assert "The rope right is slack in the blow: its ends do not move apart, and it exerts no impulse." in page
    assert "rope left is slack" not in page
