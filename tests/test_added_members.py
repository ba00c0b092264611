"""Members that somebody adds: a file in a folder is on the shelf, and the whole program knows what it does."""

from __future__ import annotations

import textwrap
from collections.abc import Callable, Iterator
from contextlib import ExitStack
from pathlib import Path

import pytest
from answered import assert_close

from planar_cli.problem.structure import load_text
from planar_cli.registry import extended, members
from planar_cli.report.effects import effects
from planar_cli.solve.run import solve_problem
from planar_cli.solve.solved_problem import Solution

MAGNET = '''
    """A magnet."""

    from __future__ import annotations

    from dataclasses import dataclass
    from typing import Any, ClassVar

    from planar_cli.loads.base import Load
    from planar_cli.problem.expression import Side
    from planar_cli.problem.facts import Effect, Wrench
    from planar_cli.problem.keys import PointPairKey, SideKey, key
    from planar_cli.problem.setting import MovingSetting, Setting


    @dataclass(frozen=True, slots=True, kw_only=True)
    class Magnet(Load):
        """Two points attract each other with k / d²."""

        kind: ClassVar[str] = "magnet"
        effect: ClassVar[Effect] = Effect("magnetic force", "magnets")

        between: tuple[str, str] = key(PointPairKey(), "the two points")
        strength: Side = key(SideKey("N*m^2"), "k")

        def wrenches(self, scene: MovingSetting) -> tuple[Wrench, ...]:
            start, end = (scene.point(p) for p in self.between)
            away = end - start
            distance = scene.length(away)
            size = scene.value(self.strength) / distance**2
            ends = ((self.between[0], start, away), (self.between[1], end, -away))
            return tuple(
                Wrench(self.name, "magnet", scene.owner(p), at, d * (size / distance), 0, size) for p, at, d in ends
            )

        def potential(self, scene: Setting) -> Any:
            start, end = (scene.point(p) for p in self.between)
            return -scene.value(self.strength) / scene.length(end - start)
'''

PULLED = """
title: Pulled by a magnet
plane: horizontal
given: {k: 2 N*m^2, m: 2 kg}
points: {O: [0, 0], P: [1 m, 0]}
bodies: {b: {particle: P, mass: m}}
joints:
  - guide: {point: P, along: 0 deg}
loads:
  - magnet: {between: [O, P], strength: k}
"""

Put = Callable[[str, str, str], None]


@pytest.fixture
def put(tmp_path: Path) -> Iterator[Put]:
    """Puts a member, as the text of its file, on a shelf: shelf, name of the file, text."""
    with ExitStack() as stack:

        def on_shelf(shelf: str, name: str, text: str) -> None:
            folder = tmp_path / shelf
            folder.mkdir(exist_ok=True)
            (folder / f"{name}.py").write_text(textwrap.dedent(text).lstrip(), encoding="utf-8")
            stack.enter_context(extended(shelf, folder))

        yield on_shelf


def solution_of(text: str) -> Solution:
    problem, wrong = load_text(text)
    assert wrong == []
    assert problem is not None
    return solve_problem(problem)


def test_a_shelf_is_as_it_was_afterwards(put: Put) -> None:
    assert "magnet" not in members("loads")
    put("loads", "magnet", MAGNET)
    assert "magnet" in members("loads")


def test_an_added_load_acts_at_an_instant(put: Put) -> None:
    put("loads", "magnet", MAGNET)
    solution = solution_of(PULLED + "instant: [at rest]\nfind: {a: a(b).x, pe: PE(all)}\n")
    (part,) = solution.parts
    by_name = {f.name: f for f in part.found}
    assert_close(by_name["a"], -1)
    assert_close(by_name["pe"], -2)
    present, absent = effects(part.instants[0])
    assert "magnetic force" in present
    assert "magnets" not in absent


def test_an_added_load_that_does_not_act_is_told(put: Put) -> None:
    put("loads", "magnet", MAGNET)
    text = "plane: vertical\nbodies: {P: {particle: [0, 0], mass: 1 kg}}\ninstant: [at rest]\nfind: {a: a(P).y}\n"
    _, absent = effects(solution_of(text).parts[0].instants[0])
    assert "magnets" in absent


def test_the_potential_of_an_added_load_relates_states(put: Put) -> None:
    put("loads", "magnet", MAGNET)
    states = "states: {1: [at rest], 2: [x(b) = 0.5 m]}\nmethod: energy\nfind: {v: v(b).mag @ 2}\n"
    (part,) = solution_of(PULLED + states).parts
    # m v²/2 = k (1/0.5 - 1/1)
    assert_close(part.found[0], 2.0**0.5)
    assert "energy" in {e.kind for step in part.motion.route.steps for e in step.relations}
