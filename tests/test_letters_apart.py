"""One letter for one thing: a quantity of a body gives way where the file calls a number so."""

from __future__ import annotations

import re

from conftest import ROOT

from planar_cli.formats.terminal import Terminal
from planar_cli.problem.structure import load_text
from planar_cli.report.notation.names import latex_name, plain_name
from planar_cli.report.page.narrate import narrate
from planar_cli.solve.run import solve_problem

WEDGE = """
title: Block on a rope round a pulley on another block
plane: vertical
given: {m_A: 1 kg, m_B: 2 kg, mu: 0.1, F: 50 N, x_B: 0.3 m}
points: {A: [0, 0], B: [1 m, 0], W: [10 m, 0]}
surfaces: {floor: {through: A, angle: 0 deg}}
bodies:
  one: {particle: A, mass: m_A}
  two: {particle: B, mass: m_B}
joints:
  - contact: {between: [one, floor], at: A, mu: mu}
  - contact: {between: [two, floor], at: B, mu: mu}
  - rope: {path: [B, A, W], along: 0 deg, name: rope}
loads:
  - force: {body: two, magnitude: F, angle: 0 deg}
states:
  1: [at rest]
  2: [x(B) = 1 m + x_B]
find: {v: v(two).x @ 2}
"""


def _page(text: str) -> str:
    problem, wrong = load_text(text, "scene.yaml")
    assert problem is not None, wrong
    return " ".join(Terminal(width=200).render(narrate(solve_problem(problem))).split())


def test_a_place_beside_a_number_of_that_name() -> None:
    page = _page(WEDGE)
    assert "2: x_B′ = 1 m + x_B" in page
    assert "x_B′ - 2 x_A = const." in page
    assert "Δx_B′ = 2 Δx_A" in page
    assert "x_A,2 = x_B/2 = 0.3/2 = 0.15 m" in page
    assert not re.search(r"x_B = 1 m|x_B -|Δx_B =", page)


def test_no_prime_where_the_file_has_another_letter() -> None:
    page = _page(WEDGE.replace("x_B", "d"))
    assert "2: x_B = 1 m + d" in page
    assert "Δx_B = 2 Δx_A" in page


def test_a_vector_beside_its_given_size() -> None:
    """The file gives v_O = 1 m/s: the velocity of O has an arrow, and so have the other vectors of the page."""
    text = (ROOT / "problems" / "textbook" / "ex-4-07.yaml").read_text(encoding="utf-8")
    text = text.replace("find:\n", "find:\n  omega_disk: omega(disk)\n").partition("answers:")[0]
    page = _page(text)
    assert "v⃗_O = ω_disk × r⃗_O/C r⃗_O/C = [0, 0.1] m Given: v_Ox = v_O (1) -r ω_disk = v_O" in page
    assert "ω_rod = v_O/IO" in page
    assert "1/2 M v_O²" in page
    assert "⃗" not in _page(text.replace("v_O", "u"))


def test_arrows_in_mathematics() -> None:
    assert plain_name("v_O_vec") == "v⃗_O"
    assert latex_name("v_O_vec") == r"\vec{v}_{O}"


def test_letters_of_vectors_without_a_product() -> None:
    """a_P = -ω² r_P/G is a line of vectors as well."""
    page = _page(ROLLING)
    assert "a⃗_P = -ω_wheel² r⃗_P/G" in page
    assert "a⃗_B = a⃗_P + α_PB × r⃗_B/P - ω_PB² r⃗_B/P" in page
    assert "-R ω_wheel = v_G" in page


ROLLING = """
title: Rolling wheel that drives a slider
given: {R: 0.3 m, e: 0.2 m, l: 0.8 m, v_G: 1.2 m/s}
points:
  C: [0, 0]
  G: [0, R]
  P: {from: G, distance: e, angle: 30 deg}
  B: {y: R, distances: {P: l}, side: right}
surfaces: {floor: {through: C, angle: 0 deg}}
bodies:
  wheel: {disk: G, radius: R, points: [P]}
  PB: {rod: [P, B]}
joints:
  - rolling: {between: [wheel, floor], at: C}
  - pin: {at: P, between: [wheel, PB]}
  - guide: {point: B, along: 0 deg}
motion: [v(G).x = v_G]
find: {a_B: a(B).x}
"""
