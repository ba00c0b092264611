"""Streams of matter and masses that vary: against the momentum of body and matter together, counted by hand.

A fixed control volume: F = d/dt ∫ρ v dV + Σ rate v_out - Σ rate v_in, v over ground.
"""

from __future__ import annotations

from math import asin, cos, exp, log, pi, radians, sin, sqrt

import pytest
import sympy as sp
from answered import Answers, assert_close, solve

from planar_cli.errors import FileProblem, NoSolution
from planar_cli.problem.structure import load_text
from planar_cli.report.page.narrate import Voice, narrate
from planar_cli.solve.run import solve_problem

BEND = """
title: Bend
plane: horizontal
{more}
points: {{A: [0, 0], B: [0.5 m, 0.6 m]}}
bodies: {{bend: {{points: [A, B], center: A, mass: 60 kg}}}}
joints:
  - weld: {{at: A, between: [ground, bend], name: flange}}
loads:
  - stream:
      body: bend
      rate: {rate}
      enters: {{at: A, speed: {speed}, angle: 0 deg}}
      leaves: {{at: B, speed: {speed}, angle: 90 deg}}
      name: water
"""
VANE = """
title: Vane
plane: horizontal
given: {{rho: 1000 kg/m^3, S: 1200 mm^2, c: 25 m/s, u: {u}}}
points: {{A: [0, 0], B: [-0.05 m, 0.1 m]}}
bodies: {{vane: {{points: [A, B], center: A, mass: 40 kg}}}}
joints:
  - guide: {{body: vane, along: 0 deg, name: track}}
loads:
  - stream:
      body: vane
      rate: rho*S*(c - v(vane).x)
      enters: {{at: A, speed: c - v(vane).x, angle: 0 deg}}
      leaves: {{at: B, speed: c - v(vane).x, angle: 150 deg}}
      name: jet
"""
ROCKET = """
title: Rocket
plane: vertical
{names}
points: {{P: [0, 0]}}
bodies: {{rocket: {{particle: P, mass: M - q*t}}}}
joints:
  - guide: {{point: P, along: {along}, name: track}}
loads:
  - stream: {{body: rocket, rate: q, leaves: {{at: P, speed: u, angle: {back}}}, name: thrust}}
"""
NUMBERS = "given: {M: 1200 kg, q: 10 kg/s, u: 2000 m/s}"
ARM = """
title: Sprinkler arm
plane: horizontal
given: {{q: 2 kg/s, u: 8 m/s, r: 0.3 m, w: 5 rad/s}}
{more}
points: {{O: [0, 0], B: [r, 0]}}
bodies: {{arm: {{rod: [O, B], mass: 1 kg}}}}
joints:
  - pin: {{at: O, between: [ground, arm], name: hub}}
loads:
  - stream:
      body: arm
      rate: q
      enters: {{at: O, speed: 0 m/s, angle: 0 deg}}
      leaves: {{at: B, speed: u, angle: theta(arm) - 90 deg}}
      name: jet
"""
PLATE = """
title: Hinged plate
plane: vertical
given: {m: 8 kg, L: 0.6 m, h: 0.25 m, rho: 1000 kg/m^3, d: 25 mm, c: 11 m/s, q: rho*pi*d^2/4*c}
coordinates: {beta: deg}
points:
  A: [0, 0]
  E: {from: A, distance: L, angle: beta - 90 deg}
  P: [h*tan(beta), -h]
bodies: {plate: {rod: [A, E], mass: m}}
joints:
  - pin: {at: A, between: [ground, plate]}
loads:
  - stream:
      body: plate
      rate: q
      enters: {at: P, speed: c, angle: 0 deg}
      leaves: {at: P, speed: c, angle: beta - 90 deg}
"""


def vector(found: Answers, name: str) -> list[float]:
    values = found[name].values
    assert values is not None
    return [float(v) for v in values]


def checks(text: str) -> str:
    """Everything that is printed of a file, with what was compared, as plain words."""
    problem, wrong = load_text(text)
    assert problem is not None
    assert not wrong
    return repr(narrate(solve_problem(problem), Voice(effects=True, verbose=True)))


# --- pipes -----------------------------------------------------------------------------------------------------------

ASKED = "find: {{R: reaction(flange){at}, M: moment(flange){at}, f: force(water){at}}}"


