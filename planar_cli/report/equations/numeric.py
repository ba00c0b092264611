"""Which equations and formulas of one instant are printed in letters, and the others with the numbers put in."""

from __future__ import annotations

import re
from collections.abc import Collection, Iterator, Sequence
from decimal import Decimal
from typing import Any

import sympy as sp

from planar_cli.equation.algebra.plain import longer
from planar_cli.equation.values.ledger import Kind, Ledger
from planar_cli.report.document.blocks import Equation, Line, Math, line
from planar_cli.report.equations.group_by_group import grown
from planar_cli.report.in_numbers.by_its_letter import by_another, by_its_letter
from planar_cli.report.in_numbers.in_numbers import Collected, in_numbers, solved_for, unit_note
from planar_cli.report.in_numbers.linear_system import Row
from planar_cli.report.in_numbers.opened_sums import opened_number, opened_sides, opened_solution
from planar_cli.report.in_numbers.order_of_unknowns import places_of
from planar_cli.report.in_numbers.put_in import put_in
from planar_cli.report.in_numbers.spelled import UNITS, spelled
from planar_cli.report.in_numbers.with_units import as_stated, led, with_units
from planar_cli.report.kinematics.given_components import against
from planar_cli.report.kinematics.projected import as_components, difference_of
from planar_cli.report.kinematics.told import Across
from planar_cli.report.notation.clean import common_dimension, is_clean
from planar_cli.report.notation.page_units import coherent_unit
from planar_cli.report.words.words import Phrases
from planar_cli.solve.instant.algebra import Line as SolvedLine
from planar_cli.solve.instant.algebra import SolvedBlock
from planar_cli.solve.instant.led import OF_LENGTH
from planar_cli.solve.instant.stages import Stage
from planar_cli.solve.instant.written import Explicit, Written
from planar_cli.units import ACCELERATION, ENERGY, FORCE, LENGTH, TIME, VELOCITY, Dimension, pretty_unit

NAMED, MOST = 16, 40
"""An acceleration or an equation of forces with more operations is in numbers from the start."""
LONGEST = 30
"""A solution with more operations is not written as a formula where its equation can have numbers instead."""

DIFFERENTIATED = "coordinate"
"""The source of a relation that comes from a place: it is divided by a sine or cosine of all its terms."""

OF_CENTRE = "acceleration of "
"""Begins what the letter of an acceleration says by itself."""
ANGLE_OF = "angle of "
"""What the turning of a body is told of that a coordinate places."""
STATED = {"v": VELOCITY, "a": ACCELERATION}

Printed = tuple[tuple[Any, ...], Line]
"""The sides of an equation and the note behind it."""


def vanishing(stage: Stage) -> frozenset[sp.Symbol]:
    """Unknowns that are zero at sight or by the file."""
    data = (w for block in stage.blocks for w in block.equations if w.given and w.right == 0)
    return frozenset((*stage.zero, *(w.left for w in data)))


TURNING = {"1/s": "rad/s", "1/s^2": "rad/s^2"}
"""Units of what turns, as they are said."""


