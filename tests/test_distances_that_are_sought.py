"""The distance in polar coordinates that planar takes itself is not negative, whatever its square says."""

from __future__ import annotations

import pytest
import sympy as sp
from answered import first, solve

PULLED = """title: Puck on a string through a hole
plane: horizontal
GIVEN
unknowns: {F: N}
points: {O: [0, 0], P: [r_0, 0]}
bodies: {puck: {particle: P, mass: m}}
loads:
  - force: {body: puck, towards: O, magnitude: F, name: string}
states:
  1: [v(puck).x = 0, v(puck).y = v_0]
  2: [r(puck/O).mag = r_1]
find: {v: v(puck).theta @ 2, omega: v(puck).theta @ 2 / r_1}
"""


@pytest.mark.parametrize("way", [1, -1])
def test_a_puck_that_is_pulled_inward(way: int) -> None:
    """m r v is kept, with its sign."""
    given = f"given: {{m: 2 kg, r_0: 1 m, v_0: {3 * way} m/s, r_1: 0.5 m}}"
    found = solve(PULLED.replace("GIVEN", given))
    assert first(found["v"]) == pytest.approx(6 * way)
    assert first(found["omega"]) == pytest.approx(12 * way)


def test_the_same_in_letters() -> None:
    given = "symbols: {m: kg, r_0: m, v_0: m/s, r_1: m}\nassume: [r_1 < r_0]"
    (found,) = solve(PULLED.replace("GIVEN", given))["v"].expressions or ()
    r_0, r_1, v_0 = (next(s for s in sp.sympify(found).free_symbols if s.name == n) for n in ("r_0", "r_1", "v_0"))
    assert sp.simplify(found - v_0 * r_0 / r_1) == 0