@pytest.mark.parametrize(
    ("statements", "at"),
    [
        ("instant: [at rest]", ""),
        ("instant: [equilibrium]", ""),
        ("states: {1: [t = 0, at rest], 2: [t = 3 s]}", " @ 2"),
    ],
)
def test_a_bend_is_held(statements: str, at: str) -> None:
    text = BEND.format(more="given: {q: 45 kg/s, u: 15 m/s}", rate="q", speed="u") + statements
    found = solve(f"{text}\n{ASKED.format(at=at)}")
    assert vector(found, "f") == pytest.approx([45 * 15, -45 * 15])
    assert vector(found, "R") == pytest.approx([-45 * 15, 45 * 15])
    # What leaves at B upwards has the moment x_B rate u about A.
    assert_close(found["M"], 0.5 * 45 * 15)


def test_a_bend_in_letters() -> None:
    text = BEND.format(more="symbols: {q: kg/s, u: m/s}", rate="q", speed="u")
    found = solve(text + "instant: [at rest]\nfind: {R: reaction(flange)}")
    q, u = sp.Symbol("q", positive=True), sp.Symbol("u", positive=True)
    assert found["R"].expressions == (-q * u, q * u)


def test_a_flow_that_starts_slowly() -> None:
    """rate = 10 kg/s² t, speed = 2 m/s² t."""
    text = BEND.format(more="", rate="10 kg/s^2 * t", speed="2 m/s^2 * t")
    found = solve(
        text + "states: {1: [t = 0, at rest], 2: [t = 3 s]}\n"
        "find: {R: reaction(flange) @ 2, J: impulse(water).x @ 1->2}"
    )
    assert vector(found, "R") == pytest.approx([-180, 180])
    assert_close(found["J"], 20 * 3**3 / 3)


def test_a_flow_by_a_table() -> None:
    text = BEND.format(more="", rate="{table: [[0 s, 10 kg/s], [10 s, 30 kg/s]]}", speed="2 m/s")
    assert vector(solve(text + "instant: [t = 5 s, at rest]\nfind: {R: reaction(flange)}"), "R") == pytest.approx(
        [-40, 40]
    )


@pytest.mark.parametrize(
    ("given", "unknown", "truth"),
    [("u: 15 m/s", "q: kg/s", 20.0), ("q: 45 kg/s", "u: m/s", 300 / 45)],
)
def test_a_flow_is_sought(given: str, unknown: str, truth: float) -> None:
    text = BEND.format(more=f"given: {{{given}}}\nunknowns: {{{unknown}}}", rate="q", speed="u")
    name = unknown[0]
    found = solve(text + f"instant: [at rest, reaction(flange).x = -300 N]\nfind: {{x: {name}}}")
    assert_close(found["x"], truth)


# --- vanes -----------------------------------------------------------------------------------------------------------

PER_SPEED = 1000 * 1200e-6 * (1 + cos(radians(30)))
"""F = PER_SPEED (c - u)²: what the jet gives off along the track, seen from the vane."""


@pytest.mark.parametrize("u", [0, 10])
def test_a_vane_at_a_speed(u: float) -> None:
    more = "instant: [v(vane).x = u]\nfind: {a: a(vane).x, N: N(track), f: force(jet), P: power(jet)}"
    found = solve(VANE.format(u=f"{u} m/s") + more)
    push = PER_SPEED * (25 - u) ** 2
    side = 1.2 * (25 - u) ** 2 / 2
    assert_close(found["a"], push / 40, 9)
    assert_close(found["P"], push * u, 9)
    assert vector(found, "f") == pytest.approx([push, -side])
    assert_close(found["N"], side, 9)


def test_a_vane_set_going() -> None:
    """m dv/dt = k (c - v)²: 1/(c - v) - 1/c = k t/m."""
    more = "states: {1: [t = 0, at rest], 2: [v(vane).x = 10 m/s]}\nfind: {t: t @ 2, x: x(A) @ 2}"
    found = solve(VANE.format(u="0 m/s") + more)
    k = PER_SPEED / 40
    assert_close(found["t"], (1 / 15 - 1 / 25) / k, 9)
    assert_close(found["x"], (25 / 15 - 1 - log(25 / 15)) / k, 9)


# --- plates ----------------------------------------------------------------------------------------------------------

BETA = asin(2 * 0.25 * 1000 * pi * 0.025**2 / 4 * 11**2 / (8 * 9.81 * 0.6))


