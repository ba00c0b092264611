"""Contacts of which only the static coefficient is given: whatever the kinetic one is, the answers must be the same.

A kinetic coefficient is not larger than the static one. The part is solved with two of those that may be; an answer
that differs depends on what is not given.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from fractions import Fraction
from typing import Any

from planar_cli.errors import NoSolution, Undecided
from planar_cli.problem.implied.static_alone import kinetic_open, static_alone
from planar_cli.problem.language.expression import Binary, Number
from planar_cli.problem.scene.scene import Problem
from planar_cli.solve.solution import Found
from planar_cli.solve.solved_problem import PartSolution

SAME = Fraction(1, 10**12)
"""Answers that differ by less than this part of their size are the same."""


def whatever_kinetic(solve: Callable[..., PartSolution], problem: Problem, *rest: Any) -> PartSolution:
    """One part, solved with kinetic coefficients that are not given. NoSolution where an answer depends on one."""
    joints = static_alone(problem)
    if not joints:
        return solve(problem, *rest)
    part = solve(_with_share(problem, joints, 1), *rest)
    try:
        other = solve(_with_share(problem, joints, 2), *rest)
    except (NoSolution, Undecided):
        raise NoSolution([kinetic_open("what happens", joints)]) from None
    for one, two in zip(part.found, other.found, strict=True):
        if not same_answer(one, two):
            raise NoSolution([kinetic_open(one.name, joints)])
    return part


def _with_share(problem: Problem, joints: list[Any], divisor: int) -> Problem:
    """With the static coefficient divided by a number as the kinetic one."""

    def completed(joint: Any) -> Any:
        mark = joint.mu_s.mark
        return replace(joint, mu_k=Binary("/", joint.mu_s, Number(Fraction(divisor), None, 1, mark), mark))

    return replace(problem, joints=tuple(completed(j) if j in joints else j for j in problem.joints))


def same_answer(one: Found, other: Found) -> bool:
    """Is it the same, up to what the digits that are carried tell?"""
    if one.word != other.word or (one.values is None) != (other.values is None):
        return False
    if one.values is None or other.values is None:
        return one.expressions == other.expressions
    pairs = [(Fraction(a), Fraction(b)) for a, b in zip(one.values, other.values, strict=True)]
    size = max((abs(a) for a, _ in pairs), default=Fraction(0))
    return all(abs(a - b) <= SAME * size for a, b in pairs)
