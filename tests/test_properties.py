"""Physics as properties: turning, mirroring, scaling, other units and another order leave answers as they must.

Whole files of problems/ are rewritten literal by literal; scenes to be turned or mirrored are written out here, with
the angle or the side as a parameter.
"""

from __future__ import annotations

import random
import re
from collections.abc import Callable
from decimal import Decimal
from fractions import Fraction
from functools import cache
from typing import Any

import pytest
import yaml
from conftest import ROOT
from hypothesis import given, settings
from hypothesis import strategies as st

from planar_cli.problem.structure import load_text
from planar_cli.solve.run import solve_problem
from planar_cli.solve.solution import Found
from planar_cli.units import Unit, UnitError, parse_unit

FEW = settings(max_examples=4, deadline=None, derandomize=True)
FILES = (
    "particles/two-sliders-on-a-link",
    "particles/moving-pulley",
    "plans/rod-disk-wall",
    "plans/slider-crank-free",
    "plans/ladder-slips",
    "friction/spool-rolls-or-slips",
    "friction/stacked-blocks",
    "kinematics/wheel-on-conveyor",
    "kinematics/belt-drive",
    "rigid-bodies/two-free-rods-pushed",
    "rigid-bodies/plate-on-parallel-links",
    "systems/gear-pair",
    "systems/hoist-with-moving-pulley",
    "systems/rod-on-a-rolling-disk",
)
LITERAL = re.compile(r"(?<![\w.@>])(\d+(?:\.\d+)?(?:e-?\d+)?) ([A-Za-z1][A-Za-z0-9]*(?:[*/^][A-Za-z0-9]+)*)")
WORDS = ("title", "text", "source", "note")
Answers = dict[str, Found]


def solve(text: str) -> Answers:
    """All finds of a file."""
    problem, wrong = load_text(text)
    assert not wrong, (wrong, text)
    assert problem is not None
    return {f.name: f for part in solve_problem(problem).parts for f in part.found}


def scene_of(name: str) -> dict[str, Any]:
    """A file without its words and answers; every scalar stays text."""
    text = (ROOT / "problems" / f"{name}.yaml").read_text(encoding="utf-8")
    whole: dict[str, Any] = yaml.load(text, Loader=yaml.BaseLoader)
    return {key: value for key, value in whole.items() if key not in (*WORDS, "answers")}


def written(scene: dict[str, Any]) -> str:
    return yaml.safe_dump(scene, sort_keys=False, width=1000)


@cache
def original(name: str) -> Answers:
    return solve(written(scene_of(name)))


def rewritten(node: Any, change: Callable[[Fraction, Unit], str]) -> Any:
    """The tree with every `number unit` in it changed."""
    if isinstance(node, dict):
        return {key: rewritten(value, change) for key, value in node.items()}
    if isinstance(node, list):
        return [rewritten(value, change) for value in node]

    def one(match: re.Match[str]) -> str:
        try:
            return change(Fraction(match[1]), parse_unit(match[2]))
        except UnitError:
            return match[0]

    return LITERAL.sub(one, node)


def decimal(number: Fraction) -> str:
    """A finite decimal, written out."""
    return format(Decimal(number.numerator) / Decimal(number.denominator), "f")


def assert_same(got: Answers, want: Answers, factor: Callable[[Found], Decimal] = lambda found: Decimal(1)) -> None:
    """The same answers to 35 digits, up to a factor."""
    assert list(got) == list(want)
    for name, found in want.items():
        assert got[name].word == found.word
        if found.values is None:
            assert got[name].values is None
            continue
        values = got[name].values
        assert values is not None
        size = max(abs(v) for v in found.values) * factor(found)
        for a, b in zip(values, found.values, strict=True):
            assert abs(a - b * factor(found)) <= Decimal("1e-35") * max(size, Decimal("1e-3")), name


# --- units, scale, order ---------------------------------------------------------------------------------------------

OTHER = {"m": "mm", "mm": "m", "kg": "tonne", "N": "kN", "N*m": "kN*m", "rad/s": "rpm", "deg": "rad", "m/s": "km/h"}


