"""What things are called, and in which order a file says them, changes no answer."""

from __future__ import annotations

from collections.abc import Callable
from decimal import Decimal
from functools import cache
from pathlib import Path
from typing import Any

import pytest
import sympy as sp
from answered import Answers, assert_close, solve, somewhere
from conftest import PROBLEMS, ROOT
from renamed import nasty_names, random_names, renamed, scene_of, shuffled, written

from planar_cli.equation.values.sample import generator
from planar_cli.solve.solution import Found

SAMPLE = (
    "impact/central-impact-in-letters",
    "kinematics/collar-on-rotating-rod",
    "motion/repelled-particle",
    "oscillations/block-on-a-horizontal-spring",
    "particles/moving-pulley",
    "plans/rod-disk-wall",
    "systems/gear-pair",
    "textbook/ex-1-09",
)
PLACES = 12
SPRING = """
plane: horizontal
{given}
coordinates: {{x: m}}
points: {{P: [x, 0]}}
bodies: {{b1: {{particle: P, mass: m}}}}
joints:
  - guide: {{point: P, along: 0 deg}}
loads:
  - force: {{body: b1, magnitude: -k*(x - {offset}), angle: 0 deg}}
states:
  1: [t = 0, x = {start}, dot(x) = 0]
  2: [x = {offset}{more}]
find: {find}
"""


def assert_alike(one: Answers, other: Answers, names: dict[str, str]) -> None:
    """The same answers, in other names. `names`: by the name of the first, that of the second."""
    assert set(one) == set(other)
    for name, found in one.items():
        again = other[name]
        assert found.kind == again.kind, name
        if found.curve is not None:
            assert again.curve is not None
            assert found.curve.kind == again.curve.kind, name
            continue
        assert found.word == again.word, name
        assert (found.values is None) == (again.values is None), name
        for a, b in zip(found.values or (), again.values or (), strict=True):
            assert a == b or abs(a - b) <= Decimal("1e-9") * max(abs(a), Decimal("1e-6")), name
        if found.values is None:
            assert_same_formulas(found, again, names)


def assert_same_formulas(one: Found, other: Found, names: dict[str, str]) -> None:
    """The same value at some place at which both have one."""
    back = {new: old for old, new in names.items()}
    ours, theirs = one.expressions or (), other.expressions or ()
    assert len(ours) == len(theirs), one.name
    draw = generator(50)
    for _ in range(PLACES):
        numbers: dict[str, Decimal] = {}
        try:
            pairs = [
                (somewhere(f, {}, numbers, draw), somewhere(g, back, numbers, draw))
                for f, g in zip(ours, theirs, strict=True)
            ]
        except ArithmeticError:
            continue
        assert all(abs(a - b) <= Decimal("1e-25") * max(abs(a), Decimal(1)) for a, b in pairs), one.name
        return
    pytest.fail(f"{one.name} has no value anywhere: {ours}")


@cache
def original(path: Path) -> Answers:
    return solve(written(scene_of(path.read_text(encoding="utf-8"))))


def unchanged(path: Path, change: Callable[[dict[str, Any]], tuple[dict[str, Any], dict[str, str]]]) -> None:
    scene, names = change(scene_of(path.read_text(encoding="utf-8")))
    assert_alike(original(path), solve(written(scene)), names)


def with_nasty_names(scene: dict[str, Any]) -> tuple[dict[str, Any], dict[str, str]]:
    names = nasty_names(scene, 1)
    return renamed(scene, names), names


def with_random_names(scene: dict[str, Any]) -> tuple[dict[str, Any], dict[str, str]]:
    names = random_names(scene, 1)
    return renamed(scene, names), names


def in_another_order(scene: dict[str, Any]) -> tuple[dict[str, Any], dict[str, str]]:
    return shuffled(scene, 1), {}


CHANGES = [with_nasty_names, with_random_names, in_another_order]


@pytest.mark.parametrize("change", [with_nasty_names, in_another_order])
@pytest.mark.parametrize("name", SAMPLE)
def test_names_and_order_change_nothing(name: str, change: Any) -> None:
    unchanged(ROOT / "problems" / f"{name}.yaml", change)


@pytest.mark.slow
@pytest.mark.parametrize("path", PROBLEMS, ids=lambda p: p.stem)
@pytest.mark.parametrize("change", CHANGES)
def test_names_and_order_change_nothing_anywhere(path: Path, change: Any) -> None:
    unchanged(path, change)


# --- a given that is called like the start of a coordinate -----------------------------------------------------------


@pytest.mark.parametrize("offset", ["c", "x_0", "x_dot", "x_ddot", "v_P", "omega", "t_2"])
@pytest.mark.parametrize(("place", "start"), [("0.3 m", "0.5 m"), ("-0.3 m", "-0.1 m")])
def test_an_offset_may_have_any_name(offset: str, place: str, start: str) -> None:
    """A spring pulls towards a place of any name: v = √(k/m) b after a quarter of the period."""
    given = f"given: {{k: 20 N/m, m: 2 kg, {offset}: {place}}}"
    text = SPRING.format(given=given, offset=offset, start=start, more="", find="{v: v(b1).x @ 2, t: t @ 2}")
    found = solve(text)
    assert_close(found["v"], "-0.63245553203367586639977870888654371")
    assert_close(found["t"], "0.49672941328980510259573022264168226")


@pytest.mark.parametrize("offset", ["c", "x_0"])
def test_an_offset_in_letters(offset: str) -> None:
    given = f"symbols: {{k: N/m, m: kg, {offset}: m, b: m}}"
    text = SPRING.format(given=given, offset=offset, start=f"{offset} + b", more="", find="{v: v(b1).x @ 2}")
    (v,) = solve(text)["v"].expressions or ()
    k, m, b = sp.symbols("k m b", positive=True)
    assert sp.simplify(v + b * sp.sqrt(k / m)) == 0


@pytest.mark.parametrize("offset", ["c", "x_0"])
def test_a_stiffness_beside_an_offset(offset: str) -> None:
    given = f"given: {{m: 2 kg, {offset}: 0.3 m}}\nunknowns: {{k: N/m}}"
    more = ", v(b1).x = -0.4 m/s"
    found = solve(SPRING.format(given=given, offset=offset, start="0.5 m", more=more, find="{k: k}"))
    assert_close(found["k"], 8)


@pytest.mark.parametrize("known", ["given: {y: -0.4 m, w: 2 rad/s, R: 0.5 m}", "symbols: {y: m, w: rad/s, R: m}"])
def test_a_known_may_be_called_like_an_axis(known: str) -> None:
    """The path of P is the circle about O, whatever the height of O is called."""
    found = solve(f"""
{known}
coordinates: {{phi: deg}}
points: {{O: [0.2 m, y], P: {{from: O, distance: R, angle: phi}}}}
bodies: {{b: {{particle: P}}}}
joints:
  - link: {{between: [O, P]}}
motion: [dot(phi) = w]
find: {{path: path(P)}}
""")
    (equation,) = found["path"].expressions or ()
    names = {s.name: s for s in equation.free_symbols}
    assert set(names) == {"x_P", "y_P", "y", "R"}
    x, y, h, r = (names[n] for n in ("x_P", "y_P", "y", "R"))
    circle = (x - sp.Rational(1, 5)) ** 2 + (y - h) ** 2 - r**2
    assert sp.expand(equation.lhs - equation.rhs - circle) == 0
