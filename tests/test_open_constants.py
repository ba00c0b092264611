"""A constant that is sought and that nothing tells is no answer; a small one of either sign is found by trial."""

from __future__ import annotations

import pytest
from answered import first, solve

from planar_cli.errors import NoSolution

DRIVEN = """
title: Motor that is driven up and down
plane: vertical
given: {{m: 2 kg}}
unknowns: {{X: m}}
points: {{O: [0, 0]}}
bodies:
  motor: {{particle: O, mass: m}}
joints:
  - guide: {{point: O, along: 90 deg, name: frame}}
motion: ["y(motor) = X*sin(1200 rpm * t)"]
find: {{{find}}}
"""
UNBALANCE = """
title: Motor with an unbalance on springs
plane: vertical
given: {g: 32.2 ft/s^2, W: 350 lbf, k: 3000 lbf/in, w: 0.0625 lbf, e: 6 in}
unknowns: {X: in}
points: {O: [0, 0], U: [e, 0], F: [0, -2 ft]}
bodies:
  motor: {particle: O, mass: (W - w)/g}
  rotor: {parts: [{particle: U, weight: w}], points: [O]}
joints:
  - guide: {point: O, along: 90 deg, name: frame}
  - pin: {at: O, between: [motor, rotor]}
loads:
  - spring: {between: [F, O], stiffness: k, natural_length: 2 ft + W/k}
motion: [omega(rotor) = 1200 rpm]
states:
  steady: [t = 0, y(motor) = 0, v(motor).y = X*1200 rpm]
  quarter: [t = 0.0125 s, y(motor) = X]
find: {X: X in in}
"""


@pytest.mark.parametrize("find", ["X: X", "v: v(motor)", "F: force, X: X", "y: path(motor), v: v(motor).mag"])
def test_open_constant_is_refused(find: str) -> None:
    with pytest.raises(NoSolution) as error:
        solve(DRIVEN.format(find=find.replace("force", "reaction(frame).x")))
    assert "X is open" in str(error.value)


def test_what_does_not_rest_on_it_is_answered() -> None:
    assert first(solve(DRIVEN.format(find="F: reaction(frame).x"))["F"]) == 0


def test_small_amplitude_against_the_unbalance() -> None:
    """X = w e n²/(k g - W n²): beyond resonance against the force; X n² m is lost beside k here."""
    n = 40 * 3.141592653589793
    amplitude = 0.0625 * 6 * n**2 / (3000 * 12 * 32.2 - 350 * n**2)
    assert first(solve(UNBALANCE)["X"]) == pytest.approx(amplitude / 12, rel=1e-6)  # ft
