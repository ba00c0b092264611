"""What of the state is integrated: the independent coordinates, from which joints tell the others."""

from __future__ import annotations

import pytest
from answered import first, solve
from conftest import ROOT
from pinned import chain, four_bars, model_of

from planar_cli.integrators.base import Setting, Step
from planar_cli.motion.regime.model import Model
from planar_cli.motion.start.start import start_of
from planar_cli.motion.trajectory.drive import drive
from planar_cli.motion.trajectory.reduced import Reduced

SQUEEZER = (ROOT / "problems" / "hard" / "andrews-squeezer.yaml").read_text(encoding="utf-8")
FREE = """
plane: horizontal
points: {A: [0, 0], B: [1 m, 0], C: [1 m, 1 m]}
bodies: {one: {rod: [A, B], mass: 1 kg}, other: {rod: [B, C], mass: 1 kg}}
joints:
  - pin: {at: B, between: [one, other]}
instant: [v(A).x = 0, v(A).y = 1 m/s, omega(one) = 1 rad/s, omega(other) = 3 rad/s]
"""
SLIDER = """
plane: vertical
points: {O: [0, 0], A: [0.3 m, 0.4 m], B: [1 m, 0]}
bodies: {crank: {rod: [O, A], mass: 1 kg}, rod: {rod: [A, B], mass: 1 kg}, piston: {particle: B, mass: 1 kg}}
joints:
  - pin: {at: O, between: [ground, crank]}
  - pin: {at: A, between: [crank, rod]}
  - pin: {at: B, between: [rod, piston]}
  - guide: {body: piston, along: 0 deg}
instant: [omega(crank) = 2 rad/s cw]
"""


def steps_of(model: Model, until: float, tolerance: float) -> tuple[Step, ...]:
    part, t, y = reduced(model)
    regime = model.regime()
    setting = Setting(model.scale, tolerance, project=regime.project)
    return drive(regime.rates, t, y, until, setting, reduced=part).steps


def reduced(model: Model) -> tuple[Reduced, float, list[float]]:
    start = start_of(model)
    found = model.regime().reduced(start.time, start.state)
    assert found is not None
    return found, start.time, list(start.state)


@pytest.mark.parametrize(
    ("text", "independent", "loops"),
    [
        (chain(10, -0.3), 10, False),
        (four_bars(3), 7, True),
        (SQUEEZER, 7, True),
        (FREE, 4, False),
        (SLIDER, 2, True),
    ],
)
def test_places_follow_from_angles_wherever_bodies_hang_together(text: str, independent: int, loops: bool) -> None:
    found, t, y = reduced(model_of(text))
    assert len(found.free) == independent
    assert (found.loops > 0) == loops
    assert found.whole(t, found.part(y)) == pytest.approx(y, abs=1e-13)


@pytest.mark.parametrize("text", [chain(4, -0.3), four_bars(2), SQUEEZER, FREE, SLIDER])
def test_both_have_the_same_rates(text: str) -> None:
    model = model_of(text)
    found, t, y = reduced(model)
    whole = model.regime().rates(t, y)
    rates = found.rates(t, found.part(y))
    size = max(map(abs, whole))
    assert rates == pytest.approx(found.part(whole), abs=1e-12 * size)


def test_a_step_has_the_whole_state_and_its_rates() -> None:
    model = model_of(SLIDER)
    regime = model.regime()
    for step in steps_of(model, 0.5, 1e-8):
        for t, y in ((step.t0, step.y0), (step.t1, step.y1)):
            assert max(map(abs, regime.residuals(t, y))) < 1e-14
        assert step.r1 == pytest.approx(regime.rates(step.t1, step.y1), rel=1e-9, abs=1e-9)


def test_an_open_chain_keeps_its_joints_inside_a_step_at_any_tolerance() -> None:
    model = model_of(chain(5, -0.3))
    regime = model.regime()
    for step in steps_of(model, 1.0, 1e-3):
        for k in range(5):
            t = step.t0 + k / 5 * (step.t1 - step.t0)
            assert max(map(abs, regime.residuals(t, step.at(t)))) < 1e-14


def test_wheels_of_one_size_under_a_belt() -> None:
    """Their places cancel in the relation of the belt: how far the other has turned does not rest on them."""
    found = solve("""
points: {A: [0, 0], B: [0.8 m, 0]}
bodies: {one: {disk: A, radius: 0.2 m}, other: {disk: B, radius: 0.2 m}}
joints:
  - pin: {at: A, between: [ground, one]}
  - pin: {at: B, between: [ground, other]}
  - belt: {between: [one, other]}
motion: [alpha(one) = 3 rad/s^2]
states:
  1: [t = 0, at rest]
  2: [t = 5 s]
find: {w: omega(other) @ 2}
""")
    assert first(found["w"]) == pytest.approx(15)
