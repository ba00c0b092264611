"""A rope with `along` keeps the direction of its parts: that their ends move aside is told; no load stays behind."""

from __future__ import annotations

import pytest
from answered import solve

from planar_cli.errors import NoSolution

CRANE = """
title: A crane trolley and its load
plane: vertical
given: {m: 10 kg, L: 2 m, u: 1 m/s}
points: {A: [0, 0], B: [0, -L]}
bodies:
  trolley: {particle: A, mass: 3 kg}
  load: {particle: B, mass: m}
joints:
  - guide: {point: A, along: 0 deg, name: rail}
  - rope: {path: [A, B], along: 90 deg, name: rope}
"""
PUSHED = """
loads:
  - force: {body: trolley, at: A, magnitude: 6 N, angle: 0 deg}
states:
  1: [at rest]
  2: [t = 1 s]
find: {x: x(load) @ 2, T: tension(rope) @ 2}
"""
AT_ONCE = "instant: [VELOCITIES]\nfind: {v: v(load).x, T: tension(rope)}\n"


@pytest.mark.parametrize("then", [PUSHED, AT_ONCE.replace("VELOCITIES", "v(A).x = u, v(B).x = 0")])
def test_a_trolley_does_not_leave_its_load_behind(then: str) -> None:
    with pytest.raises(NoSolution) as raised:
        solve(CRANE + then)
    why = raised.value.diagnostics[0]
    assert (why.code, why.mark.line) == ("PL539", 11)
    assert why.message.startswith("rope: its part from A to B does not keep its direction `along`")


def test_nor_does_a_support_that_a_coordinate_moves() -> None:
    text = CRANE.replace("points: {A: [0, 0]", "coordinates: {s: m}\npoints: {A: [s, 0]").replace(", mass: 3 kg", "")
    text = text.replace("  - guide: {point: A, along: 0 deg, name: rail}\n", "motion: [ddot(s) = 1 m/s^2]\n")
    text = text.replace("joints:\nmotion: [ddot(s) = 1 m/s^2]\n", "motion: [ddot(s) = 1 m/s^2]\njoints:\n")
    text += "states: {1: [t = 0, s = 0, at rest], 2: [t = 2 s]}\nfind: {x: x(load) @ 2}\n"
    with pytest.raises(NoSolution) as raised:
        solve(text)
    assert raised.value.diagnostics[0].code == "PL539"


@pytest.mark.parametrize("told", ["v(A).x = u", "v(A).x = u, v(B).x = u"])
def test_the_load_goes_along(told: str) -> None:
    found = solve(CRANE + AT_ONCE.replace("VELOCITIES", told))
    assert [float(found[name].values[0]) for name in ("v", "T")] == pytest.approx([1, 98.1])


def test_a_trolley_that_is_pushed_from_rest_does_not_pull_its_load_yet() -> None:
    force = "loads:\n  - force: {body: trolley, at: A, magnitude: 6 N, angle: 0 deg}\n"
    found = solve(CRANE + force + "instant: [at rest]\nfind: {a: a(load).x, a_A: a(trolley).x, T: tension(rope)}\n")
    assert [float(found[name].values[0]) for name in ("a", "a_A", "T")] == pytest.approx([0, 2, 98.1])
