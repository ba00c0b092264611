"""A stepped wheel on the `ground`: it stands with its larger radius, or with its hub on a rail where it is drawn so."""

from __future__ import annotations

import pytest
from answered import number, solve

WHEEL = """
title: Stepped wheel
plane: vertical
given: {{m: 40 kg, k_G: 0.25 m, R: 0.4 m, r: 0.15 m, P: 50 N}}
points: {{G: [0, {height}], T: {{from: G, distance: R, angle: {side} deg}}}}
bodies: {{wheel: {{disk: G, radius: R, hub: r, mass: m, radius_of_gyration: k_G}}}}
joints:
  - rolling: {{between: [wheel, {floor}]}}
loads:
  - force: {{body: wheel, wound_at: T, magnitude: P, angle: 0 deg}}
instant: [at rest]
find: {{alpha: alpha(wheel)}}
"""


@pytest.mark.parametrize(
    ("height", "step", "side"), [("R", 0.4, 90), ("0 m", 0.4, 90), ("r", 0.15, 90), ("r", 0.15, -90)]
)
def test_it_rolls_on_the_step_that_stands_on_the_ground(height: str, step: float, side: int) -> None:
    """Moments about the point of contact: α = -P (step ± R) / (m (k_G² + step²))."""
    found = solve(WHEEL.format(height=height, side=side, floor="ground"))
    arm = step + (0.4 if side > 0 else -0.4)
    assert float(number(found["alpha"])) == pytest.approx(-50 * arm / (40 * (0.25**2 + step**2)))
