"""A set with a list of students: as many variants as students; which values are never fit is told."""

from __future__ import annotations

import math
from pathlib import Path

import pytest
from homework_made import SLOPE, set_of

from planar_cli.homework.homework import prepared
from planar_cli.homework.sets.set_file import HomeworkSet

VARIED = f"""{SLOPE}
variants: {{beta: [30 deg, 5 deg, 35 deg], m: [2 kg, 3 kg]}}
"""


def made(folder: Path, more: str) -> HomeworkSet:
    return set_of(folder, more, slope=VARIED)


@pytest.mark.parametrize(
    ("more", "number"),
    [
        ("students: [ann, bob, cid]\nvariants: {seed: 7}", 3),
        ("students: [ann, bob, cid]\nvariants: {number: 2}", 2),
        ("students: [ann, bob, cid]", 0),
    ],
)
def test_so_many_variants(more: str, number: int, tmp_path: Path) -> None:
    assert made(tmp_path, more).variants == number


def test_values_that_are_never_fit_are_told(tmp_path: Path) -> None:
    """At 5° the block stays, as tan 5° < 0.2."""
    (problem,) = made(tmp_path, "variants: {number: 6}").problems
    told = prepared(problem, 6, 1).warnings
    assert "slope: no combination with β = 5° is fit, because another case holds" in told


CRANK = """
given: {r: 120 mm, l: 400 mm, h: 60 mm, n: 120 rpm, phi: 60 deg}
points: {O: [0, 0], A: {from: O, distance: r, angle: phi}, B: {y: -h, distances: {A: l}, side: right}}
bodies: {crank: {rod: [O, A]}, rod: {rod: [A, B]}}
joints:
  - pin: {at: O, between: [ground, crank]}
  - pin: {at: A, between: [crank, rod]}
  - guide: {point: B, along: 0 deg}
motion: [omega(crank) = -n]
find: {a_B: a(B)}
variants: {r: [120 mm, 130 mm, 110 mm], phi: [60 deg, 65 deg, 45 deg], n: [120 rpm, 150 rpm]}
"""


def test_what_rounding_leaves_of_a_zero_has_no_sign(tmp_path: Path) -> None:
    """The slider moves along x: a_y is zero, and a_x negative at 60° and 65° in each combination."""
    (problem,) = made(tmp_path, "variants: {number: 12}").problems
    Path(problem.path).write_text(CRANK)
    ready = prepared(problem, 12, 1)
    angles = {dict(v)["phi"] for v in ready.values[1:]}
    assert {"60 deg", "65 deg"} <= angles
    assert ready.taken >= 10
    assert not any("a_B changes its sign" in w for w in ready.warnings)
    assert "because the mistake sine-for-cosine gives nearly the right a_B" in "; ".join(ready.warnings)


def test_a_component_has_the_heading_of_its_own_variant(tmp_path: Path) -> None:
    """Along the slope of the variant, not of the file."""
    down = VARIED.replace("a(block).mag", "a(block).along(-beta)").replace("5 deg, 35", "33 deg, 35")
    (problem,) = made(tmp_path, "variants: {number: 6}").problems
    Path(problem.path).write_text(down)
    ready = prepared(problem, 6, 1)
    assert len(ready.values) > 3
    for values, task in zip(ready.values, ready.tasks, strict=True):
        degrees = float(dict(values).get("beta", "30 deg").split()[0])
        (a,) = task.expected
        assert a.heading == pytest.approx(-math.radians(degrees))


def test_variants_differ_in_their_answers_where_they_can(tmp_path: Path) -> None:
    """The mass is of no matter to a = g (sin β - μ cos β)."""
    (problem,) = made(tmp_path, "variants: {number: 3}").problems
    Path(problem.path).write_text(VARIED.replace("5 deg, 35 deg]", "33 deg, 35 deg]"))
    for seed in (1, 2, 3):
        assert len({task.expected[0].text for task in prepared(problem, 3, seed).tasks[1:]}) == 3
    ready = prepared(problem, 5, 1)
    assert len(set(ready.values[1:])) == 5
    assert (
        "slope: 2 of 5 variants have the answers of another one, as there are no others that are fit" in ready.warnings
    )
