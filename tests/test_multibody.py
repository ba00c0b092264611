"""The independent road agrees with all choices of modes that hold, in all problem files, and catches planted faults."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from decimal import Decimal
from pathlib import Path
from typing import Any

import pytest
from conftest import PROBLEMS, ROOT

from planar_cli.equation.algebra.form import Nonlinear
from planar_cli.equation.values.exact import Unvalued
from planar_cli.errors import FileProblem
from planar_cli.problem.scene.facts import Action, Push
from planar_cli.problem.scene.scene import Problem
from planar_cli.problem.structure import load, load_text
from planar_cli.solve.instant.instant import Trial, make_instant
from planar_cli.solve.instant.modes_search import search_modes
from planar_cli.solve.instant.worked import Worked, unknowns_of
from planar_cli.solve.multibody.agreement import Agreement
from planar_cli.solve.multibody.motion import second_road

HIDDEN = {"particles/unknown-counterweight.yaml", "momentum/jet-against-a-hinged-plate.yaml"}
"""Files that seek a mass, or what stands inside a given name: the numbers of one choice of modes are linear in what is
sought.
"""
KNOWN = [p for p in PROBLEMS if str(p.relative_to(ROOT / "problems")) not in HIDDEN]


def held_trials(problem: Problem) -> list[Trial]:
    """All choices of modes of a file that hold; none where its instant is beyond the linear trial."""
    always = tuple(law.statement for law in problem.motion)
    now = problem.instant if problem.instant is not None else problem.states[0].relations if problem.states else ()
    try:
        instant = make_instant(problem, always, now, {}, problem.instant is None and not problem.states)
        return search_modes(instant, instant.scene.valuations)[0]
    except (Unvalued, Nonlinear, FileProblem):
        return []


def parts(path: Path) -> Iterator[Problem]:
    problem, wrong, _ = load(str(path))
    if problem is not None and not wrong:
        yield problem
        for case in problem.cases:
            yield case.problem


@pytest.mark.parametrize("path", KNOWN, ids=lambda p: str(p.relative_to(ROOT / "problems")))
def test_second_road_agrees(path: Path) -> None:
    for problem in parts(path):
        for trial in held_trials(problem):
            for outcome in trial.outcomes:
                found = second_road(trial.system, Worked.of_solution(trial.system, outcome, {}))
                assert found.disagreements == ()
                assert found.digits >= 40
                assert found.velocities_ok < Decimal("1e-40")


CRANK = """
title: Crank and slider, driven
plane: vertical
points: {O: [0, 0], A: {from: O, distance: 0.3 m, angle: 50 deg}, B: {distances: {A: 0.8 m}, y: 0, side: right}}
bodies:
  OA: {rod: [O, A], mass: 2 kg}
  AB: {rod: [A, B], mass: 4 kg}
  piston: {particle: B, mass: 1 kg}
joints:
  - pin: {at: O, between: [ground, OA]}
  - pin: {at: A, between: [OA, AB]}
  - pin: {at: B, between: [AB, piston]}
  - guide: {point: B, along: 0 deg, mu: 0.1}
loads:
  - torque: {body: OA, moment: 20 N*m}
instant: [omega(OA) = 3 rad/s]
find: {alpha: alpha(OA)}
"""


@pytest.fixture
def crank() -> Trial:
    problem, wrong = load_text(CRANK)
    assert problem is not None
    assert not wrong
    return held_trials(problem)[0]


def road(trial: Trial, **changes: Any) -> Agreement:
    worked = Worked.of_solution(trial.system, trial.outcomes[0], {})
    return second_road(trial.system, replace(worked, **changes))


def test_the_crank_agrees(crank: Trial) -> None:
    assert road(crank).holds
    assert road(crank).digits >= 50


def test_a_wrong_acceleration_is_named(crank: Trial) -> None:
    worked = Worked.of_solution(crank.system, crank.outcomes[0], {})
    linear, alpha = worked.accelerations["AB"]
    found = road(crank, accelerations={**worked.accelerations, "AB": (linear, alpha * Decimal("1.0000001"))})
    assert [d.split(":")[0] for d in found.disagreements] == ["alpha of AB"]
    assert found.digits == 7


def test_a_wrong_push_is_named(crank: Trial) -> None:
    worked = Worked.of_solution(crank.system, crank.outcomes[0], {})
    name = next(n for n in worked.pushes if n.startswith("N_"))
    found = road(crank, pushes={**worked.pushes, name: worked.pushes[name] + 1})
    assert found.disagreements
    assert all(" of B" in d for d in found.disagreements)


def test_velocities_that_break_a_joint_are_named(crank: Trial) -> None:
    worked = Worked.of_solution(crank.system, crank.outcomes[0], {})
    linear, omega = worked.velocities["AB"]
    found = road(crank, velocities={**worked.velocities, "AB": (linear, omega + 1)})
    assert found.velocities_ok > Decimal("0.01")
    assert any("A: place on OA and AB" in d for d in found.disagreements)


def test_a_wrong_acceleration_relation_of_a_joint_is_caught() -> None:
    """A rod that rocks on a fixed round log: the way its centre rises is in the second derivative only."""
    text = """
