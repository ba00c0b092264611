"""Answers in letters in a homework: the key as a page tells it, any identical form, and what mistakes make of it."""

from __future__ import annotations

import pytest
import sympy as sp

from planar_cli.commands._told_formulas import told_formulas
from planar_cli.homework.grading import grade
from planar_cli.homework.homework import assembled, prepared
from planar_cli.homework.paper import Graded, Submission
from planar_cli.homework.ready import Homework
from planar_cli.homework.rules import Rules
from planar_cli.homework.set_file import read_set
from planar_cli.homework.wrong_formulas import as_written

SLOPE = """
title: Block that slides down, in letters
text: >-
  A block is let go on a slope of the angle beta on which it slides; the coefficient of friction is mu. Find its speed
  after the length L, and the normal force.
plane: vertical
symbols: {m: kg, beta: deg, mu: 1, L: m}
assume: [mu < tan(beta)]
points: {A: [0, 0]}
surfaces: {slope: {through: A, angle: -beta}}
bodies: {block: {particle: A, mass: m}}
joints:
  - contact: {between: [block, slope], at: A, mu: mu, name: C}
states:
  1: [at rest]
  2: [path_length(block) @ 1->2 = L]
find: {v: v(block).mag @ 2, N: N(C)}
"""
RIGHT = "sqrt(2*g*L*(sin(beta) - mu*cos(beta)))"


@pytest.fixture(scope="module")
def homework(tmp_path_factory: pytest.TempPathFactory) -> Homework:
    folder = tmp_path_factory.mktemp("letters")
    path = folder / "set.yaml"
    (folder / "letters.yaml").write_text(SLOPE)
    path.write_text("problems: [letters.yaml]\n")
    homework_set = read_set(str(path))
    return assembled(homework_set, [prepared(p, 0, 1, None, told_formulas) for p in homework_set.problems])


def graded(homework: Homework, find: str, typed: str) -> Graded:
    submission = Submission("ann", 0, (("letters", find, typed),))
    result = grade(submission, homework.papers, Rules())
    return next(g for g in result.graded if g.find == find)


@pytest.mark.parametrize("typed", [RIGHT, "sqrt(2)*sqrt(L*g*sin(beta) - g*L*mu*cos(beta))"])
def test_a_size_in_letters_is_right_in_any_form(homework: Homework, typed: str) -> None:
    one = graded(homework, "v", typed)
    assert one.verdict == "right"
    assert one.expected == "√(2 g L (sin β - μ cos β))"


@pytest.mark.parametrize(
    ("find", "typed", "mistake", "said"),
    [
        ("v", "sqrt(2*g*L*sin(beta))", "friction-left-out", "without friction"),
        ("v", "sqrt(2*g*L*(sin(beta) + mu*cos(beta)))", "friction-reversed", "the other way"),
        ("v", "sqrt(2*g*L*(cos(beta) - mu*sin(beta)))", "sine-for-cosine", "sine and cosine of beta"),
        ("N", "m*g*sin(beta)", "sine-for-cosine", "sine and cosine of beta"),
        ("N", "m*cos(beta)", "mass-for-weight", "the mass stands where the weight"),
    ],
)
def test_a_mistake_in_letters_is_named(homework: Homework, find: str, typed: str, mistake: str, said: str) -> None:
    one = graded(homework, find, typed)
    assert (one.verdict, one.mistakes) == ("wrong", (mistake,))
    assert said in one.feedback


def test_another_wrong_formula_is_not_diagnosed(homework: Homework) -> None:
    one = graded(homework, "v", "sqrt(3*g*L*sin(beta))")
    assert (one.verdict, one.mistakes, one.feedback) == ("wrong", (), "")


def test_formulas_are_written_by_the_functions_of_a_file() -> None:
    x, y = sp.symbols("x y", real=True)
    assert as_written(sp.Abs(sp.sqrt(x + y))) == "sqrt(x + y)"
    assert as_written(y + sp.Abs(x)) == "y + abs(x)"
    assert as_written(sp.atan2(y, x)) == "2*atan(y/(x + sqrt(x^2 + y^2)))"
    assert as_written(sp.sinh(x)) == "(exp(x) - exp(-x))/2"
