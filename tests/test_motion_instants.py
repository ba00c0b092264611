"""Every instant of the problem files by the engine of motion, against the stated answers: a road of its own.

The scene is taken from position residuals, pushes and loads alone, its accelerations from generated equations.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path

import pytest
from conftest import ROOT

from planar_cli.base_units import in_base
from planar_cli.errors import FileProblem
from planar_cli.motion.follow.stages import SceneStages
from planar_cli.motion.regime.mode import Chooser, Chosen
from planar_cli.motion.scene.quantities import Quantities
from planar_cli.motion.scene.scene import MovingScene
from planar_cli.motion.scene.stated import either
from planar_cli.motion.start.start import start_of
from planar_cli.motion.terms.terms import Term, evaluate
from planar_cli.problem.language.expression import Equilibrium, Name, Negate, Number, Quantity, Relation, Side, Word
from planar_cli.problem.language.walk import walk
from planar_cli.problem.scene.geometry import Vec
from planar_cli.problem.scene.reactions import Reactions
from planar_cli.problem.scene.scene import Answer, Find, Problem
from planar_cli.problem.structure import load, load_text
from planar_cli.simulate.run import Settings, simulate
from planar_cli.units import parse_unit

FOLDERS = sorted({p.parent for p in (ROOT / "problems").rglob("*.yaml")})
GIVEN = frozenset("a alpha ddot coriolis".split())
"""What an instant may state of accelerations as such; it is no motion that goes on."""


def instants(folder: Path) -> Iterator[tuple[str, Problem, dict[str, Answer]]]:
    """The instants of a folder's files and of their cases that a motion could begin with."""
    for path in sorted(folder.glob("*.yaml")):
        problem, wrong, _ = load(str(path))
        assert problem is not None, wrong
        answers = {a.name: a for a in problem.answers}
        for name, each in ((path.stem, problem), *((f"{path.stem}: {c.name}", c.problem) for c in problem.cases)):
            said = each.instant
            if said is None or not each.find or any(isinstance(s, Equilibrium) for s in said):
                continue
            if not any(isinstance(n, Quantity) and n.word in GIVEN for s in said for n in walk(s)):
                yield name, each, answers


class Instant:
    """The start of one scene with its accelerations and reactions."""

    def __init__(self, problem: Problem) -> None:
        self.scene = scene = MovingScene(problem)
        automaton = SceneStages(scene).automaton(())
        self.model = automaton.model
        start = start_of(self.model)
        automaton.note(start.time, start.state)
        chosen = Chooser(automaton, start.time, start.state).choose((0,) * len(automaton.choices))
        assert isinstance(chosen, Chosen)
        regime, layout, graph = self.model.regime(chosen.choice), self.model.layout, scene.graph
        rates = regime.rates(start.time, list(chosen.state))
        forces = regime.forces(start.time, list(chosen.state))
        accelerations = {
            v: graph.variable(scene.free_name(f"a{i}"), a)
            for i, (v, a) in enumerate(zip(layout.speeds, rates[layout.count :], strict=True))
        }
        pushes = zip(regime.reactions, forces, strict=False)
        sized = tuple((p, graph.variable(scene.free_name(p.name), f)) for p, f in pushes)
        names = {j.name: j.name for j in self.model.joints}
        reactions = Reactions(sized, regime.parts.wrenches, names, graph.number(0.0))
        self.asked = Quantities(scene, scene.stored_energy, accelerations, reactions)
        state = zip(layout.state, chosen.state, strict=True)
        self.at: dict[Term, float] = {**dict(state), layout.time: start.time}

    def values(self, side: Side) -> list[float]:
        """A side, or the parts of a vector."""
        found = either(side, self.asked)
        parts = [found.x, found.y] if isinstance(found, Vec) else [found]
        return evaluate([self.scene.graph.of(p) for p in parts], self.at)


