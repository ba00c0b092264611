"""Motions that are hard for numbers: dead centres, unstable rest, grazing, change points, worlds of any size."""

from __future__ import annotations

import math
from decimal import Decimal, localcontext
from types import SimpleNamespace

import mpmath
import pytest
from answered import assert_close, number, solve

from planar_cli.errors import PlanarError
from planar_cli.motion.follow.unstable import growth

# --- dead centres: √(l² - r² sin²) cancels ---------------------------------------------------------------------------

NEAR_ONE = (45035996, 2**52)
"""The double nearest to 1 + 1e-8 is 1 and this fraction."""
PISTON = """
bodies: {crank: {rod: [O, A]}, rod: {rod: [A, B]}, piston: {points: [B], center: B}}
joints:
  - pin: {at: O, between: [ground, crank]}
  - pin: {at: A, between: [crank, rod]}
  - pin: {at: B, between: [rod, piston]}
  - guide: {body: piston, along: 0 deg}
"""


@pytest.mark.parametrize("more", [(1, 10**8), NEAR_ONE], ids=["decimal", "double"])
def test_a_rod_hardly_longer_than_its_crank(more: tuple[int, int]) -> None:
    """At 90 degrees the acceleration is r² w²/√(l² - r²), 7071.07 m/s²; differences of floats lose it altogether.

    The exact value of l = 1 + 1e-8 is 7071.0677941878; 7071.0678156749, found in print, is that of l rounded to
    a machine number. What a file writes is exact, so each l has its own value to thirty digits.
    """
    with localcontext() as context:
        context.prec = 40
        want = 1 / ((1 + Decimal(more[0]) / more[1]) ** 2 - 1).sqrt()
    printed = "7071.0678156749106" if more == NEAR_ONE else "7071.0677941878062"
    assert abs(want - Decimal(printed)) < Decimal("1e-12")
    motion = "motion: [omega(crank) = 1 rad/s]\n"
    names = f"title: Upright crank\ngiven: {{l: (1 + {more[0]}/{more[1]}) m, r: 1 m}}\n"
    drawn = "points: {O: [0, 0], A: [0, r], B: [sqrt(l^2 - r^2), 0]}"
    found = solve(f"{names}{drawn}{PISTON}{motion}find: {{a_B: a(B).x, v_B: v(B).x}}\n")
    assert_close(found["a_B"], want, 30)
    assert_close(found["v_B"], -1, 30)
    drawn = "points: {O: [0, 0], A: [r, 0], B: [r + l, 0]}"
    states = "states: {start: [t = 0], up: [t = (pi/2) s]}\n"
    found = solve(f"{names}{drawn}{PISTON}{motion}{states}find: {{a_B: a(B).x @ up, v_B: v(B).x @ up}}\n")
    assert_close(found["a_B"], want, 14)
    assert_close(found["v_B"], -1, 14)


@pytest.mark.parametrize(("crank", "acceleration"), [("-1", "2/3"), ("1", "-4/3")])
def test_a_dead_centre(crank: str, acceleration: str) -> None:
    """r w² (1 - r/l) and -r w² (1 + r/l), l = 3 r; the rod itself turns with -w r/l or w r/l."""
    drawn = f"title: Dead centre\npoints: {{O: [0, 0], A: [{crank} m, 0], B: [{crank} m + 3 m, 0]}}"
    find = "find: {a_B: a(B).x, v_B: v(B).x, w_rod: omega(rod), alpha_rod: alpha(rod)}\n"
    found = solve(f"{drawn}{PISTON}motion: [omega(crank) = 1 rad/s]\n{find}")
    above, below = acceleration.split("/")
    assert_close(found["a_B"], Decimal(above) / Decimal(below), 25)
    assert_close(found["w_rod"], -Decimal(crank) / 3, 25)
    assert number(found["v_B"]) == number(found["alpha_rod"]) == 0


