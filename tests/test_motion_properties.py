"""Motions as properties: turned, mirrored, in other units, scaled, later, in another order, by energy, and backwards.

What the scenes ask for has a truth that needs no second program: the same motion seen otherwise, the same motion by
another principle, or the datum that was hidden.
"""

from __future__ import annotations

import random
from collections.abc import Sequence
from decimal import Decimal
from functools import cache
from typing import Any

import mpmath
import pytest
import sympy as sp
import yaml
from answered import Answers, assert_close, number, solve
from conftest import ROOT
from hypothesis import Phase, given, settings
from hypothesis import strategies as st

from planar_cli.problem.structure import load_text
from planar_cli.solve.run import solve_problem
from planar_cli.units import parse_unit

FEW = settings(max_examples=3, deadline=None, derandomize=True, phases=[Phase.generate])
TINY = Decimal("1e-12")


def assert_same(got: Answers, want: Answers, factors: dict[str, int] | None = None) -> None:
    """The same answers to 12 digits, some with a sign of their own."""
    assert list(got) == list(want)
    for name, found in want.items():
        assert got[name].word == found.word
        if found.values is not None:
            factor = (factors or {}).get(name, 1)
            for a, b in zip(got[name].values or (), found.values, strict=True):
                assert abs(a - b * factor) <= TINY * max(abs(b), Decimal("1e-3")), name


# --- frames ----------------------------------------------------------------------------------------------------------

SLIDER = """
title: Block on a rail, drawn back by a spring and pushed by a force
plane: horizontal
points:
  O: [{x} m, {y} m]
  W: {{from: O, distance: 2 m, angle: {turn} deg + 180 deg}}
  A: {{from: O, distance: 0.5 m, angle: {turn} deg}}
bodies: {{b: {{particle: A, mass: 2 kg}}}}
joints:
  - guide: {{point: A, along: {turn} deg}}
loads:
  - spring: {{between: [W, A], stiffness: 18 N/m, natural_length: 2 m}}
  - force: {{body: b, at: A, magnitude: 6 N, angle: {turn} deg + ({side})*60 deg}}
states:
  1: [t = 0, at rest]
  2: [t = 0.3 s]
find: {{d_2: r(A/O).mag @ 2, v_2: v(A).mag @ 2, a_2: a(A).mag @ 2, N_2: reaction(A).along({turn} deg + 90 deg) @ 2}}
"""
ROTOR = """
title: Arm with a torque that grows
plane: horizontal
points: {{O: [{x} m, {y} m], A: {{from: O, distance: 0.6 m, angle: {turn} deg}}}}
bodies: {{arm: {{rod: [O, A], mass: 3 kg}}}}
joints:
  - pin: {{at: O, between: [ground, arm]}}
loads:
  - torque: {{body: arm, moment: ({side})*(0.5 N*m/s)*t}}
states:
  1: [t = 0, omega(arm) = ({side})*1 rad/s]
  2: [t = 2 s]
  3: [omega(arm) = ({side})*9 rad/s]
find:
  turned: theta(arm) @ 2 - theta(arm) @ 1
  omega_2: omega(arm) @ 2
  a_t: a(A).t @ 2
  a_n: a(A).n @ 2
  t_3: t @ 3
  pin: reaction(O/arm).mag @ 2
"""
THROW = """
title: Ball driven by a constant force instead of its weight
plane: horizontal
points: {{O: [{x} m, {y} m], P: [{x} m, {y} m]}}
bodies: {{b: {{particle: P, mass: 2 kg}}}}
loads:
  - force: {{body: b, at: P, magnitude: (2 kg)*(9.81 m/s^2), angle: {turn} deg - 90 deg}}
states:
  launch: [t = 0, v(b).mag = 12 m/s, v(b).angle = {turn} deg + 90 deg - ({side})*40 deg]
  hit: ['r(b/O).along({turn} deg + 90 deg) = ({side})*0.4*r(b/O).along({turn} deg)']
find: {{t_hit: t @ hit, d: r(b/O).mag @ hit, v_hit: v(b).mag @ hit}}
"""
FRAMES = pytest.mark.parametrize("template", [SLIDER, ROTOR, THROW], ids=["slider", "rotor", "throw"])
SIGNED = {SLIDER: {"N_2": -1}, ROTOR: {"turned": -1, "omega_2": -1}, THROW: {}}


