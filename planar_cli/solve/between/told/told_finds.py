"""Finds in the letters in which a page tells them: constant rates, and what varies by its letter at the state."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import replace
from decimal import Decimal

import sympy as sp

from planar_cli.equation.algebra.counting import operations
from planar_cli.equation.algebra.plain import by_name, longer
from planar_cli.equation.values.exact import Valuation
from planar_cli.equation.values.ledger import Kind, Role
from planar_cli.solve.between.equations.asked_finds import AskedFind
from planar_cli.solve.between.equations.motion_equations import MotionEquations
from planar_cli.solve.between.told.energies_beside import energies_inside, energy_is_worth_a_letter
from planar_cli.solve.between.told.velocities_beside import is_worth_a_letter, velocities_inside
from planar_cli.solve.between.trace.derivation import at_right_angles
from planar_cli.solve.between.trace.trace import Request
from planar_cli.solve.regimes.constant_rates import LastingLetters
from planar_cli.solve.regimes.timeline import KeptLetters, Reader, Stop
from planar_cli.units import Unit

MOST = 24
"""A letter whose formula at a state has more operations is no help to a reader."""
LEAST = 2
"""One of fewer operations needs no letter."""
SPARED = 2
"""So many operations less must a find have with a letter at its state."""


class FindTeller:
    """Tells the finds of one motion. `value`: numbers of everything; `level`: angles whose sines are put in."""

    def __init__(
        self, course: MotionEquations, lasting: LastingLetters, value: Valuation, level: Mapping[sp.Symbol, sp.Expr]
    ) -> None:
        self.course, self.lasting, self.value, self.level = course, lasting, value, level
        self.numbers: dict[sp.Symbol, Decimal] = {}
        self._made: dict[tuple[sp.Symbol, str], sp.Symbol] = {}

    def requests(self, finds: Sequence[AskedFind]) -> tuple[Request, ...]:
        """What is asked, in the letters of its state, with the sines of right angles put in. What is a letter of the
        general position alone is told by its letter at the state where other finds need this.
        """
        found = [self._request(a) for a in finds]
        lines = {own: formula for r in found for own, formula in r.beside}
        return tuple(self._by_letter(a, r, lines) for a, r in zip(finds, found, strict=True))

    def _by_letter(self, asked: AskedFind, found: Request, lines: Mapping[sp.Symbol, sp.Expr]) -> Request:
        """A find that is one letter of the general position, which has a line."""
        places = self._places(asked)
        if len(places) != 1 or len(asked.raw) != 1 or not places[0][2].is_Symbol:
            return found
        own = self._made.get((places[0][2], places[0][1].name))
        if own is None or own not in lines:
            return found
        return replace(found, parts=(own,), beside=self._used((own,), lines))

    def _request(self, asked: AskedFind) -> Request:
        """One find, and the letters at its state in which it is shorter."""
        kept = self._kept(asked)
        found = Request(asked.find, self._parts(asked, kept), asked.unit)
        places = self._places(asked)
        if self.course.symbolic:
            return found
        if told := self._by_parts(asked, kept):
            return told
        if len({(id(reader.regime), stop.name) for reader, stop, _ in places}) != 1:
            return found
        regime = id(places[0][0].regime)
        constant = kept.get(regime) or self.course.rates.names.get(regime, {})
        beside = self._beside(places, constant)
        names = {g: own for g, (own, _) in beside.items()}
        parts = self._parts(asked, {**kept, regime: {**constant, **names}})
        lines = self._used(parts, dict(beside.values()))
        spared = sum(map(operations, found.parts)) - sum(map(operations, parts))
        if spared < SPARED or any(p.is_Symbol for p in parts):
            return found
        for own, formula in lines:
            # What is left of terms that cancel is zero: at a largest speed nothing accelerates.
            known = self.value.extended(self.numbers)
            self.numbers[own] = Decimal(0) if known.is_zero(formula) else known(formula)
        return replace(found, parts=parts, beside=lines)

    def _by_parts(self, asked: AskedFind, kept: KeptLetters) -> Request | None:
        """A find by the velocities of points, or the kinetic energies, of which it is made up; None: these are letters
        anyway.
        """
        lines: dict[sp.Symbol, sp.Expr] = {}
        put: dict[sp.Symbol, sp.Expr] = {}
        letter = self.course.problem.kinetic_energy
        inside = [("m/s", is_worth_a_letter, *found) for found in velocities_inside(asked)]
        inside += [("J", energy_is_worth_a_letter, *found) for found in energies_inside(asked, letter)]
        order = [s.name for s in self.course.states]
        for unit, is_worth, symbol, name, state in sorted(inside, key=lambda one: order.index(one[-1])):
            (formula,) = self._parts(replace(asked, raw=(symbol,)), kept)
            if not is_worth(formula):
                continue
            own = self._part(name, state, unit)
            lines[own], put[symbol], self.numbers[own] = formula, own, self.value(formula)
        if not lines:
            return None
        parts = self._parts(replace(asked, raw=(asked.raw[0].xreplace(put),)), kept)
        return Request(asked.find, parts, asked.unit, tuple(lines.items()))

    def _part(self, name: str, state: str, unit: str) -> sp.Symbol:
        """The letter of a component of the velocity of a point, or of a kinetic energy."""
        key = sp.Symbol(name, real=True), state
        if key not in self._made:
            self._made[key] = self.course.ledger.fresh(f"{name}__{state}", unit, role=Role(Kind.STATE, None, state))
        return self._made[key]

    @staticmethod
    def _used(parts: Iterable[sp.Expr], formulas: Mapping[sp.Symbol, sp.Expr]) -> tuple[tuple[sp.Symbol, sp.Expr], ...]:
        """The letters that a find needs, each after those that it needs itself."""
        order: dict[sp.Symbol, sp.Expr] = {}

        def add(expr: sp.Expr) -> None:
            for x in by_name(expr.free_symbols & formulas.keys()):
                if x not in order:
                    add(formulas[x])
                    order[x] = formulas[x]

        for part in parts:
            add(part)
        return tuple(order.items())

    def _parts(self, asked: AskedFind, kept: KeptLetters) -> tuple[sp.Expr, ...]:
        return tuple(at_right_angles(p, self.level) for p in asked.parts(kept))

    def _kept(self, asked: AskedFind) -> KeptLetters:
        """The letters in which a find is told: those with one number in the whole motion, and constant rates. None
        where it asks for an unknown that has several: what that is made of tells less than its formula.
        """
        plain = {letter: letter for letter in self.lasting.numbers}
        rates = self.course.rates.names
        kept = {id(r): {**plain, **rates.get(id(r), {})} for r in self.course.distinct_regimes()}
        elsewhere = [asked.reader.pending[s] for p in asked.raw for s in p.free_symbols if s in asked.reader.pending]
        parts = [*((asked.reader, p) for p in asked.raw), *((reader, p) for reader, _, p in elsewhere)]
        several = ((self.lasting.several.get(id(reader.regime), ()), p.free_symbols) for reader, p in parts)
        return {} if any(x in inside for letters, inside in several for x in letters) else kept

    def _places(self, asked: AskedFind) -> list[tuple[Reader, Stop, sp.Expr]]:
        """Who reads what at which state."""
        found = []
        for part in asked.raw:
            inside = [asked.reader.pending[s] for s in by_name(part.free_symbols) if s in asked.reader.pending]
            found += [(reader, self.course.stops[state], expr) for reader, state, expr in inside]
            if asked.at is not None and not inside:
                found.append((asked.reader, asked.at, part))
        return found

    def _beside(
        self, places: Sequence[tuple[Reader, Stop, sp.Expr]], constant: Mapping[sp.Symbol, sp.Expr]
    ) -> dict[sp.Symbol, tuple[sp.Symbol, sp.Expr]]:
        """Unknowns of the general position that stand in a find at one state: their letters there, with what they are.
        `constant`: letters that have their numbers before.
        """
        reader, stop, _ = places[0]
        regime = reader.regime
        formulas: dict[sp.Symbol, sp.Expr] = {}
        for stage in regime.general.stages:
            formulas |= {**stage.algebra.explicit, **stage.algebra.formulas}
        asked_for = {expr for _, _, expr in places}
        inside = _closure(asked_for, formulas) - asked_for - set(constant) - set(regime.letters)
        made = {g: self._letter(g, stop.name) for g in by_name(inside) if g in self._units()}
        for letter in list(made):
            closed = regime.closed(letter, frozenset(constant)).xreplace(dict(constant))
            if operations(closed) < LEAST or not self.value.known(self._at(closed, reader, stop)):
                del made[letter]
        while True:
            found = {}
            for letter, own in made.items():
                others = {**constant, **{g: x for g, x in made.items() if g != letter}}
                found[letter] = (own, self._at(regime.closed(letter, frozenset(others)).xreplace(others), reader, stop))
            long = [letter for letter, (_, formula) in found.items() if longer(formula, MOST)]
            if not long:
                return found
            made = {g: own for g, own in made.items() if g not in long}

    def _at(self, closed: sp.Expr, reader: Reader, stop: Stop) -> sp.Expr:
        """A formula of the general position at a state, stand-ins and the sines of right angles put in."""
        return at_right_angles(reader.settled(stop.at(closed)), self.level)

    def _units(self) -> dict[sp.Symbol, Unit]:
        units: dict[sp.Symbol, Unit] = {}
        for regime in self.course.distinct_regimes():
            units |= regime.general.instant.scene.ledger.units
        return units

    def _letter(self, general: sp.Symbol, state: str) -> sp.Symbol:
        """An unknown of the general position at a state."""
        if (general, state) not in self._made:
            ledger = self.course.ledger
            units = self._units()
            name = f"{general.name}__{state}" if state else f"{general.name}__1"
            made = ledger.fresh(name, units[general].text, role=Role(Kind.STATE, general, state))
            self._made[general, state] = made
        return self._made[general, state]


def _closure(exprs: Iterable[sp.Expr], formulas: Mapping[sp.Symbol, sp.Expr]) -> set[sp.Symbol]:
    """All letters with a formula on which expressions rest."""
    found: set[sp.Symbol] = set()
    left = list(exprs)
    while left:
        for s in left.pop().free_symbols & formulas.keys() - found:
            found.add(s)
            left.append(formulas[s])
    return found