# --- change points ---------------------------------------------------------------------------------------------------

PARALLEL = """
bodies: {AB: {rod: [A, B]}, BC: {rod: [B, C]}, DC: {rod: [D, C]}}
joints:
  - pin: {at: A, between: [ground, AB]}
  - pin: {at: B, between: [AB, BC]}
  - pin: {at: C, between: [BC, DC]}
  - pin: {at: D, between: [ground, DC]}
"""


@pytest.mark.parametrize("base", [1, pytest.param(2, marks=pytest.mark.slow)], ids=["square", "oblong"])
def test_cranks_stay_parallel_through_the_change_point(base: int) -> None:
    """Flat after π/3 seconds, where it might turn into a crossed linkage; the velocities go on as they were."""
    cranks = "B: {from: A, distance: 1 m, angle: 60 deg}, C: {from: D, distance: 1 m, angle: 60 deg}"
    drawn = f"title: Parallel cranks\npoints: {{A: [0, 0], D: [{base} m, 0], {cranks}}}"
    motion = "motion: [omega(AB) = -1 rad/s]\nstates: {start: [t = 0], after: [t = 2 s]}\n"
    find = "find: {beside: theta(DC) @ after - theta(AB) @ after, x_C: x(C) @ after, w: omega(DC) @ after}\n"
    found = solve(drawn + PARALLEL + motion + find)
    assert_close(found["beside"], 0, 10)
    assert_close(found["w"], -1, 10)
    assert_close(found["x_C"], str(base + mpmath.cos(mpmath.pi / 3 - 2)), 13)


def test_a_square_linkage_that_starts_flat() -> None:
    """Its velocities are 0/0: a message, and no number that is none."""
    drawn = "title: Flat square\npoints: {A: [0, 0], D: [1 m, 0], B: [1 m, 0], C: [2 m, 0]}"
    motion = "motion: [omega(AB) = 1 rad/s]\n"
    with pytest.raises(PlanarError):
        solve(f"{drawn}{PARALLEL}{motion}find: {{w: omega(DC)}}\n")
    with pytest.raises(PlanarError):
        solve(
            f"{drawn}{PARALLEL}{motion}states: {{start: [t = 0], after: [t = 0.5 s]}}\nfind: {{w: omega(DC) @ after}}\n"
        )


# --- unstable rest ---------------------------------------------------------------------------------------------------

PENDULUM = """
title: Pendulum on its head
plane: vertical
coordinates: {theta: deg}
points: {O: [0, 0], P: {from: O, distance: 1 m, angle: theta - 90 deg}}
bodies: {bob: {particle: P, mass: 1 kg}}
joints:
  - link: {between: [O, P]}
"""


def test_a_pendulum_upright_stays_there() -> None:
    """sin(π) of a float is 1.2e-16, and a step method falls after 12 or 17 s, as its tolerance will have it."""
    states = "states:\n  start: [t = 0, theta = 180 deg, at rest]\n  low: [theta = 0]\n"
    assert falls(f"{PENDULUM}{states}find: {{falls: reached(low)}}\n") in ("false", "equilibrium")


class Edge:
    """x'' = x, beside a number that has no value elsewhere."""

    @staticmethod
    def project(_: float, y: list[float]) -> list[float]:
        return [*y[:2], y[2] if y[2] == 0 else math.nan]

    @staticmethod
    def rates(_: float, y: list[float]) -> list[float]:
        return [y[1], y[0], y[2]]


def test_deviations_that_have_no_value_are_none() -> None:
    rate = growth(SimpleNamespace(scale=[1.0] * 3, time_scale=1.0), Edge, 0.0, [0.0] * 3)
    assert rate == pytest.approx(1)


def falls(text: str) -> str:
    """The answer, or what the message says instead."""
    try:
        return solve(text)["falls"].word
    except PlanarError as error:
        return "equilibrium" if "equilibrium" in str(error) else str(error)


