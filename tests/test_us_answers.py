"""In feet and pounds: answers that are read off a motion, and checks by energies, are told in feet and pounds."""

from __future__ import annotations

from planar_cli.formats.terminal import Terminal
from planar_cli.problem.structure import load_text
from planar_cli.report.page.narrate import narrate
from planar_cli.solve.run import solve_problem

BLOCK = """
title: Spring-mounted block on a rough floor
plane: vertical
given: {g: 32.2 ft/s^2, W: 10 lbf, k: 20 lbf/ft, mu: 0.22}
points: {O: [-3 ft, 0], P: [1 ft, 0]}
bodies: {block: {particle: P, weight: W}}
joints:
  - contact: {between: [block, ground], mu: mu, name: C}
loads:
  - spring: {between: [O, P], stiffness: k, natural_length: 3 ft}
states: {1: [t = 0, at rest], end: [mode(C) = stick]}
find: {x: x(block) @ end, d: path_length(block) @ 1->end, Q: heat(C) @ 1->end}
"""
SLIDE = """
title: Block down a smooth slope
plane: vertical
given: {g: 32.2 ft/s^2, W: 12 lbf, s: 2 ft, beta: 30 deg}
points: {P: [0, 0]}
surfaces: {slope: {through: P, angle: -beta}}
bodies: {block: {particle: P, weight: W}}
joints:
  - contact: {between: [block, slope], at: P, mu: 0}
states: {1: [t = 0, at rest], 2: [x(block) = s*cos(beta)]}
find: {v: v(block).mag @ 2, t: t @ 2}
"""


def _page(text: str) -> str:
    problem, wrong = load_text(text)
    assert problem is not None
    assert not wrong
    return " ".join(Terminal(200).render(narrate(solve_problem(problem))).split())


def test_what_is_read_off_is_converted_once() -> None:
    """Each half swing ends 0.22 ft (2 μ W/k) short: 1.78 + 1.34 + 0.90 + 0.46 + 0.02 ft, on the near side at last."""
    page = _page(BLOCK)
    assert "x = 0.1000 ft" in page
    assert "d = 4.500 ft" in page
    assert "Q = 9.900 lbf·ft" in page


def test_no_joule_in_a_check() -> None:
    assert not [word for word in _page(SLIDE).split() if word == "J"]
