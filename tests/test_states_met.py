"""States that a motion meets on its way: where contacts part, ropes slacken, frictions turn round, springs engage."""

from __future__ import annotations

from math import acos, asin, atan, cos, pi, sin, sqrt

import pytest
import sympy as sp
from answered import first, solve

from planar_cli.errors import NoSolution

G = 9.81

DOME = """
title: Ball that leaves a dome
plane: vertical
given: {{m: 0.5 kg, R: 2 m, v_0: 1.5 m/s}}
points: {{O: [0, 0], P: [0, R]}}
surfaces: {{dome: {{center: O, radius: R}}}}
bodies: {{ball: {{particle: P, mass: m}}}}
joints:
  - contact: {{between: [ball, dome], at: P, mu: 0}}
states: {{1: [v(P).x = v_0], {leaves}3: [y(P) = 0]}}
find: {{N: N(P) @ 1, x: x(P) @ 3, v: v(P).mag @ 3, mode: mode(P) @ 3}}
"""
HILL = """
title: Sledge that leaves the top of a hill at once
plane: vertical
points: {O: [0, 0], P: [0, 0]}
surfaces: {hill: {y: -0.05*x^2/(1 m)}}
bodies: {sledge: {particle: P, mass: 30 kg}}
joints:
  - contact: {between: [sledge, hill], at: P, mu: 0}
states: {1: [v(P).x = 12 m/s], 2: [t = 0.5 s]}
find: {x: x(P) @ 2, y: y(P) @ 2, mode: mode(P) @ 1}
"""
LADDER = """
title: Ladder that leaves a wall
plane: vertical
given: {m: 15 kg, l: 4 m, beta: 70 deg}
points: {O: [0, 0], A: [l*cos(beta), 0], B: [0, l*sin(beta)]}
surfaces: {floor: {through: O, angle: 0 deg}, wall: {through: O, angle: 90 deg}}
bodies: {ladder: {rod: [A, B], mass: m}}
joints:
  - contact: {between: [ladder, floor], at: A, mu: 0}
  - contact: {between: [ladder, wall], at: B, mu: 0}
states: {1: [at rest], 2: [N(B) = 0], 3: [y(B) = 0]}
find: {height: y(B) @ 2, omega: omega(ladder) @ 2, v: v(A).x @ 3}
"""
THREAD = """
title: Bob on a thread that goes slack
plane: vertical
given: {m: 0.3 kg, l: 0.8 m}
points: {O: [0, 0], P: [0, -l]}
bodies: {bob: {particle: P, mass: m}}
joints:
  - rope: {path: [O, P], name: thread}
cases:
  too_slow:
    given: {v_0: 5.2 m/s}
    states: {1: [v(P).x = v_0], 2: [tension(thread) = 0], top: [y(P) is largest]}
    find: {beta: r(P/O).angle @ 2, top: y(P) @ top, across: v(P).x @ top, mode: mode(thread) @ top}
  full_circle:
    unknowns: {v_0: m/s}
    states: {1: [v(P).x = v_0, v_0 > 0], 2: [y(P) = l, tension(thread) = 0]}
    find: {v_min: v_0}
"""
HOIST = """
title: Two loads and a pulley
plane: vertical
points: {A: [0, 0], B: [0.4 m, 0], D: [0.2 m, 3 m]}
bodies:
  A_load: {particle: A, mass: 3 kg}
  B_load: {particle: B, mass: 2 kg}
joints:
  - rope: {path: [A, D, B], along: 90 deg, name: rope}
states: {1: [v(A).mag = 0.5 m/s, v(A).y < 0], 2: [y(A) = -1.2 m]}
find: {v: v(A).mag @ 2}
"""
CRATES = """
title: Two crates drawn along a floor
plane: vertical
given: {{F: {F} N, mu: 0.2}}
points: {{O: [0, 0], A: [0, 0], B: [1.5 m, 0]}}
surfaces: {{floor: {{through: O, angle: 0 deg}}}}
bodies: {{crate_A: {{particle: A, weight: 30 N}}, crate_B: {{particle: B, weight: 15 N}}}}
joints:
  - contact: {{between: [crate_A, floor], at: A, mu: mu}}
  - contact: {{between: [crate_B, floor], at: B, mu: mu}}
  - rope: {{path: [A, B], name: cord}}
loads:
  - force: {{body: crate_B, at: B, magnitude: F, angle: 0 deg}}
states: {{1: [at rest], 2: [t = 2 s]}}
find: {{v: v(A).x @ 2, Q: heat(B) @ 1->2{more}}}
"""
YO_YO = """
title: Yo-yo
plane: vertical
given: {m: 0.5 kg, r: 10 mm}
unknowns: {k_G: mm}
points: {G: [0, 0], T: [r, 0], A: [r, 0.3 m]}
bodies: {yoyo: {disk: G, radius: 60 mm, hub: r, mass: m, radius_of_gyration: k_G}}
joints:
  - rope: {path: [A, T on yoyo]}
states: {1: [at rest], 2: [y(G) = -0.8 m, v(G).mag = 1 m/s]}
find: {k_G: k_G}
"""
AXLE = """
title: Flywheel that winds up a load
plane: vertical
points: {O: [0, 0], T: [0.15 m, 0], L: [0.15 m, -6 m]}
bodies:
  wheel: {disk: O, radius: 0.5 m, hub: 0.15 m, mass: 40 kg, radius_of_gyration: 0.3 m}
  load: {particle: L, mass: 12 kg}
joints:
  - pin: {at: O, between: [ground, wheel], friction_torque: 3 N*m}
  - rope: {path: [L, T on wheel], name: rope}
states: {1: [omega(wheel) = 6 rad/s], 2: [wheel at rest], 3: [y(L) = -6 m]}
find: {h: y(L) @ 2 + 6 m, v: v(L).y @ 3, Q: heat(O) @ 1->3}
"""
HELD_ARM = """
title: Arm on a rough axle
plane: vertical
points: {O: [0, 0], A: [1 m, 0]}
bodies: {arm: {rod: [O, A], mass: 2 kg}}
joints:
  - pin: {at: O, between: [ground, arm], friction_torque: 6 N*m}
states: {1: [at rest], 2: [arm at rest], 3: [t = 60 s]}
find: {phi: theta(arm) @ 2, later: theta(arm) @ 3, M: moment(O) @ 3}
"""
BUFFER = """
title: Block that slides down onto a buffer
plane: vertical
given: {m: 4 kg, beta: 30 deg, mu: 0.2, k: 600 N/m, a: 1 m, l_0: 0.5 m}
coordinates: {s: m}
points:
  O: [0, 0]
  P: {from: O, distance: s, angle: -beta}
  W: {from: O, distance: a + l_0, angle: -beta}
surfaces: {slope: {through: O, angle: -beta}}
bodies: {block: {particle: P, mass: m}}
joints:
  - contact: {between: [block, slope], at: P, mu: mu}
loads:
  - spring: {between: [P, W], stiffness: k, natural_length: l_0, acts: push, name: buffer}
states: {1: [s = 0, at rest], meets: [s = a], deepest: [block at rest], rebound: [block at rest]}
find: {v: v(P).mag @ meets, c: s @ deepest - a, back: s @ rebound, Q: heat(P) @ 1->rebound}
"""
BETWEEN_SPRINGS = """
title: Cylinder between two springs
plane: vertical
unknowns: {k: N/m}
points: {L: [-1.5 m, 0], P: [0, 0], R: [1.5 m, 0]}
bodies: {cylinder: {particle: P, mass: 10 kg}}
loads:
  - spring: {between: [L, P], stiffness: k, natural_length: 1 m, name: left}
  - spring: {between: [R, P], stiffness: k, natural_length: 1 m, name: right}
states: {1: [at rest], 2: [y(P) = -0.5 m, at rest]}
find: {k: k, x: x(P) @ 2}
"""
CATAPULT = """
title: A force that grows and fades away, of which the peak is sought
plane: horizontal
unknowns: {F: N}
points: {P: [0, 0]}
bodies: {sledge: {particle: P, mass: 24 kg}}
joints:
  - guide: {point: P, along: 0 deg}
loads:
  - force: {body: sledge, at: P, magnitude: {table: [[0 s, 0 N], [0.15 s, F], [0.5 s, 0 N]]}, angle: 0 deg, name: push}
states: {1: [t = 0, at rest], peak: [t = 0.15 s], 2: [t = 0.5 s, v(P).x = 20 m/s], 3: [t = 2 s]}
find: {F: F, v: v(P).x @ peak, mean: mean(force(push).x) @ 1->2, later: v(P).x @ 3}
"""
DRAWN_IN = """
title: Ball drawn in by a cord through a hole
plane: horizontal
coordinates: {r: m, phi: rad}
points: {O: [0, 0], P: {from: O, distance: r, angle: phi}, H: [-0.5 m, 0]}
bodies: {ball: {particle: P, mass: 0.5 kg}, hand: {particle: H}}
joints:
  - guide: {point: H, along: 0 deg, name: track}
  - rope: {path: [ball, O, hand], name: cord}
motion: [v(H).x = -0.25 m/s]
states: {1: [t = 0, r = 0.8 m, phi = 0, v(P).y = 2 m/s], 2: [r = 0.4 m], 3: [tension(cord) = 60 N]}
find: {t: t @ 2, v: v(P).mag @ 2, turned: phi @ 2, T: tension(cord) @ 2, r: r @ 3}
"""
LAMP = """
title: Lamp in a car that begins to accelerate
plane: vertical
given: {l: 0.6 m, b: 4 m/s^2}
coordinates: {phi: deg}
points: {O: [0, 0], P: {from: O, distance: l, angle: -90 deg - phi}}
bodies: {car: {particle: O}, lamp: {particle: P, mass: 1.5 kg}}
joints:
  - guide: {point: O, along: 0 deg, name: road}
  - rope: {path: [car, lamp], name: cord}
motion: [a(car).x = b]
states: {1: [phi = 0, dot(phi) = 0, v(car).x = 0], balance: [phi = atan(b/g)], far: [phi is largest]}
find: {far: phi @ far, v: v(P/O).mag @ balance, S: tension(cord) @ far, x: x(P) @ far - x(O) @ far}
"""
TWO_BLOCKS = """
title: Two blocks, a spring and a wall
plane: horizontal
symbols: {m_A: kg, m_B: kg, k: N/m, l: m, c: m}
assume: [c < l]
points: {A: [0, 0], B: [l - c, 0]}
surfaces: {wall: {through: A, angle: 90 deg}}
bodies: {A: {particle: A, mass: m_A}, B: {particle: B, mass: m_B}}
joints:
  - guide: {point: A, along: 0 deg, name: track_A}
  - guide: {point: B, along: 0 deg, name: track_B}
  - contact: {between: [A, wall], at: A, mu: 0, name: stop}
loads:
  - spring: {between: [A, B], stiffness: k, natural_length: l}
states: {1: [t = 0, at rest], 2: [N(stop) = 0], 3: [r(B/A).mag is largest]}
find: {t: t @ 2, J: impulse(stop).x @ 1->2, v: v(B).x @ 3, stretch: r(B/A).mag @ 3 - l}
"""
ESCAPE = """
title: Least speed to escape
plane: horizontal
given: {R: 6371 km, k: 3.986e14 m^3/s^2}
unknowns: {v_e: km/s}
points: {O: [0, 0], P: [R, 0]}
bodies: {probe: {particle: P, mass: 100 kg}}
loads:
  - force: {body: probe, at: P, magnitude: 100 kg * k/r(P/O).mag^2, towards: O}
states: {1: [v(P).x = v_e, v(P).y = 0, v_e > 0], far: [x(P) = infinity, v(P).x = 0]}
find: {v: v_e}
"""
TOP = """
title: Ball that slides off the top of a sphere
plane: vertical
given: {{R: 2 m}}
points: {{O: [0, 0], P: [0, R]}}
surfaces: {{sphere: {{center: O, radius: R}}}}
bodies: {{ball: {{particle: P, mass: 0.5 kg}}}}
joints:
  - contact: {{between: [ball, sphere], at: P, mu: 0}}
states: {{1: [at rest], leaves: [N(P) = 0{more}]}}
find: {{{find}}}
"""
UPRIGHT = """
title: Bar that falls over and meets a spring
plane: vertical
given: {b: 1.5 m}
coordinates: {theta: deg}
points: {A: [b*sin(theta), 0], G: [0, b*cos(theta)], B: [-b*sin(theta), 2*b*cos(theta)], W: [1.7 m, 0]}
bodies: {bar: {rod: [A, B], mass: 12 kg, points: [G]}}
joints:
  - guide: {point: A, along: 0 deg}
  - guide: {point: G, along: 90 deg}
loads:
  - spring: {between: [W, A], stiffness: 20 N/m, natural_length: 0.5 m, acts: push, name: buffer}
states: {1: [theta = 0, at rest], 2: [theta = 30 deg], 3: [theta = 90 deg]}
find: {omega: omega(bar) @ 2, v: v(G).y @ 3, W: work(buffer) @ 1->3, first: omega(bar) @ 1}
"""