@pytest.mark.parametrize("name", FILES)
def test_other_units(name: str) -> None:
    def change(number: Fraction, unit: Unit) -> str:
        other = parse_unit(OTHER.get(unit.text, unit.text))
        turns = unit.pi_power - other.pi_power
        value = number * unit.factor / other.factor
        if turns:
            return f"(({value.numerator}/{value.denominator})*pi^({turns})) {other.text}"
        if Decimal(value.denominator) not in _FINITE:
            return f"({value.numerator}/{value.denominator}) {other.text}"
        return f"{decimal(value)} {other.text}"

    assert_same(solve(written(rewritten(scene_of(name), change))), original(name))


_FINITE = {Decimal(2**a * 5**b) for a in range(12) for b in range(12)}
FACTORS = st.sampled_from([Fraction(1, 4), Fraction(1, 2), Fraction(2), Fraction(5), Fraction(8)])


@pytest.mark.parametrize("name", FILES)
@FEW
@given(length=FACTORS, mass=FACTORS, time=FACTORS)
def test_scaling(name: str, length: Fraction, mass: Fraction, time: Fraction) -> None:
    """A world with another metre, kilogram and second: each answer changes by its own dimension."""

    def scale(unit: Unit) -> Fraction:
        of = unit.dimension
        return length ** int(of.length) * mass ** int(of.mass) * time ** int(of.time)

    def change(number: Fraction, unit: Unit) -> str:
        return f"{decimal(number * scale(unit))} {unit.text}"

    scene = scene_of(name)
    scene["given"] = {"g": "9.81 m/s^2", **scene.get("given", {})}

    def factor(found: Found) -> Decimal:
        exact = scale(found.unit)
        return Decimal(exact.numerator) / Decimal(exact.denominator)

    assert_same(solve(written(rewritten(scene, change))), original(name), factor)


@pytest.mark.parametrize("name", FILES)
@FEW
@given(seed=st.integers(0, 10**6))
def test_any_order(name: str, seed: int) -> None:
    """Names and joints may be written in any order; finds keep theirs, since answers are printed in it."""
    rng = random.Random(seed)
    scene = scene_of(name)
    for key in ("given", "points", "surfaces", "bodies"):
        if isinstance(scene.get(key), dict):
            scene[key] = dict(rng.sample(list(scene[key].items()), len(scene[key])))
    for key in ("joints", "loads"):
        if isinstance(scene.get(key), list):
            scene[key] = rng.sample(scene[key], len(scene[key]))
    scene = dict(rng.sample(list(scene.items()), len(scene)))
    assert_same(solve(written(scene)), original(name))


# --- turned and mirrored frames --------------------------------------------------------------------------------------