def test_a_hinged_plate_hangs_aslant() -> None:
    found = solve(
        PLATE + "instant: [equilibrium, beta > 0 deg, beta < 90 deg]\nfind: {b: beta, R: reaction(A), a: alpha(plate)}"
    )
    qu = 1000 * pi * 0.025**2 / 4 * 11**2
    assert_close(found["b"], BETA, 12)
    assert_close(found["a"], 0)
    assert vector(found, "R") == pytest.approx([qu * (sin(BETA) - 1), 8 * 9.81 - qu * cos(BETA)])


def test_a_hinged_plate_swings() -> None:
    """I δ'' = -m g L/2 cos β δ: the moment of the jet is rate c h, whatever β."""
    found = solve(PLATE + "states: {e: [equilibrium, beta > 0 deg, beta < 90 deg]}\nfind: {T: period(e)}")
    assert_close(found["T"], 2 * pi * sqrt(8 * 0.6**2 / 3 / (8 * 9.81 * 0.3 * cos(BETA))), 9)


# --- bodies that turn ------------------------------------------------------------------------------------------------


def test_a_sprinkler_at_a_constant_speed() -> None:
    """The water gains rate r (u - ω r) of angular momentum against the turn, over ground."""
    text = ARM.format(more="unknowns: {M: N*m}") + "  - torque: {body: arm, moment: M}\n"
    found = solve(text + "instant: [omega(arm) = w, alpha(arm) = 0]\nfind: {M: M, R: reaction(hub)}")
    assert_close(found["M"], -2 * 0.3 * (8 - 5 * 0.3))
    # The water in the arm has the momentum rate r along it; that vector turns with ω.
    leaving, within, arm = 2 * (5 * 0.3 - 8), 2 * 0.3 * 5, -1 * 0.15 * 25
    assert vector(found, "R") == pytest.approx([arm, leaving + within])


def test_a_sprinkler_set_going() -> None:
    """m r²/3 dω/dt = rate r (u - ω r)."""
    found = solve(ARM.format(more="") + "states: {1: [t = 0, at rest], 2: [t = 0.1 s]}\nfind: {w: omega(arm) @ 2}")
    assert_close(found["w"], 8 / 0.3 * (1 - exp(-3 * 2 * 0.1)), 9)


def test_sand_on_a_turntable() -> None:
    """Sand that falls straight down and stays at the radius r: I ω is constant."""
    found = solve("""
title: Turntable
plane: horizontal
given: {I_0: 3 kg*m^2, q: 2 kg/s, r: 0.5 m}
points: {O: [0, 0], P: [r, 0]}
bodies: {table: {points: [O, P], center: O, mass: 20 kg + q*t, inertia: I_0 + q*t*r^2}}
joints:
  - pin: {at: O, between: [ground, table]}
loads:
  - stream: {body: table, rate: q, enters: {at: P, speed: omega(table)*r, angle: theta(table) - 90 deg}}
states: {1: [t = 0, omega(table) = 4 rad/s], 2: [t = 6 s]}
find: {w: omega(table) @ 2, H: H(table/O) @ 2, dK: dot(KE(table)) @ 1, m: mass(table) @ 2}
""")
    assert_close(found["w"], 2)
    assert_close(found["H"], 12)
    assert_close(found["m"], 32)
    # T = H²/(2 I), dI/dt = 0.5 kg m²/s.
    assert_close(found["dK"], -(12**2) / (2 * 3**2) * 0.5)


def test_a_rocket_that_turns() -> None:
    """Thrust beside the mass centre, gas that leaves a turning body, a shrinking moment of inertia."""
    found = solve("""
title: Rocket that turns
plane: horizontal
given: {M: 1200 kg, q: 10 kg/s, u: 2000 m/s, k: 3 m, e: 0.02 m, l: 5 m}
points: {G: [0, 0], N: [-l, e]}
bodies: {rocket: {points: [G, N], center: G, mass: M - q*t, radius_of_gyration: k}}
loads:
  - stream: {body: rocket, rate: q, leaves: {at: N, speed: u, angle: theta(rocket) + 180 deg}}
states: {1: [t = 0, at rest], 2: [t = 20 s]}
find: {w: omega(rocket) @ 2, v: v(rocket) @ 2, r: r(rocket) @ 2}
""")
    x, y, vx, vy, _, w = _by_hand()
    assert_close(found["w"], w, 8)
    assert vector(found, "v") == pytest.approx([vx, vy], rel=1e-8)
    assert vector(found, "r") == pytest.approx([x, y], rel=1e-8)