def left_dome() -> tuple[float, float, float]:
    """Height of the ball over the centre and its velocity, where the weight alone bends its path: from the energy."""
    height = (1.5**2 + 2 * G * 2) / (3 * G)
    speed, slope = sqrt(G * height), acos(height / 2)
    return height, speed * cos(slope), -speed * sin(slope)


@pytest.mark.parametrize("leaves", ["2: [N(P) = 0], ", ""])
def test_a_ball_leaves_a_dome(leaves: str) -> None:
    """Whether a state says so or not."""
    found = solve(DOME.format(leaves=leaves))
    height, vx, vy = left_dome()
    time = (vy + sqrt(vy**2 + 2 * G * height)) / G
    assert first(found["N"]) == pytest.approx(0.5 * (G - 1.5**2 / 2))
    assert first(found["x"]) == pytest.approx(sqrt(4 - height**2) + vx * time)
    assert first(found["v"]) == pytest.approx(sqrt(1.5**2 + 2 * G * 2))
    assert found["mode"].word == "apart"


def test_a_sledge_leaves_a_hill_at_once() -> None:
    """12² · 0.1 m > g: it flies, level at first although only its velocity along x is given."""
    found = solve(HILL)
    assert found["mode"].word == "apart"
    assert (first(found["x"]), first(found["y"])) == pytest.approx((6, -G / 8))


