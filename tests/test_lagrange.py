"""Lagrange's equations: at an instant and over time, beside Newton's law, and what they do not reach."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest
from answered import assert_close, number

from planar_cli.errors import FileProblem
from planar_cli.problem.scene.scene import Problem
from planar_cli.problem.structure import load, load_text
from planar_cli.registry import members
from planar_cli.report.page.narrate import narrate
from planar_cli.solve.run import solve_problem
from planar_cli.solve.solved_problem import PartSolution, Solution

PENDULUM = """
title: Pendulum
plane: vertical
given: {l: 2 m, m: 3 kg}
points: {O: [0, 0], B: {from: O, distance: l, angle: -30 deg}}
bodies: {rod: {rod: [O, B], mass: m}}
joints:
  - pin: {at: O, between: [ground, rod]}
"""

DOUBLE = """
title: Double pendulum with a damper
plane: vertical
given: {l: 2 m, m: 3 kg, c: 4 N*s/m, k: 50 N/m}
points:
  O: [0, 0]
  A: {from: O, distance: l, angle: -50 deg}
  B: {from: A, distance: l, angle: -10 deg}
  W: [5 m, 1 m]
bodies: {upper: {rod: [O, A], mass: m}, lower: {rod: [A, B], mass: m}}
joints:
  - pin: {at: O, between: [ground, upper]}
  - pin: {at: A, between: [upper, lower]}
loads:
  - damper: {between: [B, W], coefficient: c, name: dashpot}
  - spring: {between: [A, W], stiffness: k, natural_length: 1 m, name: coil}
instant: [omega(upper) = 2 rad/s, omega(lower) = -1 rad/s]
find: {upper: alpha(upper), lower: alpha(lower)}
"""

SLIDER = """
title: Ladder on two guides
plane: vertical
given: {l: 4 m, m: 20 kg}
points: {A: [0, 0], B: {from: A, distance: l, angle: 60 deg}}
bodies: {ladder: {rod: [A, B], mass: m}}
joints:
  - guide: {point: A, along: 0 deg}
  - guide: {point: B, along: 90 deg}
instant: [omega(ladder) = 1 rad/s]
find: {alpha: alpha(ladder)}
"""

PULLEY = """
title: Two weights over a drum
plane: vertical
given: {m_A: 6 kg, m_B: 4 kg}
points: {O: [0, 0], A: [-0.2 m, -1 m], B: [0.2 m, -1 m], P: [-0.2 m, 0], Q: [0.2 m, 0]}
bodies:
  drum: {disk: O, radius: 0.2 m, mass: 2 kg}
  one: {particle: A, mass: m_A}
  two: {particle: B, mass: m_B}
joints:
  - pin: {at: O, between: [ground, drum]}
  - rope: {path: [A, P on drum], name: left}
  - rope: {path: [B, Q on drum], name: right}
instant: [at rest]
find: {a: a(one).y}
"""

FREE = """
title: Bead on a smooth floor
plane: vertical
points: {C: [0, 0]}
bodies: {crate: {particle: C, mass: 20 kg}}
surfaces: {floor: {through: C, angle: 0 deg}}
joints:
  - contact: {between: [crate, floor], at: C, mu: 0}
loads:
  - force: {body: crate, magnitude: 50 N, angle: 0 deg}
