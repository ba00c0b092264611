"""The second road finds by itself where a coordinate is driven, and what that takes."""

from __future__ import annotations

import pytest
import sympy as sp
from answered import solve

from planar_cli.equation.system.system import System
from planar_cli.errors import Undecided
from planar_cli.later import loaded
from planar_cli.problem.scene.facts import Action
from planar_cli.problem.scene.geometry import Vec

ROD = """
title: Rod that is turned by its angle
plane: vertical
given: {m: 2 kg, L: 1.2 m}
coordinates: {theta: deg}
points: {A: [0, 0], B: {from: A, distance: L, angle: theta}}
bodies: {rod: {rod: [A, B], mass: m}}
joints:
  - pin: {at: A, between: [ground, rod]}
motion: [MOTION]
instant: [INSTANT]
find: {R: reaction(A)}
"""
BY_RATE = ROD.replace("MOTION", "ddot(theta) = 3 rad/s^2").replace("INSTANT", "theta = 30 deg, dot(theta) = 2 rad/s")
BY_TIME = ROD.replace("MOTION", "theta = 0.5 rad + (3 rad/s^2)*t^2").replace("INSTANT", "t = 0.5 s")
LINKS = """
title: Two links, with the angle between them driven
plane: vertical
given: {m: 2 kg}
coordinates: {theta: deg, phi: deg}
points: {A: [0, 0], B: {from: A, distance: 1 m, angle: theta}, C: {from: B, distance: 1 m, angle: theta + phi}}
bodies: {AB: {rod: [A, B], mass: m}, BC: {rod: [B, C], mass: m}}
joints:
  - pin: {at: A, between: [ground, AB]}
  - pin: {at: B, between: [AB, BC]}
motion: [ddot(theta) = 1 rad/s^2, ddot(phi) = -2 rad/s^2]
instant: [theta = 30 deg, phi = 40 deg, dot(theta) = 1 rad/s, dot(phi) = 0.5 rad/s]
find: {R: reaction(B/BC)}
"""
BEAD = """
title: Bead that is pushed along a turning rod
plane: vertical
given: {m: 2 kg}
coordinates: {theta: deg, r: m}
points: {A: [0, 0], B: {from: A, distance: 2 m, angle: theta}, P: {from: A, distance: r, angle: theta}}
bodies: {rod: {rod: [A, B], mass: 1 kg}, bead: {particle: P, mass: m}}
joints:
  - pin: {at: A, between: [ground, rod]}
  - guide: {point: P, along: rod}
motion: [dot(theta) = 3 rad/s, ddot(r) = 0.4 m/s^2]
instant: [theta = 30 deg, r = 0.7 m, dot(r) = 1 m/s]
find: {R: reaction(A)}
"""


@pytest.mark.parametrize("text", [BY_RATE, BY_TIME, LINKS, BEAD])
def test_both_roads_agree(text: str) -> None:
    assert solve(text)["R"].values


@pytest.mark.parametrize("text", [BY_RATE, BY_TIME])
def test_a_drive_at_another_place_is_found_out(text: str, monkeypatch: pytest.MonkeyPatch) -> None:
    """The first road lets a force act at the mass centre, along x, of the rod."""

    def elsewhere(system: System, q: sp.Symbol) -> tuple[Action, ...]:
        return (Action("rod", system.scene.center("rod"), Vec(sp.S.One, sp.S.Zero), sp.S.Zero),)

    # The module itself, which is loaded late.
    monkeypatch.setattr(loaded("planar_cli.equation.system.driving"), "_working_on", elsewhere)
    with pytest.raises(Undecided):
        solve(text)