def test_a_ladder_leaves_a_wall() -> None:
    """At two thirds of the first height; from then on its mass centre keeps its velocity along the floor."""
    found = solve(LADDER)
    top = 4 * sin(70 * pi / 180)
    away = asin(2 / 3 * sin(70 * pi / 180))
    omega = sqrt(3 * G / 4 * (top / 4 - sin(away)))
    across = 2 * omega * sin(away)
    assert first(found["height"]) == pytest.approx(2 / 3 * top)
    assert first(found["omega"]) == pytest.approx(omega)
    assert first(found["v"]) == pytest.approx(across)


def test_what_flies_off_and_comes_down_again_needs_an_impact() -> None:
    """Nothing says how a blow goes on."""
    valley = "-0.05*x^2/(1 m) + 2e-4*x^4/(1 m^3)"
    text = HILL.replace("2: [t = 0.5 s]", "2: [t = 60 s]").replace("-0.05*x^2/(1 m)", valley)
    with pytest.raises(NoSolution, match="meets again"):
        solve(text)


def test_a_thread_goes_slack() -> None:
    """Where the weight alone bends the path; then the bob flies, and rises as far as its velocity there tells."""
    found = solve(THREAD)
    height = (5.2**2 - 2 * G * 0.8) / (3 * G)
    slope = asin(height / 0.8)
    speed = sqrt(G * height)
    assert first(found["beta"]) == pytest.approx(slope)
    assert first(found["top"]) == pytest.approx(height + (speed * cos(slope)) ** 2 / (2 * G))
    assert first(found["across"]) == pytest.approx(-speed * sin(slope))
    assert found["mode"].word == "slack"
    assert first(found["v_min"]) == pytest.approx(sqrt(5 * G * 0.8))


