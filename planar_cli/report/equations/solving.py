"""The last step of an instant: what the equations give, one unknown after the other."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import replace
from functools import partial
from typing import Any

import sympy as sp

from planar_cli.equation.algebra.plain import longer, simplified
from planar_cli.report.document.blocks import Block, Equation, Line, Math, Paragraph, line
from planar_cli.report.equations.isolated import at_sight
from planar_cli.report.equations.numeric import DIFFERENTIATED, NumericTelling
from planar_cli.report.equations.put_at_once import put_at_once, without_repeated
from planar_cli.report.equations.results import numbered, other_roots
from planar_cli.report.equations.small_system import named_in, small_system
from planar_cli.report.equations.solved_already import is_given, is_told, is_written
from planar_cli.report.equations.steps import SINGLE
from planar_cli.report.in_numbers.by_its_letter import makes_storeys, put_in_before
from planar_cli.report.in_numbers.by_sine import by_sine
from planar_cli.report.in_numbers.closed_letters import in_letters
from planar_cli.report.notation.notation import plain
from planar_cli.report.words.words import Phrases
from planar_cli.solve.instant.algebra import Line as SolvedLine
from planar_cli.solve.instant.algebra import SolvedBlock
from planar_cli.solve.instant.stages import Stage
from planar_cli.solve.instant.written import Written
from planar_cli.solve.solution import InstantSolution

SHORT = 9
"""A formula of so many operations is told in letters again with its numbers."""
FEW = 3
"""Of so many equations with one unknown each the solution stands at once below them."""
MANY = 6
"""Of more accelerations that stand for others only the numbers of their lines are named."""


class SolvingTelling:
    """Tells how the unknowns of a stage follow. `number`: the printed number of an equation or line of a stage;
    `merged`: equations that were told together with their solution, by algebra and number; `constants`: speaks of what
    has a number all the time, where the rest of a general position is told in letters.
    """

    def __init__(
        self,
        instant: InstantSolution,
        phrases: Phrases,
        numeric: NumericTelling,
        number: Callable[[Stage, int], int],
        constants: Phrases | None = None,
    ) -> None:
        self.constants = constants
        self.instant, self.phrases, self.numeric, self.number = instant, phrases, numeric, number
        self.merged: set[tuple[int, int]] = set()
        self.nil: set[tuple[int, int]] = set()
        """Equations of forces that said at once that something is zero."""
        self._valued: set[sp.Symbol] = set()
        self._together: dict[sp.Symbol, tuple[int, ...]] = {}
        self._solved: set[sp.Symbol] = set()
        """What was solved in letters before it has its value."""
        self._inserted: dict[sp.Symbol, tuple[int, ...]] = {}
        self._outright: set[sp.Symbol] = set()
        """What several equations tell together, though they do not tell each of their unknowns."""
        self._carried_in_numbers: set[sp.Symbol] = set()
        """What would be fractions of fractions in letters."""
        self._by_letter: dict[sp.Symbol, Math | None] = {}
        """The numbers of what was told by the one letter of its block, with that of the letter put in."""

    def chain(self, symbol: sp.Symbol, expr: sp.Expr, value: Any) -> tuple[Any, ...]:
        """symbol = formula = numbers = value."""
        if self._is_constant(symbol):
            assert self.constants is not None
            value = self.constants.shown(symbol)
            told = [] if expr.is_number else [expr]
            known = self.constants.value.known
            if any(known(s) is None for s in expr.free_symbols):
                # What has no number cancels: the formula without it has numbers.
                expr = simplified(self.constants.value.definitions.get(symbol, expr))
                told += [] if expr.is_number or plain(expr) in map(plain, told) else [expr]
            bare = expr.is_Symbol or expr.is_number or any(known(s) is None for s in expr.free_symbols)
            put = () if bare else self.constants.substituted(self.numeric.led(expr), value)
            return (self.phrases.math(symbol), *(self.numeric.formula(symbol, e) for e in told), *put, value)
        sides: list[Any] = [self.phrases.math(symbol)]
        if not expr.is_number and self.numeric.readable(expr):
            sides.append(self.phrases.math(expr))
            if not expr.is_Symbol:
                sides += self.phrases.substituted(expr, value)
        if not self.phrases.symbolic:
            number = self.phrases.value.known(symbol)
            sides += [value, *(self.phrases.converted(symbol, number) if number is not None else ())]
        elif expr.is_number:
            sides.append(self.phrases.math(expr))
        elif self.constants is None and (closed := in_letters(expr, self.instant)) is not None:
            sides.append(self.phrases.math(closed))
        return tuple(sides)

    def told_already(self, w: Written, found: SolvedLine, itself: bool) -> tuple[Any, ...]:
        """A relation that stands as unknown = formula and solves `itself`, or whose solution would add nothing."""
        if not itself and (found.letters or not self.phrases.symbolic or not is_written(w, found, self.phrases)):
            return ()
        chain = self.chain(found.symbol, found.formula, self.phrases.shown(found.symbol, found.value))
        return chain if itself or len(chain) == 2 else ()

    def solves_itself(self, w: Written, found: SolvedLine, stage: Stage) -> bool:
        """Does a relation already stand as unknown = formula, all of which is known by then?"""
        if found.letters or not is_written(w, found, self.phrases):
            return False
        return not (found.formula.free_symbols & stage.algebra.unknowns) and self.numeric.readable(found.formula)

    def take_outright(self, w: Written, found: SolvedLine | None, stage: Stage) -> None:
        """An equation of forces that stands as unknown = formula is its own solution, where that would add nothing."""
        alone = any(b.equations == (w,) and len(b.unknowns) == 1 for b in stage.blocks)
        if found is None or found.letters or not alone or w.left != found.symbol or not self.phrases.symbolic:
            return
        chain = self.chain(found.symbol, found.formula, self.phrases.shown(found.symbol, found.value))
        if len(chain) == 2 and is_written(w, found, self.phrases):
            self.merged.add((id(stage.algebra), w.number))

    def _is_constant(self, symbol: sp.Symbol) -> bool:
        """Has it a number all the time, though the page is in letters?"""
        told = self.constants is not None and self.phrases.symbolic
        return told and self.constants is not None and self.constants.value.known(symbol) is not None

    def count(self, stage: Stage, last: int) -> Line:
        """How many equations there are, and which unknowns; by their numbers where they are not all from (1) to the
        last one that has a number.
        """
        blocks = self._left(stage)
        named = named_in(stage, [w for b in blocks for w in b.equations])
        many = sorted(self.number(stage, n) for n in named.values()) if len(named) > MANY else []
        named = {} if many else named
        equations = sum(len(b.equations) for b in blocks) + len(named)
        unknowns = [*named, *(u for b in blocks for u in b.unknowns)]
        if many:
            order = self.instant.trial.system.tree.acceleration_unknowns()
            unknowns.sort(key=lambda u: order.index(u) if u in order else len(order))
        numbers = {*named.values(), *(w.number for b in blocks for w in b.equations)}
        printed = sorted({self.number(stage, n) for n in numbers})
        head = f"{equations} equation{'s' if equations != 1 else ''}, "
        if equations > 1 and printed != list(range(1, last + 1)):
            head = f"{numbered(printed)}, "
        head += f"{len(unknowns)} unknown{'s' if len(unknowns) != 1 else ''}: "
        alone = 1 < len(unknowns) <= FEW and not named and all(self._is_alone(b, unknowns) for b in blocks)
        parts: list[Any] = [f"{SINGLE} each: " if alone else head]
        for i, u in enumerate(unknowns):
            parts += [", " if i else "", Math(u)]
        for i, s in enumerate(self._carried(stage, blocks, unknowns)):
            parts += [", " if i else "; in terms of ", Math(s)]
        return line(*parts, f"; the accelerations in these by {numbered(many)}" if many else "")

    def _left(self, stage: Stage) -> list[SolvedBlock]:
        """What is to be solved: more than what the file gives, and than what is zero at sight."""
        return [
            b
            for b in stage.blocks
            if not is_given(b)
            and not is_told(b, stage)
            and not all((id(stage.algebra), w.number) in self.nil | self.merged for w in b.equations)
        ]

    @staticmethod
    def _is_alone(block: SolvedBlock, unknowns: Sequence[sp.Symbol]) -> bool:
        """Is it one equation with one unknown, whatever the others give?"""
        held = {s for w in block.equations for s in w.residual.free_symbols}
        return len(block.equations) == len(block.unknowns) == 1 and held & set(unknowns) == set(block.unknowns)

    def _carried(self, stage: Stage, blocks: Sequence[SolvedBlock], unknowns: Sequence[sp.Symbol]) -> list[sp.Symbol]:
        """What is sought of the file, stands in the equations, and is only found by what follows."""
        held = {s for b in blocks for w in b.equations for s in w.residual.free_symbols}
        open_ = {u.name for u in self.instant.instant.scene.problem.unknowns}
        left = held - set(unknowns) - stage.algebra.unknowns
        return sorted((s for s in left if s.name in open_), key=lambda s: s.name)

    def is_needed(self, stage: Stage) -> bool:
        """Is there more to solve than what the file gives, and what is zero at sight?"""
        return bool(self._left(stage))

    def blocks(self, stage: Stage) -> list[Block]:
        """The lines that give the unknowns of a stage, one after the other."""
        return [x for block in self._left(stage) for x in self._block(block, stage)]

    def _block(self, block: SolvedBlock, stage: Stage) -> list[Block]:
        blocks: list[Block] = []
        if len(block.letters) > 1 and (small := small_system(block, stage, self.instant, self.numeric, self.number)):
            return small
        block = replace(block, lines=tuple(at_sight(x, block.equations, self.numeric.readable) for x in block.lines))
        lines = [x for x in block.lines if x.letters or not self._is_repeated(x, block)]
        stands = partial(self._stands, block=block)
        if len(block.unknowns) > 1 and not block.letters:
            self._outright.add(block.lines[0].symbol)
        long = any(not self.numeric.readable(x.formula) for x in lines) or self._in_numbers(block, stage)
        if long or self._in_storeys(block, stage):
            blocks = self._put_in(block, stage) if long else []
            lines = [x for x in lines if not x.letters]
            if len(block.unknowns) > 1:
                self._name_together(block, lines, stage)
                if inserted := self._last_in_numbers(block, stage):
                    blocks = [*without_repeated(blocks, inserted), *inserted]
                    lines = [x for x in lines if x.symbol not in block.letters]
        elif put := put_at_once(block, lines, self.phrases, stands, self._is_constant):
            self._inserted |= put
            lines = [x for x in lines if not x.letters]
        elif block.letters and len(block.unknowns) > 1:
            blocks += self._carrying(block, stage)
            lines = [x for x in lines if not (x.letters and stands(x))]
            lines = self._each_once(lines)
        merged = {n for algebra, n in self.merged if algebra == id(stage.algebra)}
        return [*blocks, *(b for x in lines if not merged >= set(x.equations) for b in self._line(x, stage))]

    def _carrying(self, block: SolvedBlock, stage: Stage) -> list[Block]:
        """What is said before lines that carry letters: of one letter nothing, as its result names the few equations
        that are put into its own, (2) in (3). Among velocities their relations stand in the same column.
        """
        result = next((x for x in block.lines if x.symbol in block.letters and not x.letters), None)
        put = [n for x in block.lines if x.letters for n in x.equations]
        few = stage.level != "velocity" and len(block.letters) == 1 and 0 < len(put) <= FEW - 1
        if few and result is not None and not {*put} & {*result.equations}:
            self._inserted[result.symbol] = tuple(put)
            return []
        numbers = [self.number(stage, w.number) for w in block.equations]
        parts: list[Any] = [f"{numbered(numbers)} together, in terms of "]
        for i, s in enumerate(block.letters):
            parts += [", " if i else "", Math(s)]
        return [Paragraph(line(*parts, ":"))]

    def _each_once(self, lines: Sequence[SolvedLine]) -> list[SolvedLine]:
        """Without the formulas of what was solved in letters before: of that its numbers alone are new, or its closed
        form.
        """
        before = {x.symbol: x.formula for x in lines if x.letters}
        self._solved.update(x.symbol for x in lines if not x.letters and before.get(x.symbol) == x.formula)
        again = [x for x in lines if x.symbol in before and not x.letters]
        old = [x for x in again if self.phrases.symbolic and not self._is_constant(x.symbol)]
        return [x for x in lines if x not in old or in_letters(x.formula, self.instant) is not None]

    def _stands(self, x: SolvedLine, block: SolvedBlock) -> bool:
        """Does a line in letters stand as its equation already, be it with others that are then put in?"""
        own = [w for w in block.equations if w.number in x.equations]
        return any(is_written(w, x, self.phrases) or self._is_outright(w, x.symbol) for w in own)

    def _is_outright(self, w: Written, symbol: sp.Symbol) -> bool:
        """Does an equation stand as unknown = formula, whatever the formula?"""
        either = [self.phrases.writer.sides(n * w.left, n * w.right, w.source == DIFFERENTIATED) for n in (1, -1)]
        return any(symbol in sides and symbol not in sides[sides[0] == symbol].free_symbols for sides in either)

    def _is_repeated(self, x: SolvedLine, block: SolvedBlock) -> bool:
        """Does a result without numbers stand as a line, or as an equation, before?"""
        if not self.phrases.symbolic or x.letters or self._is_constant(x.symbol):
            return False
        if any(y.letters and (y.symbol, y.formula) == (x.symbol, x.formula) for y in block.lines):
            return True
        own = [w for w in block.equations if w.number in x.equations]
        return len(block.unknowns) > 1 and any(is_written(w, x, self.phrases) for w in own)

    def _last_in_numbers(self, block: SolvedBlock, stage: Stage) -> list[Block]:
        """The one letter of a block from its last equation, into which the others are put."""
        found = self.numeric.inserted(block, stage)
        x = next((x for x in block.lines if x.symbol in block.letters), None)
        if found is None or x is None:
            return []
        (sides, note), solved = found
        *put, last = (self.number(stage, w.number) for w in block.equations)
        lead = line(f"{numbered(put)} in ({last}):")
        told: list[Block] = []
        by_letter = list(self.numeric.by_letter(block, stage))
        for one, (chain, beside) in by_letter if 1 < len(by_letter) <= FEW else ():
            self._by_letter[one.symbol] = self.numeric.at_letter(one, block, stage)
            own, put_for = numbered([self.number(stage, n) for n in one.equations]), self._put_for(one, stage)
            if len(chain) == 2:
                put_for = sorted({*put_for, *(self.number(stage, n) for n in put_in_before(one, block, stage))})
            told.append(Equation(chain, None, line(f"{numbered(put_for)} in {own}:" if put_for else f"{own}:"), beside))
        result: tuple[Any, ...] = (self.phrases.math(x.symbol), *solved, self.phrases.shown(x.symbol, x.value))
        if _is_quotient(solved):
            return [*told, Equation(result, None, lead)]
        return [*told, Equation(sides, None, lead, note), Equation(result)]

    def _in_storeys(self, block: SolvedBlock, stage: Stage) -> bool:
        """Would letters make fractions of fractions of what is carried, where numbers make it a few short lines?"""
        if not makes_storeys(block, self.instant) or self.numeric.inserted(block, stage) is None:
            return False
        carried = [x.symbol for x, _ in self.numeric.by_letter(block, stage)]
        self._carried_in_numbers.update(carried)
        return 1 < len(carried) <= FEW

    def _name_together(self, block: SolvedBlock, lines: Sequence[SolvedLine], stage: Stage) -> None:
        """The first result of several equations bears the numbers of all; so does one that its own does not hold."""
        numbers = tuple(w.number for w in block.equations)
        held = {w.number: w.residual.xreplace(stage.algebra.explicit).free_symbols for w in block.equations}
        for i, x in enumerate(lines):
            if i == 0 or not any(x.symbol in held.get(n, ()) for n in x.equations):
                self._together[x.symbol] = numbers

    def _in_numbers(self, block: SolvedBlock, stage: Stage) -> bool:
        return any(self.numeric.put_whole(w, stage) for w in block.equations)

    def _put_in(self, block: SolvedBlock, stage: Stage) -> list[Block]:
        """The equations of a block with the numbers put in, those that were not printed so."""
        found: list[Block] = []
        for w in block.equations:
            bare = w.residual.free_symbols <= stage.algebra.unknowns
            # The accelerations in it have their values first.
            bare |= len(block.unknowns) == 1 and bool(named_in(stage, [w])) and not self.numeric.put_whole(w, stage)
            # Of one unknown the result has all these numbers.
            bare |= len(block.lines) == len(block.unknowns) == 1 and bool(self.numeric.solution(block.lines[0], stage))
            equation = None if bare else self.numeric.put_in(w, stage, block.unknowns)
            if equation is not None:
                sides, note = equation
                found.append(Equation(sides, None, line(f"({self.number(stage, w.number)}) in numbers:"), note))
        return found

    def _line(self, x: SolvedLine, stage: Stage) -> list[Block]:
        numbers = x.equations
        if x.symbol in self._together:
            numbers = tuple(dict.fromkeys((*x.equations, *self._together[x.symbol])))
        lead = line(numbered([self.number(stage, n) for n in numbers]) + ":")
        if x.symbol in self._outright:
            *others, last = (self.number(stage, n) for n in x.equations)
            lead = line(f"{numbered(others)} in ({last}):")
        elif x.symbol in self._inserted:
            inserted = {self.number(stage, n) for n in self._inserted[x.symbol]} | set(self._put_for(x, stage))
            lead = line(f"{numbered(sorted(inserted))} in ", *lead)
        elif (put_in := self._put_for(x, stage)) and x.symbol not in self._by_letter:
            lead = line(f"{numbered(put_in)} in ", *lead)
        if x.letters:
            return [Equation((self.phrases.math(x.symbol), self.numeric.formula(x.symbol, x.formula)), None, lead)]
        shown = self.phrases.shown(x.symbol, x.value)
        own = (w for b in stage.blocks for w in b.equations if w.number in x.equations)
        put = any(self.numeric.put_whole(w, stage) for w in own)
        sides = self.chain(x.symbol, x.formula, shown)
        bare = len(sides) == 2 and not x.formula.is_number and not self.phrases.symbolic
        if put or bare:
            solution = self.numeric.solution(x, stage)
            quotient = self.numeric.quotient(x, stage) if solution else ()
            sides = (self.phrases.math(x.symbol), *quotient, *solution, shown)
            if len(sides) == 2 and (first := by_sine(x, stage, lead, self.phrases)) is not None:
                return [first, Equation(sides), *other_roots(self.instant, x, self.phrases)]
        short = not longer(x.formula, SHORT) and x.symbol not in self._carried_in_numbers
        by_letter = None if put or short else self._by_letter.get(x.symbol)
        if by_letter is not None:
            sides = (self.phrases.math(x.symbol), by_letter, shown)
        if x.symbol in self._solved and len(sides) > 3:
            sides = (sides[0], *sides[2:])
        return [
            *(() if put or by_letter is not None else self._values_of(sides, x, stage)),
            Equation(sides, None, lead),
            *other_roots(self.instant, x, self.phrases),
        ]

    def _put_for(self, x: SolvedLine, stage: Stage) -> list[int]:
        """The lines of accelerations that stand in the equation of a result, but no longer in the result."""
        own = [w for b in stage.blocks for w in b.equations if w.number in x.equations]
        gone = named_in(stage, own).items()
        return [self.number(stage, n) for s, n in gone if s not in x.formula.free_symbols | self._valued]

    def _values_of(self, sides: tuple[Any, ...], x: SolvedLine, stage: Stage) -> Iterator[Block]:
        """The values of named accelerations that are put into a formula, those that were not told before."""
        if len(sides) < 3:
            return
        for symbol in sorted(x.formula.free_symbols & set(stage.algebra.explicit) - self._valued, key=lambda s: s.name):
            self._valued.add(symbol)
            value = None if self.phrases.symbolic else self.phrases.shown(symbol)
            chain = self.chain(symbol, stage.algebra.explicit[symbol], value)
            short = self._by_its_line(symbol, chain, stage)
            named = next((y.number for y in stage.lines if y.symbol == symbol and short != chain), None)
            if len(short) > 2 or not self.phrases.symbolic:
                yield Equation(short, None, line() if named is None else line(f"({self.number(stage, named)}):"))

    def _by_its_line(self, symbol: sp.Symbol, chain: tuple[Any, ...], stage: Stage) -> tuple[Any, ...]:
        """The value of an acceleration without the formula of its line, or with the numbers of that line."""
        own = next((y for y in stage.lines if y.symbol == symbol), None)
        if len(chain) == 2 or (own is not None and self.numeric.put_named(own)):
            numbers = self.numeric.put_whole_line(symbol, stage)
            return chain if numbers is None else (chain[0], numbers, chain[-1])
        long = own is not None and len(chain) > 3 and longer(own.expression, SHORT)
        stands = long and own is not None and chain[1] == self.phrases.math(own.expression)
        return (chain[0], *chain[2:]) if stands else chain


def _is_quotient(numbers: Sequence[Math]) -> bool:
    """Is it one number by another, which tells their equation as well: 52.86/0.5742 of 0.5742 α = 52.86?"""
    (one, *more) = numbers
    above, below = one.expr.as_numer_denom()
    return not more and below != 1 and not (above.is_Add or below.is_Add)
