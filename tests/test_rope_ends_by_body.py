"""A rope may end at a body by its name: at a particle, wherever the file puts that, and at the mass centre of another.

Source of the numbers: the drum gives the rope T = (M - I α)/r, the load T - m g = m r α, so that
α = (M - m g r)/(I + m r²), and s = v_0²/(2 r α).
"""

from __future__ import annotations

from decimal import Decimal
from pathlib import Path

import pytest

from planar_cli.homework.checking.checking import read, solve_and_compare

HOIST = """\
title: Load lowered by a brake
plane: vertical
given: {{m: 200 kg, r: 0.1 m, I: 3 kg*m^2, M: 300 N*m, v_0: 1.5 m/s}}
points: {{B: [0, 0], T: [r, 0], L: [r, -2 m]}}
bodies:
  drum: {{disk: B, radius: r, mass: 20 kg, inertia: I}}
  crate: {crate}
joints:
  - pin: {{at: B, between: [ground, drum]}}
  - rope: {{path: [crate, T on drum]}}
loads:
  - torque: {{body: drum, moment: M}}
states:
  1: [v(crate).y = -v_0]
  2: [v(crate).mag = 0]
find: {{s: y(crate) @ 1 - y(crate) @ 2}}
"""


@pytest.mark.parametrize(
    "crate",
    [
        "{particle: L, mass: m}",
        "{particle: [r, -2 m], mass: m}",
        "{plate: L, width: 0.5 m, height: 0.5 m, mass: m}",
    ],
)
def test_a_load_on_a_drum(crate: str, tmp_path: Path) -> None:
    path = tmp_path / "problem.yaml"
    path.write_text(HOIST.format(crate=crate), encoding="utf-8")
    (found,) = solve_and_compare(read(str(path)))[0].parts[0].found
    alpha = (300 - Decimal("196.2")) / (3 + Decimal(200) * Decimal("0.01"))
    assert found.values is not None
    assert abs(found.values[0] - Decimal("2.25") / (Decimal("0.2") * alpha)) < Decimal("1e-12")
