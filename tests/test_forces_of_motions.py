"""Forces and accelerations of a motion, at its states and throughout, take part in mistakes and in what is carried."""

from __future__ import annotations

import math

import numpy as np
import pytest
import sympy as sp
from conftest import ROOT
from homework_made import with_known_mistakes

from planar_cli.homework.variants.worked_problem import WorkedProblem, read_and_solve
from planar_cli.replay.equations import Asked, Equations, Step
from planar_cli.replay.numbers import Replay

PROBLEMS = ROOT / "problems"


def mistakes(worked: WorkedProblem) -> dict[str, dict[str, float]]:
    """Of each find what the models of mistakes give, by their names."""
    row = with_known_mistakes(worked)
    return {e.find: {m.name: m.values[0] for m in e.mistakes} for e in row}


def test_a_constant_acceleration_is_told_by_its_forces() -> None:
    # Two crates of 45 N drawn by 18 N over 4 m: v² = 2 a s, without friction a = 18 g/45.
    worked = read_and_solve(str(PROBLEMS / "energy" / "exercise-3-30.yaml"), "p")
    (part,) = worked.parts
    assert part.replay is not None
    assert set(part.replay.equations.asked) == {f.name for f in part.solution.found}
    found = mistakes(worked)
    assert found["v_2"]["friction-left-out"] == pytest.approx(math.sqrt(2 * 18 * 9.81 / 45 * 4))


def test_a_force_at_a_state_has_the_equations_there() -> None:
    # A thread from a hub: T = m (g - r α), where the moment of inertia about the point of contact gives α.
    worked = read_and_solve(str(PROBLEMS / "energy" / "yo-yo.yaml"), "p")
    part = worked.parts[0]
    assert part.replay is not None
    for find in ("v_2", "omega_2", "T_2", "share"):
        due = [float(v) for f in part.solution.found if f.name == find for v in f.values or ()]
        assert [float(n[0]) for n in part.replay.run({}).asked(find)] == pytest.approx(due, rel=1e-9)
    assert "diameter-for-radius" in mistakes(worked)["T_2"]


def test_what_is_known_by_a_number_alone_costs_no_other_find() -> None:
    worked = read_and_solve(str(PROBLEMS / "motion" / "there-and-back.yaml"), "p")
    (part,) = worked.parts
    assert part.replay is not None
    missing = [f.name for f in part.solution.found if f.name not in part.replay.equations.asked]
    assert missing == ["distance"]
    assert not worked.is_written


def test_steps_that_need_each_other_are_solved_together() -> None:
    x, y, z, a = sp.symbols("x y z a", real=True)
    steps = (Step((z,), (z - x * y,)), Step((x,), (x - y / 2 - 1,)), Step((y,), (y - x / 2 - a,)))
    asked = {"z": Asked((z,))}
    whole = Equations("", {"a": a}, {}, steps, asked, (), {a: 1.0, x: 2.0, y: 2.0, z: 4.0}).in_order()
    # x = y/2 + 1 and y = x/2 + 5/2 meet at (3, 4).
    assert [s.unknowns for s in whole.steps] == [(x, y), (z,)]
    assert Replay(whole).run({a: np.array([2.5])}).asked("z")[0] == pytest.approx(12.0)


def test_one_body_in_equilibrium_and_one_equation_without_the_weight() -> None:
    # A motor lifts 80 lb by a cord: T = W, and T = W a/g.
    worked = read_and_solve(str(ROOT / "tests" / "homework" / "hoist.yaml"), "p")
    row = with_known_mistakes(worked)
    told = {m.feedback: m.values[0] for m in row[1].mistakes}
    assert told["load is taken to be in equilibrium: m a is missing"] == pytest.approx(80)
    a = worked.parts[0].solution.found[0].values
    assert a is not None
    alone = told["this is the result without the weight in the equation of load along y"]
    assert alone == pytest.approx(80 / 32.2 * float(a[0]))


def test_several_instants_have_numbers_of_their_own() -> None:
    # Three instants of one linkage call its speed by one name.
    worked = read_and_solve(str(PROBLEMS / "kinematics" / "quick-return-stroke.yaml"), "p")
    (part,) = worked.parts
    assert part.replay is not None
    run = part.replay.run({})
    for name in part.replay.equations.asked:
        due = [float(v) for f in part.solution.found if f.name == name for v in f.values or ()]
        assert [float(n[0]) for n in run.asked(name)] == pytest.approx(due)
    assert {"cutting", "returning"} <= part.replay.equations.asked.keys()
