"""Numbers of joints and loads that the file writes where they stand have their letters on the page."""

from __future__ import annotations

import re

import pytest
from conftest import ROOT
from worked import worked

from planar_cli.formats.terminal import Terminal
from planar_cli.problem.implied.lettered import lettered
from planar_cli.problem.structure import load_text
from planar_cli.report.page.narrate import narrate
from planar_cli.solve.run import solve_problem


def _page(name: str) -> str:
    return Terminal(width=110).render(narrate(worked(ROOT / "problems" / f"{name}.yaml")[0]))


@pytest.mark.parametrize(
    ("name", "equation"),
    [
        ("friction/crate-pulled", "P cos 25° - μ_k N_A = m a"),
        ("friction/stacked-blocks", "P - μ_A N_A - μ_B N_B = m_B a_B"),
        ("friction/spool-rolls-or-slips", "P r_h - μ_k N_C R = I_G α"),
        ("rigid-bodies/built-in-beam-with-prop", "F cos 35° + A_x = 0"),
    ],
)
def test_letters_in_equations(name: str, equation: str) -> None:
    page = _page(name)
    assert equation in page
    assert not re.search(r"\d N_[A-Z]\b", page.split("Answer")[0])


FILE = """
plane: vertical
given: {mu: 0.5}
points: {A: [0, 0], B: [1 m, 0]}
bodies:
  a: {particle: A, mass: 2 kg}
  b: {particle: B, mass: 3 kg}
joints:
  - contact: {between: [a, ground], mu: 0.2}
  - contact: {between: [b, ground], mu: 0.3}
loads:
  - force: {body: a, magnitude: 4 N, angle: 0 deg}
instant: [at rest]
find: {a_a: a(a).x}
"""


def test_names_that_are_free() -> None:
    """Two numbers have two letters, and a name of the file is never taken."""
    problem = lettered(load_text(FILE, "x.yaml")[0])
    values = {s.name: s.value for s in problem.given}
    assert {"mu", "mu_a", "mu_b", "F"} <= set(values)
    assert [str(j.mu.name) for j in problem.joints] == ["mu_a", "mu_b"]
    again = lettered(problem)
    assert again == problem


def test_beside_letters_a_number_stays() -> None:
    """An answer in letters of the file holds the coefficient as the number that it is."""
    lines = FILE.replace("given: {mu: 0.5}", "symbols: {m: kg}")
    assert lettered(load_text(lines, "x.yaml")[0]).given == ()


def test_a_length_and_an_elastic_blow_stay_numbers() -> None:
    """A natural length cancels against places; e = 1 says that the speeds are exchanged."""
    page = _page("impact/cart-against-a-cart-on-a-buffer")
    assert "5 l_0" not in page


def test_radii_of_wheels_get_letters_that_cancel_against_places() -> None:
    """The rack touches the pinion 40 mm below its centre, which is the radius."""
    page = _page("motion/rack-driven-by-a-crossed-belt")
    assert "r_wheel ω_wheel = -r_driver ω_driver" in page
    assert "s = r_pinion θ_wheel,2" in page


def test_members_of_one_name_keep_their_own_numbers() -> None:
    """Two forces on one body, without names, and two contacts of one particle."""
    problem, _ = load_text(TWO_FORCES)
    assert problem is not None
    (found,) = (f for part in solve_problem(problem).parts for f in part.found)
    assert found.values is not None
    assert float(found.values[0]) == pytest.approx((12 - 3) / 2)


TWO_FORCES = """
plane: horizontal
points: {P: [0, 0]}
bodies: {ball: {particle: P, mass: 2 kg}}
joints: [guide: {point: P, along: 0 deg}]
loads:
  - force: {body: ball, magnitude: 12 N, angle: 0 deg}
  - force: {body: ball, magnitude: 3 N, angle: 180 deg}
instant: [at rest]
find: {a: a(ball).x}
"""
