"""Homework made from problem files that are written out in a test: what is graded of it, which mistakes are known."""

from __future__ import annotations

from pathlib import Path

from planar_cli.homework.grading.grading import grade
from planar_cli.homework.grading.what_mistakes_give import with_mistakes
from planar_cli.homework.homework import assembled, prepared
from planar_cli.homework.sets.paper import Expected, Graded, Submission
from planar_cli.homework.sets.ready import Homework
from planar_cli.homework.sets.rules import Rules
from planar_cli.homework.sets.set_file import HomeworkSet, read_set
from planar_cli.homework.variants.worked_problem import WorkedProblem, base_expected, read_and_solve

SLOPE = """
plane: vertical
given: {m: 2 kg, beta: 30 deg, mu_k: 0.2}
points: {A: [0, 0]}
surfaces: {slope: {through: A, angle: -beta}}
bodies: {block: {particle: A, mass: m}}
joints:
  - contact: {between: [block, slope], at: A, mu: mu_k}
instant: [at rest]
find: {a: a(block).mag}
"""

GATE = """
plane: vertical
given: {W: 14 lbf, l: 3.5 ft, W_D: 8 lbf, D: 20 in, beta: 30 deg, g: 32.2 ft/s^2}
points:
  A: [0, 0]
  B: {from: A, distance: l, angle: beta}
bodies:
  arm: {rod: [A, B], weight: W}
  disk: {disk: B, radius: D/2, weight: W_D}
joints:
  - pin: {at: A, between: [ground, arm]}
  - weld: {at: B, between: [arm, disk]}
states:
  1: [at rest]
  2: [theta(arm) = -90 deg]
find: {omega: omega(arm) @ 2, A: reaction(A) @ 2}
"""
# By hand: ω² = 2 (W/2 + W_D) l (1 + sin β)/I, I = (W l²/3 + W_D l² + W_D D²/8)/g; A = W + W_D + (W/2 + W_D) l ω²/g.

BALL_ON_ROD = """
points: {A: [0, 0], B: [0, -l], P: [0, -b]}
bodies:
  rod: {rod: [A, B], mass: M}
  ball: {particle: P, mass: m}
joints:
  - pin: {at: A, between: [ground, rod]}
  - impact: {between: [ball, rod], restitution: e, normal: 0 deg, during: 1->2}
states:
  1: [rod at rest, v(ball).x = v_0, v(ball).y = 0]
  2: [just after 1]
"""
# By hand: ω = (1 + e) m v_0 b/(M l²/3 + m b²).


def set_of(folder: Path, more: str = "", **problems: str) -> HomeworkSet:
    """A set of problem files by their names; `more`: what else its file says."""
    for name, text in problems.items():
        (folder / f"{name}.yaml").write_text(text)
    files = ", ".join(f"{name}.yaml" for name in problems)
    (folder / "set.yaml").write_text(f"problems: [{files}]\n{more}\n")
    return read_set(str(folder / "set.yaml"))


def homework_of(homework_set: HomeworkSet) -> Homework:
    """A set that is ready, with the files as they are."""
    return assembled(homework_set, [prepared(problem, 0, 1) for problem in homework_set.problems])


def graded(homework: Homework, place: str, typed: str) -> Graded:
    """What a student has for an answer to a find, such as slope.a, who gives no other."""
    problem, find = place.split(".")
    result = grade(Submission("ann", 0, ((problem, find, typed),)), homework.papers, Rules())
    return next(g for g in result.graded if (g.problem, g.find) == (problem, find))


def with_known_mistakes(problem: WorkedProblem) -> tuple[Expected, ...]:
    """The finds of a problem with what every mistake gives, for the values of the file."""
    (row,) = with_mistakes(problem, [base_expected(problem)], {})
    return row


def mistakes_of(folder: Path, text: str) -> tuple[Expected, ...]:
    """The same of a problem file with this text."""
    (folder / "p.yaml").write_text(text)
    return with_known_mistakes(read_and_solve(str(folder / "p.yaml"), "p"))