title: Rod that rocks on a log
plane: vertical
points: {O: [0, 0], C: [0, 1 m], A: [-1 m, 1 m], B: [1.4 m, 1 m]}
bodies: {AB: {rod: [A, B], mass: 3 kg}}
surfaces: {trunk: {center: O, radius: 1 m}}
joints: [{rolling: {between: [AB, trunk], at: C}}]
instant: [omega(AB) = 1 rad/s]
find: {alpha: alpha(AB)}
"""
    problem, _ = load_text(text)
    assert problem is not None
    for factor in (1, 2):
        instant = make_instant(problem, (), problem.instant or (), {}, False)
        joint, (mode,) = instant.modes[0]
        joining = mode.facts.joinings[0]
        assert joining.rolling is not None
        bent = replace(joining, rolling=replace(joining.rolling, mover=factor * joining.rolling.mover))
        instant.modes[0] = (joint, (replace(mode, facts=replace(mode.facts, joinings=(bent,))),))
        trial = search_modes(instant, instant.scene.valuations)[0][0]
        worked = Worked.of_solution(trial.system, trial.outcomes[0], {})
        assert second_road(trial.system, worked).holds == (factor == 1)


def test_only_what_is_unique_is_compared() -> None:
    """A beam on three props: any distribution over them passes, its acceleration must fit."""
    path = next(p for p in PROBLEMS if p.name == "parallelogram-3-cranks.yaml")
    problem = next(parts(path))
    trial = held_trials(problem)[0]
    outcome = trial.outcomes[0]
    free = next(iter(outcome.solved.null.values()), None)
    assert free is not None
    values = [v + 7 * n for v, n in zip(outcome.solved.values, free, strict=True)]
    other = replace(outcome, solved=replace(outcome.solved, values=values))
    assert second_road(trial.system, Worked.of_solution(trial.system, other, {})).holds


def test_the_unknowns_of_the_tree_are_recovered(crank: Trial) -> None:
    found = unknowns_of(crank.system, crank.outcomes[0])
    assert set(crank.system.tree.acceleration_unknowns()) <= set(found)


def turned_push(push: Push) -> Push:
    """The push turned by a right angle."""
    actions = [Action(a.body, a.point, a.force.turned(), a.couple) for a in push.actions if a.force is not None]
    return replace(push, actions=tuple(actions))


def test_pushes_do_no_work_in_allowed_motions(crank: Trial) -> None:
    """A push turned away from the normal is caught: the net force of the joint differs."""
    system = crank.system
    turned = tuple(turned_push(p) if p.kind == "normal" else p for p in system.pushes)
    worked = Worked.of_solution(system, crank.outcomes[0], {})
    before, system.pushes = system.pushes, turned
    try:
        assert not second_road(system, worked).holds
    finally:
        system.pushes = before


DRIVEN = """
title: Cart with a pendulum, driven
plane: vertical
points: {A: [0, 0], B: [0.6 m, -0.8 m]}
bodies:
  cart: {particle: A, mass: 3 kg}
  rod: {rod: [A, B], mass: 2 kg}
joints:
  - guide: {point: A, along: 0 deg}
  - pin: {at: A, between: [cart, rod]}
motion: [a(A).x = 3 m/s^2]
instant: [at rest]
find: {N: N(A)}
"""
BY_COORDINATE = DRIVEN.replace("points:", "coordinates: {s: m}\npoints:").replace("A: [0, 0]", "A: [s, 0]")
BY_COORDINATE = BY_COORDINATE.replace("B: [0.6 m, -0.8 m]", "B: {from: A, distance: 1 m, angle: -53.13 deg}")
BY_COORDINATE = BY_COORDINATE.replace("a(A).x =", "ddot(s) =").replace("at rest", "at rest, s = 0")


def driven(text: str, elsewhere: str = "") -> tuple[Trial, Push]:
    """The trial and what drives it; `elsewhere`: a body at whose mass centre it is made to act."""
    problem, wrong = load_text(text)
    assert problem is not None, wrong
    assert not wrong
    always = tuple(law.statement for law in problem.motion)
    instant = make_instant(problem, always, problem.instant or (), {}, False)
    assert instant.add_drivers()
    if elsewhere:
        at = instant.scene.center(elsewhere)
        (push,) = instant.drivers
        moved = tuple(replace(a, body=elsewhere, point=at) for a in push.actions)
        instant.drivers = (replace(push, actions=moved),)
    trial = search_modes(instant, instant.scene.valuations)[0][0]
    (push,) = (p for p in trial.system.pushes if p.joint not in trial.system.modes)
    return trial, push


@pytest.mark.parametrize("text", [DRIVEN, BY_COORDINATE])
def test_what_drives_is_found_anew(text: str) -> None:
    trial, push = driven(text)
    assert road(trial).holds
    worked = Worked.of_solution(trial.system, trial.outcomes[0], {})
    found = road(trial, pushes={**worked.pushes, push.name: worked.pushes[push.name] + 1})
    assert [d.split(":")[0] for d in found.disagreements] == [f"what drives `{push.place}`"]


def test_a_drive_at_a_wrong_place_is_caught() -> None:
    """At the middle of the rod it would turn the rod, which a force on the cart does through the pin alone."""
    trial, _ = driven(DRIVEN, "rod")
    assert any(d.startswith("alpha of rod") for d in road(trial).disagreements)