def _by_hand(steps: int = 4000) -> list[float]:
    """x, y, v_x, v_y, θ, ω after 20 s: Runge-Kutta on the momentum and angular momentum over ground.

    Momentum: m v + rate r_N (the gas on its way from G to N); it falls by rate (v + ω × r_N + u). Angular momentum
    about G: k² m ω; it falls by rate r_N × (ω × r_N + u).
    """
    q, u, k, e, b = 10.0, 2000.0, 3.0, 0.02, 5.0

    def rates(t: float, y: list[float]) -> list[float]:
        _, _, vx, vy, th, w = y
        m = 1200 - q * t
        rx, ry = -b * cos(th) - e * sin(th), -b * sin(th) + e * cos(th)
        ux, uy = -u * cos(th) - w * ry, -u * sin(th) + w * rx
        ax, ay = (-q * ux + q * w * ry) / m, (-q * uy - q * w * rx) / m
        alpha = (-q * (rx * uy - ry * ux) + q * k * k * w) / (m * k * k)
        return [vx, vy, ax, ay, w, alpha]

    y, h = [0.0] * 6, 20 / steps
    for i in range(steps):
        t = i * h
        k1 = rates(t, y)
        k2 = rates(t + h / 2, [p + h / 2 * s for p, s in zip(y, k1, strict=True)])
        k3 = rates(t + h / 2, [p + h / 2 * s for p, s in zip(y, k2, strict=True)])
        k4 = rates(t + h, [p + h * s for p, s in zip(y, k3, strict=True)])
        y = [p + h / 6 * (a + 2 * b + 2 * c + d) for p, a, b, c, d in zip(y, k1, k2, k3, k4, strict=True)]
    return y


# --- masses that vary ------------------------------------------------------------------------------------------------


def test_a_rocket_along_a_track() -> None:
    """v = u ln(M/m)."""
    text = ROCKET.format(names=NUMBERS, along="0 deg", back="180 deg")
    found = solve(
        text + "states: {1: [t = 0, at rest], 2: [mass(rocket) = 600 kg]}\n"
        "find: {t: t @ 2, v: v(rocket).x @ 2, x: x(rocket) @ 2, K: KE(rocket) @ 2, p: momentum(rocket).x @ 2,"
        " N: N(track) @ 2}"
    )
    v = 2000 * log(2)
    assert_close(found["t"], 60)
    assert_close(found["v"], v, 12)
    assert_close(found["x"], 2000 * 60 * (1 - log(2)), 12)
    assert_close(found["K"], 600 * v**2 / 2, 12)
    assert_close(found["p"], 600 * v, 12)
    assert_close(found["N"], 600 * 9.81, 12)


def test_a_rocket_straight_up_in_letters() -> None:
    names = "symbols: {M: kg, q: kg/s, u: m/s, T: s}\nassume: [q*T < M, M*g < q*u]"
    text = ROCKET.format(names=names, along="90 deg", back="270 deg")
    found = solve(text + "states: {1: [t = 0, at rest], 2: [t = T]}\nfind: {v: v(rocket).y @ 2, a: a(rocket).y @ 2}")
    M, q, u, T, g = (sp.Symbol(n, positive=True) for n in ("M", "q", "u", "T", "g"))
    numbers = {M: 7, q: 2, u: 31, T: 3, g: 9}
    for name, truth in (("v", u * sp.log(M / (M - q * T)) - g * T), ("a", q * u / (M - q * T) - g)):
        assert found[name].expressions is not None
        assert abs(sp.N((found[name].expressions[0] - truth).subs(numbers), 30)) < 1e-25


def test_no_energy_balance_where_the_mass_varies() -> None:
    """dT/dt = P does not hold: the gas takes energy along."""
    text = ROCKET.format(names=NUMBERS, along="0 deg", back="180 deg")
    printed = checks(text + "states: {1: [t = 0, at rest], 2: [t = 60 s]}\nfind: {v: v(rocket).x @ 2}")
    assert "followed by independent facts" in printed
    assert "balance of energy" not in printed
    assert "stream of matter" in printed
    assert "mass that varies" in printed