def test_a_pendulum_upright_after_a_minute() -> None:
    states = "states:\n  start: [t = 0, theta = 180 deg, at rest]\n  later: [t = 60 s]\n"
    found = solve(f"{PENDULUM}{states}find: {{turned: theta @ later, w: dot(theta) @ later}}\n")
    assert_close(found["turned"], "3.14159265358979323846264338328", 25)
    assert number(found["w"]) == 0


@pytest.mark.parametrize(("beside", "digits"), [("0.01", 11), ("1e-4", 11), ("1e-6", 10)])
def test_a_pendulum_nearly_upright(beside: str, digits: int) -> None:
    """The time to leave grows with the logarithm of how near: K - F of the elliptic integrals.

    The motion is followed from a start in machine numbers: a millionth beside pi has ten digits of its own.
    """
    states = f"states:\n  start: [t = 0, theta = pi - {beside}, at rest]\n  away: [theta = pi - 0.1]\n"
    found = solve(f"{PENDULUM}{states}find: {{t_away: t @ away}}\n")
    with mpmath.workdps(40):
        k = mpmath.cos(mpmath.mpf(beside) / 2)
        phi = mpmath.asin(mpmath.cos(mpmath.mpf("0.05")) / k)
        time = (mpmath.ellipk(k**2) - mpmath.ellipf(phi, k**2)) / mpmath.sqrt(mpmath.mpf("9.81"))
        assert_close(found["t_away"], mpmath.nstr(time, 30), digits)


# --- grazing ---------------------------------------------------------------------------------------------------------

BALL = """
title: Ball under a ceiling
plane: vertical
bodies: {b: {particle: [0, 0], mass: any}}
states:
  start: [t = 0, v(b).x = 3 m/s, v(b).y = 9.81 m/s]
"""


def test_a_ball_that_just_touches_the_ceiling() -> None:
    """v²/(2 g) = 4.905 m: one touch, after 1 s, with no speed upward."""
    states = "  touch: [y(b) = 4.905 m]\n"
    find = "find: {touches: reached(touch), t_1: t @ touch, v_1: v(b).y @ touch, x_1: x(b) @ touch}\n"
    found = solve(BALL + states + find)
    assert found["touches"].word == "true"
    assert_close(found["t_1"], 1, 30)
    assert_close(found["v_1"], 0, 25)
    assert_close(found["x_1"], 3, 30)


@pytest.mark.parametrize("gap", ["1e-6", "1e-9", "1e-12", "1e-15"])
def test_a_ball_that_just_misses_the_ceiling(gap: str) -> None:
    states = f"  touch: [y(b) = 4.905 m + {gap} m]\n"
    assert solve(f"{BALL}{states}find: {{touches: reached(touch)}}\n")["touches"].word == "false"
    found = solve(f"{BALL}  top: [y(b) is largest]\nfind: {{gap: 4.905 m + {gap} m - y(b) @ top}}\n")
    assert abs(number(found["gap"]) - Decimal(gap)) < Decimal("1e-30")


@pytest.mark.parametrize("over", ["1e-3", "1e-6", "1e-9", "1e-12"])
def test_a_ball_that_passes_the_ceiling_twice(over: str) -> None:
    """δ = 1e-6 m: 9.030e-4 s apart, at 4.429e-3 m/s."""
    states = "".join(f"  {name}: [y(b) = 4.905 m - {over} m]\n" for name in ("up", "down"))
    found = solve(f"{BALL}{states}find: {{v_up: v(b).y @ up, between: t @ down - t @ up}}\n")
    speed = (2 * Decimal("9.81") * Decimal(over)).sqrt()
    for name, want in (("v_up", speed), ("between", 2 * speed / Decimal("9.81"))):
        assert abs(number(found[name]) / want - 1) < Decimal("1e-15")
    if over == "1e-6":
        assert abs(number(found["between"]) - Decimal("9.030e-4")) < Decimal("1e-7")


