"""The course of a motion and the trajectory that the engine finds are the same motion: states, modes, numbers.

The course knows symbols of coordinates and free speeds; the engine knows places and velocities of all bodies. At every
state of the file the bodies must be at the same places with the same velocities, and where the course has put in a
state because something sticks, slips, parts or goes slack, the engine must have changed the modes of a joint.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from pathlib import Path

import pytest

from planar_cli.problem.structure import load
from planar_cli.simulate.run import Run, Settings, followed, prepared
from planar_cli.solve.between.branches.solved_motion import SolvedMotion
from planar_cli.solve.between.roots.followed import Followed
from planar_cli.solve.following.mode_search import ModeSearch
from planar_cli.solve.regimes.mode_sequence import Workshop
from planar_cli.solve.regimes.regime import Regime, number_function

PROBLEMS = Path(__file__).parent.parent / "problems"
CLOSE = 1e-9
"""Of the scale of a place, a velocity, or the latest time."""
TURNS = ("it turns round", "it comes to the other side")
"""A law reads otherwise from there on, but no mode changes."""
FILES = (
    "energy/ball-leaving-a-dome",
    "energy/block-down-a-slope-onto-a-buffer",
    "energy/crate-winched-up-a-slope",
    "energy/ladder-leaving-the-wall",
    "impact/ball-on-a-string-hits-a-block",
    "impact/row-of-hanging-balls",
    "impact/slanting-rod-falls-on-a-floor",
    "impact/three-carriages",
    "motion/ball-up-with-drag",
    "motion/block-runs-into-a-spring",
    "motion/body-ball-that-slides-then-rolls",
    "motion/body-block-sent-up-a-slope",
    "motion/body-four-bar-over-time",
    "motion/bullet-in-air",
)


def both(name: str) -> tuple[SolvedMotion, Followed, Run]:
    """A motion solved and followed, by the course and by the engine."""
    problem, wrong = load(PROBLEMS / f"{name}.yaml")[:2]
    assert problem is not None, wrong
    if not problem.find or not problem.states:
        problem = problem.cases[0].problem
    found = ModeSearch(problem, Workshop({})).run()
    assert found.followed is not None
    values = {s.name: float(found.value(s)) for s in found.course.sought()}
    run = followed(prepared(problem, values), Settings(values=values, tolerance=1e-12))
    return found, found.followed, run


def moving(regime: Regime, found: SolvedMotion, state: str) -> dict[str, tuple[float, ...]]:
    """By body: x, y, θ and their rates at a state, from the symbols of the state."""
    assert found.followed is not None
    bodies = {n: b for n, b in regime.general.instant.scene.bodies.items() if n != "ground"}
    places = [regime.closed(e) for b in bodies.values() for e in (b.center.x, b.center.y, b.theta)]
    function = number_function([*places, *map(regime.derivative, places)], regime.letters, found.value)
    letters = found.course.stops[state].letters
    numbers = function(*(found.followed.values[letters[s]] for s in regime.letters))
    half = len(places)
    return {
        name: (*numbers[3 * k : 3 * k + 3], *numbers[half + 3 * k : half + 3 * k + 3]) for k, name in enumerate(bodies)
    }


def differences(found: SolvedMotion, run: Run, state: str) -> Iterator[tuple[str, float]]:
    """How far bodies are apart in the two motions at a state, in parts of the scales."""
    layout, scale = run.model.layout, run.model.scale
    start, event = run.prepared.start, run.trajectory.event(state)
    y = start.y if state == found.course.states[0].name else event.y if event is not None else None
    assert y is not None, f"{state} is not reached"
    regime = found.course.readers[state].regime
    for body, numbers in moving(regime, found, state).items():
        frame = layout.frames.get(body)
        indices = () if frame is None else (frame.x, frame.y, frame.theta)
        for k, index in enumerate(indices):
            if index is None or (k == 2 and regime.general.instant.scene.bodies[body].theta.is_number):
                continue
            place, rate = numbers[k] - y[index], numbers[k + 3] - y[layout.count + index]
            if k == 2:
                place = math.remainder(place, 2 * math.pi)
            yield f"{body} in {state}", abs(place) / max(scale[index], abs(y[index]))
            size = max(scale[layout.count + index], abs(y[layout.count + index]))
            yield f"rate of {body} in {state}", abs(rate) / size


@pytest.mark.slow
@pytest.mark.parametrize("name", FILES)
def test_the_course_and_the_trajectory_are_the_same_motion(name: str) -> None:
    found, numbers, run = both(name)
    course, trajectory = found.course, run.trajectory
    times = {s.name: numbers.values[course.stops[s.name].t] for s in course.states}
    near = CLOSE * max(map(abs, times.values()))
    for state in (s.name for s in course.states if s.name not in course.modes.turnings):
        event = trajectory.event(state)
        assert event is None or abs(event.t - times[state]) <= near
        assert not [what for what, off in differences(found, run, state) if off > CLOSE]
    changes = [x.t for x in trajectory.transitions if x.old != x.new or x.kind == "impact"]
    for state, (_, words) in course.modes.turnings.items():
        assert words in TURNS or any(abs(t - times[state]) <= near for t in changes), words
    # Whatever changes on the way is a state of the course, too.
    last = max(times.values())
    assert all(any(abs(t - other) <= near for other in times.values()) for t in changes if t < last)
