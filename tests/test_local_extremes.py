"""What is largest in a state is so at the first such time; where other local extremes were found they are told."""

from __future__ import annotations

from planar_cli.formats.terminal import Terminal
from planar_cli.problem.structure import load_text
from planar_cli.report.page.narrate import narrate
from planar_cli.solve.run import solve_problem

TWO_SINES = """
title: Sum of two vibrations
bodies: {a: {particle: free}}
motion: [x(a) = 1 m * sin(1 rad/s * t) + 1 m * sin(3 rad/s * t), y(a) = 0]
states:
  1: [t = 0]
  2: [x(a) is largest]
find: {t: t @ 2}
"""


def page(text: str) -> str:
    problem, wrong = load_text(text)
    assert problem is not None, wrong
    return " ".join(Terminal(400).render(narrate(solve_problem(problem))).split())


def test_the_other_local_extremes_of_a_sum_of_sines() -> None:
    """With c = cos t the rate is c (12 c² - 8): maxima where c = ± sqrt(2/3) in the first half, and at 3 pi/2."""
    assert "the first such time after the start other local maxima at t_2 = 2.526 s, 4.712 s" in page(TWO_SINES)
    # Between them there is a minimum at pi/2.
    smallest = page(TWO_SINES.replace("largest", "smallest"))
    assert "t = 1.571 s" in smallest
    assert "another local minimum at t_2 = 3.757 s" in smallest
