"""A body in a curved guide turns with the tangent: where the curvature changes on the way, that tells in alpha."""

from __future__ import annotations

from math import sqrt

import pytest
from answered import first, number, solve

from planar_cli.problem.structure import load_text
from planar_cli.simulate.run import Settings, simulate

CURVED = """
title: Block whose guide is a curve
plane: vertical
given: {{c: 0.5 1/m, b: 0.4 m}}
points: {{O: [0, 0], P: {place}}}
surfaces: {{track: {{{curve}}}}}
bodies: {{b1: {{points: [P], center: P, mass: 2 kg, inertia: 0.1 kg*m^2}}}}
joints:
  - guide: {{body: b1, along: track}}
"""
PARABOLA = CURVED.format(place="[1 m, 0.5 m]", curve="y: c*x^2")
SPIRAL = CURVED.format(place="{from: O, distance: b*pi/3, angle: 60 deg}", curve="r: b*theta")


def test_alpha_on_a_parabola() -> None:
    """kappa = 1/(1 + x²)^(3/2): with s' = -sqrt(2) m/s, alpha = kappa s'' - 0.375 s'²."""
    found = solve(PARABOLA + "instant: [v(P).x = -1 m/s]\nfind: {alpha: alpha(b1), w: omega(b1), a: a(P).t}")
    kappa = 2**-1.5
    # (m + I kappa²) s'' + I kappa kappa' s'² = -m g sin(45 deg)
    rate = (-2 * 9.81 / sqrt(2) + 0.1 * kappa * 0.75) / (2 + 0.1 * kappa**2)
    assert first(found["w"]) == pytest.approx(-0.5)
    assert first(found["a"]) == pytest.approx(-rate)
    assert first(found["alpha"]) == pytest.approx(kappa * rate - 0.75)


@pytest.mark.parametrize(("text", "said"), [(PARABOLA, "v(P).x = 2 m/s"), (SPIRAL, "v(P).mag = 3 m/s, v(P).x < 0")])
def test_as_it_is_followed(text: str, said: str) -> None:
    asked = f"{text}states: {{1: [t = 0, {said}], 2: [t = 0.05 s]}}\n"
    problem, wrong = load_text(asked + "find: {w: omega(b1) @ 2, x: x(P) @ 2, alpha: alpha(b1) @ 1}")
    assert problem is not None, wrong
    followed = {a.name: a.values[0] for a in simulate(problem, Settings(estimate=False)).answers}
    alpha = number(solve(f"{text}instant: [{said}]\nfind: {{alpha: alpha(b1)}}")["alpha"])
    assert float(alpha) == pytest.approx(followed["alpha"], rel=1e-9)


def test_over_time() -> None:
    """m g h = (m + I kappa²) v²/2, kappa = 1 at the lowest point."""
    found = solve(PARABOLA + "states: {1: [t = 0, at rest], 2: [x(P) = 0]}\nfind: {v: v(P).mag @ 2, w: omega(b1) @ 2}")
    speed = sqrt(2 * 9.81 * 0.5 / 1.05)
    assert first(found["v"]) == pytest.approx(speed)
    assert first(found["w"]) == pytest.approx(-speed)
