"""A line in letters holds for all numbers: each number of the file changes by some per cent, and it is solved anew."""

from __future__ import annotations

import random
import re
from dataclasses import fields, is_dataclass, replace
from fractions import Fraction
from pathlib import Path
from typing import Any

import pytest
import sympy as sp
from conftest import PROBLEMS
from worked import GOLDEN, name_of, worked

from planar_cli.problem.language.expression import Number
from planar_cli.problem.scene.scene import At
from planar_cli.report.document.blocks import Equation, Math, Value
from planar_cli.report.page.narrate import narrate
from planar_cli.solve.run import solve_problem
from planar_cli.solve.solved_problem import PartSolution, Solution

FUNCTIONS = re.compile(r"\b(?:arc)?(?:sin|cos|tan)\b|\b(?:exp|ln|rad)\b")


def in_letters(side: str) -> bool:
    """Is a side of a printed line a formula with letters?"""
    return bool(re.search(r"[^\W\d_π]", FUNCTIONS.sub("", side)))


def has_a_chain(path: Path) -> bool:
    """Is there a line letter = formula in results = formula in the data = numbers = value?"""
    lines = (GOLDEN / f"{name_of(path)}.solution.txt").read_text("utf-8").splitlines()
    chains = (line.split(" = ") for line in lines)
    return any(len(c) > 4 and all(map(in_letters, c[1:3])) and not in_letters(c[3]) for c in chains)


LETTERED = [p for p in PROBLEMS if has_a_chain(p)]
NO_OTHER_NUMBERS = {
    "cart-that-couples-with-a-buffered-cart",
    "crate-that-bumps-into-a-headboard",
    "load-of-a-movable-pulley-that-lands",
    "rack-driven-by-a-crossed-belt",
    "double-planet-train",
    "falling-pole",
    "sack-that-swings-against-a-chest",
    "tilted-block-that-falls-back",
}
"""Their numbers fit each other: what touches, the teeth of gears; or the number stands in the line: cos 40°; or with
others there is no formula.
"""
NEAR = 1e-9
OFTEN = 6
"""Of so many files one is solved again each time, the others with the slow tests."""
FILES = [
    p if i % OFTEN == 0 else pytest.param(p, marks=pytest.mark.slow)
    for i, p in enumerate(p for p in LETTERED if p.stem not in NO_OTHER_NUMBERS)
]


def formulas(solution: Solution) -> list[sp.Expr]:
    """What stands in letters on the page of a file, behind another formula and before the numbers."""
    chains = [b.sides for b in narrate(solution).blocks if isinstance(b, Equation) and isinstance(b.sides[-1], Value)]
    return [s.expr for c in chains for s in c[2:-1] if isinstance(s, Math) and not s.values]


def number(formula: sp.Expr, part: PartSolution) -> float | None:
    """Its value by the letters of a part; None: it has others."""
    ledger = part.motion.ledger if part.motion is not None else part.instants[0].instant.scene.ledger
    given = {s.name: value for s, value in ledger.values.items()}
    while formula.free_symbols:
        if not all(s.name in given for s in formula.free_symbols):
            return None
        formula = formula.xreplace({s: given[s.name] for s in formula.free_symbols})
    return float(formula)


def told(solution: Solution) -> list[tuple[str, str, sp.Expr]]:
    """Case, find and formula of each line in letters."""
    found = []
    for formula in formulas(solution):
        for part in solution.parts:
            value = number(formula, part)
            own = [f for f in part.found if f.values and f.expressions and len(f.values) == 1]
            found += [(part.case, f.name, formula) for f in own if value is not None and agree(value, f.values[0])]
    return found


def agree(one: Any, other: Any) -> bool:
    return abs(float(one) - float(other)) <= NEAR * abs(float(other))


def drawn(node: Any, inside: bool = False) -> set[tuple[Fraction, str | None]]:
    """The numbers of places; a state may tell one of them."""
    if isinstance(node, tuple):
        return {x for n in node for x in drawn(n, inside)}
    if isinstance(node, Number):
        return {(abs(node.value), node.unit)} if inside else set()
    if not is_dataclass(node) or isinstance(node, type):
        return set()
    return {x for f in fields(node) for x in drawn(getattr(node, f.name), inside or isinstance(node, At))}


def changed(node: Any, salt: str, kept: set[tuple[Fraction, str | None]]) -> Any:
    """A problem with other numbers: equal ones stay equal, right angles right, and places are drawn where they were."""
    if isinstance(node, tuple):
        return tuple(changed(n, salt, kept) for n in node)
    if isinstance(node, Number):
        plain = node.unit is None and node.value.denominator <= 4
        right = node.unit in ("deg", "rev") and node.value % 90 == 0
        if plain or right or (abs(node.value), node.unit) in kept:
            return node
        factor = random.Random(f"{salt} {node.value} {node.unit}").randint(1005, 1030)
        return replace(node, value=node.value * Fraction(factor, 1000))
    if not is_dataclass(node) or isinstance(node, (type, At)):
        return node
    own = {f.name: changed(getattr(node, f.name), salt, kept) for f in fields(node) if f.init and f.name != "answers"}
    return replace(node, **own)


@pytest.mark.parametrize("path", FILES, ids=name_of)
def test_a_line_in_letters_holds_for_other_numbers(path: Path) -> None:
    solution = worked(path)[0]
    lines = told(solution)
    problem = changed(solution.problem, path.stem, drawn(solution.problem))
    other = solve_problem(problem, problem.method)
    parts = {p.case: p for p in other.parts}
    for case, find, formula in lines:
        (answer,) = (f for f in parts[case].found if f.name == find)
        assert answer.values is not None
        assert agree(number(formula, parts[case]), answer.values[0]), f"{find} = {formula} for these numbers alone"
