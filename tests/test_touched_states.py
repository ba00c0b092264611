"""States told by several relations, of which one crosses and the others are only touched there."""

from __future__ import annotations

from math import pi, sqrt

import pytest
from answered import first, solve

from planar_cli.errors import NoSolution
from planar_cli.problem.structure import load_text
from planar_cli.simulate.run import Run, Settings, followed, prepared

ORBIT = """
title: Satellite on an elliptical path
plane: horizontal
given: {{R: 6370 km, h_A: 439 km, h_B: 2384 km, GM: 398600 km^3/s^2}}
points: {{O: [0, 0], S: [R + h_A, 0]}}
unknowns: {{v_A: m/s}}
bodies: {{sat: {{particle: S, mass: 100 kg}}}}
loads:
  - force: {{body: sat, towards: O, magnitude: GM*(100 kg)/r(S).mag^2}}
states:
  A: [t = 0, v(S).x = 0, v(S).y = v_A]
  B: [{apse}]
find: {{vA: v(S).mag @ A, vB: v(S).mag @ B, t: t @ B}}
"""
BALL = """
title: Ball thrown up
plane: vertical
bodies: {{b: {{particle: [0, 0], mass: 1 kg}}}}
states: {{1: [t = 0, v(b).x = 1 m/s, v(b).y = 9.81 m/s], top: [{top}]}}
find: {{met: reached(top)}}
"""


@pytest.mark.parametrize("apse", ["r(S).mag = R + h_B, v(S).r = 0", "v(S).r = 0, r(S).mag = R + h_B"])
def test_both_apses_of_an_orbit(apse: str) -> None:
    """v_A² = 2 GM r_B/(r_A (r_A + r_B)), and half a period 2π √(a³/GM) leads from one to the other."""
    low, high, gm = 6809e3, 8754e3, 3.986e14
    found = solve(ORBIT.format(apse=apse))
    v = sqrt(2 * gm * high / (low * (low + high)))
    assert first(found["vA"]) == pytest.approx(v, rel=1e-9)
    assert first(found["vB"]) == pytest.approx(v * low / high, rel=1e-9)
    assert first(found["t"]) == pytest.approx(pi * sqrt(((low + high) / 2) ** 3 / gm), rel=1e-9)


@pytest.mark.parametrize("height", [4.905, 4.905 * (1 + 1e-9), 4.905 * (1 - 1e-10)])
@pytest.mark.parametrize(
    "top", ["y(b) = {0} m, v(b).y = 0", "v(b).y = 0, y(b) = {0} m", "y(b) is largest, y(b) = {0} m"]
)
def test_what_crosses_tells_the_instant_of_what_is_only_touched(height: float, top: str) -> None:
    run = motion(top.format(repr(height)))
    assert run.measures.moments["top"].t == pytest.approx(1.0, abs=1e-10)


@pytest.mark.parametrize(
    "top", ["y(b) = 4.9 m, v(b).y = 0", "v(b).y = 0, y(b) = 4.91 m", "y(b) = 4.9 m, y(b) is largest"]
)
def test_what_holds_at_two_instants_is_not_met(top: str) -> None:
    assert "top" not in motion(top).measures.moments


def motion(top: str) -> Run:
    problem, wrong = load_text(BALL.format(top=top))
    assert problem is not None, wrong
    return followed(prepared(problem, {}), Settings(estimate=False, times=5.0))


def test_what_is_largest_where_its_value_is_given() -> None:
    """Largest in time: the unknown is not what makes it so."""
    thrown = BALL.format(top="y(b) = 1.25 m, y(b) is largest").replace("9.81 m/s]", "v_0]")
    found = solve(thrown.replace("bodies:", "unknowns: {v_0: m/s}\nbodies:").replace("met: reached(top)", "v: v_0"))
    assert first(found["v"]) == pytest.approx(sqrt(2 * 9.81 * 1.25))
    wanted = "y(b) = 4 m, y(b) is largest"
    with pytest.raises(NoSolution, match=r"state top is never reached: y\(b\) = 4 m; y\(b\) is largest$"):
        solve(BALL.format(top=wanted).replace("met: reached(top)", "t: t @ top"))


def test_what_is_largest_where_a_state_is_only_just_reached() -> None:
    thrown = BALL.format(top="y(b) = 4.905 m, x(b) is largest").replace("9.81 m/s]", "v_0]")
    with pytest.raises(NoSolution) as wrong:
        solve(thrown.replace("bodies:", "unknowns: {v_0: m/s}\nbodies:").replace("met: reached(top)", "v: v_0"))
    told = wrong.value.diagnostics[0]
    assert told.message == "`x(b) is largest` at about v_0 = 9.81 m/s, the last value with which state top is reached"
    assert "`v(b).y = 0`" in (told.hint or "")
