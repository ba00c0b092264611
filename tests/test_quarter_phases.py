"""Once the place over time of a simple harmonic motion is written, it tells all that is reached at a quarter of its
period: no balance of energies beside it, and no time that nobody asked for.
"""

from __future__ import annotations

import unicodedata

import pytest

from planar_cli.formats.terminal import Terminal
from planar_cli.problem.structure import load_text
from planar_cli.report.page.narrate import narrate
from planar_cli.solve.run import solve_problem

BLOCK = """
title: Block on a spring
plane: horizontal
given: {{m: 2 kg, k: 200 N/m, l: 0.1 m}}
coordinates: {{x: m}}
points: {{W: [-1 m, 0], P: [x, 0]}}
bodies: {{block: {{particle: P, mass: m}}}}
joints:
  - guide: {{body: block, along: 0 deg}}
loads:
  - spring: {{between: [W, P], stiffness: k, relaxed_at: [x = 0]}}
states:
  1: [t = 0, x = l, at rest]
  2: [x = {place}]
  3: [at rest]
find: {{v: v(block).x @ 2, x_3: x @ 3{more}}}
"""
ENERGY, TIME = "From 1 to 2, work and kinetic energy", ": t_2 = "


def _page(place: str, more: str = "") -> str:
    problem, _ = load_text(BLOCK.format(place=place, more=more))
    assert problem is not None
    page = Terminal(200).render(narrate(solve_problem(problem)))
    return " ".join(unicodedata.normalize("NFC", page).split())


def test_what_is_reached_in_the_middle_follows_from_the_motion_that_is_written() -> None:
    page = _page("0", ", t_3: t @ 3")
    assert "cos(ω_n t_2) = 0" in page
    assert "ẋ_2 = -l ω_n sin(π/2) = -l ω_n = -0.1 · 10 = -1 m/s" in page
    assert "x_3 = l cos π = -l = -0.1 m" in page
    assert ENERGY not in page
    assert TIME not in page


def test_a_time_that_is_asked_stays() -> None:
    assert f"{TIME}π/(2 ω_n)" in _page("0", ", t_2: t @ 2")


@pytest.mark.parametrize(("place", "more"), [("0", ""), ("0.06 m", ", t_3: t @ 3")])
def test_energies_tell_a_speed_where_no_time_is_asked_or_the_phase_is_no_quarter(place: str, more: str) -> None:
    assert ENERGY in _page(place, more)