def placed(template: str, turn: int = 0, side: int = 1, x: Any = 0, y: Any = 0) -> Answers:
    return solve(template.format(turn=turn, side=side, x=x, y=y))


@cache
def plain(template: str) -> Answers:
    return placed(template)


@FRAMES
@FEW
@given(turn=st.integers(-179, 180), x=st.decimals(-3, 3, places=1), y=st.decimals(-3, 3, places=1))
def test_a_turned_and_shifted_frame(template: str, turn: int, x: Decimal, y: Decimal) -> None:
    assert_same(placed(template, turn, 1, x, y), plain(template))


@FRAMES
def test_a_mirrored_frame(template: str) -> None:
    """What is across changes its sign; what is drawn along x stays."""
    mirrored = placed(template, 0, -1)
    assert_same(mirrored, plain(template), SIGNED[template])


def test_a_constant_force_is_a_weight() -> None:
    """A throw onto a slope in the vertical plane, and its copy that lies flat."""
    text = THROW.format(turn=0, side=1, x=0, y=0)
    a, b = text.index("loads:"), text.index("states:")
    assert_same(solve(text[:a].replace("horizontal", "vertical") + text[b:]), plain(THROW))


ROLLING = """
title: Disk pulled over a floor
plane: vertical
points: {{C: [0, 0], G: [0, 0.3 m]}}
surfaces: {{floor: {{through: C, angle: 0 deg}}}}
bodies: {{disk: {{disk: G, radius: 0.3 m, mass: 4 kg}}}}
joints:
  - rolling: {{between: [disk, floor], at: C}}
loads:
  - force: {{body: disk, at: G, magnitude: (2 N/s)*t, angle: {angle} deg}}
states:
  1: [t = 0, omega(disk) = ({sign})*(-2) rad/s]
  2: [t = 1.5 s]
find: {{x_2: x(G) @ 2, turned: theta(disk) @ 2, v_2: v(G).x @ 2, F_2: friction(C).x @ 2, N_2: N(C) @ 2}}
"""


def test_a_mirrored_wheel() -> None:
    got, want = (solve(ROLLING.format(angle=angle, sign=sign)) for angle, sign in ((150, -1), (30, 1)))
    assert_same(got, want, {"x_2": -1, "turned": -1, "v_2": -1, "F_2": -1})


# --- units and scales ------------------------------------------------------------------------------------------------

JOURNEY = """
title: Car with three phases
plane: horizontal
given: {{v_1: {v_1}, a: {a}, b: {b}, t_1: {t_1}, s: {s}}}
bodies: {{car: {{particle: [0, 0], mass: {m}}}}}
motion: [v(car).y = 0, a(car).x = a during 1->2, a(car).x = 0 during 2->3, a(car).x = -b during 3->4]
states:
  1: [t = 0, v(car).x = v_1]
  2: [t = t_1]
  3: [x(car) = s]
  4: [v(car).x = 0]
find: {{v_2: v(car).x @ 2 in m/s, t_4: t @ 4 in s, x_4: x(car) @ 4 in m, T: KE(car) @ 2 in J}}
"""
IN_UNITS = [
    {"v_1": "36 km/h", "a": "0.5 m/s^2", "b": "2 m/s^2", "t_1": "0.2 min", "s": "0.4 km", "m": "1.2 tonne"},
    {"v_1": "10 m/s", "a": "500 mm/s^2", "b": "7200 km/h/min", "t_1": "12 s", "s": "400 m", "m": "1200 kg"},
    {
        "v_1": "600 m/min",
        "a": "1800 m/min^2",
        "b": "7200 m/min^2",
        "t_1": "(1/300) h",
        "s": "400000 mm",
        "m": "1.2e6 g",
    },
    {"v_1": "1000 cm/s", "a": "50 cm/s^2", "b": "200 cm/s^2", "t_1": "12000 ms", "s": "40000 cm", "m": "1200 kg"},
]


