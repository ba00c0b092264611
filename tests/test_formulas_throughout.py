"""A quantity without a state, of a motion that a state begins: a formula in the place, without numbers."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from typing import Any

import pytest
import sympy as sp

from planar_cli.formats.terminal import Terminal
from planar_cli.problem.structure import load_text
from planar_cli.report.page.narrate import narrate
from planar_cli.solve import run as solving
from planar_cli.solve.instant.verify import Disagreement
from planar_cli.solve.run import solve_problem
from planar_cli.solve.solution import Found
from planar_cli.solve.solved_problem import PartSolution

ROD = """
title: Rod let go
plane: vertical
given: {L: 2 m}
coordinates: {theta: deg}
points: {A: [0, 0], B: {from: A, distance: L, angle: theta}}
bodies: {rod: {rod: [A, B], mass: 3 kg}}
joints:
  - pin: {at: A, between: [rod, ground]}
states: {1: [theta = 0, at rest]}
find: {w: omega(rod)}
"""


def test_an_angular_velocity_as_a_function_of_the_angle() -> None:
    """From 1/2 I ω² = -m g L/2 sin θ, with I = m L²/3."""
    page = Terminal(110).render(narrate(solve_problem(load_text(ROD)[0])))
    assert "w = θ̇ = -√(-3 g sin θ / L)" in page


BLOCK = """
title: Rod on an accelerated block
plane: horizontal
symbols: {a: m/s^2, r: m, k_A: m, m: kg, phi: deg}
coordinates: {theta: deg}
points:
  A: [0, 0]
  G: {from: A, distance: r, angle: theta}
bodies:
  block: {particle: A}
  rod: {points: [A], center: G, mass: m, radius_of_gyration: k_A, about: A}
joints:
  - guide: {body: block, along: 0 deg, name: track}
  - pin: {at: A, between: [block, rod]}
motion: [a(block).x = a]
states:
  1: [theta = START, at rest]
find:
  omega: omega(rod)
"""


def _part(text: str) -> PartSolution:
    problem, wrong = load_text(text)
    assert problem is not None
    assert not wrong
    (part,) = solve_problem(problem).parts
    return part


def _formula(part: PartSolution) -> sp.Expr:
    (found,) = part.found
    assert found.expressions
    return found.expressions[0]


def _at(formula: sp.Expr, **numbers: float) -> float:
    return float(formula.subs({s: numbers[s.name] for s in formula.free_symbols}))


NUMBERS: Mapping[str, float] = {"a": 2.0, "r": 0.5, "k_A": 0.7, "theta": 1.1}


def test_it_is_compared_where_the_motion_goes() -> None:
    """Seen from the block a r (cos φ - cos θ) m is the work of the force of inertia; at the start itself both vanish,
    and the rounding of θ may put the difference below zero.
    """
    part = _part(BLOCK.replace("START", "phi"))
    there = {**NUMBERS, "phi": 0.4}
    work = there["a"] * there["r"] * float(sp.cos(0.4) - sp.cos(1.1))
    assert _at(_formula(part), **there) == pytest.approx(float(sp.sqrt(2 * work)) / there["k_A"])
    assert part.confirmed.finds == {"omega"}


@pytest.mark.parametrize(
    "wrong",
    [
        lambda e: -e,
        lambda e: e * sp.Rational(10001, 10000),
        lambda e: sp.sqrt(-(e**2)),
    ],
)
def test_a_wrong_formula_is_refused_that_is_right_at_the_start(wrong: Any, monkeypatch: pytest.MonkeyPatch) -> None:
    """From rest each of these is zero there, as it should be; the last is not real further on."""
    solve = solving.solve_part

    def off(f: Found) -> Found:
        return replace(f, expressions=tuple(wrong(e) for e in f.expressions or ()))

    def other(*given: Any) -> PartSolution:
        part = solve(*given)
        return replace(part, found=tuple(off(f) for f in part.found))

    monkeypatch.setattr(solving, "solve_part", other)
    with pytest.raises(Disagreement, match="w is not confirmed"):
        _part(ROD)


def test_from_an_unstable_equilibrium_it_is_told_after_a_slight_touch() -> None:
    """A formula in the angle is of no use where the angle stays."""
    part = _part(BLOCK.replace("START", "0"))
    work = 2.0 * 0.5 * float(1 - sp.cos(1.1))
    assert _at(_formula(part), **NUMBERS) == pytest.approx(float(sp.sqrt(2 * work)) / 0.7)
    assert part.motion is not None
    assert any("unstable equilibrium: the limit of a slight touch" in c for c in part.motion.checks)
    assert "omega" in part.confirmed.apart  # in numbers nothing leaves the equilibrium


def test_forces_go_with_it() -> None:
    """At the top of the circle: ω² = 3 g (1 - sin θ)/L, and with it N along the rod is m g (5 sin θ - 3)/2."""
    text = ROD.replace("theta = 0", "theta = 90 deg").replace("omega(rod)}", "omega(rod), N: reaction(A).along(theta)}")
    part = _part(text)
    formula = next(f.expressions[0] for f in part.found if f.name == "N" and f.expressions)
    for angle in (1.2, 2.0):
        want = 3 * 9.81 * (5 * float(sp.sin(angle)) - 3) / 2
        assert _at(formula, theta=angle, m=3.0, g=9.81, L=2.0) == pytest.approx(want)


@pytest.mark.parametrize(
    ("text", "said"),
    [
        (BLOCK.replace("START", "180 deg"), "in equilibrium beside what is driven: nothing else moves"),
        (ROD.replace("theta = 0", "theta = -90 deg"), "in equilibrium, where every acceleration vanishes"),
    ],
)
def test_where_it_stays_that_is_said(text: str, said: str) -> None:
    part = _part(text)
    assert [list(map(float, f.values or ())) for f in part.found] == [[0.0]]
    assert part.motion is not None
    assert any(said in c for c in part.motion.checks)


def test_both_components_of_a_force_have_their_lines() -> None:
    text = ROD.replace("omega(rod)}", "omega(rod), R: reaction(A)}")
    page = Terminal(110).render(narrate(solve_problem(load_text(text)[0])))
    told = page.partition("R as long as the sense of the motion is kept")[2].partition("Answer")[0]
    assert "R_x = " in told
    assert "R_y = " in told
