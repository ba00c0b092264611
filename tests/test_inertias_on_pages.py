"""Moments of inertia on which energies and momenta rest have their line: m l²/12, and of parts by their distances."""

from __future__ import annotations

import re

import pytest
from worked import page_of_file

from planar_cli.formats.terminal import Terminal
from planar_cli.problem.structure import load_text
from planar_cli.report.page.narrate import narrate
from planar_cli.solve.run import solve_problem


@pytest.mark.parametrize(
    ("stem", "words"),
    [
        ("ex-4-13", "moment of inertia of rod: I = 1/12 m AB² = 1/12 · 12 · 2² = 4 kg·m²"),
        ("ex-4-13", "about A, parallel axes: I_A = I + m AG² = 4 + 12 · 1² = 16 kg·m²"),
        ("gyration-from-test", "I_rotor = m k² = 40 · 0.206307² = 1.7025 kg·m²"),
        ("puck-hits-a-free-rod", "I_rod = 1/12 m_rod l² = 1/12 · 2 · 1.2² = 0.24 kg·m²"),
        ("dumbbell-hit-by-a-ball", "= 3 (0.9 - 0.675)² + 1 · 0.675² = 0.6075 kg·m²"),
        ("rod-and-disk-pendulum", "I = I_O - m OG² = 3.68667 - 6 · 0.73333² = 0.46 kg·m²"),
    ],
)
def test_their_lines(stem: str, words: str) -> None:
    assert words in page_of_file(stem)


def test_each_once() -> None:
    """An energy before and an instant after it rest on the same one."""
    assert page_of_file("exercise-4-35").count("moment of inertia of rod") == 1


def test_none_that_nothing_uses() -> None:
    """The balance of energies counts with the mass centre, not with the pin."""
    assert "I_O" not in page_of_file("exercise-4-35")


def test_a_sought_size_has_no_number_before_it_is_found() -> None:
    """In the second case of the yo-yo the radius of gyration is what is asked."""
    page = page_of_file("yo-yo")
    assert page.count("I_G = m k_G²") == 2
    assert "0.03834² " not in page


def test_a_body_of_parts_beside_another_has_letters_of_its_own() -> None:
    page = page_of_file("dumbbell-hit-by-a-ball")
    assert "m_C = 0.6 kg" in page
    assert "m_dumbbell" in page


GUIDED = """
plane: horizontal
points: {O: [0, 0], E: [1 m, 0], A: [0.3 m, 0]}
bodies: {rod: {rod: [O, E], mass: 2 kg}, one: {sphere: A, radius: 0.1 m, mass: 3 kg}}
joints:
  - pin: {at: O, between: [ground, rod]}
  - guide: {body: one, along: rod, name: one}
loads: [torque: {body: rod, moment: 5 N*m}]
instant: [at rest]
find: {alpha: alpha(rod), M: moment(one/one)}
"""


def test_what_turns_with_its_guide_is_turned_by_a_couple_of_it() -> None:
    """The free-body diagram has it, as the kinetic one has I α; a body that does not turn needs none."""
    problem, wrong = load_text(GUIDED)
    assert problem is not None, wrong
    page = " ".join(Terminal(200).render(narrate(solve_problem(problem))).split())
    assert re.search(r"one: N_one \S+ at A, M ↺ =", page)
    assert "M_rails" not in page_of_file("gun-on-rails")


TWO_WEIGHTS = """
plane: vertical
given: {m: 6 kg, b: 0.6 m, c: 0.5 kg}
points: {O: [0, 0], A: [0.2 m, 0], B: [-0.2 m, 0]}
bodies:
  plate:
    parts: [{plate: O, width: b, height: b, mass: m}, {disk: A, radius: 0.1 m, mass: c}, {particle: B, mass: c}]
find: {m_all: mass(plate), I_G: I(plate)}
"""


def test_what_is_asked_of_a_mass_is_derived() -> None:
    """The mass centre, which the weights leave in the middle, needs no line."""
    problem, wrong = load_text(TWO_WEIGHTS)
    assert problem is not None, wrong
    page = " ".join(Terminal(200).render(narrate(solve_problem(problem))).split())
    assert "mass of plate: m′ = m + 2 c = 6 + 2 · 0.5 = 7 kg" in page
    assert "I_2 = 1/2 c r² = 1/2 · 0.5 · 0.1² = 0.0025 kg·m²" in page
    assert "mass centre of plate:" not in page


def test_about_another_point_it_is_one_product_where_it_can_be() -> None:
    page = page_of_file("box-that-tips-over")
    assert "I_G = 1/12 m (b² + h²) = 1/12 · 40 (0.6² + 1²) = 4.533 kg·m²" in page
    assert "I_C = 1/4 m (b² + h²) + I_G = 1/3 m (b² + h²) = 1/3 · 40 (0.6² + 1²) = 18.13 kg·m²" in page
    assert "I_A = 1/4 m l² + I = 1/3 m l² = 1/3 · 1.5528 · 12² = 74.53 slug·ft²" in page_of_file("falling-pole")