def test_units_leave_no_trace() -> None:
    """The same motion, written in four systems of units, to all digits."""
    answers = [solve(JOURNEY.format(**{"b": "2 m/s^2", **units})) for units in IN_UNITS if "km/h/min" not in units["b"]]
    assert_close(answers[0]["v_2"], 16, 30)
    assert_close(answers[0]["x_4"], 464, 30)
    for other in answers[1:]:
        assert_same(other, answers[0])


SYMBOLIC = (
    "motion/pendulum-from-rest",
    "motion/atwood-let-go",
    "motion/repelled-particle",
    "motion/pin-in-circular-groove",
    "oscillations/block-on-a-horizontal-spring",
    "oscillations/simple-pendulum",
    "textbook/ex-1-06",
    "textbook/ex-1-08",
)


@cache
def in_letters(name: str) -> tuple[Any, Any]:
    problem, wrong = load_text((ROOT / "problems" / f"{name}.yaml").read_text(encoding="utf-8"))
    assert problem is not None, wrong
    return problem, solve_problem(problem)


def scale_of(unit: Any, length: int, mass: int, time: int) -> sp.Expr:
    of = unit.dimension
    return sp.Integer(length) ** of.length * sp.Integer(mass) ** of.mass * sp.Integer(time) ** of.time


@pytest.mark.parametrize("name", SYMBOLIC)
def test_formulas_scale_with_their_units(name: str) -> None:
    """m -> 3 m, L -> 2 L, t -> 5 t: every answer in letters is multiplied by its own unit."""
    problem, solution = in_letters(name)
    units = {s.name: parse_unit(s.unit) for s in (*problem.symbols, *problem.coordinates)}
    units |= {"t": parse_unit("s"), "g": parse_unit("m/s^2")}
    checked = 0
    rng = random.Random(name)
    for found in (f for part in solution.parts for f in part.found):
        for expr in found.expressions or ():
            letters = sorted(expr.free_symbols, key=str)
            if not letters or not all(s.name in units for s in letters):
                continue
            values = {s: sp.Rational(rng.randint(10, 90), 97) for s in letters}
            scaled = {s: v * scale_of(units[s.name], 2, 3, 5) for s, v in values.items()}
            got, want = (sp.N(expr.subs(v), 40) for v in (scaled, values))
            assert abs(got - want * scale_of(found.unit, 2, 3, 5)) <= 1e-25 * max(abs(got), 1e-3), (name, found.name)
            checked += 1
    assert checked


# --- time and order --------------------------------------------------------------------------------------------------

RUN = """
title: Block between a spring and a damper
plane: vertical
given: {c: 3 N*s/m, k: 50 N/m, m: 2 kg}
coordinates: {x: m}
points: {W: [-1 m, 0], P: [x, 0], V: [2 m, 0]}
bodies: {b: {particle: P, mass: m}}
joints:
  - guide: {point: P, along: 0 deg}
loads:
  - spring: {between: [W, P], stiffness: k, relaxed_at: [x = 0]}
  - damper: {between: [P, V], coefficient: c}
states:
  1: [t = 0, x = 0.2 m, at rest]
  through: [x = 0]
  turn: [v(b).x = 0]
  later: [t = 0.7 s]
find: {t_0: t @ through, v_0: v(b).x @ through, x_turn: x @ turn, x_later: x @ later}
"""


def test_a_later_start() -> None:
    """Nothing but the times themselves knows when it begins."""
    late = (
        RUN.replace("t = 0,", "t = 5 s,").replace("t = 0.7 s", "t = 5.7 s").replace("t @ through", "t @ through - 5 s")
    )
    assert_same(solve(late), solve(RUN))