# --- worlds of any size ----------------------------------------------------------------------------------------------

THROW = """
title: Throw in a world of another size
plane: vertical
given: {{g: {g} m/s^2, c: {c} kg/m, m: {m} kg}}
bodies: {{b: {{particle: [0, 0], mass: m}}}}
loads:
  - drag: {{body: b, magnitude: c*v(b).mag^2}}
states:
  1: [t = 0, v(b).x = {v_x} m/s, v(b).y = {v_y} m/s]
  2: [y(b) is largest]
  3: [y(b) = 0]
find: {{h: y(b) @ 2, x_3: x(b) @ 3, t_3: t @ 3, v_3: v(b).mag @ 3}}
"""


def throw(metre: int, second: int, kilogram: int) -> dict[str, Decimal]:
    """A throw with drag in a world whose metre, second and kilogram are these powers of ten; measured in those."""
    sizes = {"g": (9.81, metre - 2 * second), "c": (0.01, kilogram - metre), "m": (2, kilogram)}
    sizes |= {"v_x": (5, metre - second), "v_y": (8, metre - second)}
    found = solve(THROW.format(**{name: f"{value}e{power}" for name, (value, power) in sizes.items()}))
    powers = {"h": metre, "x_3": metre, "t_3": second, "v_3": metre - second}
    return {name: number(found[name]).scaleb(-power) for name, power in powers.items()}


@pytest.mark.parametrize(("metre", "second", "kilogram"), [(-9, -6, -6), (-9, 0, 0), (9, 3, 3), (9, 0, 0), (0, 6, -9)])
def test_a_throw_in_worlds_of_any_size(metre: int, second: int, kilogram: int) -> None:
    want = throw(0, 0, 0)
    for name, value in throw(metre, second, kilogram).items():
        assert abs(value / want[name] - 1) <= Decimal("1e-11"), name


@pytest.mark.slow
def test_a_stiff_spring() -> None:
    """k = 1e10 N/m: 16000 swings in a second; the static deflection would be -9.81e-10 m."""
    found = solve("""
title: Mass let go on a stiff spring
plane: vertical
coordinates: {y: m}
points: {O: [0, -1 m], P: [0, y]}
bodies: {b: {particle: P, mass: 1 kg}}
joints:
  - guide: {point: P, along: 90 deg}
loads:
  - spring: {between: [O, P], stiffness: 1e10 N/m, natural_length: 1 m}
states:
  1: [t = 0, y = 0, at rest]
  2: [t = 0.01 s]
find: {y_2: y @ 2}
""")
    assert abs(number(found["y_2"]) / Decimal("-4.293061261588e-10") - 1) < Decimal("1e-12")


@pytest.mark.parametrize(
    ("mu", "speed"),
    [("tan(30 deg)/3", "6.54"), ("0.1", "8.110858157774"), ("0.5", "6.54")],
    ids=["limit", "slip", "roll"],
)
def test_rolling_at_the_limit(mu: str, speed: str) -> None:
    """mu = tan(30 deg)/3 is just enough: 2/3 g sin(30 deg) for two seconds."""
    found = solve(f"""
title: Disk at the limit of rolling
plane: vertical
given: {{mu: {mu}}}
points: {{C: [0, 0], G: {{from: C, distance: 0.5 m, angle: 60 deg}}}}
surfaces: {{slope: {{through: C, angle: -30 deg}}}}
bodies: {{disk: {{disk: G, radius: 0.5 m, mass: 3 kg}}}}
joints:
  - contact: {{between: [disk, slope], at: C, mu: mu}}
states:
  1: [t = 0, at rest]
  2: [t = 2 s]
find: {{v_2: v(G).mag @ 2, what: mode(C) @ 2}}
""")
    assert_close(found["v_2"], speed, 12)
    assert found["what"].word == ("slip" if mu == "0.1" else "stick")
