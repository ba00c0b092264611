"""Answers in letters of a file with cases, in feet and pounds: diagnosed and carried as those of any other file."""

from __future__ import annotations

import pytest

from planar_cli.homework.grading.carried_errors import Carrier, unpickled
from planar_cli.homework.grading.grading import grade
from planar_cli.homework.homework import assembled, prepared
from planar_cli.homework.sets.paper import Graded, Submission
from planar_cli.homework.sets.ready import Homework
from planar_cli.homework.sets.rules import Rules
from planar_cli.homework.sets.set_file import read_set

SLOPE = """
plane: vertical
symbols: {m: slug, beta: deg, mu: 1}
given: {L: 10 ft}
assume: [mu < tan(beta)]
points: {A: [0, 0]}
surfaces: {slope: {through: A, angle: -beta}}
bodies: {block: {particle: A, mass: m}}
joints:
  - contact: {between: [block, slope], at: A, mu: mu, name: C}
states:
  1: [at rest]
  2: [path_length(block) @ 1->2 = L]
find: {N: N(C), v: v(block).mag @ 2}
cases:
  held:
    symbols: {P: lbf}
    assume: [P < m*g*(sin(beta) - mu*cos(beta))]
    loads:
      - force: {body: block, at: A, magnitude: P, angle: 180 deg - beta}
    find: {N_held: N(C), v_held: v(block).mag @ 2}
"""


@pytest.fixture(scope="module")
def homework(tmp_path_factory: pytest.TempPathFactory) -> Homework:
    path = tmp_path_factory.mktemp("cases") / "set.yaml"
    (path.parent / "slope.yaml").write_text(SLOPE)
    path.write_text("problems: [slope.yaml]\n")
    homework_set = read_set(str(path))
    return assembled(homework_set, [prepared(p, 0, 1) for p in homework_set.problems])


def graded(homework: Homework, **typed: str) -> dict[str, Graded]:
    submission = Submission("ann", 0, tuple(("slope", find, text) for find, text in typed.items()))
    carry = Carrier(unpickled(homework.carrying)).for_variant(0)
    return {g.find: g for g in grade(submission, homework.papers, Rules(), carry).graded}


def test_the_right_formulas(homework: Homework) -> None:
    v_held = "sqrt(2*L*(g*sin(beta) - mu*g*cos(beta) - P/m))"
    found = graded(homework, v="sqrt(2*g*L*(sin(beta) - mu*cos(beta)))", v_held=v_held, N_held="m*g*cos(beta)")
    assert [found[f].verdict for f in ("v", "v_held", "N_held")] == ["right"] * 3


@pytest.mark.parametrize(("find", "typed"), [("v", "sqrt(2*g*L*(sin(beta) - mu))"), ("N_held", "m*g")])
def test_what_the_equations_alone_tell_is_named(homework: Homework, find: str, typed: str) -> None:
    one = graded(homework, **{find: typed})[find]
    assert (one.verdict, one.mistakes) == ("wrong", ("normal-force-is-weight",))


def test_what_has_no_value_where_the_answer_has_one_is_wrong(homework: Homework) -> None:
    one = graded(homework, v_held="sqrt(2*L*(g*sin(beta) - 40*g - P/m))")["v_held"]
    assert one.verdict == "wrong"


@pytest.mark.parametrize(
    ("wrong", "find", "typed"),
    [
        ("N", "v", "sqrt(2*L*(g*sin(beta) - mu*(m*g*sin(beta))/m))"),
        ("N_held", "v_held", "sqrt(2*L*(g*sin(beta) - mu*g*sin(beta) - P/m))"),
    ],
)
def test_an_own_force_is_carried_on(homework: Homework, wrong: str, find: str, typed: str) -> None:
    found = graded(homework, **{wrong: "m*g*sin(beta)", find: typed})
    assert found[wrong].verdict == "wrong"
    assert found[find].carried == (wrong,)
