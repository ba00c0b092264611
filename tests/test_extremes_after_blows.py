"""What is largest just after a blow, over a constant that is sought: in letters and in numbers."""

from __future__ import annotations

from math import pi
from pathlib import Path

import pytest
from answered import solved

from planar_cli.errors import NoSolution

STRUCK = """\
plane: horizontal
{data}
unknowns: {{M: kg}}
points: {{A: [0, 0], B: [1 m, 0]}}
bodies: {{A: {{particle: A, mass: m}}, B: {{particle: B, mass: M}}}}
joints:
  - impact: {{between: {between}, normal: {normal} deg, restitution: e, during: 1->2}}
states:
  1: [v(A).x = v_0, v(A).y = 0, B at rest]
  2: [just after 1, {asked}, M > 0]
find: {{M: M, T: KE(B) @ 2}}
"""
LETTERS = "symbols: {m: kg, v_0: m/s, e: 1}"
NUMBERS = "given: {m: 2 kg, v_0: 3 m/s, e: 0.5}"


@pytest.mark.parametrize("data", [LETTERS, NUMBERS])
@pytest.mark.parametrize(("between", "normal"), [("[A, B]", "0"), ("[B, A]", "180")])
def test_the_block_that_takes_most_of_the_energy(tmp_path: Path, data: str, between: str, normal: str) -> None:
    """T = M ((1 + e) m v_0/(m + M))²/2 is largest for M = m."""
    found = solved(tmp_path, STRUCK.format(data=data, between=between, normal=normal, asked="KE(B) is largest"))
    told = {"m": 2.0, "v_0": 3.0, "e": 0.5}
    for name, value in {"M": 2.0, "T": 1.5**2 * 2 * 9 / 8}.items():
        if data == NUMBERS:
            assert float(found[name].values[0]) == pytest.approx(value)
        else:
            (expr,) = found[name].expressions or ()
            assert float(expr.subs({s: told[s.name] for s in expr.free_symbols})) == pytest.approx(value)


@pytest.mark.parametrize("data", [LETTERS, NUMBERS])
def test_what_is_largest_there_is_not_called_smallest(tmp_path: Path, data: str) -> None:
    """T falls to zero for M -> 0 and for M -> infinity."""
    with pytest.raises(NoSolution, match="state 2: `KE\\(B\\) is smallest` nowhere"):
        solved(tmp_path, STRUCK.format(data=data, between="[A, B]", normal="0", asked="KE(B) is smallest"))


BALL = """\
plane: vertical
symbols: {{m: kg, v_0: m/s, e: 1}}
unknowns: {{phi: deg}}
points: {{O: [0, 0], P: [0, 0]}}
surfaces: {{wedge: {{through: O, angle: phi}}}}
bodies: {{ball: {{particle: P, mass: m}}}}
joints:
  - impact: {{between: [ball, wedge], restitution: e, during: 1->2}}
states:
  1: [v(ball).x = 0, v(ball).y = -v_0]
  2: [just after 1, v(ball).x is {extreme}, phi > 0 deg, phi < 90 deg]
find: {{phi: phi, v: v(ball).x @ 2}}
"""


def test_the_slope_that_throws_a_ball_farthest_aside(tmp_path: Path) -> None:
    """v_x = -(1 + e) v_0 sin phi cos phi, largest in size at 45 deg."""
    found = solved(tmp_path, BALL.format(extreme="smallest"))
    (angle,) = found["phi"].expressions or ()
    assert float(angle) == pytest.approx(pi / 4)
    (speed,) = found["v"].expressions or ()
    assert float(speed.subs({s: {"v_0": 3.0, "e": 0.5}[s.name] for s in speed.free_symbols})) == pytest.approx(-2.25)