def test_a_leaking_bucket_on_a_rope() -> None:
    """The weight is m(t) g; sand that drips out without speed leaves no push behind."""
    found = solve("""
title: Bucket
plane: vertical
points: {O: [0, 2 m], P: [0, 0]}
bodies: {bucket: {particle: P, mass: 20 kg - 0.5 kg/s * t}}
joints:
  - rope: {path: [O, P], name: cord}
loads:
  - stream: {body: bucket, rate: 0.5 kg/s, leaves: {at: P, speed: 0 m/s, angle: -90 deg}, name: sand}
instant: [t = 4 s, at rest]
find: {S: tension(cord), f: force(sand).mag}
""")
    assert_close(found["S"], 18 * 9.81)
    assert_close(found["f"], 0)


@pytest.mark.parametrize(
    ("inertia", "truth"), [("inertia: 2 kg*m^2", 1.5), ("radius_of_gyration: 0.5 m", 0.75), ("", 4 * 0.75 * 0.36 / 2)]
)
def test_the_moment_of_inertia_goes_with_the_mass(inertia: str, truth: float) -> None:
    keys = ", ".join(k for k in ("disk: O", "radius: 0.6 m", "mass: 4 kg - 0.5 kg/s * t", inertia) if k)
    found = solve(f"""
title: Disk
plane: horizontal
points: {{O: [0, 0]}}
bodies: {{d: {{{keys}}}}}
joints:
  - pin: {{at: O, between: [ground, d]}}
loads:
  - torque: {{body: d, moment: 6 N*m}}
instant: [t = 2 s, at rest]
find: {{I: I(d), a: alpha(d)}}
""")
    assert_close(found["I"], truth)
    assert_close(found["a"], 6 / truth)


# --- what is refused -------------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("old", "new", "code"),
    [
        ("rate: q", "rate: 10 N", "PL224"),
        ("speed: u", "speed: 3 kg", "PL224"),
        ("angle: 180 deg", "angle: 180", "PL225"),
        ("at: P", "at: X", "PL403"),
        ("body: rocket", "body: rocker", "PL403"),
        (", leaves: {at: P, speed: u, angle: 180 deg}", "", "PL314"),
        (", angle: 180 deg", "", "PL311"),
        ("speed: u", "speed: v(rocket)", "PL426"),
        ("speed: u", "speed: N(track)/q", "PL555"),
        ("M - q*t", "M - v(rocket).x*q/u", "PL413"),
        ("t = 60 s", "t = 130 s", "PL634"),
    ],
)
def test_refused(old: str, new: str, code: str) -> None:
    text = ROCKET.format(names=NUMBERS, along="0 deg", back="180 deg")
    text += "states: {1: [t = 0, at rest], 2: [t = 60 s]}\nfind: {v: v(rocket).x @ 2}\n"
    assert old in text
    with pytest.raises((FileProblem, NoSolution)) as error:
        solve(text.replace(old, new))
    assert code in {d.code for d in error.value.diagnostics}


def test_the_time_must_be_known() -> None:
    text = ROCKET.format(names=NUMBERS, along="0 deg", back="180 deg")
    with pytest.raises(FileProblem, match="the mass of rocket has a value only at a time that is known"):
        solve(text + "instant: [at rest]\nfind: {a: a(rocket).x}\n")


def test_no_mass_where_the_moment_of_inertia_is_given() -> None:
    with pytest.raises(FileProblem, match="has no mass at t = 0"):
        solve("""
title: Disk
plane: horizontal
points: {O: [0, 0]}
bodies: {d: {disk: O, radius: 0.6 m, mass: 0.5 kg/s * t, inertia: 2 kg*m^2}}
instant: [t = 2 s, at rest]
find: {a: alpha(d)}
""")


# --- what is largest -------------------------------------------------------------------------------------------------


def test_the_speed_of_greatest_power() -> None:
    """u (c - u)² is greatest at c/3; at u = c it is least."""
    text = VANE.format(u="0 m/s").replace("u: 0 m/s", "F_0: 0 N")
    text = text.replace("given:", "unknowns: {u: m/s, F: N}\ngiven:").replace("v(vane).x", "u")
    text += "  - force: {body: vane, at: A, magnitude: F, angle: 180 deg, name: holder}\n"
    found = solve(text + "instant: [v(vane).x = u, a(vane).x = 0, F*u is largest]\nfind: {u: u, P: F*u}")
    assert_close(found["u"], 25 / 3)
    assert_close(found["P"], PER_SPEED * 25 / 3 * (50 / 3) ** 2, 9)
