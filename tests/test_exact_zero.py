"""What is zero counts as zero also where it stands for an angle by name; equilibrium settles what is sought."""

from __future__ import annotations

from decimal import Decimal

import pytest
import sympy as sp
from answered import assert_close, solve

from planar_cli.equation.values.exact import PI, Valuation
from planar_cli.equation.values.jets import Jet, magnitude
from planar_cli.errors import NoSolution
from planar_cli.problem.scene.geometry import Vec

PHI, PSI = sp.Symbol("phi", real=True), sp.Symbol("psi", real=True)


@pytest.mark.parametrize(
    ("expr", "zero"),
    [
        (sp.cos(PHI), True),
        (sp.sin(2 * PHI), True),
        (sp.tan(2 * PHI), True),
        (5 * sp.cos(PHI) * sp.sin(PSI), True),
        (sp.sin(PHI - 3 * PSI), True),
        (sp.cos(PHI - sp.Rational(1, 10**25)), False),
        (sp.sin(PSI * sp.Rational(1, 10**30)), False),
        (sp.sin(PHI) - 1, True),
    ],
)
def test_zeros_of_angles(expr: sp.Expr, zero: bool) -> None:
    value = Valuation({PHI: PI / 2, PSI: PI / 6})
    assert value.is_zero(sp.sympify(expr)) is zero


def test_what_has_no_value_is_told_as_none() -> None:
    value = Valuation({PHI: PI / 2})
    assert value.known(sp.sin(PHI)) == 1
    assert value.known(PSI) is None
    assert value.known(sp.sqrt(-PHI)) is None
    assert value.vanishes(sp.cos(PHI))
    assert not value.vanishes(PSI)
    assert not value.vanishes(sp.log(-PHI))


BLOCK = """
title: Block on a track
plane: vertical
given: {{phi: {phi}}}
points: {{P: [0, 0]}}
bodies: {{block: {{particle: P, mass: 1200 kg}}}}
joints:
  - guide: {{point: P, along: phi}}
loads:
  - force: {{body: block, magnitude: 20000 N, angle: phi}}
instant: [at rest]
find: {{a: {a}}}
"""


@pytest.mark.parametrize(
    ("phi", "a", "truth"),
    [("90 deg", "a(block).y", 20000 / 1200 - 9.81), ("0 deg", "a(block).x", 20000 / 1200)],
)
def test_a_track_whose_direction_has_a_name(phi: str, a: str, truth: float) -> None:
    assert_close(solve(BLOCK.format(phi=phi, a=a))["a"], truth)


LEVER = """
title: Lever
plane: vertical
given: {{m: 8 kg, l: 0.6 m}}
{unknown}
points: {{A: [0, 0], E: [l, 0]}}
bodies: {{lever: {{rod: [A, E], mass: m}}}}
joints:
  - pin: {{at: A, between: [ground, lever]}}
loads:
  - force: {{body: lever, at: E, magnitude: {force}, angle: 90 deg}}
instant: [equilibrium]
find: {{R: reaction(A).y, a: alpha(lever){more}}}
"""


def test_equilibrium_settles_a_force() -> None:
    found = solve(LEVER.format(unknown="unknowns: {F: N}", force="F", more=", F: F"))
    assert_close(found["F"], 4 * 9.81)
    assert_close(found["R"], 4 * 9.81)
    assert_close(found["a"], 0)


def test_no_equilibrium_is_said() -> None:
    with pytest.raises(NoSolution, match="contradict"):
        solve(LEVER.format(unknown="", force="10 N", more=""))


@pytest.mark.parametrize(("function", "other"), [(sp.cot, sp.tan), (sp.sec, sp.cos), (sp.csc, sp.sin)])
def test_functions_that_sympy_writes_itself(function: type[sp.Expr], other: type[sp.Expr]) -> None:
    """Their products with their inverses are 1."""
    angle = sp.atan(sp.Rational(10, 3)) / 2
    value = Valuation({})
    assert abs(value(function(angle, evaluate=False)) * value(other(angle, evaluate=False)) - 1) < Decimal("1e-50")


def test_the_rate_of_a_distance_along_a_line() -> None:
    """|x| has the second derivative sign(x) ẍ; where x = 0 it has none, and no formula stands for that."""
    x, v, a = sp.symbols("x v a", real=True)
    distance = magnitude(Vec(Jet(x, v, a), Jet(sp.S.Zero)))
    assert (distance.rate, distance.second) == (sp.sign(x) * v, sp.sign(x) * a)
