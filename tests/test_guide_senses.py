"""A negative force of a guide is told with its size and its direction."""

from __future__ import annotations

import pytest
from test_letters_apart import _page
from test_letters_of_bodies import ARM
from worked import page_of_file

HOLDS = """
title: Bead in a circular groove
plane: horizontal
given: {m: 2 kg, R: 0.5 m, v_0: 3 m/s}
points: {Q: [0, 0], P: [R, 0]}
surfaces: {ring: {center: Q, radius: R}}
bodies: {bead: {particle: P, mass: m}}
joints:
  - guide: {point: P, along: ring, name: groove}
instant: [v(P).y = WAY v_0]
find: {N: N(groove)}
"""
SLOPED = """
title: Collar that is pulled off its rod
plane: horizontal
given: {m: 2 kg, F: 10 N}
points: {P: [0, 0]}
bodies: {collar: {particle: P, mass: m}}
joints:
  - guide: {point: P, along: 30 deg, name: rod}
loads:
  - force: {body: collar, magnitude: F, angle: ANGLE deg}
instant: [at rest]
find: {N: N(rod)}
"""


def test_away_from_the_centre() -> None:
    # Q lies at the lower left of the ball, towards which the force counts.
    page = _page(ARM.replace("LETTER", "omega"))
    assert "N_circle = -2.704 N, that is 2.704 N away from the centre Q" in page


def test_along_an_axis() -> None:
    page = page_of_file("collar-drawn-up-from-its-rod-by-a-spring")
    assert "N = -1.2 lbf, that is 1.2 lbf downward" in page


def test_towards_the_centre() -> None:
    pages = [_page(HOLDS.replace("WAY ", way)) for way in ("", "-")]
    assert not [p for p in pages if "away from the centre" in p]
    for page in pages:
        answer = page.partition("Answer ")[2]
        assert answer.startswith(("N = 36 N", "N = -36 N, that is 36 N towards the centre Q"))


@pytest.mark.parametrize(("angle", "told"), [
    # The rod holds back what F pulls across it: 10 N sin 60° at right angles to the rod.
    ("90", "N = -8.660 N, that is 8.660 N at 60° below +x"), ("-30", "N = 8.660 N"),
])  # fmt: skip
def test_slanting(angle: str, told: str) -> None:
    answer = _page(SLOPED.replace("ANGLE", angle)).partition("Answer ")[2]
    assert answer.startswith(told)
    assert ("that is" in answer) == ("that is" in told)
