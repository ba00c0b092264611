"""What is told later may drop out of an equation: the masses of two parts, where the place of the cut is sought."""

from __future__ import annotations

import pytest
from answered import first, solve

ROD = """
title: Largest bending moment in a rod let go
plane: vertical
DATA
unknowns: {z: m}
points: {A: [0, 0], J: [(SIDE)*z, 0], B: [(SIDE)*L, 0]}
bodies:
  AJ: {rod: [A, J], mass: m*z/L}
  JB: {rod: [J, B], mass: m*(L - z)/L}
joints:
  - pin: {at: A, between: [ground, AJ]}
  - weld: {at: J, between: [AJ, JB]}
instant: [at rest, WHAT, z > 0, z < L]
find: {z: z, M: moment(J/JB)}
"""


@pytest.mark.parametrize(
    ("side", "what"),
    [(1, "-moment(J/JB) is largest"), (1, "moment(J/JB) is smallest"), (-1, "moment(J/JB) is largest")],
)
def test_the_largest_bending_moment(side: int, what: str) -> None:
    """M = m g z (L - z)²/(4 L²), largest at z = L/3: m g L/27."""
    found = solve(ROD.replace("DATA", "given: {m: 6 kg, L: 1.2 m}").replace("WHAT", what).replace("SIDE", str(side)))
    assert first(found["z"]) == pytest.approx(0.4)
    assert first(found["M"]) == pytest.approx(-side * 6 * 9.81 * 1.2 / 27)


def test_in_letters() -> None:
    found = solve(
        ROD.replace("DATA", "symbols: {m: kg, L: m}").replace("WHAT", "-moment(J/JB) is largest").replace("SIDE", "1")
    )
    z, moment = (found[n].expressions[0] for n in ("z", "M"))
    assert (str(z), str(moment)) == ("L/3", "-L*g*m/27")
