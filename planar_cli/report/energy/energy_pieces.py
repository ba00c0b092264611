"""The pieces of which energies are told: formulas, then their letters and numbers as far as one line holds them."""

from __future__ import annotations

from collections.abc import Collection, Mapping
from dataclasses import field
from decimal import Decimal
from typing import Any

import sympy as sp

from planar_cli.equation.algebra.counting import operations
from planar_cli.equation.algebra.plain import longer, simplified
from planar_cli.equation.values.ledger import display
from planar_cli.principles.base import Moving
from planar_cli.records import record
from planar_cli.report.document.blocks import Math, Value
from planar_cli.report.in_numbers.put_in import Writer, in_known, partly
from planar_cli.report.notation.by_geometry import by_geometry
from planar_cli.report.notation.clean import is_clean
from planar_cli.report.notation.notation import plain
from planar_cli.report.notation.numbers import quantity
from planar_cli.report.notation.reciprocals import with_reciprocals
from planar_cli.report.notation.whole_roots import with_whole_roots
from planar_cli.report.words.words import Phrases, told_unit
from planar_cli.solve.between.trace.trace import BalanceTrace
from planar_cli.units import (
    ENERGY,
    FORCE,
    LENGTH,
    RATE,
    Dimension,
    Unit,
    parse_unit,
)

SHORT = 16
"""With more operations a formula of an energy is told by what it is made of."""
WIDE = 94
"""So many characters of a chain fit into a line."""
LONGER = 2
"""By so many operations a height by the data alone may be longer than one by letters of a state."""
STATE = "__"
ARCS = (sp.asin, sp.acos, sp.atan)


