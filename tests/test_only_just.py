"""States at which a contact just does not let go: the push comes to nought there and grows again."""

from __future__ import annotations

from pathlib import Path

import pytest
from worked import page_of_file

from planar_cli.errors import NoSolution
from planar_cli.problem.structure import load
from planar_cli.solve.run import solve_problem

LOOP = """title: A block in a loop
plane: vertical
given: {{m: 2 kg, r: 0.5 m}}
unknowns: {{u: m/s}}
points: {{O: [0, 0], A: [0, -r]}}
surfaces: {{loop: {{center: O, radius: r}}}}
bodies: {{block: {{particle: A, mass: m}}}}
joints:
  - contact: {{between: [block, loop], mu: 0, name: K}}
states:
  1: [t = 0, v(block).x = {sense}u, u > 0]
  top: [{top}]
find: {{u: u, N_1: N(K) @ 1}}
"""


def test_a_spring_that_just_shoots_a_block_round_a_loop() -> None:
    page = page_of_file("spring-that-shoots-a-block-round-a-loop")
    assert "Answer s = √(5 m g r/k) N_1 = 6 m g " in page


@pytest.mark.parametrize("sense", ["", "-"])
@pytest.mark.parametrize("top", ["x(block) = 0, y(block) > 0, N(K) = 0", "y(block) = r, N(K) = 0"])
def test_the_least_speed_round_a_loop(sense: str, top: str, tmp_path: Path) -> None:
    path = tmp_path / "loop.yaml"
    path.write_text(LOOP.format(sense=sense, top=top))
    part = solve_problem(load(str(path))[0]).parts[0]
    told = {f.name: float(f.values[0]) for f in part.found if f.values is not None}
    assert told == pytest.approx({"u": (5 * 9.81 * 0.5) ** 0.5, "N_1": 6 * 2 * 9.81})


@pytest.mark.slow
def test_a_block_that_lets_go_before_is_no_such_state(tmp_path: Path) -> None:
    path = tmp_path / "loop.yaml"
    path.write_text(LOOP.format(sense="", top="x(block) = 0, y(block) > 0, v(block).mag = 1 m/s"))
    with pytest.raises(NoSolution):
        solve_problem(load(str(path))[0])
