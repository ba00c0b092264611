"""Several constants that only the states together tell: start velocities of a boundary-value problem."""

from __future__ import annotations

import math

import pytest
from answered import first, solve

from planar_cli.errors import NoSolution
from planar_cli.problem.structure import load_text
from planar_cli.simulate.shooting_at_several import each_once, shooting_at_several

SHELL = """
title: Shell in air that must hit a target
plane: vertical
given: {m: 2 kg}
unknowns: {u: m/s, w: m/s}
points: {P: [0, 0]}
bodies: {shell: {particle: P, mass: m}}
loads:
  - drag: {body: shell, quadratic: 0.04 kg/m}
states:
  fired: [t = 0, v(shell).x = u, v(shell).y = w]
  hit: [t = 3 s, x(P) = 60 m, y(P) = 10 m]
find: {u: u, w: w}
"""
SATELLITE = """
title: Satellite that must be at a second point
plane: horizontal
given: {mu: 398600 km^3/s^2, r_A: 7000 km, r_B: 12000 km, m: 1000 kg}
unknowns: {u: km/s, w: km/s}
points: {O: [0, 0], S: [r_A, 0]}
bodies: {sat: {particle: S, mass: m}}
loads:
  - force: {body: sat, at: S, towards: O, magnitude: m*mu/r(S/O).mag^2}
states:
  A: [t = 0, v(sat).x = w, v(sat).y = u]
  B: [t = 40 min, r(S/O).angle = 120 deg, r(S/O).mag = r_B]
find: {u: u, w: w}
"""


def test_both_components_of_a_start_velocity() -> None:
    found = solve(SHELL)
    # The fourth-order method of Runge and Kutta in 6000 steps, and Newton's method.
    assert first(found["u"]) == pytest.approx(41.91010069, rel=1e-8)
    assert first(found["w"]) == pytest.approx(28.42447064, rel=1e-8)


@pytest.mark.slow
def test_two_orbits_go_there() -> None:
    """One with the other way round; an inequality tells which is meant (by Kepler's equation, the first)."""
    with pytest.raises(NoSolution) as caught:
        solve(SATELLITE)
    (told,) = caught.value.diagnostics
    assert told.code == "PL635"
    assert told.message.startswith("u = 9.06668 km/s, w = -0.463678 km/s; or u = -6.73457 km/s, w = -6.22056 km/s")
    found = solve(SATELLITE.replace("= u]", "= u, u > 0]"))
    assert first(found["u"]) == pytest.approx(9066.679795389, rel=1e-9)
    assert first(found["w"]) == pytest.approx(-463.677863583, rel=1e-8)


def test_too_little_is_said() -> None:
    problem, _ = load_text(SHELL.replace(", y(P) = 10 m", ""))
    assert problem is not None
    assert shooting_at_several(problem, {}) is None


@pytest.mark.slow
def test_stiffness_and_damping_from_two_successive_crests() -> None:
    """delta = ln(x_0/x_1)/T, omega_n^2 = (2 pi/T)^2 + delta^2; what creeps has no crest, however near it is to rest."""
    text = """
title: Stiffness and damping from two successive crests
plane: horizontal
given: {m: 2 kg, x_0: 100 mm, x_1: 60 mm, T: 0.8 s}
unknowns: {k: N/m, c: N*s/m}
coordinates: {x: m}
points: {W: [-0.5 m, 0], P: [x, 0]}
bodies: {block: {particle: P, mass: m}}
joints:
  - guide: {point: P, along: 0 deg, name: rail}
loads:
  - spring: {between: [W, P], stiffness: k, relaxed_at: [x = 0]}
  - damper: {between: [W, P], coefficient: c}
states:
  1: [t = 0, x = x_0, at rest]
  low: [v(block).x = 0]
  2: [v(block).x = 0, x = x_1, t = T]
find: {k: k, c: c}
"""
    found = solve(text)
    delta = math.log(100 / 60) / 0.8
    assert first(found["c"]) == pytest.approx(4 * delta, rel=1e-9)
    assert first(found["k"]) == pytest.approx(2 * ((math.tau / 0.8) ** 2 + delta**2), rel=1e-9)


THROWN = """
title: Throw through air at what must be hit after a given time
plane: vertical
given: {m: 2 kg}
unknowns: {v_0: m/s, phi: deg}
points: {A: [0, 0]}
bodies: {ball: {particle: A, mass: m}}
loads:
  - drag: {body: ball, quadratic: 0.01 kg/m}
states:
  A: [t = 0, v(ball).mag = v_0, v(ball).angle = phi]
  B: [t = 2 s, x(ball) = 20 m, y(ball) = 5 m]
find: {v_0: v_0, phi: phi}
"""


def test_a_direction_by_whole_turns_more_is_the_same_one() -> None:
    problem, _ = load_text(THROWN)
    assert problem is not None
    speed, angle = 16.581, math.radians(50.087)
    found = [{"v_0": speed, "phi": angle + k * math.tau} for k in (2, 1, -1)]
    other = {"v_0": speed, "phi": angle + 1.0}
    once = each_once(problem, [*found, other], {}, [10.0, 1.0])
    # Another angle is another motion.
    assert [v["phi"] for v in once] == pytest.approx([angle + 1.0, angle])


def test_a_direction_that_the_file_counts_further_stays_so() -> None:
    problem, _ = load_text(THROWN.replace("find:", "assume: [phi > 180 deg]\nfind:"))
    assert problem is not None
    found = [{"v_0": 16.581, "phi": math.radians(50.087) + k * math.tau} for k in (1, 2)]
    assert each_once(problem, found, {}, [10.0, 1.0]) == found[:1]


@pytest.mark.slow
def test_an_assumption_may_leave_out_what_is_tried_for_the_sizes() -> None:
    found = solve(THROWN.replace("find:", "assume: [v_0 > 10 m/s]\nfind:"))
    assert first(found["v_0"]) == pytest.approx(16.581, rel=1e-4)
    assert first(found["phi"]) == pytest.approx(math.radians(50.09), rel=1e-3)