@record
class EnergyPieces:
    """Tells the parts of one balance. `unknowns`: what it is solved for; `plain`: letters that are data, with what they
    are. All else has a number.
    """

    balance: BalanceTrace
    unknowns: Collection[sp.Symbol]
    phrases: Phrases
    plain: Mapping[sp.Symbol, sp.Expr]
    told: set[tuple[sp.Symbol, sp.Expr]]
    """Stretches, heights and kinetic energies that were told before."""
    geometry: Collection[sp.Expr]
    """What vanishes by relations that stand before, of which the unknowns are found together with this balance."""
    axes: Mapping[sp.Symbol, sp.Expr] = field(default_factory=dict)
    """Moments of inertia about the points at which blows hold bodies, as they stand on the page."""
    bare: bool = False
    """Is the balance solved in letters? Then no numbers stand beside its unknowns, as no line would use them."""
    drawn: Mapping[sp.Symbol, sp.Expr] = field(default_factory=dict)
    """Letters of states in the given position, with what they are in letters of the file."""
    springs: Mapping[str, tuple[str, sp.Symbol]] = field(default_factory=dict)
    """By their words those that have a natural length: their length by their ends, and the letter of that."""
    letters: dict[str, sp.Expr | None] = field(default_factory=dict)
    """By its words each energy in the letters in which it was told; None: it has none."""

    def put(self, expr: Any) -> sp.Expr:
        """A formula with what is data put in, as short as the geometry that stands before makes it."""
        return self._put(expr)

    def _put(self, expr: sp.Expr) -> sp.Expr:
        put = sp.sympify(expr).xreplace(dict(self.plain))
        short = by_geometry(put, self.geometry, self.unknowns)
        return short if longer(short, SHORT * 4) else with_reciprocals(simplified(short))

    def height(self, expr: sp.Expr) -> sp.Expr:
        """A height as it is told: in the given position by the data."""
        return self._as_drawn(self._put(expr))

    def is_short(self, put: sp.Expr, dimension: Dimension) -> bool:
        """Is it a short formula of letters alone?"""
        return self._short(put, dimension)

    def centre(self, made: Moving) -> str:
        """The mass centre as an index: its point, of a particle its name, else G with the body's name."""
        if made.center != made.body or made.inertia == 0:
            return made.center
        moving = self.balance.parts.moving if self.balance.parts is not None else ()
        return "G" if sum(m.inertia != 0 for m in moving) == 1 else f"G,{made.body}"

    def is_neat(self, weight: sp.Expr) -> bool:
        """Do letters alone make m g?"""
        return is_clean(self.phrases.ledger, weight, dimension=FORCE)

    def _as_drawn(self, measure: sp.Expr) -> sp.Expr:
        """A height or stretch in the given position by the data alone, where that is no longer."""
        if self._is_sought(measure) or not measure.free_symbols & self.drawn.keys():
            return measure
        found = with_whole_roots(simplified(measure.xreplace(dict(self.drawn))), self.phrases.value)
        # sin 60° is told as that, unless the file has roots in its places.
        places = (e for e in self.drawn.values() if not e.is_number and not e.has(*ARCS))
        waves = any(not e.free_symbols for e in found.atoms(sp.sin, sp.cos, sp.tan)) or found.has(*ARCS)
        if waves or (has_number_root(found) and not any(map(has_number_root, places))):
            return measure
        return found if operations(found) <= operations(measure) + LONGER and self._short(found, LENGTH) else measure

    def _is_sought(self, put: sp.Expr) -> bool:
        """Does it rest on what the balance is solved for?"""
        return bool(put.free_symbols & set(self.unknowns))

    def _vanishes(self, put: sp.Expr) -> bool:
        """Is it nothing, whatever is sought?"""
        if put == 0 or self._is_sought(put):
            return bool(put == 0 or self._summed(put)[0].expr == 0)
        return self.phrases.value.is_zero(put)

    def _short(self, put: sp.Expr, dimension: Dimension = ENERGY) -> bool:
        return not longer(put, SHORT) and is_clean(self.phrases.ledger, put, dimension=dimension)

    def _fitting(self, formula: Math, put: sp.Expr, numbers: tuple[Any, ...] = ()) -> tuple[Any, ...]:
        """A formula of what an energy is made of, then as much of its letters and numbers as one line holds.
        `numbers`: the formula with its numbers.
        """
        last = self._numbers(put, ())
        letters = (self.phrases.math(put),) if self._short(put) and not put.is_number else ()
        value = last[0]
        substituted = tuple(self.phrases.substituted(put, value)) if letters and isinstance(value, Value) else ()
        if not isinstance(value, Value) and self.bare and letters:
            last = ()
        whole = (formula, *letters, *substituted, *last)
        if letters and fits(whole):
            return whole
        if letters and not isinstance(value, Value) and fits(short := (formula, *letters, *last)):
            return short
        return (formula, *(numbers if isinstance(value, Value) else ()), *last)

    def _numbers(self, put: sp.Expr, numbers: tuple[Any, ...]) -> tuple[Any, ...]:
        """What it is by the unknowns; or its value, after the numbers put in."""
        if self._is_sought(put):
            return (self.phrases.math(put),) if self.bare and self._short(put) else self._summed(put)
        return (*numbers, self._joule(put))

    def _chain(self, put: sp.Expr) -> tuple[Any, ...]:
        """A formula, its numbers, and its value or what it is by the unknowns."""
        if put == 0:
            return (self.phrases.math(put),)
        about = self._about_axis(put)
        if self._is_sought(put):
            formula = self.phrases.math(put if about is None else about)
            if self.bare and (about is not None or self._short(put)):
                return (formula,)
            shown = self._summed(put)
            if about is not None:
                return (formula, *shown)
            return (formula, *(s for s in shown if s != formula)) if self._short(put) else shown
        value = self._joule(put)
        if about is not None:
            return (self.phrases.math(about), *self.phrases.substituted(about, value), value)
        if not put.is_number and not is_clean(self.phrases.ledger, put, dimension=ENERGY):
            part = partly(put, [s for s in put.free_symbols if STATE in s.name], self.phrases)
            if part is not None:
                return part, value
        formulas = (self.phrases.math(put),) if not put.is_number and not longer(put, 2 * SHORT) else ()
        return (*formulas, *(self.phrases.substituted(put, value) if formulas else ()), value)

    def _about_axis(self, put: sp.Expr) -> sp.Expr | None:
        """I_A ω²/2 of a body that turns about a fixed point A, where lengths are numbers of the file or I_A is a sum
        in letters; None: it does not, or nothing on the page has defined I_A.
        """
        ledger = self.phrases.ledger
        speeds = [s for s in put.free_symbols if s in ledger.units and ledger.units[s].dimension == RATE]
        if len(speeds) != 1 or (not put.has(sp.Add) and is_clean(ledger, put, dimension=ENERGY)):
            return None
        factor = 2 * put / speeds[0] ** 2
        if simplified(factor).free_symbols & {speeds[0]}:
            return None
        for symbol in ledger.definitions:
            title = ledger.titles.get(symbol, "")
            fixed = title.startswith("moment of inertia") and " about " in title
            if fixed and self.phrases.value.is_zero(simplified(factor) - symbol):
                return symbol * speeds[0] ** 2 / 2
        whole = (s for s, i in self.axes.items() if self.phrases.value.vanishes(simplified(factor) - i))
        return next((s * speeds[0] ** 2 / 2 for s in whole), None)

    def _summed(self, expr: sp.Expr, unit: str = "J") -> tuple[Any, ...]:
        """A formula with numbers for all but the unknowns. `unit`: of one that has none of these."""
        if not self._is_sought(expr):
            return (self._value(expr, parse_unit(unit)),)
        writer = Writer(self.unknowns, self.phrases)
        found = writer.written(expr)
        return (self.phrases.math(expr) if found is None else Math(found, writer.texts),)

    def _joule(self, expr: sp.Expr) -> Value:
        return self._value(expr, parse_unit("J"))

    def _length(self, expr: sp.Expr) -> tuple[Any, ...]:
        """A height or a stretch: its formula where that is short, its number."""
        (letter, *more) = expr.free_symbols or (sp.S.One,)
        unit = self.phrases.ledger.units.get(letter)
        multiple = not more and unit is not None and unit.dimension == LENGTH and (expr / letter).is_number
        clean = bool(expr.free_symbols) and (multiple or self._short(expr, LENGTH))
        if self._is_sought(expr):
            shown, formula = self._summed(expr, "m"), self.phrases.math(expr)
            if not clean:
                return shown
            single = expr.is_Symbol or self.bare
            return (formula,) if single else (formula, *(s for s in shown if s != formula))
        value = self._value(expr, parse_unit("m"))
        if clean:
            return (self.phrases.math(expr), *self.phrases.substituted(expr, value), value)
        own = {s for s in expr.free_symbols if STATE in s.name}
        return (*(in_known(expr, own, value, self.phrases) if own else ()), value)

    def _value(self, expr: sp.Expr, unit: Unit) -> Value:
        own = self.phrases.page_unit(unit)
        text = told_unit(own, unit.dimension == ENERGY)
        zero = self.phrases.value.is_zero(expr)
        number = display(self.phrases.value(sp.S.Zero if zero else expr), own, self.phrases.ledger.us)
        return Value(number, text, self.phrases.figures)

    def _with(
        self, told: sp.Expr, ends: Mapping[sp.Symbol, sp.Expr], factor: Mapping[sp.Symbol, Decimal]
    ) -> tuple[Any, ...]:
        """A formula with heights or stretches as numbers. `factor`: of one that is a number already."""
        sizes = dict(factor)
        if not all(self.phrases.has_numbers(expr) for expr in ends.values()):
            return ()
        for own, expr in ends.items():
            listed = own in self.phrases.ledger.units
            sizes[own] = self.phrases.value(expr) if listed else self._value(expr, parse_unit("m")).number
        found = self.phrases.numbers(told, sizes)
        return () if found is None else (found,)


def fits(sides: tuple[Any, ...], wide: int = WIDE) -> bool:
    """Does a chain of formulas stand in one line?"""
    texts = (plain(s.expr, s.values) if isinstance(s, Math) else quantity(s.number, s.unit, s.figures) for s in sides)
    return sum(len(t) + 3 for t in texts) <= wide


def has_root(expr: sp.Expr) -> bool:
    """Is there a root of a sum in it?"""
    return any(p.exp == sp.Rational(1, 2) and p.base.has(sp.Add) for p in expr.atoms(sp.Pow))


def has_number_root(expr: sp.Expr) -> bool:
    """Is there a root of a number in it?"""
    return any(p.base.is_number and p.exp.is_Rational and not p.exp.is_Integer for p in expr.atoms(sp.Pow))
