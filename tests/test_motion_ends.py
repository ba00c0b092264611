"""How motions end that nobody gave an end, or that can go no further: said by name, with the place and the time."""

from __future__ import annotations

import math
from pathlib import Path

import pytest
from answered import LEVEL_ROD

from planar_cli.errors import FileProblem
from planar_cli.problem.structure import load, load_text
from planar_cli.simulate.run import FREE_STEPS, Settings, Simulation, simulate
from planar_cli.solve.run import solve_problem

PROBLEMS = Path(__file__).parent.parent / "problems"
ATWOOD = """\
title: Two blocks until one comes to the pulley
plane: vertical
points: {D: [0, 0], A: [-0.1 m, -1 m], B: [0.1 m, -1 m]}
bodies:
  pulley: {disk: D, radius: 0.1 m}
  A_block: {particle: A, mass: 3 kg}
  B_block: {particle: B, mass: 2 kg}
joints:
  - pin: {at: D, between: [ground, pulley]}
  - rope: {path: [A, over pulley, B], name: rope}
"""


def simulated(path: Path, settings: Settings) -> Simulation:
    problem, wrong, _ = load(str(path))
    assert problem is not None, wrong
    return simulate(problem, settings, {})


@pytest.mark.parametrize("tolerance", [1e-3, 1e-6, 1e-9, 1e-12])
def test_a_rope_of_which_a_part_has_run_out(tolerance: float) -> None:
    """The wheel's centre comes to the pulley, 2 m up the slope: beyond it the cord has another direction."""
    found = simulated(PROBLEMS / "systems/wheel-pulled-uphill.yaml", Settings(tolerance=tolerance, until=3.0))
    outcome = found.run.trajectory.outcome
    assert (outcome.kind, outcome.code, outcome.joint) == ("spent", "PL712", "cord")
    assert outcome.t == pytest.approx(math.sqrt(2 * 2 / found.answers[0].values[0]), rel=3e-3)


def test_without_an_end_a_rope_that_runs_out_is_one() -> None:
    found = simulated(PROBLEMS / "systems/wheel-pulled-uphill.yaml", Settings())
    assert found.run.trajectory.outcome.kind == "spent"
    assert not found.run.trajectory.outcome.refused
    assert found.answers[0].values == pytest.approx([1.64232], rel=1e-5)


def test_a_block_that_comes_to_the_rim_of_its_pulley(tmp_path: Path) -> None:
    """Inside the rim the free part would have the root of a negative number for a length."""
    scene = tmp_path / "scene.yaml"
    scene.write_text(ATWOOD + "instant: [at rest]\nfind: {a: a(A).y}\n", encoding="utf-8")
    outcome = simulated(scene, Settings(until=3.0)).run.trajectory.outcome
    assert outcome.kind == "spent"
    assert outcome.t == pytest.approx(math.sqrt(2 * 1 / (9.81 / 5)), rel=2e-3)


def test_without_an_end_a_motion_costs_no_more_than_it_may() -> None:
    """A crank under a constant torque turns faster and faster."""
    found = simulated(PROBLEMS / "plans/slider-crank-free.yaml", Settings(tolerance=1e-6, estimate=False))
    trajectory = found.run.trajectory
    assert trajectory.outcome.kind == "long"
    assert not trajectory.outcome.refused
    assert trajectory.work.steps == pytest.approx(FREE_STEPS, abs=1)
    assert found.answers[0].values == pytest.approx([441.368], rel=1e-5)


def test_a_state_where_a_force_is_largest() -> None:
    """A force has no formula for its rate; it is a difference along the motion."""
    found = simulated(PROBLEMS / "motion/body-hoist-starting-softly.yaml", Settings(estimate=False))
    answers = {a.name: a.values[0] for a in found.answers}
    assert answers["t_max"] == pytest.approx(2.0, rel=1e-9)
    assert answers["T_max"] == pytest.approx(3084.3716694, rel=1e-9)
    assert not found.run.trajectory.missed


def test_the_rate_of_a_force_is_refused(tmp_path: Path) -> None:
    """It was told to be zero."""
    scene = tmp_path / "scene.yaml"
    text = "states:\n  1: [t = 0, at rest]\n  2: [t = 0.1 s]\nfind: {rate: dot(tension(rope)) @ 2}\n"
    scene.write_text(ATWOOD + text, encoding="utf-8")
    with pytest.raises(FileProblem, match="rate of a force"):
        simulated(scene, Settings())


