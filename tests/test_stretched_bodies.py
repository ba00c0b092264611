"""A body whose points are written so that their distance would change is refused; one that ties coordinates is not."""

from __future__ import annotations

import math

import pytest
from answered import solve

from planar_cli.errors import NoSolution

LADDER = """
title: Ladder whose foot is drawn away
given: {l: 2 m, v: 1 m/s}
coordinates: COORDINATES
points: {A: [s, 0], B: PLACE}
bodies: {ladder: {rod: [A, B]LENGTH}}
joints:
  - guide: {point: A, along: 0 deg}
  - guide: {point: B, along: 90 deg}
motion: [dot(s) = v]
MOMENT
"""
STATES = "states: {1: [s = 1 m], 2: [s = 1.2 m]}\nfind: {w: omega(ladder) @ 2}"
FORMULA = "find: {w: omega(ladder)}"
SLOTTED = """
title: Slotted arm
given: {R: 50 mm, l: 80 mm, w: 10 rad/s}
coordinates: {phi: deg}
points: {O: [0, 0], B: [l, 0], P: {from: B, distance: R, angle: phi}}
bodies: {crank: {rod: [B, P]}, arm: {rod: [O, P]}}
joints:
  - pin: {at: O, between: [ground, arm]}
  - pin: {at: B, between: [ground, crank]}
  - JOINT
motion: [omega(crank) = w]
states: {1: [phi = 150 deg], 2: [phi = 200 deg]}
find: {omega: omega(arm) @ 2}
"""


def ladder(place: str, moment: str, coordinates: str = "{s: m}", length: str = "") -> str:
    text = LADDER.replace("PLACE", place).replace("MOMENT", moment).replace("COORDINATES", coordinates)
    return text.replace("LENGTH", length)


@pytest.mark.parametrize("moment", [STATES, FORMULA])
def test_a_ladder_whose_upper_end_is_written_as_fixed(moment: str) -> None:
    with pytest.raises(NoSolution) as refused:
        solve(ladder("[0, l]", moment))
    why = refused.value.diagnostics[0]
    assert (why.code, why.mark.line) == ("PL625", 6)
    assert why.message == "A and B are points of ladder, and as s varies they are not always equally far apart"


@pytest.mark.parametrize(
    ("place", "coordinates"),
    [("[0, sqrt(l^2 - s^2)]", "{s: m}"), ("{x: 0, distances: {A: l}, side: above}", "{s: m}")],
)
def test_a_ladder_whose_ends_keep_their_distance(place: str, coordinates: str) -> None:
    found = solve(ladder(place, STATES, coordinates))["w"].values
    assert found is not None
    # cos = s/l of the angle of the ladder, differentiated.
    assert float(found[0]) == pytest.approx(1 / math.sqrt(2**2 - 1.2**2))


def test_at_one_instant_a_place_is_as_it_is_then() -> None:
    found = solve(ladder("[0, l]", "instant: [s = 1.2 m]\nfind: {w: omega(ladder)}"))["w"].values
    assert found is not None
    assert float(found[0]) == pytest.approx(0.5)


def test_a_slotted_arm_may_end_at_the_pin_that_runs_in_it() -> None:
    found = solve(SLOTTED.replace("JOINT", "guide: {point: P, along: arm}"))["omega"].values
    assert found is not None
    # In polar coordinates about O.
    x, y = 80 + 50 * math.cos(math.radians(200)), 50 * math.sin(math.radians(200))
    assert float(found[0]) == pytest.approx((x * 10 * (x - 80) + y * 10 * y) / (x * x + y * y))


def test_an_arm_that_is_pinned_there_would_have_to_stretch() -> None:
    with pytest.raises(NoSolution, match="O and P are points of arm"):
        solve(SLOTTED.replace("JOINT", "pin: {at: P, between: [crank, arm]}"))