ARM = """
plane: horizontal
given: {{F: 12 N, w: 3 rad/s}}
points:
  O: [0.3 m, -0.2 m]
  A: {{from: O, distance: 0.5 m, angle: {0} deg}}
  B: {{from: A, distance: 0.4 m, angle: {1} deg}}
bodies:
  upper: {{rod: [O, A], mass: 2 kg}}
  lower: {{rod: [A, B], mass: 1.5 kg}}
joints:
  - pin: {{at: O, between: [ground, upper]}}
  - pin: {{at: A, between: [upper, lower]}}
loads:
  - force: {{body: lower, at: B, magnitude: F, angle: {2} deg}}
instant: [omega(upper) = ({sign})*w, omega(lower) = ({sign})*(-2)*w]
find:
  alpha_upper: alpha(upper)
  alpha_lower: alpha(lower)
  speed: v(B).mag
  a_B: a(B).mag
  pin_O: reaction(O/upper).mag
  pin_A: reaction(A/lower).along(A/O)
"""
LINKAGE = """
points:
  O: [0, 0]
  C: {{from: O, distance: 0.5 m, angle: {0} deg}}
  A: {{from: O, distance: 0.2 m, angle: {1} deg}}
  B: {{from: C, distance: 0.4 m, angle: {2} deg}}
bodies: {{OA: {{rod: [O, A]}}, AB: {{rod: [A, B]}}, CB: {{rod: [C, B]}}}}
joints:
  - pin: {{at: O, between: [ground, OA]}}
  - pin: {{at: A, between: [OA, AB]}}
  - pin: {{at: B, between: [AB, CB]}}
  - pin: {{at: C, between: [CB, ground]}}
motion: [omega(OA) = ({sign})*(6 rad/s)]
find: {{omega_AB: omega(AB), alpha_AB: alpha(AB), alpha_CB: alpha(CB), v_B: v(B).mag, a_B: a(B).mag}}
"""
SPOOL = """
plane: vertical
given: {{m: 50 kg, k_G: 0.2 m, R: 0.45 m, r: 0.3 m, P: 100 N}}
points: {{C: [({sign})*(1 m), 0], G: [({sign})*(1 m), R], T: [({sign})*(1 m), R + r]}}
surfaces: {{floor: {{through: C, angle: 0 deg}}}}
bodies: {{spool: {{disk: G, radius: R, hub: r, mass: m, radius_of_gyration: k_G}}}}
joints:
  - rolling: {{between: [spool, floor], at: C}}
loads:
  - force: {{body: spool, wound_at: T, magnitude: P, angle: {0} deg}}
instant: [at rest]
find: {{alpha_spool: alpha(spool), speeding: a(G).mag, force: friction(C).mag, normal: N(C)}}
"""
SLIDE = """
plane: vertical
points: {{A: [0, 0], B: {{from: A, distance: 0.8 m, angle: {1} deg}}}}
surfaces: {{slope: {{through: A, angle: {0} deg}}}}
bodies: {{block: {{particle: A, mass: 3 kg}}, rod: {{rod: [A, B], mass: 2 kg}}}}
joints:
  - contact: {{between: [block, slope], at: A, mu: 0.1}}
  - pin: {{at: A, between: [block, rod]}}
instant: [at rest]
find: {{alpha_rod: alpha(rod), a_A: a(A).mag, N_A: N(A/block), state: mode(A)}}
"""
# Each scene with its angles, in a frame where nothing is turned.
TURNABLE = ((ARM, (40, -15, 100)), (LINKAGE, (5, 70, 110)))
MIRRORED = (*TURNABLE, (SPOOL, (0,)), (SLIDE, (-30, -100)))
ROTATES = ("omega", "alpha")


def drawn(template: str, angles: tuple[float, ...], sign: int = 1) -> str:
    return template.format(*angles, sign=sign)


@pytest.mark.parametrize(("template", "angles"), TURNABLE, ids=["arm", "linkage"])
@settings(max_examples=6, deadline=None, derandomize=True)
@given(turn=st.integers(-179, 180))
def test_a_turned_frame(template: str, angles: tuple[float, ...], turn: int) -> None:
    assert_same(solve(drawn(template, tuple(a + turn for a in angles))), solve(drawn(template, angles)))


@pytest.mark.parametrize(("template", "angles"), MIRRORED, ids=["arm", "linkage", "spool", "slide"])
def test_a_mirrored_frame(template: str, angles: tuple[float, ...]) -> None:
    """Left and right exchanged: rotations change sign, sizes do not. A line's angle is mirrored like a direction."""
    mirrored = tuple(180 - a for a in angles)
    if template is SLIDE:
        mirrored = (-angles[0], 180 - angles[1])
    got, want = solve(drawn(template, mirrored, -1)), solve(drawn(template, angles))
    assert_same(got, want, lambda found: Decimal(-1 if found.name.startswith(ROTATES) else 1))


@pytest.mark.parametrize("shift", [("1 m", "0"), ("(-2 m)", "3 m")])
def test_a_shifted_frame(shift: tuple[str, str]) -> None:
    moved = ARM.replace("[0.3 m, -0.2 m]", f"[0.3 m + {shift[0]}, -0.2 m + {shift[1]}]")
    assert_same(solve(drawn(moved, (40, -15, 100))), solve(drawn(ARM, (40, -15, 100))))


def test_a_whole_turn_is_no_turn() -> None:
    assert_same(solve(drawn(ARM, (400, 345, 460))), solve(drawn(ARM, (40, -15, 100))))
