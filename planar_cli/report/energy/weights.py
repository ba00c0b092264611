"""The work of weights told: m g (y_1 - y_2), the heights in lines of their own before; of a body on an axle m g AG
(cos φ - 1).
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from decimal import Decimal
from typing import Any

import sympy as sp

from planar_cli.equation.algebra.plain import longer, simplified
from planar_cli.equation.values.ledger import NAMED
from planar_cli.principles.base import Storage
from planar_cli.records import record
from planar_cli.report.document.blocks import Block, Equation, Line, Math, line
from planar_cli.report.energy.alike import WEIGHT
from planar_cli.report.energy.energy_pieces import SHORT, STATE, EnergyPieces
from planar_cli.report.notation.clean import is_clean
from planar_cli.report.notation.notation import plain
from planar_cli.report.notation.numbers import significant
from planar_cli.report.notation.ordering import NUMBER
from planar_cli.report.notation.page_units import coherent_unit
from planar_cli.report.words.words import told_unit
from planar_cli.units import ENERGY, FORCE, LENGTH, Dimension, parse_unit, pretty_unit

WAY = "s_"
"""Begins the letter of the way that something goes."""


@record
class WeightTelling(EnergyPieces):
    """Tells what weights bring in one balance."""

    def _weight(self, made: Storage, put: sp.Expr, lead: Line) -> Iterator[Block]:
        """m g (y_1 - y_2); the heights in a line before, where they come with their numbers."""
        ends = [self._put(e) for e in (made.first, made.last)]
        if self._short(put) and (all(e.is_Symbol or e == 0 for e in ends) or _is_way_down(made)):
            yield self._line(lead, *self._chain(put))
            return
        own = [sp.Symbol(f"{made.letter}{STATE}{n}", real=True) for n in (self.balance.since, self.balance.stop)]
        factor, sizes = self._factor(made, FORCE)
        if (arm := self._by_arm(made, put)) is not None:
            self.letters[f"U of {made.words}"] = arm
            yield self._line(lead, self.phrases.math(arm), *self._numbers(put, ()))
            return
        told = sp.Mul(factor, sp.Add(own[0], -own[1], evaluate=False), evaluate=False)
        heights = dict(zip(own, ends, strict=True))
        numbers = self._with(told, heights, sizes)
        sides = self._fitting(self._lettered(told, sizes), put, numbers)
        if numbers and numbers[0] in sides:
            yield from self._heights(heights, made.alike)
        elif len(sides) > 1 and not any(longer(e, SHORT) for e in ends):
            yield from self._difference(heights) or self._heights(heights, made.alike)
        if numbers and numbers[0] in sides:
            self.letters[f"U of {made.words}"] = None if sizes else told
        yield self._line(lead, *sides)

    def _by_arm(self, made: Storage, put: sp.Expr) -> sp.Expr | None:
        """m g AG (cos φ - 1) of a body that turns about A, where AG is a number of the file; None: it is no such work,
        or nothing on the page has named AG.
        """
        ledger, body = self.phrases.ledger, made.words.removeprefix(WEIGHT)
        moving = self.balance.parts.moving if self.balance.parts is not None else ()
        own_body = next((m for m in moving if m.body == body), None)
        if own_body is None or not put.free_symbols & set(self.unknowns) or self._short(put):
            return None
        for symbol, whole in ledger.definitions.items():
            title = ledger.titles.get(symbol, "").removesuffix(", parallel axes")
            place = title.removeprefix(f"moment of inertia of {body} about ")
            own = [s for s in whole.free_symbols if ledger.titles.get(s) == f"moment of inertia of {body}"]
            if place == title or len(own) != 1:
                continue
            square = simplified((whole - own[0]) / own_body.mass)
            rest = simplified(put / made.factor / sp.sqrt(square)) if square.is_number and square > 0 else sp.S.Zero
            if rest.free_symbols and all(abs(n) == 1 for n in rest.atoms(sp.Number)):
                letter = sp.Symbol(f"{place}{self.centre(own_body)}", positive=True)
                ledger.know(letter, parse_unit("m"), NAMED)
                return made.factor * letter * rest
        return None

    def _heights(self, ends: Mapping[sp.Symbol, sp.Expr], alike: Sequence[str]) -> Iterator[Block]:
        """y_1 = formula = number, and y_2: each once, but again where it has a number that was still to be found.
        `alike`: the names of others that are the same.
        """
        for own, general in ends.items():
            expr = self._as_drawn(general)
            known = self.phrases.value.known(own) is not None
            if not {(own, expr), (own, general)} & self.told and expr != own and not (known and expr.is_number):
                if not expr.free_symbols & set(self.unknowns):
                    self.told.add((own, expr))
                sides = self._length(expr)
                # Where the other height is still to be found, the work goes on in letters.
                lettered = self.bare and isinstance(sides[0], Math) and any(map(self._is_sought, ends.values()))
                state = own.name.rpartition(STATE)[2]
                others = (Math(sp.Symbol(f"{name}{STATE}{state}", real=True)) for name in alike)
                yield self._line(Math(own), *others, *(sides[:1] if lettered else sides), dimension=LENGTH)

    def _difference(self, ends: Mapping[sp.Symbol, sp.Expr]) -> list[Block]:
        """y_1, and y_1 - y_2 where it is a multiple of what is sought, as both heights are of one that is asked for."""
        (one, first), (two, last) = ends.items()
        (u, *more) = sorted(last.free_symbols & set(self.unknowns), key=str) or (sp.S.One, sp.S.One)
        way = sp.S.Zero if more else -simplified(sp.diff(last, u)) * u
        rest = first - last.xreplace({u: sp.S.Zero})
        if not way.as_coeff_Mul()[1].is_Symbol or first in (0, rest) or not self._vanishes(rest):
            return []
        # How far what is sought goes down itself needs no height.
        told = (one, first) in self.told or first == one or way.is_Symbol
        self.told.add((one, first))
        height = [] if told else [Equation((Math(one), self.phrases.math(first)))]
        return [*height, Equation((Math(sp.Add(one, -two, evaluate=False)), self.phrases.math(way)))]

    def _factor(self, made: Storage, dimension: Dimension) -> tuple[sp.Expr, dict[sp.Symbol, Decimal]]:
        """m g or k; a number, where letters alone do not make it."""
        if is_clean(self.phrases.ledger, made.factor, dimension=dimension):
            return self.phrases.neat(made.factor), {}
        number = sp.Symbol(f"{NUMBER}factor", positive=True)
        return number, {number: self.phrases.of_dimension(self.phrases.value(made.factor), dimension).number}

    def _lettered(self, told: sp.Expr, factor: Mapping[sp.Symbol, Decimal]) -> Math:
        """A formula of heights or stretches."""
        # Of heights the later one is taken from the earlier one, whichever is the greater.
        return Math(told, {s: significant(x, self.phrases.figures) for s, x in factor.items()})

    def _line(self, *sides: Any, dimension: Dimension = ENERGY) -> Equation:
        """One energy or length, with its unit where numbers stand beside unknowns; no side stands twice."""
        shown = [plain(s.expr, s.values) if isinstance(s, Math) else "" for s in sides]
        sides = tuple(s for i, s in enumerate(sides) if not i or not shown[i] or shown[i] != shown[i - 1])
        mixed = isinstance(sides[-1], Math) and sides[-1].values
        unit = coherent_unit(dimension, us=self.phrases.ledger.us)
        return Equation(sides, None, (), line(f"in {pretty_unit(told_unit(unit, True))}") if mixed else ())


def _is_way_down(made: Storage) -> bool:
    """Do two heights differ by the way that something goes down, s_2 - s_1?"""
    ways = [w.as_coeff_Mul()[1] for w in sp.Add.make_args(sp.sympify(made.first - made.last))]
    return all(w.is_Symbol and w.name.startswith(WAY) and STATE in w.name for w in ways)
