"""The largest acceleration of a truck before its load slips or tips, however little is said of its speed."""

from __future__ import annotations

import pytest
from answered import solve

from planar_cli.errors import NoSolution

TRUCK = """
title: Crate on a truck that brakes
plane: vertical
given: {{b: {b}, h: 1.5 m, mu: 0.5, m: 80 kg}}
{unknowns}
points: {{G: [0, h/2], Q: [-b, 0]}}
surfaces: {{bed: {{through: Q, angle: 0 deg, body: truck}}}}
bodies:
  truck: {{points: [Q]}}
  crate: {{plate: G, width: b, height: h, mass: m}}
joints:
  - guide: {{body: truck, along: 0 deg, name: road}}
  - contact: {{between: [crate, bed], mu: mu, name: C}}
instant: [{now}, mode(C) = stick]
find: {{a: {find}}}
"""


@pytest.mark.slow
@pytest.mark.parametrize("now", [
    "at rest", "v(truck).x = 10 m/s", "v(truck).x > 0", "v(truck).x > 0, v(crate/truck).x = 0", "v(truck).x < 0",
])  # fmt: skip
@pytest.mark.parametrize(("b", "largest"), [("0.6 m", 3.924), ("1 m", 4.905)])
def test_whatever_tells_how_it_moves(now: str, b: str, largest: float) -> None:
    """The smaller one of μ g and g b/h."""
    text = TRUCK.format(b=b, unknowns="unknowns: {a: m/s^2}", now=f"{now}, a(truck).x = -a, a is largest", find="a")
    (value,) = solve(text)["a"].values or ()
    assert float(value) == pytest.approx(largest, rel=1e-9)


def test_what_nothing_drives_is_told() -> None:
    text = TRUCK.format(b="1 m", unknowns="", now="at rest, a(truck).x is largest", find="a(truck).x")
    with pytest.raises(NoSolution) as caught:
        solve(text)
    (why,) = caught.value.diagnostics
    assert (why.code, why.mark.line) == ("PL601", 14)
    assert "nothing drives truck, which has no mass" in why.message
    assert "`a(truck).x = a_0, a_0 is largest`" in why.hint