@pytest.mark.parametrize("seed", range(3))
def test_order_does_not_count(seed: int) -> None:
    """Keys, points, loads in any order; a state with a given time anywhere."""
    rng = random.Random(seed)
    scene: dict[str, Any] = yaml.load(RUN, Loader=yaml.BaseLoader)
    for key in ("given", "points"):
        scene[key] = dict(rng.sample(list(scene[key].items()), len(scene[key])))
    scene["loads"] = rng.sample(scene["loads"], 2)
    states = list(scene["states"].items())
    states.insert(rng.choice([0, 3]), states.pop(3))
    scene["states"] = dict(states)
    scene = dict(rng.sample(list(scene.items()), len(scene)))
    assert_same(solve(yaml.safe_dump(scene, sort_keys=False, width=1000)), solve(RUN))


# --- two principles --------------------------------------------------------------------------------------------------

LEDGER = "E_1: KE(all) @ 1 + PE(all) @ 1, E_2: KE(all) @ 2 + PE(all) @ 2, T_1: KE(all) @ 1, T_2: KE(all) @ 2"
SPRING = """
title: Block on a spring
plane: horizontal
coordinates: {{x: m}}
points: {{W: [-3 m, 0], P: [x, 0]}}
bodies: {{b: {{particle: P, mass: {m} kg}}}}
joints:
  - guide: {{point: P, along: 0 deg}}
loads:
  - spring: {{between: [W, P], stiffness: {k} N/m, relaxed_at: [x = 0]}}
states: {{1: [t = 0, x = {q} m, v(b).x = {u} m/s], 2: [t = {t} s]}}
"""
SWING = """
title: Bar on a hinge
plane: vertical
coordinates: {{phi: deg}}
points: {{O: [0, 0], B: {{from: O, distance: {k} m, angle: phi - 90 deg}}}}
bodies: {{b: {{rod: [O, B], mass: {m} kg}}}}
joints:
  - pin: {{at: O, between: [ground, b]}}
states: {{1: [t = 0, phi = {q} rad, omega(b) = {u} rad/s], 2: [t = {t} s]}}
"""
ROLL = """
title: Disk that rolls down
plane: vertical
points: {{C: [0, 0], G: {{from: C, distance: {k} m, angle: 70 deg}}}}
surfaces: {{slope: {{through: C, angle: -20 deg}}}}
bodies: {{b: {{disk: G, radius: {k} m, mass: {m} kg}}}}
joints:
  - rolling: {{between: [b, slope], at: C}}
states: {{1: [t = 0, omega(b) = -{u} rad/s], 2: [t = {t} s + {q} s]}}
"""
ATWOOD = """
title: Two weights on a light pulley
plane: vertical
points: {{A: [-{k} m, -1 m], B: [{k} m, -2 m], D: [0, 0]}}
bodies: {{a: {{particle: A, mass: {m} kg}}, b: {{particle: B, mass: {q} kg + 4 kg}}}}
joints:
  - rope: {{path: [A, over D, B], along: 90 deg}}
states: {{1: [t = 0, v(a).y = {u} m/s], 2: [t = {t} s]}}
"""
CONSERVATIVE = pytest.mark.parametrize(
    "template", [SPRING, SWING, ROLL, ATWOOD], ids=["spring", "pendulum", "rolling", "atwood"]
)
SIZES = {
    "m": st.decimals("0.5", 4, places=2),
    "k": st.decimals("0.3", 3, places=2),
    "q": st.decimals("0.1", "1.2", places=2),
    "u": st.decimals("0.1", "1.5", places=2),
    "t": st.decimals("0.2", "1.5", places=2),
}


@CONSERVATIVE
@FEW
@given(**SIZES)
def test_energy_is_kept(template: str, **sizes: Decimal) -> None:
    """The motion comes from Newton's law, over the time; the ledger of energy does not know of it."""
    found = solve(f"{template.format(**sizes)}find: {{{LEDGER}}}\n")
    size = max(abs(number(found[name])) for name in found)
    assert abs(number(found["E_1"]) - number(found["E_2"])) <= TINY * size


