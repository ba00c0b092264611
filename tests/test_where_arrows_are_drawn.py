"""Arrows and senses are those of the motion: of a position it passes, of a force that acts, of a path that is run."""

from __future__ import annotations

import pytest

from planar_cli.formats.terminal import Terminal
from planar_cli.problem.structure import load_text
from planar_cli.report.page.narrate import narrate
from planar_cli.solve.run import solve_problem

RODS = """
title: A rod falls from upright
plane: vertical
symbols: {m: kg, L: m}
coordinates: {x: m, theta: deg}
points: {A: [x, 0], B: {from: A, distance: L, angle: 90 deg - theta}}
surfaces: {floor: {through: A, angle: 0 deg}}
bodies: {rod: {rod: [A, B], mass: m}}
joints: [contact: {between: [rod, floor], at: A, mu: 0}]
states: {1: [at rest, x = 0, theta = 0], 2: [theta = 90 deg]}
find: {omega: abs(omega(rod) @ 2), pressed: N(A) @ 2}
"""
BOWL = """
title: A bar in a bowl
plane: vertical
symbols: {m: kg, L: m}
coordinates: {theta: deg}
points:
  O: [0, 0]
  A: {from: O, distance: L, angle: theta - 120 deg}
  B: {from: O, distance: L, angle: theta - 60 deg}
surfaces: {bowl: {center: O, radius: L}}
bodies: {bar: {rod: [A, B], mass: m}}
joints: [guide: {point: A, along: bowl}, guide: {point: B, along: bowl}]
states: {rest: [equilibrium, theta = 0]}
find: {T: period(rest)}
"""
BUFFER = """
title: A box runs on a spring that is pressed
plane: vertical
given: {m: 60 kg, k: 20 kN/m, d: 0.6 m, L: 1 m}
unknowns: {mu: 1}
points: {P: [0, 0], W: [d + L, 0]}
surfaces: {floor: {through: P, angle: 0 deg}}
bodies: {box: {particle: P, mass: m}}
joints: [contact: {between: [box, floor], mu_k: mu, name: C}]
loads: [spring: {between: [P, W], stiffness: k, natural_length: L + 0.12 m, name: buffer, during: 2->3}]
states: {1: [v(box).x = 2.5 m/s], 2: [x(box) = d], 3: [x(box) = d + 0.04 m, v(box).x = 0]}
find: {mu: mu}
"""
DIP = """
title: A car in a dip
plane: vertical
given: {W: 2000 lbf, h: 40 ft}
points: {C: [0, 20 ft], P: [0, 0]}
surfaces: {dip: {center: C, radius: 20 ft}}
bodies: {car: {particle: P, weight: W}}
joints: [contact: {between: [car, dip], at: P, mu: 0, name: track}]
instant: [v(car).x = sqrt(2*g*h)]
find: {N_2: N(track) in lbf}
"""
PLANE = """
title: A plane on a circle
given: {rho: 400 km, v_B: 600 km/h}
points: {B: [4 km, 0], C: [404 km, 0]}
surfaces: {circle: {center: C, radius: rho}}
bodies: {plane_B: {particle: B}}
joints: [guide: {point: B, along: circle}]
instant: [v(B).y = v_B, a(B).t = -100 km/h^2]
find: {a_x: a(B).x in km/h^2, a_y: a(B).y in km/h^2}
"""
CASES = [
    (RODS, "N_A ↑ at A", "N_A ↓"),
    (BOWL, "N_A ↗ at A,  N_B ↖ at B", "N_A ↖"),
    (BUFFER, "F_buffer ←", "F_buffer →"),
    (DIP, "Accelerations:\n    (2)  a = 128.7", "Velocities:\n    (2)"),
    (PLANE, "e_t = [0, 1], e_n = [1, 0]", "v_B′ = -v_B"),
    (PLANE, "a_Bt = -0.007716 m/s²", "0.007716                       in m/s²"),
]


@pytest.mark.parametrize(("text", "true", "false"), CASES)
def test_senses_on_the_page(text: str, true: str, false: str) -> None:
    printed = Terminal(width=110).render(narrate(solve_problem(load_text(text)[0])))
    assert true in printed
    assert false not in printed
