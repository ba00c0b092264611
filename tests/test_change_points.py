"""Redundant constraints and singular positions: what is unique is right, what is not is told, nothing jumps."""

from __future__ import annotations

import math
from pathlib import Path

import pytest
from conftest import ROOT
from pinned import followed, four_bars, model_of, written

from planar_cli.errors import FileProblem
from planar_cli.motion.start.start import start_of
from planar_cli.problem.structure import load
from planar_cli.simulate.run import Settings, simulate

ANGLES = {2: 31.7505971869861018, 10: 31.6217298227818727, 40: 31.5974337439857377}
"""φ(10 s) of N four-bars, from an integration of their reduced equation with 50 digits."""


@pytest.mark.parametrize(
    ("count", "tolerance", "angle", "energy"),
    [
        (2, 1e-6, 1e-4, 1e-3),
        (2, 1e-8, 1e-6, 1e-6),
        (2, 1e-10, 1e-8, 1e-8),
        (10, 1e-6, 1e-4, 1e-3),
        pytest.param(40, 1e-6, 1e-4, 1e-3, marks=pytest.mark.slow),
    ],
)
def test_four_bars_pass_through_horizontal(count: int, tolerance: float, angle: float, energy: float) -> None:
    model = model_of(four_bars(count))
    found = followed(model, 10.0, tolerance)
    assert math.pi / 2 - found.at("theta_crank0") == pytest.approx(ANGLES[count], abs=angle)
    assert found.energy <= energy
    assert found.drift <= 1e-12
    turned = [found.at(f"theta_crank{i}") for i in range(count + 1)]
    assert turned == pytest.approx([turned[0]] * (count + 1), abs=1e-9)


PARALLELOGRAM = written(
    {
        "A": "[0, 0]",
        "B": "[1 m, 0]",
        "C": "[2 m, 0]",
        **{f"{p}1": f"{{from: {p}, distance: 1 m, angle: beta}}" for p in "ABC"},
    },
    {
        "a": "rod: [A, A1], mass: 1 kg",
        "b": "rod: [B, B1], mass: 1 kg",
        "c": "rod: [C, C1], mass: 1 kg",
        "coupler": "rod: [A1, C1], mass: 2 kg",
    },
    [(p, f"ground, {p.lower()}") for p in "ABC"] + [(f"{p}1", f"{p.lower()}, coupler") for p in "ABC"],
    "coordinates: {beta: deg}\ninstant: [beta = 60 deg, omega(a) = 2 rad/s]",
)


def test_a_third_crank_is_redundant_and_the_motion_unique() -> None:
    model = model_of(PARALLELOGRAM)
    start, regime = start_of(model), model.regime()
    independent = regime.parts.independent
    assert (len(regime.constraints), len(independent.kept), independent.singular) == (12, 11, False)
    # No pin has a component that is determined.
    assert independent.open == set(range(12))
    assert regime.indeterminate == {p.name for p in regime.reactions}
    rates = regime.rates(start.time, start.state)
    alphas = [rates[model.layout.count + model.layout.frames[b].theta] for b in ("a", "b", "c")]
    assert alphas == pytest.approx([-9.81 * math.cos(math.pi / 3) * 3.5 / 3] * 3, rel=1e-12)


def test_where_the_motion_may_branch_the_start_is_told_to_be_open() -> None:
    model = model_of(four_bars(2, "instant: [omega(crank0) = -2 rad/s]", "0 deg"))
    assert model.regime().parts.independent.singular
    with pytest.raises(FileProblem, match="velocity of crank1, crank2") as caught:
        start_of(model)
    assert caught.value.diagnostics[0].code == "PL704"


