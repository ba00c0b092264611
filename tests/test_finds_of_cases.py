"""A later case uses the find of an earlier one: a number, or a formula in letters that are letters there too."""

from __future__ import annotations

import pytest

from planar_cli.errors import FileProblem
from planar_cli.formats.terminal import Terminal
from planar_cli.homework.checking.checking import solve_and_compare
from planar_cli.problem.structure import load_text
from planar_cli.report.page.narrate import narrate
from planar_cli.solve.run import solve_problem

STONE = """
title: Stone thrown up, then faster
plane: vertical
symbols: {h: m}
unknowns: {v: m/s}
points: {A: [0, 0]}
bodies: {stone: {particle: A, mass: any}}
joints:
  - guide: {point: A, along: 90 deg}
cases:
  first:
    states:
      1: [t = 0, v(stone).y = v]
      2: [v(stone).y = 0, y(stone) = h]
    find: {v_1: v}
  second:
    given: {u: 2*first.v_1}
    unknowns: {k: m}
    states:
      1: [t = 0, v(stone).y = u, v = 0]
      2: [v(stone).y = 0, y(stone) = k]
    find: {k_2: k}
answers: {v_1: sqrt(2*g*h), k_2: 4*h}
"""

HILL = """
title: Car on the crest of a hill
plane: vertical
symbols: {c: 1/m, m: kg}
unknowns: {v: m/s}
points: {A: [0, 0]}
surfaces: {hill: {y: -c*x^2}}
bodies: {car: {particle: A, mass: m}}
joints:
  - contact: {between: [car, hill], at: A, mu: 0}
cases:
  limit:
    instant: [v(car).x = v, N(A) = 0]
    find: {v_max: v}
  half:
    instant: [v(car).x = v, v = limit.v_max/2]
    find: {N: N(A)}
answers: {v_max: sqrt(g/(2*c)), N: 3/4*m*g}
"""


@pytest.mark.parametrize("text", [STONE, HILL])
def test_a_formula_of_an_earlier_case(text: str) -> None:
    problem, wrong = load_text(text)
    assert problem is not None, wrong
    solution, verdicts = solve_and_compare(problem)
    assert [v.agrees for v in verdicts] == [True, True]
    assert not any(part.confirmed.apart for part in solution.parts)


def test_a_formula_in_what_is_no_letter_any_more() -> None:
    text = STONE.replace("    given: {u: 2*first.v_1}\n", "    given: {u: 2*first.v_1, h: 3 m}\n")
    problem, wrong = load_text(text.partition("answers")[0])
    assert problem is not None, wrong
    with pytest.raises(FileProblem, match=r"first\.v_1 has no value here"):
        solve_and_compare(problem)


PULL = """
title: A block on a slope is pulled
plane: vertical
given: {m: 40 kg, beta: 20 deg, P: 100 N}
points: {A: [0, 0]}
surfaces: {incline: {through: A, angle: beta}}
bodies: {block: {particle: A, mass: m}}
joints: [contact: {between: [block, incline], mu_s: 0.3, mu_k: 0.25}]
loads: [force: {body: block, magnitude: P, angle: 0 deg}]
instant: [at rest]
cases:
  weak: {given: {P: 100 N}}
  strong: {given: {P: 300 N}, find: {F: friction(block).along(beta)}}
"""


def test_nothing_is_told_of_a_case_in_which_nothing_is_asked() -> None:
    page = Terminal(110).render(narrate(solve_problem(load_text(PULL)[0])))
    assert "CASE  strong" in page
    assert "CASE  weak" not in page
    assert page.count("multibody") == 1
