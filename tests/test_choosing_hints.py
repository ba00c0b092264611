"""Several values fit: the hint names an inequality, and what it names chooses where it is written."""

from __future__ import annotations

import re

import pytest
from answered import solve

from planar_cli.errors import NoSolution

THROW = """
title: Throw to a target
plane: vertical
unknowns: {alpha: deg}
bodies: {P: {particle: [0, 0], mass: 1 kg}}
"""
STATES = """
states:
  1: [t = 0, v(P).mag = 20 m/s, v(P).angle = alpha]
  2: [x(P) = 20 m, y(P) = 2 m]
find: {alpha: alpha, t: t @ 2}
"""
DRAG = """
loads:
  - drag: {body: P, magnitude: (0.02 kg/m)*v(P).mag^2}
"""


@pytest.mark.parametrize("text", [THROW + STATES, THROW + DRAG + STATES])
def test_the_inequality_that_is_named_chooses(text: str) -> None:
    with pytest.raises(NoSolution) as caught:
        solve(text)
    (why,) = caught.value.diagnostics
    assert why.code == "PL635"
    (assumed,) = re.findall(r"`(assume: .*?)`", why.hint)
    chosen = [solve(f"{text}{line}\n")["alpha"].values for line in (assumed, assumed.replace("<", ">"))]
    low, high = (float(values[0]) for values in chosen if values)
    assert 0.3 < low < 0.8 < high < 1.6