def test_a_load_that_is_only_hoisted_does_not_sway() -> None:
    """Its speed alone does not send it sideways, as the rope runs on over a pulley."""
    found = solve(HOIST)
    assert first(found["v"]) == pytest.approx(sqrt(0.5**2 + 2 * G / 5 * 1.2))


def test_redundant_friction_does_not_hold_for_ever() -> None:
    """With 18 N both crates slide; how they would share the friction at rest does not matter."""
    found = solve(CRATES.format(F=18, more=", T: tension(cord) @ 2"))
    assert first(found["v"]) == pytest.approx(2 * G / 5)
    assert first(found["T"]) == pytest.approx(12)
    assert first(found["Q"]) == pytest.approx(3 * 2 * G / 5)


def test_redundant_friction_holds() -> None:
    """With 5 N they stay; the tension is open, as before."""
    assert first(solve(CRATES.format(F=5, more=""))["v"]) == 0
    with pytest.raises(NoSolution, match="not unique"):
        solve(CRATES.format(F=5, more=", T: tension(cord) @ 2"))


def test_of_two_roots_that_only_differ_in_sign_the_positive_one() -> None:
    """1² = 2 · 0.8 g / (1 + k²/r²)."""
    assert first(solve(YO_YO)["k_G"]) == pytest.approx(0.01 * sqrt(1.6 * G - 1))


