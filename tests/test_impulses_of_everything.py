"""The impulse of everything on a body is the change of its momentum, whatever the forces do in between."""

from __future__ import annotations

import math

import pytest
from answered import first, solve

from planar_cli.formats.terminal import Terminal
from planar_cli.problem.structure import load_text
from planar_cli.report.page.narrate import narrate
from planar_cli.solve.run import solve_problem

PENDULUM = """
title: Bob let go from beside the point of its cord
plane: vertical
{letters}
points: {{O: [0, 0], P: [l, 0]}}
bodies: {{bob: {{particle: P, mass: m}}}}
joints: [link: {{between: [O, P], name: cord}}]
states: {{A: [at rest], B: [x(bob) = 0], C: [v(bob).mag = 0], back: [x(bob) = 0]}}
find: {{J: impulse(bob) @ A->B, H: impulse(bob/O) @ A->B, H_back: impulse(bob/O) @ A->back}}
"""
ROD = """
title: Rod let go from the horizontal
plane: vertical
given: {l: 1.5 m, m: 4 kg}
points: {O: [0, 0], B: [l, 0]}
bodies: {rod: {rod: [O, B], mass: m}}
joints: [pin: {at: O, between: [ground, rod]}]
states: {1: [at rest], 2: [theta(rod) = -90 deg]}
find: {J: impulse(rod) @ 1->2, H: impulse(rod/O) @ 1->2}
"""


def test_of_a_bob_in_letters() -> None:
    problem, wrong = load_text(PENDULUM.format(letters="symbols: {m: kg, l: m}"))
    assert problem is not None, wrong
    page = Terminal(120).render(narrate(solve_problem(problem)))
    assert "Impulse and momentum." in page
    assert "J_x = m v_B = -m √(2 g l)" in page
    assert "H = m v_B l = -m √(2 g l³)" in page
    assert "H_back = m v_back l = m √(2 g l³)" in page
    assert "∫" not in page
    assert "S_cord =" not in page


def test_of_a_bob_in_numbers() -> None:
    found = solve(PENDULUM.format(letters="given: {m: 3 kg, l: 2 m}"))
    assert [float(v) for v in found["J"].values] == pytest.approx([-3 * math.sqrt(2 * 9.81 * 2), 0], abs=1e-12)
    assert first(found["H_back"]) == pytest.approx(6 * math.sqrt(2 * 9.81 * 2))


def test_of_a_rod_about_its_pin() -> None:
    """omega² = 3 g/l; the moment of inertia about the pin is m l²/3, and the pin's force has no moment there."""
    omega, found = math.sqrt(3 * 9.81 / 1.5), solve(ROD)
    assert first(found["H"]) == pytest.approx(-4 * 1.5**2 / 3 * omega)
    assert [float(v) for v in found["J"].values] == pytest.approx([-4 * 0.75 * omega, 0], abs=1e-12)
