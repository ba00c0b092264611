"""The force of a joint that acts up to a state is, at that state, the last one that it has."""

from __future__ import annotations

import pytest
from answered import first, solve

from planar_cli.errors import FileProblem

BOB = """
title: Bob whose cord catches on a nail
plane: vertical
given: {l: 2 m, m: 1.5 kg, d: 1.2 m}
points: {O: [0, 0], Q: [0, -d], P: [l, 0]}
bodies: {bob: {particle: P, mass: m}}
joints:
  - rope: {path: [O, P], name: long, during: 1->2}
  - link: {between: [Q, P], name: short, during: 2->3}
states:
  1: [t = 0, at rest]
  2: [x(bob) = 0]
  3: [x(bob) = 0, y(bob) > -d]
find: {before: tension(long) @ 2, after: tension(short) @ 2, jump: tension(short) @ 2 - tension(long) @ 2}
"""
RAMP = """
title: Crate that leaves a rough ramp
plane: vertical
given: {m: 10 kg, beta: 30 deg, s: 4 m}
points: {E: [0, 0], A: {from: E, distance: s, angle: 180 deg - beta}}
surfaces: {ramp: {through: E, angle: -beta}}
bodies: {crate: {particle: A, mass: m}}
joints:
  - contact: {between: [crate, ramp], at: A, mu_k: 0.2, name: bed, during: 1->2}
states:
  1: [at rest]
  2: [x(crate) = 0]
  3: [y(crate) = -1 m]
find: {N: N(bed) @ 2, a: a(crate).y @ 2}
"""


def test_of_two_cords_that_change_at_a_state_each_has_its_own_tension() -> None:
    found = solve(BOB)
    assert [first(found[name]) for name in ("before", "after", "jump")] == pytest.approx([44.145, 88.29, 44.145])


def test_a_ramp_presses_to_its_end_and_the_acceleration_is_that_of_the_flight() -> None:
    found = solve(RAMP)
    assert first(found["N"]) == pytest.approx(10 * 9.81 * 3**0.5 / 2)
    assert first(found["a"]) == pytest.approx(-9.81)


def test_later_it_has_none() -> None:
    with pytest.raises(FileProblem) as raised:
        solve(RAMP.replace("N(bed) @ 2", "N(bed) @ 3"))
    assert raised.value.diagnostics[0].code == "PL557"