class NumericTelling:
    """Chooses between letters and numbers. In a problem of letters everything stays in letters."""

    def __init__(self, phrases: Phrases, stages: Collection[Stage] = (), general: Phrases | None = None) -> None:
        """`general`: writes letters of a motion in which nothing varies, with the units of the numbers among them."""
        self.phrases, self.general = phrases, general
        self._put: set[tuple[int, int]] = set()
        self._told_by_terms: set[tuple[int, int]] = set()
        """Equations that are not collected, as what they give has their very terms."""
        self.components: dict[tuple[int, int], Across | None] = {}
        """The components of known vectors that were told before a relation, by its algebra and number."""
        self._whole = {id(s.algebra) for s in stages if not phrases.symbolic and not self._lettered(s)}
        """Stages whose kinematic relations are all in numbers, because one of them has to be."""
        self._rows: set[tuple[int, int]] = set()
        """Equations that are solved together as rows of numbers, and stand all alike before."""
        for stage in stages if not phrases.symbolic else ():
            for block in stage.blocks:
                self._rows |= self._rows_of(block, stage)

    def _rows_of(self, block: SolvedBlock, stage: Stage) -> set[tuple[int, int]]:
        """The equations of a block, where one of them has to be in numbers and all of them can."""
        written = block.equations
        if len(block.letters) < 2 or any(w.law not in UNITS for w in written):
            return set()
        if not any(self.put_whole(w, stage) for w in written):
            return set()
        others = grown(block, stage)
        told = all(self._opened((w.left, w.right), stage, row=True) for w in written if w not in others)
        told = told and all(self.row(w, stage, block.unknowns) is not None for w in others)
        return {(id(stage.algebra), w.number) for w in written} if told else set()

    def is_row(self, w: Written, stage: Stage) -> bool:
        """Does an equation stand collected further down, where it is solved together with others?"""
        return (id(stage.algebra), w.number) in self._rows

    def _lettered(self, stage: Stage) -> bool:
        relations = [w for b in stage.blocks for w in b.equations if w.law == "relation" and not w.given]
        return all(is_clean(self.phrases.ledger, w.left, w.right) for w in relations)

    def put_whole(self, w: Written, stage: Stage) -> bool:
        """Is an equation in numbers from the start?"""
        if self.phrases.symbolic:
            return False
        if self.is_row(w, stage) or (w.law == "relation" and id(stage.algebra) in self._whole):
            return True
        if w.law in ("force", "moment") and longer(w.left - w.right, MOST):
            return True
        return not is_clean(self.phrases.ledger, w.left, w.right, dimension=self._dimension(w, stage))

    def put_named(self, x: Explicit) -> bool:
        """Is a line that names an acceleration in numbers?"""
        if self.phrases.symbolic:
            return False
        clean = is_clean(self.phrases.ledger, x.symbol, x.expression, dimension=ACCELERATION)
        return longer(x.expression, NAMED) or not clean

    def named(self, x: Explicit, stage: Stage) -> Printed:
        """A line that names an acceleration in the unknowns of the equations."""
        if self.put_named(x):
            unknowns = {x.symbol, *stage.algebra.unknowns} - self._data(stage)
            found = in_numbers(x.symbol, x.expression, unknowns, self.phrases)
            if found is None or found.dimension is None:
                found = in_numbers(x.symbol, x.expression, unknowns, self.phrases, ACCELERATION)
            if found is not None:
                return (found.left, found.right), unit_note(found.dimension, self.phrases)
        return (self.phrases.math(x.symbol), self.phrases.math(x.expression)), ()

    def readable(self, formula: sp.Expr) -> bool:
        """May a solution stand as a formula?"""
        if self.phrases.symbolic:
            return True
        return not longer(formula, LONGEST) and is_clean(self.phrases.ledger, formula)

    def sides(self, w: Written, stage: Stage, sides: tuple[sp.Expr, sp.Expr]) -> Printed:
        """An equation in letters where these are all that it needs, else in numbers."""
        if self.put_whole(w, stage):
            unknowns = {*stage.algebra.unknowns, *stage.zero} - self._data(stage)
            if (found := as_stated(w, self.phrases) or self._numbers(w, stage, sides, unknowns)) is not None:
                self._put.add((id(stage.algebra), w.number))
                return found
        if self.general is not None and (letters := spelled(w, sides, self.general)):
            return letters, ()
        if w.law == "relation":
            sides = self.phrases.writer.sides(*sides, turns=w.source == DIFFERENTIATED)
        return tuple(self.phrases.math(s) for s in sides), self._stated_unit(w)

    def _stated_unit(self, w: Written) -> Line:
        """The unit of what a file states over time, where its numbers hide theirs: v_Px = 3 (3 + t² - 4 t) in m/s."""
        stated, ledger = w.source == "given" and w.law == "relation", self.phrases.ledger
        if not stated or not w.left.free_symbols or is_clean(ledger, w.left, w.right):
            return ()
        dimension = common_dimension(ledger, w.left)
        if dimension is None or dimension not in STATED.values():
            return ()
        return line(f"in {pretty_unit(coherent_unit(dimension, us=ledger.us).text)}")

    def led(self, formula: sp.Expr) -> sp.Expr:
        """A formula as it gets its numbers: with those that hold a unit by themselves."""
        return formula if self.general is None else led(self.phrases.neat(formula), self.phrases.ledger)

    def formula(self, symbol: sp.Symbol, formula: sp.Expr) -> Math:
        """The formula of an unknown; where letters stay beside numbers, with the units of these."""
        unit = self.phrases.ledger.units.get(symbol)
        if self.general is None or unit is None or is_clean(self.phrases.ledger, symbol, formula):
            return self.phrases.math(formula)
        return with_units(self.phrases.neat(formula), unit.dimension, self.general) or self.phrases.math(formula)

    def result(self, found: SolvedLine | None, sides: tuple[Any, ...]) -> tuple[Any, ...]:
        """letter = value with its unit, where an equation in numbers says so already; else nothing."""
        if (
            found is None
            or self.phrases.symbolic
            or len(sides) not in (2, 3)
            or not all(isinstance(side, Math) for side in sides)
        ):
            return ()
        letter, number = (sides[0], sides[-1]) if sides[0].expr == found.symbol else (sides[-1], sides[0])
        size = number.expr.as_coeff_Mul()[1]
        if letter.expr != found.symbol or not (number.expr.is_Number or size in (number.values or ())):
            return ()
        return letter, *sides[1:-1], self.phrases.shown(found.symbol, found.value)

    def keep(self, w: Written, stage: Stage, components: Across | None) -> None:
        """The components of known vectors that were told before a relation."""
        if components is not None:
            self.components[id(stage.algebra), w.number] = components

    def told(self, w: Written, stage: Stage) -> None:
        """An equation stands on the page with its numbers."""
        self._put.add((id(stage.algebra), w.number))

    def put_in(self, w: Written, stage: Stage, unknowns: Collection[sp.Symbol]) -> Printed | None:
        """An equation in numbers, in unknowns that are still to be found; None where it was printed so."""
        if (id(stage.algebra), w.number) in self._put or self.phrases.symbolic:
            return None
        return self._numbers(w, stage, (w.left, w.right), unknowns)

    def put_whole_line(self, symbol: sp.Symbol, stage: Stage) -> Math | None:
        """The numbers of a named acceleration by those of the unknowns, where its line stands in numbers."""
        if self.phrases.symbolic:
            return None
        explicit = stage.algebra.explicit[symbol]
        unknowns = {symbol, *stage.algebra.unknowns} - self._data(stage)
        return solved_for(symbol, (symbol, explicit), unknowns, self.phrases)

    def row(self, w: Written, stage: Stage, unknowns: Sequence[sp.Symbol]) -> tuple[Row, Line] | None:
        """An equation collected in unknowns that are solved for together, the first of them positive, and the note
        behind it; None where it is not linear in them, or holds others.
        """
        inside = {s: e for s, e in stage.algebra.explicit.items() if e.free_symbols & stage.algebra.unknowns}
        residual = sp.sympify(w.left - w.right).xreplace(inside) / self._length(w)
        if not all(self.phrases.has_numbers(s) or s in unknowns for s in residual.free_symbols):
            return None
        terms = Collected(frozenset(unknowns), self.phrases).terms(residual)
        if terms is None or not terms.keys() <= {sp.S.One, *unknowns}:
            return None
        number = -terms.pop(sp.S.One, Decimal(0))
        sense = -1 if next((c for s in unknowns if (c := terms.get(s))), 1) < 0 else 1
        row = Row({s: sense * c for s, c in terms.items()}, sense * number)
        return row, unit_note(self._dimension(w, stage), self.phrases)

    def solution(self, x: SolvedLine, stage: Stage) -> list[Math]:
        """The numbers that give an unknown, where the one equation that it is found from was printed in numbers."""
        explicit = {s: e for s, e in stage.algebra.explicit.items() if e.free_symbols & stage.algebra.unknowns}
        written = [w for b in stage.blocks for w in b.equations if w.number in x.equations]
        if len(written) != 1:
            return []
        (w,) = written
        if (id(stage.algebra), w.number) in self._told_by_terms and (found := self._by_terms(w, stage)) is not None:
            return [found]
        if explicit.keys() & w.residual.free_symbols & x.formula.free_symbols and not self.put_whole(w, stage):
            explicit = {}
        left, right = (s.xreplace(explicit) / self._length(w) for s in (w.left, w.right))
        named = stage.algebra.explicit.keys() & x.formula.free_symbols if not explicit else set[sp.Symbol]()
        unknowns = (left - right).free_symbols & (stage.algebra.unknowns | named) - self._data(stage)
        if not unknowns - {x.symbol} <= x.formula.xreplace(explicit).free_symbols:
            return []
        found = solved_for(x.symbol, (left, right), unknowns, self.phrases)
        return [] if found is None else [found]

    def quotient(self, x: SolvedLine, stage: Stage) -> list[Line]:
        """What gives an unknown from the components that were told before its equation."""
        found = [self.components.get((id(stage.algebra), n)) for n in x.equations]
        return [f.quotient for f in found if f is not None and f.quotient and len(found) == 1]

    def inserted(self, block: SolvedBlock, stage: Stage) -> tuple[Printed, list[Math]] | None:
        """The last equation of a block when the others are put into it, in its one letter; and the numbers that give
        this. None: there are more letters, or numbers alone do not tell it.
        """
        if len(block.letters) != 1 or self.phrases.symbolic:
            return None
        (letter,), w = block.letters, block.equations[-1]
        formulas = {x.symbol: x.formula for x in block.lines if x.letters}
        explicit = {s: e for s, e in stage.algebra.explicit.items() if e.free_symbols & stage.algebra.unknowns}
        left, right = (s.xreplace(explicit).xreplace(formulas) / self._length(w) for s in (w.left, w.right))
        found = in_numbers(left, right, (letter,), self.phrases, self._dimension(w, stage), apart=True)
        solved = solved_for(letter, (left, right), (letter,), self.phrases)
        if found is None or solved is None:
            return None
        return ((found.left, found.right), unit_note(found.dimension, self.phrases)), [solved]

    def by_letter(self, block: SolvedBlock, stage: Stage) -> Iterator[tuple[SolvedLine, Printed]]:
        """What the other unknowns of a block are by its one letter, in numbers: S = 100 - 3.333 a_A."""
        for x, formula in by_its_letter(block, stage):
            found = put_in(x.symbol, formula, {x.symbol, *block.letters}, self.phrases)
            if found is not None and formula.free_symbols & set(block.letters):
                unit = self.phrases.ledger.units.get(x.symbol)
                own = None if unit is None else coherent_unit(unit.dimension, us=self.phrases.ledger.us).text
                note = found.note if own is None else line(f"in {pretty_unit(TURNING.get(own, own))}")
                yield x, ((Math(x.symbol), *by_another(x, block, stage, self.phrases), found.right), note)

    def at_letter(self, one: SolvedLine, block: SolvedBlock, stage: Stage) -> Math | None:
        """The same with the number of the letter: 100 - 3.333 · 20.73; None: it is one number."""
        formula = next(f for x, f in by_its_letter(block, stage) if x.symbol == one.symbol)
        return solved_for(one.symbol, (one.symbol, formula), (one.symbol, *block.letters), self.phrases)

    def _places(self, stage: Stage) -> dict[sp.Symbol, int]:
        return places_of(stage.algebra, self.phrases.ledger)

    @staticmethod
    def _data(stage: Stage) -> set[sp.Symbol]:
        """What the file gives of this stage."""
        return {w.left for b in stage.blocks for w in b.equations if w.given and w.right.is_number}

    def _numbers(
        self, w: Written, stage: Stage, sides: tuple[sp.Expr, sp.Expr], unknowns: Collection[sp.Symbol]
    ) -> Printed | None:
        explicit = stage.algebra.explicit
        inside = {s: e for s, e in explicit.items() if e.free_symbols & stage.algebra.unknowns}
        left, right = (sp.sympify(s).xreplace(inside) / self._length(w) for s in sides)
        apart = w.law == "relation"
        found = in_numbers(left, right, unknowns, self.phrases, self._dimension(w, stage), apart, self._places(stage))
        if found is None:
            return None
        # In the derivative of what the file gives, a number may hide a unit: a distance for each radian.
        hidden = w.source == "given" and w.times and self._dimension(w, stage) is None
        bare = hidden and not is_clean(self.phrases.ledger, left, right)
        note = () if bare else unit_note(found.dimension, self.phrases)
        if apart and found.right.expr != 0:
            whole = self._number_of(w, stage, left - right, unknowns, found.right.expr.could_extract_minus_sign())
            across = self.components.get((id(stage.algebra), w.number))
            if told := as_components(across, (found.left, whole, found.right)):
                return told, note
            if whole is None and not found.left.expr.is_Symbol and against(w, found.right.expr):
                return tuple(Math(-side.expr, side.values) for side in (found.left, found.right)), note
            return (found.left, *([] if whole is None else [whole]), found.right), note
        return (found.left, found.right), note

    def _number_of(
        self, w: Written, stage: Stage, residual: sp.Expr, unknowns: Collection[sp.Symbol], negative: bool
    ) -> Math | None:
        """What the number of a relation is made of: the components that were told before it, or its products."""
        found = self.components.get((id(stage.algebra), w.number))
        if found is None:
            return opened_number(residual, unknowns, self.phrases, negative)
        number = abs(self.phrases.value(residual.xreplace(dict.fromkeys(unknowns, sp.S.Zero))))
        return difference_of(found.sizes, -number if negative else number, self.phrases.figures)

    def opened(self, w: Written, stage: Stage, sides: tuple[sp.Expr, sp.Expr]) -> tuple[Any, ...]:
        """The sides of an equation of forces or moments that stands in numbers, before its terms are collected; empty
        where they say nothing more.
        """
        return self._opened(sides, stage, self.is_row(w, stage)) if self.put_whole(w, stage) else ()

    def _opened(self, sides: tuple[sp.Expr, sp.Expr], stage: Stage, row: bool) -> tuple[Any, ...]:
        own = stage.algebra.unknowns
        named = {s for s, e in stage.algebra.explicit.items() if e.free_symbols & own}
        unknowns = {*own, *stage.zero, *named}
        return opened_sides(sides, unknowns - self._data(stage), self.phrases, row, self._places(stage))

    def collected(self, w: Written, stage: Stage, sides: tuple[Any, ...], note: Line) -> tuple[Equation, ...]:
        """The line below such an equation, unless it stands collected where it is solved, or gives its one unknown
        by these very terms.
        """
        if self.is_row(w, stage):
            return ()
        if self._by_terms(w, stage) is not None:
            self._told_by_terms.add((id(stage.algebra), w.number))
            return ()
        return (Equation(sides, None, line("collected:"), note),)

    def _by_terms(self, w: Written, stage: Stage) -> Math | None:
        """The numbers that give the only unknown of an equation of forces, as its terms have them."""
        block = next((b for b in stage.blocks if any(x.number == w.number for x in b.equations)), None)
        if block is None or len(block.equations) != 1 or len(block.lines) != 1 or block.letters:
            return None
        (own,), (x,) = block.equations, block.lines
        inside = own.residual.free_symbols
        if stage.algebra.explicit.keys() & inside or own.law not in UNITS:
            return None
        unknowns = (inside & stage.algebra.unknowns) - self._data(stage)
        return opened_solution(x.symbol, (own.left, own.right), unknowns, self.phrases)

    def title(self, x: Explicit, stage: Stage) -> Line:
        """What stands before a line that names an acceleration; where some are in numbers, its reason alone."""
        bare = self.put_named(x) or (x.words.startswith(OF_CENTRE) and any(map(self.put_named, stage.lines)))
        return () if bare else line(x.words + ":")

    def _length(self, w: Written) -> sp.Expr:
        """The length of the vector along which a component was taken; the sense in which its terms are positive."""
        if w.law != "relation" or w.along is None:
            return sp.S.One
        x, y = (self.phrases.value(sp.sympify(p)) for p in w.along)
        return sp.Rational(str((x * x + y * y).sqrt()))

    def _dimension(self, w: Written, stage: Stage) -> Dimension | None:
        """What the sides of an equation are, by the law from which it comes."""
        if w.law == "force":
            return FORCE
        if w.law == "moment":
            return ENERGY
        if w.source in ("closure", "coordinate"):
            whole = VELOCITY if level_of(w, stage, self.phrases.ledger) == "velocity" else ACCELERATION
            whole = whole * LENGTH if w.words == OF_LENGTH else whole
            return whole / LENGTH if w.lead.startswith(ANGLE_OF) else whole
        return _of_statement(w) if w.source == "given" else None


def level_of(w: Written, stage: Stage, ledger: Ledger) -> str:
    """The level of a relation of kinematics: where velocities and accelerations are found together, a relation of
    unknown speeds without an acceleration is one of velocities.
    """
    roles = ledger.roles
    kinds = {roles[s].kind for s in w.residual.free_symbols & stage.algebra.unknowns if s in roles}
    return "velocity" if Kind.SPEED in kinds and Kind.ACCELERATION not in kinds else stage.level


def _of_statement(w: Written) -> Dimension | None:
    """What a velocity or acceleration that the file states is: its size squared where the equation has squares."""
    match = re.match(r"([a-z]+)\(\w+\)(\.\w+)? = ", w.words or w.lead)
    dimension = STATED.get(match[1]) if match is not None else None
    if match is None or dimension is None:
        return None
    letters = w.residual.free_symbols
    square = match[2] == ".mag" and any(w.residual.diff(s).free_symbols & letters for s in letters)
    return (dimension * dimension if square else dimension) / TIME**w.times
