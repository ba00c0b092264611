"""Limits at which something may be largest or smallest: an assumption that only just holds, or a size that is zero."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import replace

import sympy as sp

from planar_cli.equation.system.conditions import Condition
from planar_cli.equation.system.on_two_points import on_two_points
from planar_cli.equation.system.system import Statements, System
from planar_cli.problem.implied.not_negative import not_negative
from planar_cli.problem.language.expression import Extreme, Name, Side
from planar_cli.problem.scene.facts import Test
from planar_cli.problem.scene.scene import Problem

PARTS = "the contact is about to part"


def at_the_limit(words: str) -> str:
    """An assumption as it reads where it only just holds."""
    for holds, just in (
        ("within its limit", "reaches its limit, it is about to slip"),
        (" presses", f" vanishes, {PARTS}"),
        ("acts inside the face", "acts at the edge of the face, it is about to tip"),
        ("the tension pulls", "the tension vanishes, the rope is about to slacken"),
    ):
        words = words.replace(holds, just)
    return words


def limit_of(test: Test, values: dict[str, sp.Expr]) -> Condition:
    """An assumption that only just holds, as an equation."""
    if test.within:
        square = sp.Add(*(values[n] ** 2 for n in test.within)) - test.constant**2
        return Condition("limit", f"at the limit: {at_the_limit(test.words)}", square)
    words = f"at the limit: {at_the_limit(test.words)}"
    residual = sp.Add(*(factor * values[name] for name, factor in test.pushes if name in values), test.constant)
    return Condition("limit", words, sp.sympify(residual))


def tipping(condition: Condition, test: Test, system: System) -> Condition:
    """The same limit, in the words of a body that stands on two points: at one of them it parts as it tips about the
    other.
    """
    found = on_two_points(system, test.joint) if PARTS in condition.text else None
    if found is None:
        return condition
    return replace(condition, text=condition.text.replace(PARTS, "{} is about to tip about {}".format(*found)))


def only_just_apart(test: Test, parting: sp.Expr) -> Condition:
    """What has lifted off, and only just leaves its path. `parting`: the acceleration with which it does [m/s²]."""
    words = test.words.replace("does not press into its partner", "only just leaves its partner")
    return Condition("limit", f"at the limit: {words}", parting)


def stated_limits(statements: Statements, read: Callable[[Side], sp.Expr]) -> Iterator[Condition]:
    """Inequalities of the file that allow their sides to be equal, where they are: of something that is to be largest
    they may be all that bounds it.
    """
    for relation in statements.inequalities if statements.extremes else ():
        if relation.operator in ("<=", ">="):
            residual = read(relation.left) - read(relation.right)
            if residual.free_symbols:
                words = f"at the limit: {relation.text} only just holds"
                yield Condition("limit", words, residual, mark=relation.mark)


def least_sizes(extremes: Sequence[Extreme], problem: Problem, sought: Iterable[sp.Symbol]) -> Iterator[Condition]:
    """`v is smallest` of what can not be negative: it is zero where nothing else holds it above."""
    for extreme in extremes:
        named = extreme.side.name if extreme.sense < 0 and isinstance(extreme.side, Name) else ""
        if named in not_negative(problem):
            zero = next((s for s in sought if s.name == named), None)
            if zero is not None:
                yield Condition("limit", f"at the limit: {named} is no less than zero", zero)