def test_axle_friction_turns_round() -> None:
    """The load goes up against weight and friction, and comes down with the friction the other way."""
    found = solve(AXLE)
    inertia = 40 * 0.3**2 + 12 * 0.15**2
    weight = 12 * G * 0.15
    angle = inertia * 6**2 / (2 * (weight + 3))
    assert first(found["h"]) == pytest.approx(0.15 * angle)
    assert first(found["v"]) == pytest.approx(-0.15 * sqrt(2 * angle * (weight - 3) / inertia))
    assert first(found["Q"]) == pytest.approx(6 * angle)


def test_an_arm_stays_where_friction_stops_it() -> None:
    """It swings until the weight has done the work of the friction, and is then held there, not where it was drawn."""
    found = solve(HELD_ARM)
    turned = -first(found["phi"])
    assert 2 * G * 0.5 * sin(turned) == pytest.approx(6 * turned)
    assert first(found["later"]) == pytest.approx(-turned)
    assert first(found["M"]) == pytest.approx(2 * G * 0.5 * cos(turned))


def test_a_rough_slope_and_a_buffer() -> None:
    """Work of weight, friction and spring for each way; the friction changes its direction at the deepest place."""
    found = solve(BUFFER)
    weight, friction = 4 * G / 2, 0.2 * 4 * G * sqrt(3) / 2
    down, up = weight - friction, weight + friction
    c = (down + sqrt(down**2 + 2 * 600 * down)) / 600
    back = 1 + c - 300 * c**2 / up
    assert first(found["v"]) == pytest.approx(sqrt(2 * down / 4))
    assert first(found["c"]) == pytest.approx(c)
    assert first(found["back"]) == pytest.approx(back)
    assert first(found["Q"]) == pytest.approx(friction * (2 * (1 + c) - back))


def test_a_sought_stiffness_and_what_stays_in_the_middle() -> None:
    """The springs hold each other's sideways pull, whatever they are; so the energy alone gives the stiffness."""
    found = solve(BETWEEN_SPRINGS)
    stretch = (sqrt(1.5**2 + 0.5**2) - 1) ** 2 - 0.5**2
    assert first(found["k"]) == pytest.approx(10 * G * 0.5 / stretch)
    assert first(found["x"]) == 0


def test_a_peak_that_is_sought_inside_a_table() -> None:
    """The area below the table is the momentum; nothing acts later."""
    found = solve(CATAPULT)
    assert first(found["F"]) == pytest.approx(24 * 20 / 0.25)
    assert first(found["v"]) == pytest.approx(20 * 0.15 / 0.5)
    assert first(found["mean"]) == pytest.approx(24 * 20 / 0.5)
    assert first(found["later"]) == pytest.approx(20)


