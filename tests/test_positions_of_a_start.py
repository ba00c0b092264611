"""A start that is written with coordinates and fits in two positions: the positive one, or the one that is chosen."""

from __future__ import annotations

import pytest
from answered import solve

CRANK = """
title: Crank whose slider may stand on either side
plane: vertical
points: {{O: [0, 0], A: {{from: O, distance: 0.1 m, angle: theta}}, B: [x, 0]}}
coordinates: {{theta: deg, x: m}}
bodies: {{crank: {{rod: [O, A], mass: 1 kg}}, slider: {{particle: B, mass: 2 kg}}}}
joints:
  - pin: {{at: O, between: [ground, crank]}}
  - link: {{between: [A, B], length: 0.3 m}}
  - guide: {{point: B, along: 0 deg}}
states:
  1: [t = 0, theta = 30 deg, omega(crank) = 10 rad/s{chosen}]
  2: [theta = 90 deg]
find: {{v: v(slider).x @ 2, x: x @ 2, x_1: x @ 1}}
"""


@pytest.mark.parametrize(("chosen", "x_1", "x", "v"), [
    ("", 0.382407, 0.282843, -0.539230), (", x > 0", 0.382407, 0.282843, -0.539230),
    (", x < 0", -0.209201, -0.282843, -0.199557), (", x(slider) < 0", -0.209201, -0.282843, -0.199557),
])  # fmt: skip
def test_the_side_on_which_a_slider_stands(chosen: str, x_1: float, x: float, v: float) -> None:
    """x = r cos θ ± √(l² - r² sin² θ), and the work of the weight of the crank; each is followed as well."""
    found = solve(CRANK.format(chosen=chosen))
    told = {name: float(f.values[0]) for name, f in found.items() if f.values}
    assert told == {"x_1": pytest.approx(x_1, abs=1e-5), "x": pytest.approx(x, abs=1e-5), "v": pytest.approx(v, 1e-4)}