@settings(max_examples=3, deadline=None, derandomize=True, phases=[Phase.generate])
@given(**SIZES)
def test_a_pendulum_against_its_equation(**sizes: Decimal) -> None:
    """phi'' = -3 g sin(phi)/(2 l), followed by steps."""
    found = solve(f"{SWING.format(**sizes)}find: {{phi: phi @ 2, w: omega(b) @ 2}}\n")
    n = 3 * 9.81 / (2 * float(sizes["k"]))

    def rates(t: Any, y: Sequence[Any]) -> list[Any]:
        return [y[1], -n * mpmath.sin(y[0])]

    phi, w = mpmath.odefun(rates, 0, [float(sizes["q"]), float(sizes["u"])])(float(sizes["t"]))
    assert abs(float(number(found["phi"])) - phi) < 1e-10
    assert abs(float(number(found["w"])) - w) < 1e-9


@settings(max_examples=3, deadline=None, derandomize=True, phases=[Phase.generate])
@given(c=st.decimals("0.1", 30, places=1), **SIZES)
def test_a_damped_block_against_its_equation(c: Decimal, **sizes: Decimal) -> None:
    text = SPRING.format(**sizes) + "find: {x: x @ 2, v: v(b).x @ 2}\n"
    found = solve(text.replace("states:", f"  - damper: {{between: [W, P], coefficient: {c} N*s/m}}\nstates:"))
    m, k = sizes["m"], sizes["k"]

    def rates(t: Any, y: Sequence[Any]) -> list[Any]:
        return [y[1], -(mpmath.mpf(str(k)) * y[0] + mpmath.mpf(str(c)) * y[1]) / mpmath.mpf(str(m))]

    x, v = mpmath.odefun(rates, 0, [mpmath.mpf(str(sizes[s])) for s in "qu"])(mpmath.mpf(str(sizes["t"])))
    assert_close(found["x"], mpmath.nstr(x, 15), 10)
    assert_close(found["v"], mpmath.nstr(v, 15), 10)


# --- backwards -------------------------------------------------------------------------------------------------------

# A scene, the datum that is hidden with its unit, and what is asked about state 2, which then is stated instead.
INVERSE = [
    (SPRING, "k: {k} N/m", "stiffness: {k} N/m", "k", "v(b).x", "m/s"),
    (ROLL, "u: {u} rad/s", "-{u} rad/s", "-u", "v(G).mag", "m/s"),
    (ATWOOD, "m: {m} kg", "mass: {m} kg", "m", "v(a).y", "m/s"),
    (ATWOOD, "u: {u} m/s", "v(a).y = {u} m/s", "u", "y(a)", "m"),
]


@pytest.mark.slow
@pytest.mark.parametrize("row", INVERSE, ids=["stiffness", "start", "weight", "speed"])
@settings(max_examples=2, deadline=None, derandomize=True, phases=[Phase.generate])
@given(**SIZES)
def test_what_is_hidden_comes_back(row: tuple[str, ...], **sizes: Decimal) -> None:
    template, datum, place, name, asked, unit = row
    named = place.rsplit("{", maxsplit=1)[0].removesuffix("-")
    open_text = template.replace(place, f"{named}{name}")
    letter, value = datum.format(**sizes).split(": ")
    forward = f"{open_text.format(**sizes)}given: {{{letter}: {value}}}\nfind: {{out: '{asked} @ 2'}}\n"
    out = number(solve(forward)["out"])
    stated = f"2: [t = {{t}} s, {asked} = {out:.30f} {unit}]"
    backward = open_text.replace("2: [t = {t} s + {q} s]", "2: [t = {t} s]").replace("2: [t = {t} s]", stated)
    if template is ROLL:
        backward = backward.replace("t = {t} s,", "t = {t} s + {q} s,")
    of = value.split()[1]
    got = number(solve(f"{backward.format(**sizes)}unknowns: {{{letter}: {of}}}\nfind: {{back: {letter}}}\n")["back"])
    assert abs(got / Decimal(value.split()[0]) - 1) < TINY
