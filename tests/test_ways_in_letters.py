"""The length of a way in letters: told where the motion turns nowhere, whatever the letters are."""

from __future__ import annotations

import pytest
from answered import solve

from planar_cli.errors import Undecided

BRAKED = """
title: Car that is braked
plane: horizontal
symbols: {{v_0: m/s, a: m/s^2, T: s}}
{assume}
points: {{P: [0, 0]}}
bodies: {{p: {{particle: P}}}}
joints:
  - guide: {{point: P, along: {along} deg}}
motion: [a(p).{axis} = -a]
states: {{1: [t = 0, v(p).{axis} = {start}], 2: [t = {end}]}}
find: {{s: path_length(p) @ 1->2, d: {axis}(p) @ 2}}
"""


@pytest.mark.parametrize(("along", "axis", "start"), [(0, "x", "v_0"), (90, "y", "v_0")])
def test_a_turn_that_letters_leave_open_is_no_answer(along: int, axis: str, start: str) -> None:
    """With T beyond v_0/a it comes back, and has run further than it has come."""
    text = BRAKED.format(assume="", along=along, axis=axis, start=start, end="T")
    with pytest.raises(Undecided, match=r"whether it turns round between 1 and 2.* depends on T, a, v_0"):
        solve(text)


@pytest.mark.parametrize(("assume", "start", "end", "sense"), [
    ("assume: [T < v_0/a]", "v_0", "T", 1),
    ("", "v_0", "v_0/a", 1),
    ("", "v_0", "v_0/(2*a)", 1),
    ("", "-v_0", "T", -1),
    ("", "0 m/s", "T", -1),
])  # fmt: skip
def test_without_a_turn_the_way_is_the_displacement(assume: str, start: str, end: str, sense: int) -> None:
    found = solve(BRAKED.format(assume=assume, along=0, axis="x", start=start, end=end))
    (way,), (displacement,) = found["s"].expressions or (), found["d"].expressions or ()
    assert (way - sense * displacement).expand() == 0
