"""Blows are checked by the work of their impulses, which is the change of kinetic energy."""

from __future__ import annotations

import re

import pytest
from worked import page_of_file

from planar_cli.formats.terminal import Terminal
from planar_cli.problem.structure import load_text
from planar_cli.report.page.narrate import narrate
from planar_cli.solve.run import solve_problem

ONE = r"\([uc] \+ [uc]′\)/2 = (\S+) \((\S+) \+ (\S+)\)/2 = (\S+) J; T′ - T = (\S+) - (\S+) = (\S+) J"


@pytest.mark.parametrize("stem", ["puck-hits-a-free-rod", "ball-strikes-the-end-of-a-pinned-rod", "ex-4-14"])
def test_one_impulse(stem: str) -> None:
    """Of ex-4-14 the impulse is found by the momentum of the ball alone: the page had no need of it."""
    found = re.search(ONE, page_of_file(stem))
    assert found is not None
    size, before, after, work, last, first, change = (float(x) for x in found.groups())
    assert size * (before + after) / 2 == pytest.approx(work, rel=3e-3)
    assert last - first == pytest.approx(work, rel=3e-3)
    assert change == work


def test_several_impulses() -> None:
    found = re.search(
        r"Σ J \(u \+ u′\)/2 = (\S+) - (\S+) = (\S+) J; T′ - T = (\S+) - (\S+) =", page_of_file("wheel-over-a-kerb")
    )
    assert found is not None
    one, other, work, last, first = (float(x) for x in found.groups())
    assert one - other == pytest.approx(work)
    assert last - first == pytest.approx(work, rel=3e-3)


@pytest.mark.parametrize("stem", ["rod-caught-and-let-go", "ball-bouncing-twice"])
def test_the_blow_before_the_fall_that_leads_to_it(stem: str) -> None:
    page = page_of_file(stem)
    assert "(u + u′)/2" in page
    assert "Check work and energy" not in page


def test_none_in_letters() -> None:
    assert "T′ - T" not in page_of_file("hinged-bars-struck")


def test_a_velocity_that_vanishes_has_no_digits() -> None:
    """Caught without restitution, the point struck stands still: what rounding leaves of it is not told."""
    text = """plane: vertical
points: {A: [0, 0], E: {from: A, distance: 0.8 m, angle: 30 deg}}
bodies:
  rod: {rod: [A, 30 deg], length: 1 m, mass: 2 kg}
  edge: {particle: E}
joints:
  - weld: {at: E, between: [edge, ground]}
  - impact: {between: [rod, edge], restitution: 0}
states:
  1: [v(rod).x = 0 m/s, v(rod).y = -3 m/s, omega(rod) = 0 rad/s]
  2: [just after 1]
find: {w: omega(rod) @ 2}
"""
    problem, wrong = load_text(text)
    assert problem is not None, wrong
    page = " ".join(Terminal(300).render(narrate(solve_problem(problem))).split())
    assert "2.498 (-2.598 + 0)/2 = -3.245 J" in page
