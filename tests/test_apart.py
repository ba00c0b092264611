"""An impact acts only between bodies that touch: places that a state fixes are not overruled."""

from __future__ import annotations

import pytest
from answered import first, solve

from planar_cli.errors import NoSolution

DISKS = """
title: Two disks
plane: horizontal
points: {P: [0, 0], Q: [%s, 0]}
bodies:
  A: {disk: P, radius: 10 mm, mass: 1 kg}
  B: {disk: Q, radius: 10 mm, mass: 2 kg}
joints:
  - impact: {between: [A, B], restitution: 0.5%s}
states:
  1: [t = 0, v(A).x = 1 m/s, v(A).y = 0, B at rest, omega(A) = 0%s]
  2: [%s]
  3: [just after 2]
find: {v: v(B).x @ 3}
"""
AT_ONCE = DISKS.replace("  2: [%s]\n  3: [just after 2]", "  2: [just after 1]").replace("@ 3", "@ 2")
PARTICLES = AT_ONCE.replace("disk: P, radius: 10 mm", "particle: P").replace("disk: Q, radius: 10 mm", "particle: Q")


def test_disks_that_meet() -> None:
    """m_A m_B/(m_A + m_B) (1 + e) v_A / m_B = (2/3)(3/2)/2."""
    assert first(solve(DISKS % ("50 mm", "", "", "x(B) - x(A) = 20 mm"))["v"]) == pytest.approx(0.5)


@pytest.mark.parametrize("during", ["", ", during: 2->3"])
def test_a_motion_that_leads_them_less_near(during: str) -> None:
    with pytest.raises(NoSolution, match=r"A and B do not touch in state 2: they are 0\.01 m apart"):
        solve(DISKS % ("50 mm", during, "", "x(B) - x(A) = 30 mm"))


@pytest.mark.parametrize("stated", ["", ", x(B) - x(A) = 50 mm, y(B) = y(A)"])
def test_disks_drawn_apart(stated: str) -> None:
    with pytest.raises(NoSolution, match=r"A and B do not touch in state 1: they are 0\.03 m apart"):
        solve(AT_ONCE % ("50 mm", "", stated))


def test_the_gap_is_measured_by_the_scene() -> None:
    """A gap of 0.03 mm is one between disks of a hundredth of a millimetre, and none on a way of a metre."""
    small = AT_ONCE.replace("10 mm", "10e-6 m")
    with pytest.raises(NoSolution, match="do not touch in state 1"):
        solve(small % ("50e-6 m", "", ""))
    assert first(solve(DISKS % ("1.02 m", "", "", "x(B) - x(A) = 20.03 mm"))["v"]) == pytest.approx(0.5)


def test_particles_that_the_state_holds_apart() -> None:
    text = PARTICLES % ("50 mm", ", normal: 0 deg", ", x(B) - x(A) = 50 mm, y(B) = y(A)")
    with pytest.raises(NoSolution, match=r"A and B do not touch in state 1: they are 0\.05 m apart"):
        solve(text.replace(", omega(A) = 0", ""))


def test_particles_that_are_only_drawn_apart() -> None:
    """They stand for bodies of any size."""
    text = PARTICLES % ("50 mm", ", normal: 0 deg", "")
    assert first(solve(text.replace(", omega(A) = 0", ""))["v"]) == pytest.approx(0.5)


def test_the_gap_is_told_in_the_units_of_the_file() -> None:
    text = """plane: horizontal
given: {W: 2 lbf}
bodies:
  A: {disk: [0, 0], radius: 1 ft, weight: W}
  B: {disk: [3 ft, 0], radius: 0.5 ft, weight: W}
joints:
  - impact: {between: [A, B], restitution: 0.5}
states:
  1: [v(A).x = 5 ft/s, v(A).y = 0 ft/s, omega(A) = 0 rad/s, B at rest]
  2: [just after 1]
find: {v: v(B).x @ 2}
"""
    with pytest.raises(NoSolution, match=r"A and B do not touch in state 1: they are 1\.5 ft apart"):
        solve(text)


def test_a_link_that_does_not_fit_is_told_in_the_units_of_the_file() -> None:
    text = """plane: vertical
points: {A: [0, 0], B: [3 ft, 0]}
bodies: {P: {particle: B, weight: 4 lbf}}
joints:
  - link: {between: [A, P], length: 2.5 ft}
instant: [at rest]
find: {a: a(P).mag}
"""
    with pytest.raises(NoSolution, match=r"length is off by 0\.5 ft"):
        solve(text)