def test_at_a_singular_position_the_motion_goes_on_as_its_velocities_say() -> None:
    model = model_of(four_bars(2, "instant: [omega(crank0) = -2 rad/s]", "0 deg"))
    regime, (t, y) = model.regime(), model.reference
    half = model.layout.count
    for name, frame in model.layout.frames.items():
        y[half + frame.y] = -1.0 if name.startswith("crank") else -2.0
        if frame.theta is not None and name.startswith("crank"):
            y[half + frame.theta] = -2.0
    assert max(map(abs, regime.residuals(t, y))) < 1e-15
    rates = regime.rates(t, y)
    # φ'' = (N + (N+1)/2) g sin φ/(N + (N+1)/3), φ from the upward vertical, clockwise.
    expected = -(2 + 3 / 2) * 9.81 / (2 + 3 / 3)
    alphas = [rates[half + model.layout.frames[f"crank{i}"].theta] for i in range(3)]
    assert alphas == pytest.approx([expected] * 3, rel=1e-5)


def test_a_parallelogram_keeps_its_branch_at_the_change_point() -> None:
    points = {"A": "[0, 0]", "D": "[2 m, 0]", "B": "[0, 1 m]", "C": "[2 m, 1 m]"}
    bodies = {"AB": "rod: [A, B], mass: 1 kg", "BC": "rod: [B, C], mass: 1 kg", "DC": "rod: [D, C], mass: 1 kg"}
    pins = [("A", "ground, AB"), ("B", "AB, BC"), ("C", "BC, DC"), ("D", "ground, DC")]
    model = model_of(written(points, bodies, pins, "instant: [omega(AB) = -8 rad/s]"))
    found = followed(model, 3.0, 1e-9)
    assert found.at("theta_AB") < -20
    assert found.at("theta_DC") - found.at("theta_AB") == pytest.approx(0.0, abs=1e-10)
    assert found.drift <= 1e-12


SWINGING = """
title: a rod swings down about a point off its centre
plane: vertical
given: {l: 1.76 m, d: 0.72 m}
coordinates: {theta: deg}
points:
  O: [0, 0]
  G: {from: O, distance: d, angle: theta - 90 deg}
  A: {from: G, distance: l/2, angle: theta + 90 deg}
  B: {from: G, distance: l/2, angle: theta - 90 deg}
bodies: {rod: {rod: [A, B], mass: 1 kg, points: [O]}}
joints:
  - pin: {at: O, between: [ground, rod]}
states:
  1: [theta = 90 deg, at rest]
  2: [theta = 0]
find: {omega: omega(rod) @ 2}
"""


@pytest.mark.parametrize("tolerance", [1e-6, 1e-9])
def test_where_a_place_does_not_tell_an_angle_its_rate_stays_as_it_is(tolerance: float, tmp_path: Path) -> None:
    """As the rod hangs down, the height of its end does not tell how fast it turns."""
    path = tmp_path / "scene.yaml"
    path.write_text(SWINGING, encoding="utf-8")
    problem, _, _ = load(str(path))
    assert problem is not None
    found = simulate(problem, Settings(tolerance=tolerance)).answers[0]
    omega = -math.sqrt(24 * 9.81 * 0.72 / (1.76**2 + 12 * 0.72**2))
    assert found.values[0] == pytest.approx(omega, rel=100 * tolerance)


@pytest.mark.parametrize("integrator", ["auto", "radau"])
def test_a_change_point_is_passed_or_the_motion_is_refused(integrator: str) -> None:
    """A parallelogram stays one: at no tolerance does it leave on the other branch."""
    problem, _, _ = load(str(ROOT / "problems/hard/parallelogram-through-its-change-point.yaml"))
    assert problem is not None
    passed = 0
    for tolerance in (1e-6, 1e-8, 1e-9, 1e-10, 1e-11, 3e-12, 1e-12):
        found = simulate(problem, Settings(tolerance=tolerance, integrator=integrator, estimate=False))
        if found.run.trajectory.outcome.kind == "reached":
            passed += 1
            assert found.answers[0].values[0] == pytest.approx(math.radians(30), abs=1e-7)
    assert passed >= 4