instant: [at rest]
find: {N: N(C)}
"""


def problem_of(text: str) -> Problem:
    problem, wrong = load_text(text)
    assert wrong == []
    assert problem is not None
    return problem


def solved(text: str, method: str) -> Solution:
    return solve_problem(replace(problem_of(text), method=method))


def part_of(text: str, method: str) -> PartSolution:
    (part,) = solved(text, method).parts
    return part


def page_of(solution: Solution) -> str:
    terminal: Any = members("formats")["terminal"]()
    page: str = terminal.render(narrate(solution))
    return page


def test_a_pendulum_at_an_instant() -> None:
    (found,) = part_of(PENDULUM + "instant: [omega(rod) = 2 rad/s]\nfind: {alpha: alpha(rod)}\n", "lagrange").found
    # m l²/3 α = -m g l/2 cos θ
    assert_close(found, -3 * 9.81 / 4 * 3**0.5 / 2)


def test_the_page_says_what_it_is() -> None:
    page = page_of(solved(PENDULUM + "instant: [at rest]\nfind: {alpha: alpha(rod)}\n", "lagrange"))
    assert "T = 1/2 (1/4 m l² + I) ω²" in page
    assert "V = 1/2 m g l sin θ" in page
    assert "d/dt ∂L/∂ω - ∂L/∂θ:" in page
    assert "ΣM" not in page


@pytest.mark.slow
@pytest.mark.parametrize("text", [DOUBLE, SLIDER, PULLEY])
def test_it_gives_the_accelerations_of_newton(text: str) -> None:
    for found, want in zip(part_of(text, "lagrange").found, part_of(text, "newton").found, strict=True):
        assert_close(found, number(want), 30)


def test_it_is_integrated_between_states() -> None:
    text = PENDULUM + "states: {1: [at rest], 2: [theta(rod) = -90 deg]}\nfind: {omega: omega(rod) @ 2}\n"
    part = part_of(text, "lagrange")
    # ω² = 3 g/l (sin(-30 deg) - sin(-90 deg))
    assert_close(part.found[0], -((3 * 9.81 / 2 * 0.5) ** 0.5))
    laws = [e for step in part.motion.route.steps for e in step.relations if e.offered]
    assert laws
    assert all("lagrange" in e.offered for e in laws)
    kinetic = [w for i in part.instants for s in i.stages for b in s.blocks for w in b.equations if w.law != "relation"]
    assert {w.law for w in kinetic} == {"single"}


def test_what_binds_coordinates_is_a_multiplier() -> None:
    text = PULLEY.replace("find: {a: a(one).y}", "find: {T: tension(left)}")
    # T = m_A (g + a_A), a_A = -(m_A - m_B) g / (m_A + m_B + m/2)
    assert_close(part_of(text, "lagrange").found[0], 6 * 9.81 * (1 - 2 / 11))


def test_reactions_of_ideal_joints_are_not_reached() -> None:
    with pytest.raises(FileProblem, match="method lagrange alone does not reach N_C"):
        part_of(FREE, "lagrange")
    with pytest.raises(FileProblem, match="method lagrange alone does not reach O_x"):
        part_of(PENDULUM + "instant: [at rest]\nfind: {pull: reaction(O).x}\n", "lagrange")
    text = PENDULUM + "states: {1: [at rest], 2: [theta(rod) = -90 deg]}\nfind: {pull: reaction(O).y @ 2}\n"
    with pytest.raises(FileProblem, match="method lagrange alone does not reach O_"):
        part_of(text, "lagrange")


def test_a_limit_that_it_does_not_tell_is_not_taken() -> None:
    """N = 0 stood beside |F| = μ N, since no Lagrange equation speaks of N: it left a remainder in Newton's law."""
    path = Path(__file__).parent.parent / "problems/friction/whirling-collar.yaml"
    problem, _, _ = load(str(path))
    assert problem is not None
    slow = replace(problem, find=problem.cases[0].problem.find, cases=(), instant=problem.cases[0].problem.instant)
    with pytest.raises(FileProblem, match="lagrange alone does not reach w_min"):
        solve_problem(slow, "lagrange")


FOUR_BAR = """
title: Four-bar linkage, the angle of its crank a coordinate
plane: vertical
given: {a: 0.2 m, b: 0.5 m, c: 0.4 m, d: 0.6 m}
coordinates: {phi: rad}
points: {O: [0, 0], C: [d, 0], A: {from: O, distance: a, angle: phi}, B: {distances: {A: b, C: c}, side: above}}
bodies: {OA: {rod: [O, A], mass: 1 kg}, AB: {rod: [A, B], mass: 2.5 kg}, CB: {rod: [C, B], mass: 2 kg}}
joints:
  - pin: {at: O, between: [ground, OA]}
  - pin: {at: A, between: [OA, AB]}
  - pin: {at: B, between: [AB, CB]}
  - pin: {at: C, between: [ground, CB]}
loads: [torque: {body: OA, moment: 6 N*m}]
instant: [phi = 60 deg, omega(OA) = 5 rad/s]
find: {alpha: alpha(OA)}
"""


def test_a_long_equation_of_motion_is_not_multiplied_out() -> None:
    """The same linkage as problems/plans/four-bar-free.yaml; multiplied out, its equation has some 10⁵ terms."""
    (found,) = part_of(FOUR_BAR, "lagrange").found
    assert_close(found, 40.1637, 5)
