"""A load of unknown size along a prescribed motion is what keeps it going, with and without mass."""

from __future__ import annotations

import pytest
from answered import solve

SLIDER = """
title: Slider that is moved as prescribed
plane: vertical
given: {m: 2 kg}
unknowns: {S: N}
points: {A: [0, 0], B: [0, -1 m]}
bodies: {slider: {particle: A}, bob: {particle: B, mass: m}}
joints:
  - guide: {point: A, along: 0 deg}
  - link: {between: [A, B]}
loads:
  - force: {body: slider, magnitude: S, angle: 0 deg}
motion: [a(A).x = 3 m/s^2]
instant: [v(A).x = 0, v(bob).x = 0]
find: {S: S}
"""
BESIDE = SLIDER.replace("B: [0, -1 m]", "B: [-1 m, 0]").replace(
    "joints:", "joints:\n  - guide: {point: B, along: 0 deg}"
)


@pytest.mark.parametrize(
    ("text", "mass", "force"),
    [(SLIDER, "", 0), (SLIDER, ", mass: 4 kg", 12), (BESIDE, "", 6), (BESIDE, ", mass: 4 kg", 18)],
)
def test_it_drives(text: str, mass: str, force: float) -> None:
    """A load that hangs at rest does not resist; one that is pulled along does."""
    found = solve(text.replace("{particle: A}", f"{{particle: A{mass}}}"))
    assert float(found["S"].values[0]) == pytest.approx(force, abs=1e-12)
