"""A variant that solving refuses is not handed out, also where its equations have numbers: a cable runs out."""

from __future__ import annotations

from pathlib import Path

import pytest
from homework_made import set_of

from planar_cli.errors import NoSolution
from planar_cli.homework.variants.variants import Variants, variants_of
from planar_cli.homework.variants.worked_problem import WorkedProblem, read_and_solve, with_numbers

ATWOOD = """
plane: vertical
given: {m: {one_of: MASSES}, t_1: {one_of: TIMES}, m_B: 1 kg}
points: {D: [0, 0], E: [1 m, 0], A: [0, -2 m], B: [1 m, -9 m]}
bodies: {block_A: {particle: A, mass: m}, block_B: {particle: B, mass: m_B}}
joints:
  - rope: {path: [A, D, E, B], name: cable}
states:
  start: [t = 0, at rest]
  end: [t = t_1]
find: {v: v(A).y @ end, T: tension(cable) @ end}
"""


def drawn(folder: Path, masses: str, times: str, count: int) -> tuple[WorkedProblem, Variants]:
    """The problem with so many variants."""
    text = ATWOOD.replace("MASSES", masses).replace("TIMES", times)
    (problem,) = set_of(folder, f"variants: {{number: {count}, seed: 5}}", p=text).problems
    worked = read_and_solve(problem.path, "p")
    return worked, variants_of(worked, count, 5)


def way(values: dict[str, str]) -> float:
    """a t²/2 with a = (m_B - m) g/(m_B + m), m."""
    m, t = (float(values[n].split()[0]) for n in ("m", "t_1"))
    return (1 - m) / (1 + m) * 9.81 * t**2 / 2


@pytest.mark.parametrize(
    ("masses", "times", "count", "fit"),
    [
        # Each is solved; of many the extremes, and then each that is fit by its equations.
        ("[0.8 kg, 0.6 kg]", "[1 s, 1.5 s]", 4, 3),
        pytest.param(
            "[0.8 kg, 0.75 kg, 0.7 kg, 0.65 kg, 0.6 kg]", "[1 s, 1.1 s, 1.2 s, 1.3 s, 1.5 s]", 20, 0,
            marks=pytest.mark.slow,
        ),
    ],
)  # fmt: skip
def test_a_cable_does_not_run_out_in_a_variant(masses: str, times: str, count: int, fit: int, tmp_path: Path) -> None:
    """A of 0.6 kg rises by 2.76 m in 1.5 s, and the pulley is 2 m above it."""
    worked, found = drawn(tmp_path, masses, times, count)
    ways = [way(dict(v.draw.values)) for v in found.taken]
    assert not found.note
    assert ways
    assert max(ways) < 2
    assert len(ways) == fit or not fit
    assert found.rejected["it has no solution"] >= 1
    with pytest.raises(NoSolution, match="run out"):
        with_numbers(worked, {"m": "0.6 kg", "t_1": "1.5 s"})
