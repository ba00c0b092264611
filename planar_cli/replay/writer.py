"""What gathers the equations of a part."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import replace
from typing import TypeVar

import sympy as sp

from planar_cli.equation.values.exact import Valuation
from planar_cli.equation.values.ledger import Ledger
from planar_cli.replay.equations import Asked, Equations, Step, Test
from planar_cli.replay.opened import NotWritten
from planar_cli.solve.solution import Found
from planar_cli.solve.solved_problem import PartSolution

Told = TypeVar("Told")


def is_number(found: Found) -> bool:
    """Is it a number, or a vector of two?"""
    return found.kind in ("number", "vector") and not found.word


def is_mode(found: Found) -> bool:
    """Is it a mode, such as slip, which stays what it is while the tests hold?"""
    return bool(found.word) and found.kind != "truth"


class Writer:
    """Gathers equations. `ledgers`, `values`: of all that is worked out."""

    def __init__(self, part: PartSolution) -> None:
        self.part = part
        self.inputs: dict[str, sp.Symbol] = {}
        self.defined: dict[sp.Symbol, sp.Expr] = {}
        self.steps: list[Step] = []
        self.asked: dict[str, Asked] = {}
        self.tests: list[Test] = []
        self.valuations: list[Valuation] = []
        self.ledgers: list[Ledger] = []
        self.numbers: dict[sp.Symbol, float] = {}
        """Of symbols that no valuation knows."""
        self.general: dict[sp.Symbol, sp.Symbol] = {}
        """By a symbol that was made for a state, that of the general position."""
        self.squares: dict[str, tuple[sp.Expr, ...]] = {}

    def know(self, ledger: Ledger, value: Valuation) -> None:
        """What a ledger knows: numbers are inputs, formulas definitions."""
        self.valuations.append(value)
        self.ledgers.append(ledger)
        for symbol, expr in ledger.values.items():
            if sp.sympify(expr).free_symbols:
                self.defined[symbol] = expr
            else:
                self.inputs[symbol.name] = symbol
        for symbol, expr in (*ledger.definitions.items(), *value.definitions.items()):
            if symbol not in ledger.values:
                self.defined.setdefault(symbol, sp.sympify(expr))

    def made(self) -> Equations:
        """All that was gathered, with those finds that follow from it. NotWritten: none does."""
        made = self.gathered()
        complete = {name: one for name, one in self.asked.items() if not self.loose(made, one)}
        if not complete:
            raise NotWritten("; ".join(self._told_loose(made)) or "no answer is a number of an instant or a state")
        return replace(made, asked=complete)

    def gathered(self) -> Equations:
        """All that was gathered. NotWritten: an unknown has no number."""
        numbers: dict[sp.Symbol, float] = {}
        for symbol in (*self.inputs.values(), *(u for step in self.steps for u in step.unknowns)):
            numbers[symbol] = self._number(symbol)
        gathered = Equations(
            self.part.case,
            self.inputs,
            self.defined,
            tuple(self.steps),
            self.asked,
            tuple(self.tests),
            numbers,
            self._also_made({s: role.kind for ledger in self.ledgers for s, role in ledger.roles.items()}),
            self._also_made({s: unit for ledger in self.ledgers for s, unit in ledger.units.items()}),
            self._also_made({s: title for ledger in self.ledgers for s, title in ledger.titles.items()}),
            self.squares,
        )
        return gathered.without_loose().in_order()

    def _also_made(self, known: dict[sp.Symbol, Told]) -> dict[sp.Symbol, Told]:
        """What is known of symbols, also of those that were made for a state."""
        return known | {own: known[general] for own, general in self.general.items() if general in known}

    def loose(self, made: Equations, asked: Asked) -> frozenset[sp.Symbol]:
        """That on which a find rests and which is known by its number alone."""
        return made.loose(asked.parts)

    def _told_loose(self, made: Equations) -> Iterable[str]:
        for name, one in self.asked.items():
            yield f"{name} rests on {', '.join(sorted(s.name for s in self.loose(made, one)))}, known by a number alone"

    def _number(self, symbol: sp.Symbol) -> float:
        number = self._known(symbol)
        if number is None:
            raise NotWritten(f"{symbol.name} has no number")
        return number

    def _known(self, symbol: sp.Symbol) -> float | None:
        """The number that a symbol has."""
        if symbol in self.numbers:
            return self.numbers[symbol]
        return next((float(n) for v in self.valuations if (n := v.known(symbol)) is not None), None)
