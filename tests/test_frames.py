"""A scene that is mirrored, or turned as a whole, has the mirrored and the turned answers: whole files."""

from __future__ import annotations

import math
from collections import Counter
from decimal import Decimal
from functools import cache
from pathlib import Path

import pytest
from answered import somewhere
from conftest import ROOT
from frame import ASKEW, MIRROR, QUARTER, Frame, NotWritten
from framed import Seen, as_seen, framed

from planar_cli.calculus.curve_words import Curve
from planar_cli.equation.values.sample import generator
from planar_cli.homework.checking.checking import read
from planar_cli.problem.checks.checks import check
from planar_cli.problem.scene.scene import Problem
from planar_cli.solve.run import solve_problem
from planar_cli.solve.solution import Found

AGREE = Decimal("1e-9")
TURN = Decimal(str(2 * math.pi))
PLACES = 12
AXES = ("x_", "y_", "vx", "vy")
"""How the letters of the two axes of a curve begin."""
Answers = dict[tuple[str, str], Found]
FILES = sorted((ROOT / "problems").rglob("*.yaml"))
SAMPLE = (
    "energy/exercise-4-35",
    "friction/stacked-blocks",
    "impact/rod-caught-and-let-go",
    "kinematics/slider-crank-offset",
    "motion/body-spiral-cam",
    "motion/hose-over-a-wall",
    "motion/paths-from-three-frames",
    "oscillations/disk-on-a-torsion-wire",
    "plans/ladder-slips",
    "systems/bob-on-a-cart",
)
TURNED = ("friction/block-on-turntable", "impact/pucks-at-an-angle", "kinematics/geneva-wheel", "textbook/ex-1-14")
NO_WORDS = {
    "mirrored": set(),
    "turned by a quarter": {
        "weight acts along -y",
        "a curve y(x) or r(theta)",
        "a rope over a pulley",
        "a slot in a body without a direction of its own",
    },
    "turned askew": {
        "weight acts along -y",
        "a curve y(x) or r(theta)",
        "a rope over a pulley",
        "a slot in a body without a direction of its own",
        "a point of a given x or y",
        "a place that lies left or above",
    },
}
"""What a file may hold that keeps it from being written in a frame."""


def answers(problem: Problem) -> Answers:
    return {(part.case, f.name): f for part in solve_problem(problem).parts for f in part.found}


@cache
def scene(path: Path) -> Problem:
    return read(str(path))


@cache
def original(path: Path) -> tuple[Problem, Answers]:
    problem = scene(path)
    return problem, answers(problem)


def assert_framed(path: Path, frame: Frame) -> None:
    other = framed(scene(path), frame)
    assert not check(other)
    problem, want = original(path)
    got = answers(other)
    assert list(got) == list(want)
    cases = {"": problem, **{c.name: c.problem for c in problem.cases}}
    for (case, name), found in want.items():
        find = next(f for f in cases[case].find if f.name == name)
        alike = [f.values for f in want.values() if f.unit.dimension == found.unit.dimension and f.values is not None]
        size = max((abs(v) for values in alike for v in values if v.is_finite()), default=Decimal(0))
        assert_seen(found, got[case, name], frame, as_seen(find, cases[case], frame), size)


def assert_seen(found: Found, other: Found, frame: Frame, seen: Seen, size: Decimal) -> None:
    """The answer that belongs to this one in the other frame; `size`: of the largest answer of its kind."""
    assert (other.kind, other.word) == (found.kind, found.word), found.name
    assert (other.values is None) == (found.values is None), found.name
    if found.curve is not None:
        assert other.curve is not None
        assert_same_curve(found.curve, other.curve, frame, seen)
    elif found.values is None or other.values is None:
        if found.expressions or other.expressions:
            assert_same_formulas(found, other, frame, seen)
    elif all(v.is_finite() for v in found.values):
        assert_same_numbers(found.values, other.values, frame, seen, size)
    else:
        assert found.values == other.values


def assert_same_numbers(
    values: tuple[Decimal, ...], others: tuple[Decimal, ...], frame: Frame, seen: Seen, size: Decimal
) -> None:
    want = frame.vector(*values) if len(values) == 2 else tuple(seen.sign * v for v in values)
    for a, b in zip(others, want, strict=True):
        off = a - b
        if seen.turn is not None:
            off -= Decimal(str(seen.turn))
            off -= TURN * (off / TURN).to_integral_value()
            size = max(size, Decimal(1))
        assert abs(off) <= AGREE * size, f"{seen.find.name}: {a}, and not {b}"


