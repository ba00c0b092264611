"""Springs that join at a knot without mass: they balance there, so that one gives way as the other does."""

from __future__ import annotations

from math import pi, sqrt

import pytest
import sympy as sp
from answered import first, solve

from planar_cli.errors import NoSolution

ROW = """
title: Block on two springs one behind the other
plane: horizontal
given: {m: 2 kg, k_1: 300 N/m, k_2: 600 N/m}
coordinates: {x: m}
points: {W: [-0.4 m, 0], K: [-0.2 m, 0], P: [x, 0]}
bodies: {knot: {particle: K}, block: {particle: P, mass: m}}
joints:
  - guide: {body: block, along: 0 deg}
  - guide: {body: knot, along: 0 deg}
loads:
  - spring: {between: [W, knot], stiffness: k_1, natural_length: 0.2 m}
  - spring: {between: [knot, P], stiffness: k_2, natural_length: 0.2 m}
states: STATES
find: FIND
"""
LETTERS = """
title: Two springs one behind the other, in letters
plane: horizontal
symbols: {m: kg, k_1: N/m, k_2: N/m, l: m}
coordinates: {x: m, s: m}
points: {W: [0, 0], K: [l + s, 0], P: [2*l + x, 0]}
bodies: {knot: {particle: K}, block: {particle: P, mass: m}}
joints:
  - guide: {body: block, along: 0 deg}
  - guide: {body: knot, along: 0 deg}
loads:
  - spring: {between: [W, K], stiffness: k_1, natural_length: l}
  - spring: {between: [K, P], stiffness: k_2, natural_length: l}
states: {rest: [equilibrium, x = 0, s = 0]}
find: {T: period(rest)}
"""
TOGETHER = 300 * 600 / 900


def test_the_period_of_small_oscillations() -> None:
    """1/k = 1/k_1 + 1/k_2."""
    text = ROW.replace("STATES", "{rest: [equilibrium, x = 0]}").replace("FIND", "{T: period(rest)}")
    assert first(solve(text)["T"]) == pytest.approx(2 * pi * sqrt(2 / TOGETHER))


def test_the_period_in_letters() -> None:
    (found,) = solve(LETTERS)["T"].expressions or ()
    numbers = {"m": 2, "k_1": 300, "k_2": 600, "l": 1}
    assert float(found.subs({s: numbers[s.name] for s in found.free_symbols})) == pytest.approx(
        float(2 * sp.pi * sp.sqrt(2 / TOGETHER))
    )


def test_a_damper_at_the_knot_is_another_matter() -> None:
    text = ROW.replace("STATES", "{rest: [equilibrium, x = 0]}").replace("FIND", "{T: period(rest)}")
    damped = text.replace("loads:", "loads:\n  - damper: {between: [W, knot], coefficient: 3 N*s/m}")
    with pytest.raises(NoSolution) as error:
        solve(damped)
    assert error.value.diagnostics[0].code == "PL602"


def test_a_motion_needs_a_mass_there() -> None:
    text = ROW.replace("STATES", "{1: [at rest, x = 0.1 m], 2: [x = 0]}").replace("FIND", "{v: v(block).mag @ 2}")
    with pytest.raises(NoSolution) as error:
        solve(text)
    assert error.value.diagnostics[0].code == "PL602"
