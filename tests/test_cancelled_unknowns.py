"""An unknown may stand in an equation in which it cancels: α of a bar about a pin of one at right angles to it."""

from __future__ import annotations

from pathlib import Path

from worked import page_of_text

CHAIN = """\
title: Bars, two of them at right angles
plane: vertical
given: {m: 2 kg, l: 1 m, F: 20 N}
points:
  O: [0, 0]
  A: [l, 0]
  B: {from: A, distance: l, angle: 20 deg}
  C: {from: B, distance: l, angle: -30 deg}
  D: {from: C, distance: l, angle: 60 deg}
bodies:
  OA: {rod: [O, A], mass: m}
  AB: {rod: [A, B], mass: m}
  BC: {rod: [B, C], mass: m}
  CD: {rod: [C, D], mass: m}
joints:
  - pin: {at: O, between: [ground, OA]}
  - pin: {at: A, between: [OA, AB]}
  - pin: {at: B, between: [AB, BC]}
  - pin: {at: C, between: [BC, CD]}
loads:
  - force: {body: CD, at: D, magnitude: F, angle: 90 deg}
instant: [at rest]
find: {alpha: alpha(OA)}
"""


def test_bars_at_right_angles(tmp_path: Path) -> None:
    page = page_of_text(tmp_path, CHAIN)
    assert "Answer α = α_OA = -11.47 rad/s², that is 11.47 rad/s² clockwise" in page
    assert "checked by an independent multibody solution" in page
