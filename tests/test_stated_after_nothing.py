"""What is stated just after a state holds, or is refused by its own name: nothing stated is dropped in silence."""

from __future__ import annotations

import pytest
from answered import assert_close, solve

from planar_cli.errors import NoSolution

STONES = """
title: A stone that is let go at rest, and one thrown after it
plane: vertical
bodies: {{one: {{particle: [0, 60 m], mass: 1 kg}}, two: {{particle: [0.1 m, 60 m], mass: 1 kg}}}}
joints:
  - guide: {{point: one, along: 90 deg, name: g1}}
  - guide: {{point: two, along: 90 deg, name: g2}}
{more}
states:
  1: [t = 0, at rest]
  2: [t = 1 s]
  3: [just after 2, v(two).y = {after}]
  4: [{last}]
find: {{t: t @ 4}}
"""
HELD = "motion: [v(two).y = 0 during 1->2]"
THROWN = """
unknowns: {J: N*s}
loads:
  - impulse: {body: two, magnitude: J, angle: -90 deg, during: 2->3}
"""


@pytest.mark.parametrize(
    ("more", "after", "last"),
    [
        (HELD, "-14 m/s", "y(two) = y(one)"),
        (HELD, "-20 ft/s", "y(two) = y(one)"),
        (HELD, "-14 m/s", "y(two) = 0"),
        ("", "-14 m/s", "y(two) = 0"),
    ],
)
def test_a_velocity_that_nothing_gives_is_refused_by_its_name(more: str, after: str, last: str) -> None:
    with pytest.raises(NoSolution) as refused:
        solve(STONES.format(more=more, after=after, last=last))
    (told,) = refused.value.diagnostics
    assert told.code == "PL624"
    assert f"`v(two).y = {after}`" in told.message
    assert "write an `impulse` of unknown magnitude with `during: 2->3`" in told.hint


def test_what_the_hint_says_to_write_is_solved() -> None:
    found = solve(STONES.format(more=HELD + THROWN, after="-14 m/s", last="y(two) = y(one)"))
    # 4.905 + 9.81 s = 14 s for the time s after the throw.
    assert_close(found["t"], 1 + 4.905 / 4.19)


def test_a_state_that_never_comes_is_still_told_as_such() -> None:
    with pytest.raises(NoSolution, match="state 4 is never reached"):
        solve(STONES.format(more=HELD, after="0", last="y(two) = y(one)"))
