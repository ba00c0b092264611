"""Answers in letters as a key tells them: by the letters, and by the numbers that the sheet of a variant gives."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace

import sympy as sp

from planar_cli.base_units import in_base
from planar_cli.homework.sets.key_text import shown
from planar_cli.homework.sets.paper import Expected
from planar_cli.homework.variants.given_letters import given_numbers, pure_numbers
from planar_cli.homework.variants.told_formula import ToldFormula
from planar_cli.homework.variants.worked_problem import WorkedProblem
from planar_cli.solve.solved_problem import Solution
from planar_cli.units import parse_unit, pretty_unit

Formulas = Callable[[Solution, Mapping[str, sp.Expr]], dict[str, ToldFormula]]
"""By their finds the answers in letters, with numbers put in for some of these."""
SAME = 1e-9
"""Relative: a unit is the base unit."""


class Told:
    """Tells the answers of each variant, where they are those of the file itself; other ones stand as they are."""

    def __init__(self, solved: WorkedProblem, base: Sequence[Expected], formulas: Formulas | None) -> None:
        self.solved = solved
        self.same = {e.find: e.formula for e in base if e.formula}
        self.formulas = formulas if self.same else None
        self._known: dict[tuple[tuple[str, sp.Expr], ...], dict[str, ToldFormula]] = {}

    def of(self, expected: Sequence[Expected], values: Mapping[str, str]) -> tuple[Expected, ...]:
        """The finds of a variant with these values."""
        return tuple(replace(e, text=self._text(e, values)) for e in expected) if self.formulas else tuple(expected)

    def _text(self, one: Expected, values: Mapping[str, str]) -> str:
        letters = self._with({})
        if not one.formula or one.find not in letters or one.formula != self.same[one.find]:
            return one.text
        told = letters[one.find].text
        if one.kind == "equation":
            return told
        pure = pure_numbers(self.solved, values)
        inside = {name for name, _ in one.letters if name in self._numbers(values)}
        numbers = self._with(pure)[one.find].text if inside <= pure.keys() else self._rounded(one, values)
        return told if numbers in ("", told) else f"{told} = {numbers}"

    def _rounded(self, one: Expected, values: Mapping[str, str]) -> str:
        """With all numbers that the sheet gives: 0.5333 v_0; "" where it is no product then."""
        us, numbers = self.solved.problem.us, self._numbers(values)
        found = self._with(numbers)[one.find]
        left = {name: parse_unit(unit) for name, unit in one.letters if name not in numbers}
        due = parse_unit(one.unit)
        if not found.number or any(abs(in_base(u, us) - 1) > SAME for u in left.values()):
            return ""
        coefficient = shown(found.number / in_base(due, us))
        if not left:
            return f"{coefficient} {pretty_unit(one.unit)}".strip()
        if not found.letters:
            return ""
        units = [f"{name} in {pretty_unit(unit)}" for name, unit in one.letters if name in left and unit != "1"]
        is_pure = [u.dimension for u in left.values()] == [due.dimension]
        behind = f" ({', '.join(units)})" if units and not is_pure else ""
        return f"{coefficient} {found.letters}{behind}"

    def _numbers(self, values: Mapping[str, str]) -> dict[str, sp.Expr]:
        """All numbers that a variant gives, in base units."""
        whole = self.solved.problem
        given = given_numbers(whole, whole, values)
        return {n: sp.Float(float(v) * in_base(unit, whole.us)) for n, (v, unit) in given.items()}

    def _with(self, numbers: Mapping[str, sp.Expr]) -> dict[str, ToldFormula]:
        assert self.formulas is not None
        key = tuple(sorted(numbers.items()))
        if key not in self._known:
            self._known[key] = self.formulas(self.solved.solution, numbers)
        return self._known[key]