def assert_same_formulas(found: Found, other: Found, frame: Frame, seen: Seen) -> None:
    """The same value at some place at which both have one."""
    draw = generator(50)
    for _ in range(PLACES):
        numbers: dict[str, Decimal] = {}
        try:
            ours = tuple(somewhere(e, {}, numbers, draw) for e in found.expressions or ())
            theirs = tuple(somewhere(e, {}, numbers, draw) for e in other.expressions or ())
        except ArithmeticError:
            continue
        assert_same_numbers(ours, theirs, frame, seen, max(map(abs, ours)))
        return
    pytest.fail(f"{found.name} has no value anywhere: {found.expressions}")


def assert_same_curve(curve: Curve, other: Curve, frame: Frame, seen: Seen) -> None:
    """The same kind; and in the mirror an equation that is zero in the mirrored places alone, up to a factor."""
    assert curve.kind == other.kind
    axes = (
        []
        if curve.equation is None
        else sorted((s for s in curve.equation.free_symbols if s.name[:2] in AXES), key=str)
    )
    if len(axes) != 2 or not frame.mirrors_across_y:
        return
    assert curve.equation is not None
    assert other.equation is not None
    ours, theirs = (e.lhs - e.rhs for e in (curve.equation, other.equation))
    draw = generator(50)
    letters = {s.name: Decimal(draw.randrange(300, 3000)) / 1000 for s in ours.free_symbols}
    shares = []
    for x, y in (("0.7", "1.1"), ("1.3", "0.4"), ("2.1", "1.9")):
        numbers = letters | {axes[0].name: Decimal(x), axes[1].name: Decimal(y)}
        there = numbers | ({axes[0].name: -Decimal(x)} if seen.flipped == "x" else {axes[1].name: -Decimal(y)})
        shares.append(somewhere(theirs, {}, there, draw) / somewhere(ours, {}, numbers, draw))
    assert all(abs(s - shares[0]) <= AGREE * abs(shares[0]) for s in shares), (curve.equation, other.equation)


@cache
def expressed(frame: Frame) -> tuple[list[Path], Counter[str]]:
    """The files that can be written in a frame, and how many can not, by reason."""
    found, reasons = [], Counter[str]()
    for path in FILES:
        try:
            framed(scene(path), frame)
        except NotWritten as why:
            reasons[str(why)] += 1
        else:
            found.append(path)
    return found, reasons


@pytest.mark.parametrize("name", SAMPLE)
def test_a_sample_in_the_mirror(name: str) -> None:
    assert_framed(ROOT / "problems" / f"{name}.yaml", MIRROR)


@pytest.mark.parametrize("name", TURNED)
def test_a_sample_that_is_turned(name: str) -> None:
    assert_framed(ROOT / "problems" / f"{name}.yaml", QUARTER)


@pytest.mark.parametrize("name", ["momentum/two-wheels-pressed-together", "motion/braking-before-an-obstacle"])
def test_a_sample_that_is_turned_askew(name: str) -> None:
    assert_framed(ROOT / "problems" / f"{name}.yaml", ASKEW)


@pytest.mark.slow
@pytest.mark.parametrize(("frame", "least"), [(MIRROR, 290), (QUARTER, 80), (ASKEW, 60)], ids=str)
def test_what_is_not_written_in_a_frame_and_why(frame: Frame, least: int) -> None:
    found, reasons = expressed(frame)
    told = ", ".join(f"{n} with {why}" for why, n in reasons.most_common())
    print(f"{frame}: {len(found)} of {len(FILES)} files; not {told}")
    assert len(found) >= least
    assert set(reasons) <= NO_WORDS[frame.name]


@pytest.mark.slow
@pytest.mark.parametrize("frame", [MIRROR, QUARTER], ids=str)
@pytest.mark.parametrize("path", FILES, ids=lambda p: f"{p.parent.name}-{p.stem}")
def test_all_files_in_other_frames(path: Path, frame: Frame) -> None:
    if path in expressed(frame)[0]:
        assert_framed(path, frame)
