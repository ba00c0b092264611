"""A driven speed that changes at once: what it carries needs a blow, and the refusal says how one is written."""

from __future__ import annotations

import pytest
from answered import first, solve

from planar_cli.errors import NoSolution

CART = """
title: Driven cart that is stopped at once, and the load that hangs on it
plane: vertical
points: {C: [0, 0], P: [0, -1 m]}
bodies: {cart: {particle: C, mass: 5 kg}, load: {particle: P, mass: 2 kg}}
joints:
  - guide: {point: C, along: 0 deg}
  - link: {between: [C, P]}
motion: [v(cart).x = 2 m/s during 1->2, v(cart).x = 0 during 2->3]
states:
  1: [t = 0, v(load).x = 2 m/s]
  2: [t = 1 s]
  3: [v(load) = 0]
find: {h: y(P) @ 3 + 1 m}
"""
CRANK = """
title: Crank that is driven and stands still
points: {O: [0, 0], A: [0.5 m, 0]}
bodies: {crank: {rod: [O, A]}}
joints:
  - pin: {at: O, between: [ground, crank]}
motion: [omega(crank) = 2 rad/s during 1->2, omega(crank) = 0 during 2->3]
states: {1: [t = 0], 2: [t = 1 s], 3: [t = 2 s]}
find: {turned: theta(crank) @ 3 - theta(crank) @ 1}
"""


def test_a_blow_is_asked_for() -> None:
    with pytest.raises(NoSolution) as refused:
        solve(CART)
    (why,) = refused.value.diagnostics
    assert (why.code, why.mark.line) == ("PL639", 9)
    assert why.message.startswith("`v(cart).x = 0` from state 2 on, where v(cart).x is 2 m/s as it arrives")
    assert "`[just after 2, v(cart).x = 0]`" in (why.hint or "")


def test_written_as_it_says_the_load_goes_on() -> None:
    """It swings up by v^2/(2 g), and the cart, under which the load hangs at rest, loses m v = 10 N s."""
    text = CART.replace("during 2->3", "during 3->4").replace("@ 3", "@ 4")
    text = text.replace("  3: [v(load) = 0]", "  3: [just after 2, v(cart).x = 0]\n  4: [v(load) = 0]")
    text = (
        text.replace("plane:", "unknowns: {S: N*s}\nplane:")
        .replace("find: {", "find: {S: S, ")
        .replace(
            "motion:", "loads:\n  - impulse: {body: cart, at: C, magnitude: S, angle: 180 deg, during: 2->3}\nmotion:"
        )
    )
    found = solve(text)
    assert first(found["h"]) == pytest.approx(4 / (2 * 9.81), rel=1e-7)
    assert first(found["S"]) == pytest.approx(10, rel=1e-7)


def test_what_carries_nothing_may_stop_so() -> None:
    assert first(solve(CRANK)["turned"]) == pytest.approx(2)
