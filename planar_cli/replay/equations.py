"""The equations of one part of a solution as data: what is given, the steps in which all follows, what is asked."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import field, replace

import sympy as sp

from planar_cli.equation.algebra.plain import rounded_inside
from planar_cli.equation.values.ledger import Kind
from planar_cli.records import record
from planar_cli.units import Unit


@record
class Step:
    """Unknowns and as many residuals, which vanish: left minus right side of equations on the page.

    `kinds`: of each residual: force, moment, relation, energy, … as the solution has it; `bodies`: whom it is about.
    """

    unknowns: tuple[sp.Symbol, ...]
    residuals: tuple[sp.Expr, ...]
    kinds: tuple[str, ...] = ()
    bodies: tuple[tuple[str, ...], ...] = ()
    others: Mapping[sp.Symbol, tuple[float, ...]] = field(default_factory=dict)
    """Other roots of the equation of an unknown, which the solution has left out."""
    ways: tuple[str, ...] = ()
    """Of each equation of forces or moments, its direction or point in words: along x, about A; "" of others."""


@record
class Test:
    """What must be positive for the equations to be the right ones, in words."""

    positive: sp.Expr
    words: str


@record
class Asked:
    """One find: its parts in the unknowns, in base units of the file; `turn`: -1 where a page counts it clockwise."""

    parts: tuple[sp.Expr, ...]
    turn: int = 1


@record
class Equations:
    """All of one part (the file itself, or a case).

    `inputs`: symbols of the names that are given as numbers; `defined`: names that others define, by their formulas;
    `steps`: in their order; `value`: numbers of inputs and unknowns in the solution itself.
    """

    case: str
    inputs: Mapping[str, sp.Symbol]
    defined: Mapping[sp.Symbol, sp.Expr]
    steps: tuple[Step, ...]
    asked: Mapping[str, Asked]
    tests: tuple[Test, ...]
    value: Mapping[sp.Symbol, float]
    roles: Mapping[sp.Symbol, Kind] = field(default_factory=dict)
    """What symbols are."""
    units: Mapping[sp.Symbol, Unit] = field(default_factory=dict)
    """Units in which symbols are shown."""
    titles: Mapping[sp.Symbol, str] = field(default_factory=dict)
    """What names that are defined stand for."""
    squares: Mapping[str, tuple[sp.Expr, ...]] = field(default_factory=dict)
    """By point that might lie at another place too, the square with whose root the place is made, at each instant."""

    def turns(self, symbol: sp.Symbol) -> bool:
        """Is a symbol an angle, an angular velocity or an angular acceleration?"""
        unit = self.units.get(symbol)
        return unit is not None and unit.angle

    @property
    def unknowns(self) -> tuple[sp.Symbol, ...]:
        """What the steps give, in their order."""
        return tuple(u for step in self.steps for u in step.unknowns)

    @property
    def hold_data(self) -> bool:
        """Do numbers stand in them that were computed from data? Then they hold with these data alone."""
        formulas = (*(r for step in self.steps for r in step.residuals), *self.defined.values())
        return any(rounded_inside(sp.sympify(e)) for e in formulas)

    def mapped(self, steps: Iterable[Step]) -> Equations:
        """The same with other steps."""
        return replace(self, steps=tuple(steps))

    def rests_on(self, exprs: Iterable[sp.Expr]) -> frozenset[sp.Symbol]:
        """Everything on which expressions rest: inputs, names that are defined, unknowns."""
        owner = {u: step for step in self.steps for u in step.unknowns}
        found: set[sp.Symbol] = set()
        waiting = list(exprs)
        while waiting:
            for symbol in waiting.pop().free_symbols - found:
                found.add(symbol)
                waiting.extend(self._behind(symbol, owner))
        return frozenset(found)

    def loose(self, exprs: Iterable[sp.Expr]) -> frozenset[sp.Symbol]:
        """That on which expressions rest and which nothing here gives."""
        return self.rests_on(exprs) - set(self.inputs.values()) - set(self.unknowns) - self.defined.keys()

    def without_loose(self) -> Equations:
        """The same without steps and tests that rest on what nothing here gives."""
        made = self
        while (steps := [s for s in made.steps if not made.loose(s.residuals)]) != list(made.steps):
            made = made.mapped(steps)
        return replace(made, tests=tuple(t for t in made.tests if not made.loose((t.positive,))))

    def in_order(self) -> Equations:
        """The same with every step behind those that it needs, and with steps that need each other in one."""
        steps = list(self.steps)
        needs = [self._needed_by(step) for step in steps]
        ordered: list[Step] = []
        left = list(range(len(steps)))
        while left:
            waits = {k: {j for j in left if j != k and needs[k] & set(steps[j].unknowns)} for k in left}
            ready = next((k for k in left if not waits[k]), None)
            together = [ready] if ready is not None else min((_round(k, waits) for k in left), key=len)
            ordered.append(_merged([steps[k] for k in together]))
            left = [k for k in left if k not in together]
        return self.mapped(ordered)

    def _needed_by(self, step: Step) -> frozenset[sp.Symbol]:
        """The unknowns of other steps in its equations, also behind names that are defined."""
        found: set[sp.Symbol] = set()
        waiting = [r.free_symbols - set(step.unknowns) for r in step.residuals]
        while waiting:
            for symbol in waiting.pop() - found:
                found.add(symbol)
                if symbol in self.defined and symbol not in self.unknowns:
                    waiting.append(self.defined[symbol].free_symbols)
        return frozenset(found).intersection(self.unknowns) - set(step.unknowns)

    def _behind(self, symbol: sp.Symbol, owner: Mapping[sp.Symbol, Step]) -> Iterator[sp.Expr]:
        if symbol in owner:
            yield from owner[symbol].residuals
            yield from owner[symbol].unknowns
        elif symbol in self.defined:
            yield self.defined[symbol]


def _round(first: int, waits: Mapping[int, set[int]]) -> list[int]:
    """The steps that wait for each other with a first one, and those on which they wait."""
    found, waiting = [first], [first]
    while waiting:
        for other in sorted(waits[waiting.pop()]):
            if other not in found:
                found.append(other)
                waiting.append(other)
    return sorted(found)


def _merged(steps: list[Step]) -> Step:
    if len(steps) == 1:
        return steps[0]
    others: dict[sp.Symbol, tuple[float, ...]] = {}
    for step in steps:
        others |= step.others
    return Step(
        tuple(u for s in steps for u in s.unknowns),
        tuple(r for s in steps for r in s.residuals),
        tuple(k for s in steps for k in s.kinds),
        tuple(b for s in steps for b in s.bodies),
        others,
        tuple(w for s in steps for w in (s.ways or ("",) * len(s.residuals))),
    )
