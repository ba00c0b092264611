"""Motions that begin with an infinite acceleration, such as that of constant power from rest."""

from __future__ import annotations

import math

import pytest

from planar_cli.formats.terminal import Terminal
from planar_cli.problem.structure import load_text
from planar_cli.report.page.narrate import narrate
from planar_cli.simulate.run import Settings, simulate
from planar_cli.solve.run import solve_problem
from planar_cli.solve.solved_problem import PartSolution

CAR = """\
title: Car with constant power
plane: vertical
{known}
points: {{C: [0, 0]}}
bodies: {{car: {{particle: C, mass: m}}}}
joints:
  - guide: {{point: C, along: {along}, name: road}}
loads:
  - force: {{body: car, magnitude: P/v(car).along({along}), angle: {along}, name: drive}}{more}
states:
  start: [t = 0, {start}]
  end: [{end}]
find: {{v: v(car).along({along}) @ end, s: x(car) @ end, T: t @ end}}
"""
DRIVEN = """\
title: Car with constant power
{known}
bodies: {{car: {{particle: [0, 0]}}}}
joints:
  - guide: {{point: car, along: 0 deg, name: road}}
motion: [a(car).x = P/(m*v(car).x)]
states:
  start: [t = 0, {start}]
  end: [{end}]
find: {{v: v(car).x @ end, s: x(car) @ end, T: t @ end}}
"""
USUAL = {
    "known": "given: {m: 1000 kg, P: 50 kW}",
    "along": "0 deg",
    "more": "",
    "start": "at rest",
    "end": "t = 8 s",
}
ROLLING = "\n  - force: {body: car, magnitude: 300 N, angle: 180 deg, name: resistance}"
LETTERS = "symbols: {m: kg, P: W, T: s}"


def solved(text: str, **changes: str) -> tuple[PartSolution, str]:
    problem, _ = load_text(text.format(**{**USUAL, **changes}), "car.yaml")
    solution = solve_problem(problem)
    return solution.parts[0], Terminal().render(narrate(solution))


def numbers(part: PartSolution) -> dict[str, float]:
    return {f.name: float(f.values[0]) for f in part.found if f.values}


@pytest.mark.parametrize("text", [CAR, DRIVEN])
@pytest.mark.parametrize("start", ["at rest", "v(car).x = 0"])
def test_from_rest(text: str, start: str) -> None:
    part, _ = solved(text, start=start)
    v = math.sqrt(2 * 50 * 8)
    assert numbers(part) == pytest.approx({"v": v, "s": 2 / 3 * v * 8, "T": 8})
    assert part.confirmed is not None
    assert {"v", "s"} <= part.confirmed.finds


@pytest.mark.parametrize("text", [CAR, DRIVEN])
@pytest.mark.parametrize(("end", "time"), [("x(car) = 180 m", 9), ("v(car).x = 30 m/s", 9)])
def test_until_a_place_or_a_speed(text: str, end: str, time: float) -> None:
    part, _ = solved(text, end=end)
    assert numbers(part) == pytest.approx({"v": 30, "s": 180, "T": time})


@pytest.mark.parametrize("text", [CAR, DRIVEN])
def test_in_letters(text: str) -> None:
    part, page = solved(text, known=LETTERS, end="t = T")
    told = {f.name: f.expressions[0] for f in part.found if f.expressions}
    sizes = {"m": 3.0, "P": 5.0, "T": 7.0}
    number = float(told["s"].subs({s: sizes[s.name] for s in told["s"].free_symbols}))
    assert number == pytest.approx(2 / 3 * math.sqrt(2 * 5 / 3) * 7**1.5)
    assert "√(2 P T/m)" in page
    assert part.confirmed is not None
    assert {"v", "s"} <= part.confirmed.finds


def test_us_units() -> None:
    part, _ = solved(CAR, known="given: {m: 2000 lb, P: 60 hp}")
    v = math.sqrt(2 * 60 * 550 * 8 / (2000 / 32.17405))
    assert numbers(part) == pytest.approx({"v": v, "s": 2 / 3 * v * 8, "T": 8}, rel=1e-6)


def test_against_a_resistance_it_goes_forward() -> None:
    """Backwards it would fulfil the same equation: the power is the same, and the force would be negative."""
    part, _ = solved(CAR, more=ROLLING)
    found = numbers(part)
    v, power, force, mass = found["v"], 50e3, 300.0, 1000.0
    assert v > 0
    # m v dv/(P - F v) = dt
    assert mass * (power / force**2 * math.log(power / (power - force * v)) - v / force) == pytest.approx(8)


def test_uphill() -> None:
    part, _ = solved(CAR, along="10 deg")
    assert 0 < numbers(part)["v"] < math.sqrt(2 * 50 * 8)
    assert numbers(part)["s"] > 0


def test_simulated_from_a_slight_speed_and_says_so() -> None:
    problem, _ = load_text(CAR.format(**USUAL), "car.yaml")
    found = simulate(problem, Settings())
    assert {a.name: a.values[0] for a in found.answers}["v"] == pytest.approx(math.sqrt(800), rel=1e-6)
    assert any("infinite at the start" in note for note in found.run.trajectory.notes)


@pytest.mark.parametrize("text", [CAR, DRIVEN])
def test_backwards(text: str) -> None:
    """The root that goes on from a negative speed is the negative one."""
    part, _ = solved(text, start="v(car).x = -2 m/s")
    v = -math.sqrt(4 + 2 * 50 * 8)
    assert numbers(part) == pytest.approx({"v": v, "s": (v**3 + 8) / 150, "T": 8})
