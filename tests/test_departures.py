"""What is touched lightly in an unstable equilibrium goes to the side on which it comes to the next state first."""

from __future__ import annotations

from math import acos, pi

import pytest
from answered import number, solve

ROLLER = """
title: Cylinder that rolls off a fixed cylinder
plane: vertical
given: {{R: 300 mm, r: 100 mm}}
points: {{O: [0, 0], C: [0, R], G: [0, R + r]}}
surfaces: {{drum: {{center: O, radius: R}}}}
bodies: {{roller: {{disk: G, radius: r, mass: 2 kg}}}}
joints:
  - rolling: {{between: [roller, drum], at: C}}
states:
  top: [at rest]
  leaves: [N(C) = 0{side}]
find: {{phi: r(G).angle @ leaves - 90 deg}}
"""


@pytest.mark.parametrize(("side", "sense"), [("", 1), (", x(G) < 0", 1), (", x(G) > 0", -1)])
def test_it_leaves_at_once_on_either_side(side: str, sense: int) -> None:
    """Not after a way round below: cos φ = 4/7 is met first on the side that the file says."""
    phi = float(number(solve(ROLLER.format(side=side))["phi"]))
    assert phi == pytest.approx(sense * acos(4 / 7), abs=1e-9)
    assert abs(phi) < pi / 2