def stated_answer(instant: Instant, find: Find, answer: Answer) -> list[float] | None:
    """The stated numbers in base units; None where words or a relation are asked."""
    if isinstance(answer.value, bool | str | Word) or not isinstance(find.found.what, Side):
        return None
    parts = answer.value if isinstance(answer.value, tuple) else (answer.value,)
    unit = None if find.found.unit is None else parse_unit(find.found.unit)
    found = []
    for part in parts:
        number = part.operand if isinstance(part, Negate) else part
        bare = isinstance(number, Number) and number.unit is None and unit is not None
        factor = in_base(unit, instant.scene.problem.us) if bare and unit is not None else 1.0
        found.append(evaluate([instant.scene.sides.value(part)], instant.at)[0] * factor)
    return found


def _of_another_case(find: Find) -> bool:
    """Does it name the answer of another case, `before.T`, which one instant alone does not know?"""
    what = find.found.what
    return not isinstance(what, Relation) and any(isinstance(n, Name) and "." in n.name for n in walk(what))


@pytest.mark.parametrize("folder", FOLDERS, ids=lambda p: p.name)
def test_the_engine_of_motion_finds_the_stated_answers(folder: Path) -> None:
    for name, problem, answers in instants(folder):
        try:
            instant = Instant(problem)
        except FileProblem as error:
            # Letters and unknowns without a number are refused by name.
            if {d.code for d in error.diagnostics} - {"PL704", "PL705", "PL504"}:
                raise
            continue
        for find in problem.find:
            if find.name not in answers or _of_another_case(find):
                continue
            stated = stated_answer(instant, find, answers[find.name])
            if stated is not None:
                size = max(abs(s) for s in stated)
                assert instant.values(find.found.what) == pytest.approx(stated, rel=0.01, abs=0.01 * size + 1e-9), name


def test_a_ball_that_leaves_a_dome_does_not_press_on_its_inside() -> None:
    problem, wrong, _ = load(str(ROOT / "problems" / "energy" / "ball-leaving-a-dome.yaml"))
    assert problem is not None, wrong
    found = {a.name: a.values for a in simulate(problem, Settings(estimate=False)).answers}
    assert found["x_3"] == pytest.approx((2.285984,), rel=1e-5)


def test_a_ball_drawn_on_a_rod_strikes_it_from_where_it_comes() -> None:
    problem, wrong, _ = load(str(ROOT / "problems" / "impact" / "ball-hits-a-hanging-rod.yaml"))
    assert problem is not None, wrong
    found = {a.name: a.values for a in simulate(problem.cases[0].problem, Settings(estimate=False)).answers}
    assert found["omega"] == pytest.approx((5.732484,), rel=1e-6)


GROWING = """
title: a wheel that takes up sand
plane: horizontal
points: {O: [0, 0]}
bodies: {wheel: {disk: O, radius: 0.5 m, mass: 10 kg + 2 kg/s * t}}
joints:
  - pin: {at: O, between: [ground, wheel]}
states:
  1: [t = 0, omega(wheel) = 6 rad/s]
  2: [t = 5 s]
find: {w: omega(wheel) @ 2}
"""


def test_a_body_that_takes_up_matter_turns_more_slowly() -> None:
    problem, wrong = load_text(GROWING)
    assert problem is not None, wrong
    simulation = simulate(problem, Settings(estimate=False))
    assert simulation.answers[0].values == pytest.approx((3.0,), rel=1e-8)


def test_a_place_that_is_only_guessed_is_no_start() -> None:
    problem, wrong, _ = load(str(ROOT / "problems" / "oscillations" / "block-between-two-springs.yaml"))
    assert problem is not None, wrong
    resting = next(c.problem for c in problem.cases if c.name == "parallel")
    # Without the equilibrium, which would tell it.
    (state,) = resting.states
    untold = tuple(r for r in state.relations if not isinstance(r, Equilibrium))
    resting = replace(resting, states=(replace(state, relations=untold),))
    with pytest.raises(FileProblem) as refused:
        simulate(resting, Settings(estimate=False))
    assert [d.code for d in refused.value.diagnostics] == ["PL704"]