def test_a_ball_drawn_in_by_a_cord() -> None:
    """Its angular momentum stays what it was; the law of its angle has no value 0/0 where the angle is zero."""
    found = solve(DRAWN_IN)
    assert first(found["t"]) == pytest.approx(1.6)
    assert first(found["v"]) == pytest.approx(sqrt(4**2 + 0.25**2))
    assert first(found["turned"]) == pytest.approx(8)
    assert first(found["T"]) == pytest.approx(20)
    assert first(found["r"]) == pytest.approx((0.5 * 1.6**2 / 60) ** (1 / 3))


def test_a_lamp_goes_along_with_its_car() -> None:
    """Its place is written from a point of the car; it swings as far beyond atan(b/g) as it hung before it."""
    found = solve(LAMP)
    lean = atan(4 / G)
    assert first(found["far"]) == pytest.approx(2 * lean)
    assert first(found["v"]) == pytest.approx(sqrt(2 * 0.6 * (sqrt(G**2 + 16) - G)))
    assert first(found["S"]) == pytest.approx(1.5 * sqrt(G**2 + 16) * cos(lean))
    assert first(found["x"]) == pytest.approx(-0.6 * sin(2 * lean))


def test_two_blocks_leave_a_wall_in_letters() -> None:
    """Only the difference of their places counts then: energy and momentum tell it, and no law of either place does."""
    found = solve(TWO_BLOCKS)
    names = {s.name: s for f in found.values() for e in f.expressions or () for s in e.free_symbols}
    m_a, m_b, k, c = (names[n] for n in ("m_A", "m_B", "k", "c"))
    for name, wanted in {
        "t": sp.pi / 2 * sp.sqrt(m_b / k),
        "J": c * sp.sqrt(k * m_b),
        "v": c * sp.sqrt(k * m_b) / (m_a + m_b),
        "stretch": c * sp.sqrt(m_a / (m_a + m_b)),
    }.items():
        expressions = found[name].expressions
        assert expressions is not None, name
        assert sp.simplify(expressions[0] - wanted) == 0, name


def test_the_speed_to_escape() -> None:
    """Nothing drives it sideways, whatever its speed is; so the energy along one line tells it."""
    assert first(solve(ESCAPE)["v"]) == pytest.approx(sqrt(2 * 3.986e14 / 6371e3))


@pytest.mark.parametrize(("more", "side"), [("", 0), (", x(P) < 0", -1), (", x(P) > 0", 1)])
def test_a_slight_touch_at_the_top_of_a_sphere(more: str, side: int) -> None:
    """Released exactly at the top it leaves at two thirds of the height, on either side if nothing is said."""
    found = solve(TOP.format(more=more, find="y: y(P) @ leaves, x: x(P) @ leaves, v: v(P).mag @ leaves"))
    assert first(found["y"]) == pytest.approx(4 / 3)
    assert abs(first(found["x"])) == pytest.approx(2 * sqrt(5) / 3)
    assert first(found["x"]) * side >= 0
    assert first(found["v"]) == pytest.approx(sqrt(2 * G * 2 / 3))


def test_no_time_of_a_slight_touch() -> None:
    """The slighter it is, the longer it takes."""
    with pytest.raises(NoSolution, match="without bound"):
        solve(TOP.format(more="", find="t: t @ leaves"))


@pytest.mark.slow
def test_a_slight_touch_and_a_spring_on_the_way() -> None:
    """Energy, with the spring pressed by 0.3 m at the end."""
    found = solve(UPRIGHT)
    inertia = 12 * 3**2 / 12 + 12 * (1.5 * sin(pi / 6)) ** 2
    assert first(found["omega"]) == pytest.approx(sqrt(2 * 12 * G * 1.5 * (1 - cos(pi / 6)) / inertia))
    assert first(found["v"]) == pytest.approx(-sqrt(2 * (12 * G * 1.5 - 0.9) / (12 * (1 + 1 / 3))))
    assert first(found["W"]) == pytest.approx(-0.9)
    assert first(found["first"]) == 0
