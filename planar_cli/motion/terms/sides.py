"""Formulas of the file as terms in the base units of the file."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from dataclasses import field
from fractions import Fraction

from planar_cli.base_units import in_base
from planar_cli.errors import FileProblem, Mark, refuse
from planar_cli.motion.terms.terms import Graph, Term
from planar_cli.problem.language.evaluation import ARITHMETIC, evaluated
from planar_cli.problem.language.expression import (
    Binary,
    Function,
    Name,
    Number,
    Quantity,
    Scaled,
    Side,
)
from planar_cli.problem.language.no_number import quantity_misplaced, state_misplaced
from planar_cli.problem.language.walk import Tree, walk
from planar_cli.problem.scene.geometry import Vec
from planar_cli.problem.scene.ordinary import GRAVITY
from planar_cli.problem.scene.scene import Problem
from planar_cli.records import changing, record
from planar_cli.units import parse_unit

"""g where the file gives none, m/s²."""


def no_quantity(quantity: Quantity) -> Term:
    """Where only numbers and names may stand."""
    raise quantity_misplaced(quantity)


@changing
class Constants:
    """The names of one problem that have a number, as terms; those without one are refused when they are used."""

    graph: Graph
    problem: Problem
    values: Mapping[str, float]
    """Numbers for letters and unknowns, by name, in the base units of the file; they go before what the file gives."""
    settled: dict[str, Side] = field(default_factory=dict)
    """Unknowns whose value a relation of the start gives."""
    _found: dict[str, Term] = field(default_factory=dict)
    _waiting: list[str] = field(default_factory=list)

    def __contains__(self, name: str) -> bool:
        """Is it a name that has, or should have, a number?"""
        symbols = (*self.problem.given, *self.problem.symbols, *self.problem.unknowns)
        return name in self.values or name == "g" or any(s.name == name for s in symbols)

    def valued(self, name: str) -> bool:
        """Has it a number?"""
        given = any(s.name == name and s.value is not None for s in self.problem.given)
        return name in self.values or name == "g" or given or name in self.settled

    def term(self, name: Name, sides: Sides) -> Term:
        """The number of a name."""
        found = self._found.get(name.name)
        if found is None:
            found = self._found[name.name] = self._made(name, sides)
        return found

    def gravity(self, sides: Sides) -> Term:
        """g."""
        return self.term(Name("g", None, Mark(self.problem.file, 1, 1)), sides)

    def _made(self, name: Name, sides: Sides) -> Term:
        if name.name in self.values:
            return self.graph.number(self.values[name.name])
        symbol = next((s for s in self.problem.given if s.name == name.name and s.value is not None), None)
        value = symbol.value if symbol is not None else self.settled.get(name.name)
        if value is not None:
            if name.name in self._waiting:
                raise refuse(name.mark, "PL533", f"{name.name} is given through itself")
            self._waiting.append(name.name)
            found = sides.value(value)
            self._waiting.pop()
            return found
        if name.name == "g":
            return self.graph.number(float(GRAVITY) * in_base(parse_unit("m/s^2"), self.problem.us))
        raise self._without_number(name)

    def _without_number(self, name: Name) -> FileProblem:
        sought = any(s.name == name.name for s in self.problem.unknowns)
        text = f"the {'unknown' if sought else 'letter'} {name.name} has no number"
        return refuse(name.mark, "PL705", text, f"give it one: `--set {name.name}=…`")


@record
class Sides:
    """Evaluates sides. `elsewhere`: what to do with `x @ 2`."""

    graph: Graph
    constants: Constants
    variables: Mapping[str, Term]
    """Time `t`, coordinates, and variables of curves; they go before constants."""
    quantity: Callable[[Quantity], Term] = no_quantity
    elsewhere: Callable[[str, Side], Term | Vec] | None = None

    def with_variables(self, more: Mapping[str, Term]) -> Sides:
        """The same with other or more variables."""
        return Sides(self.graph, self.constants, {**self.variables, **more}, self.quantity, self.elsewhere)

    def value(self, side: Side) -> Term:
        """The value of a side."""
        found: Term = evaluated(side, self)
        return found

    # --- the numbers of which formulas are made (problem/language/evaluation.py) --------------------------------------

    def number(self, number: Number) -> Term:
        return self.graph.number(number.sense * self._written(number.value, number.unit))

    def scaled(self, side: Scaled) -> Term:
        return self.value(side.operand) * (side.sense * self._written(Fraction(1), side.unit))

    def _written(self, value: Fraction, unit: str | None) -> float:
        """A written number in the base units of the file."""
        return float(value) if unit is None else float(value) * in_base(parse_unit(unit), self.constants.problem.us)

    def called(self, function: Function) -> Term:
        return self.graph.call(function.name, self.value(function.argument))

    def asked(self, quantity: Quantity) -> Term:
        return self.quantity(quantity)

    def at(self, state: str, side: Side) -> Term:
        """What stands before an `@`."""
        if self.elsewhere is None:
            raise state_misplaced(side.mark)
        found = self.elsewhere(state, side)
        if isinstance(found, Vec):
            raise refuse(side.mark, "PL550", "this is a vector", "ask for a part: .x .y .mag .angle")
        return found

    def named(self, name: Name) -> Term:
        if name.name in self.variables:
            return self.variables[name.name]
        if name.name in ("pi", "infinity"):
            return self.graph.number(math.pi if name.name == "pi" else math.inf)
        if name.name not in self.constants:
            hint = "give it in `given`, or seek it in `unknowns`"
            raise refuse(name.mark, "PL504", f"{name.name} has no value here", hint)
        return self.constants.term(name, self)

    def combined(self, side: Binary) -> Term:
        left, right = self.value(side.left), self.value(side.right)
        if side.operator == "/" and right.constant and right.value == 0:
            raise refuse(side.mark, "PL505", "division by zero")
        found: Term = ARITHMETIC[side.operator](left, right)
        return found


def names_in(tree: Tree) -> set[str]:
    """All bare names of a side or relation, also those inside quantities."""
    return {node.name for node in walk(tree) if isinstance(node, Name)}


def has_quantity(tree: Tree) -> bool:
    """Does a quantity stand in it?"""
    return any(isinstance(node, Quantity) for node in walk(tree))
