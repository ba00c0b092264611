"""Forces and accelerations of one instant are checked by power, with numbers that agree on both sides."""

from __future__ import annotations

import re

import pytest
from worked import page_of_file

from planar_cli.formats.terminal import Terminal
from planar_cli.problem.structure import load_text
from planar_cli.report.page.narrate import narrate
from planar_cli.solve.run import solve_problem

MOVING = r"power: Σ F v = (.*?) W; d(?:T|E_k)/dt = Σ \(m a v \+ I α ω\) = (.*?) W"
FROM_REST = r"with these accelerations for 1 s: U = (.*?) J, (?:T|E_k) = (.*?) J"


def _sum(text: str) -> tuple[float, float]:
    """What the terms come to, and what the page says that they come to."""
    terms, _, result = text.partition(" = ")
    return sum(float(t) for t in re.sub(r" ([+-]) ", r" \1", terms).split()), float(result or terms)


@pytest.mark.parametrize(("stem", "words"), [
    ("gear-pair", MOVING),
    ("gas-force-on-piston", MOVING),
    ("flywheel-axle-friction", MOVING),
    ("stacked-blocks", FROM_REST),
])  # fmt: skip
def test_both_sides_agree(stem: str, words: str) -> None:
    found = re.findall(words, page_of_file(stem))
    assert found
    for sides in found:
        (one, result), (other, same) = (_sum(side) for side in sides)
        assert result == pytest.approx(same, rel=1e-9)
        assert [one, other] == pytest.approx([result, result], rel=5e-3)


@pytest.mark.parametrize("stem", ["atwood-machine", "four-bar", "built-in-beam-with-prop"])
def test_none_in_letters_without_forces_or_in_equilibrium(stem: str) -> None:
    page = page_of_file(stem)
    assert not re.search(MOVING, page)
    assert not re.search(FROM_REST, page)


def test_of_bodies_that_swing_no_second_is_told() -> None:
    """A bar on the floor does not keep its acceleration."""
    assert "for 1 s" not in page_of_file("ex-4-16")


SLIDING = """
title: Crate that slides to the right, nobody says how fast
plane: vertical
points: {C: [0, 0]}
bodies: {crate: {particle: C, mass: 20 kg}}
joints:
  - contact: {between: [crate, ground], at: C, mu_k: 0.3}
loads:
  - force: {body: crate, magnitude: 100 N, angle: 0 deg}
instant: [v(crate).x > 0]
find: {a: a(crate).x}
"""


def test_none_with_a_speed_that_stands_for_a_direction() -> None:
    problem, _ = load_text(SLIDING)
    assert problem is not None
    page = Terminal(200).render(narrate(solve_problem(problem)))
    assert "checked by" in page
    assert "power" not in page
