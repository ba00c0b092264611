"""Linear momentum, angular momentum and energy add up over every part of a motion that confirms a solution."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import pytest

from planar_cli.motion.follow import stages
from planar_cli.motion.trajectory.impact import Bond, Struck, StruckContact, strike, unbalanced
from planar_cli.motion.trajectory.trajectory import Trajectory
from planar_cli.problem.structure import load_text
from planar_cli.simulate.run import Settings, simulate
from planar_cli.solve.instant.verify import Disagreement
from planar_cli.solve.run import solve_problem

ROCKET = """
title: Rocket that burns its fuel
plane: vertical
bodies: {R: {particle: [0.3 m, 0], mass: 10 kg - (2 kg/s)*t}}
loads:
  - stream: {body: R, rate: 2 kg/s, leaves: {at: R, speed: 100 m/s, angle: -90 deg}}
states: {1: [t = 0, v(R).x = 4 m/s, v(R).y = 0], 2: [t = 2 s]}
find: {v: v(R).y @ 2}
"""
WAGON = """
title: Rod on a wagon
plane: vertical
points: {O: [0, 0], P: [0.5 m, 0]}
bodies: {wagon: {particle: O, mass: 4 kg}, rod: {rod: [O, P], mass: 2 kg}}
joints:
  - guide: {body: wagon, along: 0 deg, name: rails}
  - pin: {at: O, between: [wagon, rod], name: hinge}
states: {1: [t = 0, at rest], 2: [theta(rod) = -90 deg]}
find: {v: v(wagon).x @ 2}
"""
PACKAGE = """
title: A package slides on the bed of a car that brakes
plane: vertical
points: {C: [0, 0], P: [0, 1 m]}
surfaces: {bed: {through: P, angle: 0 deg, body: car}}
bodies: {car: {particle: C, mass: 1000 kg}, package: {particle: P, mass: 10 kg}}
joints:
  - guide: {body: car, along: 0 deg}
  - contact: {between: [package, bed], mu: 0.4}
loads:
  - force: {body: car, magnitude: 5 kN, angle: 180 deg}
states:
  1: [t = 0, v(car).x = 20 m/s, v(package).x = 20 m/s]
  2: [t = 3 s]
find: {v: v(package/car).x @ 2}
"""


def followed(text: str) -> Trajectory:
    problem, wrong = load_text(text)
    assert problem is not None
    assert not wrong
    return simulate(problem, Settings(momenta=True, estimate=False)).run.trajectory


@pytest.mark.parametrize("text", [ROCKET, WAGON, PACKAGE])
def test_momenta_add_up(text: str) -> None:
    """Of a mass that shrinks, too, and where a load moves on a body that can not turn; a momentum that stays zero is
    measured by what is usual in the scene.
    """
    trajectory = followed(text)
    assert not trajectory.outcome.refused
    for segment in trajectory.segments:
        assert segment.balance is not None
        assert len(segment.balance.momentum) == 3
        assert segment.balance.off < 1e-7


@pytest.mark.parametrize(("part", "words"), [(0, "along x"), (1, "along y"), (2, "angular momentum")])
def test_a_solution_whose_momentum_does_not_add_up_is_none(
    part: int, words: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    """As if a force from outside were left out of what the joints and loads state."""
    found = stages.outside_of

    def other(*given: Any) -> Any:
        outside = found(*given)
        assert outside is not None

        def less(t: float, y: Any) -> tuple[float, ...]:
            return tuple(v - (1e-3 * outside.least[part] if k == part else 0.0) for k, v in enumerate(outside.at(t, y)))

        return replace(outside, at=less)

    monkeypatch.setattr(stages, "outside_of", other)
    problem, _ = load_text(WAGON)
    assert problem is not None
    with pytest.raises(Disagreement, match=rf"contradicts the solution: between .* {words} does not add up"):
        solve_problem(problem)


FRAMES = {"frames": ((0, 1, None), (2, 3, None)), "places": ((0.0, 0.0), (1.0, 0.0))}


@pytest.mark.parametrize(("normal", "holds"), [((-1, 0, 1, 0), True), ((-1, 0, 0.9, 0), False), ((0, -1, 0, 1), False)])
def test_what_bodies_do_to_each_other_in_an_impact_cancels(normal: tuple[float, ...], holds: bool) -> None:
    """The last one has no resultant, but a moment: it would set both turning."""
    hit = StruckContact("hit", normal, inner=True)
    struck = Struck((1.0, 1.0, -1.0, -1.0), (1.0,) * 4, (1.0,) * 4, (), (hit,), **FRAMES)
    assert (unbalanced(struck, strike(struck)) < 1e-12) == holds
    bond = Bond("weld", normal, inner=True)
    struck = replace(struck, contacts=(), bonds=(bond,))
    assert (unbalanced(struck, strike(struck)) < 1e-12) == holds


def test_what_acts_on_the_ground_need_not_cancel() -> None:
    hit = StruckContact("floor", (0, 1, 0, 0))
    struck = Struck((1.0, -1.0, 0.0, 0.0), (1.0,) * 4, (1.0,) * 4, (), (hit,), **FRAMES)
    assert unbalanced(struck, strike(struck)) < 1e-12