@pytest.mark.parametrize(
    "found", ["omega(rod)", "omega(rod) > 1 rad/s", "omega(rod) @ 2 = omega(rod)", "KE(rod) = 3 J"]
)
def test_a_find_that_forgets_its_state_is_refused(found: str) -> None:
    """`ω = ω` was an answer, and a relation without a state a fault of the program."""
    text = f"{LEVEL_ROD}states:\n  1: [t = 0, at rest]\n  2: [theta(rod) = -90 deg]\nfind: {{asked: {found}}}\n"
    problem, wrong = load_text(text)
    assert problem is not None, wrong
    with pytest.raises(FileProblem) as refused:
        solve_problem(problem)
    (told,) = refused.value.diagnostics
    assert told.code == "PL560"
    assert told.mark.line == text.count("\n")
    assert told.hint == "say at which state: `@ 1`, `@ 2`"


def test_what_is_constant_needs_no_state() -> None:
    """A relative velocity of two ships; a ratio of forces that vary by themselves would do, too."""
    found = simulated(PROBLEMS / "motion/ships-passing.yaml", Settings(estimate=False))
    answers = {a.name: a for a in found.answers}
    assert answers["v_rel"].values == pytest.approx([36.1156 / 3.6], rel=1e-5)


def test_what_varies_needs_one(tmp_path: Path) -> None:
    scene = tmp_path / "scene.yaml"
    text = "states:\n  1: [t = 0, omega(rod) = -1 rad/s]\n  2: [theta(rod) = -90 deg]\n"
    text += "find: {w: omega(rod), m: KE(rod)/omega(rod)^2}\n"
    scene.write_text(LEVEL_ROD + text, encoding="utf-8")
    turning, constant = simulated(scene, Settings(estimate=False)).answers
    assert turning.why == "it varies; say at which state"
    assert constant.values == pytest.approx([1 / 3], rel=1e-6)


def test_what_has_no_value_is_said(tmp_path: Path) -> None:
    """Divisions by zero were faults of the program."""
    scene = tmp_path / "scene.yaml"
    text = "states:\n  1: [t = 0, at rest]\n  2: [theta(rod) = -90 deg]\n"
    text += "find: {m: KE(rod) @ 1/(omega(rod) @ 1)^2, n: (KE(rod)/omega(rod)^2) @ 1, k: KE(rod)/omega(rod)^2}\n"
    scene.write_text(LEVEL_ROD + text, encoding="utf-8")
    for answer in simulated(scene, Settings(estimate=False)).answers:
        assert answer.values == ()
        assert "no value" in answer.why


RESISTED = """\
title: Crate against a resistance that stays the same until it rests
plane: vertical
points: {P: [0, 0]}
bodies: {crate: {particle: P, mass: 10 kg}}
joints:
  - guide: {body: crate, along: 0 deg}
loads:
  - drag: {body: crate, magnitude: 20 N, name: rubbing}
states:
  0: [t = 0, v(crate).x = 4 m/s]
  1: [crate at rest]
"""


def test_a_resistance_that_does_not_vanish_at_rest_leads_to_rest() -> None:
    """At rest such a load may be anything up to its size: where nothing else acts, it is none."""
    asked = "find: {t: t @ 1, d: x(crate) @ 1}\n"
    problem, wrong = load_text(RESISTED + asked)
    assert problem is not None, wrong
    found = simulate(problem, Settings(), {})
    assert [a.values[0] for a in found.answers] == pytest.approx([2.0, 4.0], rel=1e-8)
    problem, wrong = load_text(RESISTED + "  2: [t = 3 s]\n" + asked)
    assert problem is not None, wrong
    found = simulate(problem, Settings(), {})
    assert not found.run.trajectory.outcome.refused
    assert [a.values[0] for a in found.answers] == pytest.approx([2.0, 4.0], rel=1e-8)


KNOT = """\
title: A knot without mass between two springs, both relaxed
plane: vertical
points: {U: [0, 0.6 m], J: [0, 0.3 m], P: [0, 0]}
bodies: {knot: {particle: J}, block: {particle: P, mass: 5 kg}}
joints:
  - guide: {point: J, along: 90 deg}
  - guide: {point: P, along: 90 deg}
loads:
  - spring: {between: [J, U], stiffness: 2 kN/m, natural_length: 0.3 m}
  - spring: {between: [J, P], stiffness: 2 kN/m, natural_length: 0.3 m}
instant: [at rest]
"""


def test_a_body_without_mass_that_loads_begin_to_drive(tmp_path: Path) -> None:
    """Nothing drives it where the motion begins; it is no support, and stays nowhere."""
    scene = tmp_path / "scene.yaml"
    scene.write_text(KNOT, encoding="utf-8")
    trajectory = simulated(scene, Settings(until=1.0)).run.trajectory
    assert (trajectory.outcome.code, trajectory.outcome.joint) == ("PL702", "knot")
    assert not trajectory.segments
