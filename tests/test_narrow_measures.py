"""Two measures that let rounding pass: what is more than rounding must not pass with it."""

from __future__ import annotations

from decimal import Decimal
from types import SimpleNamespace
from typing import Any

import pytest
import sympy as sp
from answered import solve

from planar_cli.equation.values.exact import Valuation
from planar_cli.errors import NOWHERE, NoSolution
from planar_cli.integrators.base import Setting
from planar_cli.motion.terms.crossings import Watch
from planar_cli.motion.trajectory.drive import drive
from planar_cli.problem.structure import load_text
from planar_cli.simulate.run import Settings, simulate
from planar_cli.solve.between.branches.agreement import _without_turns, demand_fulfilled
from planar_cli.solve.instant.verify import Disagreement
from planar_cli.units import parse_unit

# --- an event that is only touched ------------------------------------------------------------------------------------


def parabola(t: float, y: Any) -> list[float]:
    return [2.0 * (t - 1.0)]


@pytest.mark.parametrize(
    ("above", "guard", "ways"),
    [
        (0.0, False, ["grazes"]),
        (5e-10, False, ["grazes"]),
        (3e-9, False, []),
        (1e-6, False, []),
        (5e-10, True, []),
        (-3e-9, False, ["falls"]),
    ],
)
def test_a_touch_is_no_miss(above: float, guard: bool, ways: list[str]) -> None:
    """(t - 1)² + `above`: of an event a touch is zero to a billionth of its scale, of a guard to rounding."""
    watch = Watch(lambda t, y: [y[0] + above], [1.0], [guard])
    run = drive(parabola, 0.0, [1.0], 2.0, Setting([1.0], tolerance=1e-12), watch=watch)
    assert [c.way for c in run.crossings] == ways


THROW = """
title: Stone thrown up
plane: vertical
given: {h: HEIGHT}
bodies: {stone: {particle: [0, 0], mass: 1 kg}}
states:
  1: [t = 0, v(stone).x = 0, v(stone).y = 10 m/s]
  2: [y(stone) = h]
find: {t_2: t @ 2}
"""
TOP = 100 / (2 * 9.81)


@pytest.mark.parametrize(("higher", "reached"), [(0.0, True), (-1e-7, True), (1e-7, False), (1e-3, False)])
def test_a_place_above_the_highest_is_not_reached(higher: float, reached: bool) -> None:
    text = THROW.replace("HEIGHT", f"{TOP + higher:.15f} m")
    problem, wrong = load_text(text)
    assert problem is not None
    assert not wrong
    (answer,) = simulate(problem, Settings(estimate=False)).answers
    assert bool(answer.values) is reached
    if not reached:
        with pytest.raises(NoSolution, match=r"never reached|no real"):
            solve(text)


# --- an equation whose terms all vanish -------------------------------------------------------------------------------

x, v, r = sp.symbols("x_2 v_2 r_2")


def fulfils(residual: sp.Expr, **numbers: str) -> bool:
    """Is an equation of guessed letters taken as fulfilled, in a motion of places and speeds of about one?"""
    units = {x: parse_unit("m"), v: parse_unit("m/s"), r: parse_unit("m")}
    letters = {sp.Symbol(s.name[0]): s for s in units}
    course: Any = SimpleNamespace(
        scene=SimpleNamespace(cancelling=()),
        problem=SimpleNamespace(bodies=(), motion=()),
        ledger=SimpleNamespace(units=units),
        stops={"2": SimpleNamespace(letters=letters)},
        states=[SimpleNamespace(mark=NOWHERE)],
        equations=[SimpleNamespace(kind="law", residual=residual, words="a law")],
    )
    value = Valuation({s: sp.Rational(numbers.get(s.name[0], "1")) for s in units})
    try:
        demand_fulfilled(course, value, {x, v})
    except Disagreement:
        return False
    return True


@pytest.mark.parametrize(
    ("residual", "numbers", "holds"),
    [
        (x * v, {"x": "1e-9"}, True),
        (x * v, {"x": "1e-5"}, False),
        (v, {"v": "1e-8"}, False),
        (x - r, {"x": "1"}, True),
        (x - r, {"x": "1.00001"}, False),
        (x - sp.Rational("1e-7"), {"x": "1e-12"}, False),
        (x - sp.Rational("1e-7"), {"x": "1e-7"}, True),
    ],
)
def test_terms_that_vanish_together(residual: sp.Expr, numbers: dict[str, str], holds: bool) -> None:
    assert fulfils(residual, **numbers) is holds


@pytest.mark.parametrize(("off", "left"), [(0.6283185307179586, 0.0), (-1.2566370614359172, 0.0), (0.3, 0.3)])
def test_whole_turns_of_an_angle_are_left_out_and_nothing_else(off: float, left: float) -> None:
    x, y = sp.symbols("x y")
    value = Valuation({x: Decimal(1), y: Decimal(2)})
    found = _without_turns(Decimal(repr(off)), x - sp.Rational(1, 10) * sp.atan2(y, x), value)
    assert float(found) == pytest.approx(left, abs=1e-12)
