"""A pin that holds a particle somewhere else than where it is."""

from __future__ import annotations

import pytest

from planar_cli.problem.structure import load_text

HOOP = """
title: Bead on a hoop that turns on a table
plane: horizontal
symbols: {{m: kg, R: m, w: rad/s}}
coordinates: {{theta: rad, phi: rad}}
points:
  O: [0, 0]
  C: {{from: O, distance: R, angle: theta}}
  P: {{from: C, distance: R, angle: theta + phi}}
surfaces: {{wire: {{center: C, radius: R, body: hoop}}}}
bodies: {{hoop: {{ring: C, radius: R, points: [O]}}, bead: {{particle: P, mass: m}}}}
joints:
  - pin: {{at: O, between: [ground, {body}]}}
  - guide: {{point: P, along: wire}}
motion: [omega(hoop) = w]
find: {{eom: ddot(phi)}}
"""
NUMBERS = """
title: Particle pinned to a ring
plane: horizontal
given: {{a: 1 m}}
points: {{O: [0, 0], P: {place}, C: [0, a]}}
bodies: {{bead: {{particle: P, mass: 1 kg}}, hoop: {{ring: C, radius: a, mass: 2 kg, points: [O]}}}}
joints:
  - pin: {{at: O, between: [hoop, bead]}}
states: {{1: [t = 0, omega(hoop) = 1 rad/s, v(C) = 0], 2: [t = 1 s]}}
find: {{v: v(bead).mag @ 2}}
"""


@pytest.mark.parametrize(("text", "message"), [
    (HOOP.format(body="bead"), "the pin holds bead at O, and bead is a particle at P, which moves with phi, theta"),
    (HOOP.format(body="hoop"), ""),
    (NUMBERS.format(place="[a, 0]"), "the pin holds bead at O, and bead is a particle at P"),
    (NUMBERS.format(place="[0 m, a - 1 m]"), ""),
])  # fmt: skip
def test_a_particle_is_held_where_it_is(text: str, message: str) -> None:
    _, wrong = load_text(text)
    assert [(d.code, d.message) for d in wrong] == ([("PL465", message)] if message else [])
