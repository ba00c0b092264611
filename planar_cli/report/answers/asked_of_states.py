"""What is asked of a motion, in the letters of its states: name = formula = numbers = value."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from decimal import Decimal
from typing import Any

import sympy as sp

from planar_cli.equation.algebra.common_factors import factor_terms
from planar_cli.equation.algebra.counting import operations
from planar_cli.equation.algebra.expansion import expanded
from planar_cli.equation.algebra.plain import longer, simplified, trigonometric
from planar_cli.problem.language.expression import Function, Grouped, Quantity
from planar_cli.problem.language.expression import Name as Letter
from planar_cli.problem.language.outermost import is_energy
from planar_cli.problem.language.walk import walk
from planar_cli.records import record
from planar_cli.report.answers.at_equilibrium import place_put_in
from planar_cli.report.answers.at_its_state import at_its_state
from planar_cli.report.answers.by_ends import by_ends
from planar_cli.report.answers.on_a_line import along_the_line
from planar_cli.report.answers.values_of_states import closed_value, untold
from planar_cli.report.document.blocks import Block, Equation, Line, Math, Name, Paragraph, Value, line
from planar_cli.report.energy.energy_after import energy_after
from planar_cli.report.energy.turning_groups import Turning
from planar_cli.report.friction.friction_at_states import friction_at_states
from planar_cli.report.given.compared import compared_sides
from planar_cli.report.in_numbers.put_in import in_known
from planar_cli.report.instant.at_state import told_at_states
from planar_cli.report.kinematics.turning_axes import TurningAxes
from planar_cli.report.kinetics.missing_couples import missing_couple
from planar_cli.report.laws.rate_first import ToldRate, by_told_rate
from planar_cli.report.laws.span_integrals import SpanTelling
from planar_cli.report.momentum.by_force import by_force
from planar_cli.report.momentum.nil_impulses import nil_of_blow
from planar_cli.report.notation.at_a_time import at_a_time
from planar_cli.report.notation.clean import is_clean
from planar_cli.report.oscillation.equilibrium_places import by_places, equilibrium_places
from planar_cli.report.oscillation.oscillation import by_damping, by_frequency, periods_told
from planar_cli.report.words.state_words import at, place
from planar_cli.report.words.words import Phrases
from planar_cli.solve.between.trace.span_trace import SpanIntegral
from planar_cli.solve.between.trace.trace import BalanceTrace, MotionTrace, Request
from planar_cli.units import Unit

HENCE = Paragraph(line("Hence:"))
HALF = sp.Rational(1, 2)
LONGEST, SHORT, FEW = 90, 45, 24
"""A longer formula is not told: of letters, and of what has numbers; and one whose numbers are put in, if few letters
are left then.
"""


@record
class Part:
    """A component of what is asked. `axis`: "" where it is no vector."""

    axis: str
    expr: sp.Expr


@record
class AskedTelling:
    """Tells the finds of one motion that are more than a letter. `numeric`: in which is told what rests on no letter
    without a number; `wanted`: names of letters whose derivation is told (None: all); `rates`: constant accelerations
    that were told; `groups`: what turns together, by the state.
    """

    found: MotionTrace
    phrases: Phrases
    numeric: Phrases
    wanted: frozenset[str] | None
    spans: SpanTelling
    rates: Sequence[ToldRate]
    groups: Mapping[str, Turning]

    def blocks(self) -> Iterator[Block]:
        """A heading, and a line for each component; a quantity over a span by its integral."""
        turning = TurningAxes(self.found, self.numeric)
        asked = [(r, part, span) for r, part, span in self._asked() if r.find.name not in turning.names]
        own = {s.symbol for _, _, s in asked if s is not None}
        for span in self.found.spans:
            if span.symbol not in own and nil_of_blow(span) is None and not self._is_a_way(span) and self._needs(span):
                yield from self.spans.blocks(span)
        decided = (compared_sides, friction_at_states) if self.wanted is None or self.wanted else ()
        compared = [block for decisions in decided for block in decisions(self.found, self.numeric)]
        vectors = list(self._vectors())
        places = list(dict.fromkeys(_at(r) for r, _, _ in asked))
        # What is asked of several states has no place under the heading of one.
        general = [r for r in self._requests() if len(places) > 1 and not _at(r)]
        last = places[0] if len(places) > 1 and "" not in places and not compared else ""
        if last:
            yield Paragraph(line(f"Hence, {place(last)}:"))
        elif (asked or compared or vectors or any(r.beside for r in self._requests())) and not turning.names:
            yield HENCE
        yield from compared
        told: set[sp.Symbol] = set()
        own_first = [*general, *(r for r in self._requests() if not any(r is g for g in general))]
        for find in own_first:
            if len(places) > 1 and _at(find) not in ("", last) and any(r is find for r, _, _ in asked):
                last = _at(find)
                yield Paragraph(line(at(last)))
            if find.find.name in turning.names:
                yield from turning.blocks(find.find.name)
                continue
            yield from (self._letter(x, e) for x, e in find.beside if x not in told)
            told |= {x for x, _ in find.beside}
            for request, part, whole in asked:
                if request is find:
                    yield from missing_couple(request, part.expr, self.found, self.phrases)
                    by_energies = energy_after(request, self.found, self.groups, self.numeric)
                    yield from by_energies or self._line(request, part, whole)
            if any(find is g for g in general):
                yield from (block for r, block in vectors if r is find)
        for find, block in vectors:
            if any(find is g for g in general):
                continue
            if last and _at(find) not in ("", last):
                last = _at(find)
                yield Paragraph(line(at(last)))
            yield block

    def _needs(self, span: SpanIntegral) -> bool:
        """Is it more than a component of one blow, which the answer has in the letters of its impulses?"""
        (first, *more) = span.pieces
        alone = first.how == "blow" and not more and span.duration == 1 and span.formula is not None
        return not alone or any(p.has(span.symbol) for r in self._requests() for p in r.parts)

    def _is_a_way(self, span: SpanIntegral) -> bool:
        """Is a quantity over a span the place at its end, counted from its beginning?"""
        if span.quantity.word != "path_length" or len(span.pieces) != 1 or span.formula is None:
            return False
        found = _without(span.formula, self._zeros)
        return bool(found.is_Symbol) and untold(found, self.found) is None

    def _letter(self, letter: sp.Symbol, formula: sp.Expr) -> Equation:
        """A letter of a state in which something is told."""
        formula = self._signed(_without(formula, self._zeros))
        numbers = self.numeric.has_numbers(formula)
        values = [self.phrases.shown(letter, self.found.value(letter))] if numbers else []
        if values and (by_rate := by_told_rate(formula, self.rates)) is not None:
            told, own = by_rate
            put = told.numbers(own, self.numeric)
            return Equation((self.phrases.math(letter), self.phrases.math(own), *put, *values))
        sides = self._shown(formula, None, self.phrases.ledger.units[letter], values, self.numeric)
        return Equation((self.phrases.math(letter), *sides, *values))

    def _vectors(self) -> Iterator[tuple[Request, Block]]:
        """Vectors whose components are letters of the states: name = [x, y] = numbers."""
        for asked in self._requests():
            parts = [self._signed(_without(p, self._zeros)) for p in asked.parts]
            letters = {p for p in parts if p.is_Symbol} - self.found.varying
            if len(parts) < 2 or not letters or not all(p in letters or p.is_number for p in parts):
                continue
            shown = line("[", self.phrases.math(parts[0]), ", ", self.phrases.math(parts[1]), "]")
            sides: list[Any] = [line(Name(asked.find.name)), shown]
            if all(map(self.phrases.has_numbers, parts)) and asked.unit is not None:
                numbers = [Decimal(0) if self.found.value.is_zero(p) else self.found.value(p) for p in parts]
                sides.append(self.phrases.vector(numbers[0], numbers[1], asked.unit.dimension))
            yield asked, Equation(tuple(sides))

    @property
    def _zeros(self) -> dict[sp.Symbol, sp.Expr]:
        """Letters of states that are zero, or the opposite of a letter of the file."""
        opposite = {s: f for s, f in self.found.route.plain.items() if (-f).is_Symbol}
        return {**opposite, **{s: f for s, f in self.found.route.formulas.items() if f == 0}}

    def _of_changes(self, part: sp.Expr) -> sp.Expr:
        """What is lost or gained, without the terms of letters that only keep their values from state to state."""
        kept = {s: f for s, f in self.found.route.formulas.items() if f.is_Symbol and f in self.found.general}
        put = part.xreplace(kept)
        if put == part or longer(part, LONGEST):
            return part
        short = simplified(put)
        return short if 2 * operations(short) < operations(part) else part

    def _requests(self) -> Iterator[Request]:
        """What is asked that may have a line here."""
        elsewhere = {*self.found.passing, *told_at_states(self.found), *periods_told(self.found).values()}
        elsewhere |= {p.request.find.name for p in equilibrium_places(self.found)}
        for asked in self.found.requests if self.wanted is None or self.wanted else ():
            if asked.find.name not in elsewhere and asked.unit is not None and asked.parts:
                yield asked

    def _asked(self) -> Iterator[tuple[Request, Part, SpanIntegral | None]]:
        """What has a line: every component that is more than a letter."""
        places = by_places(self.found)
        for asked in self._requests():
            axes = ("x", "y") if len(asked.parts) > 1 else ("",)
            spans = [self._span(p) for p in asked.parts]
            parts = [self._signed(self._of_changes(_without(p.xreplace(places), self._zeros))) for p in asked.parts]
            resolved = [_along_its_direction(p) for p in parts]
            became = resolved != parts
            parts = resolved
            became |= any(
                p.is_Symbol and (untold(p, self.found) is not None or not (raw.is_Symbol or raw.is_number))
                for p, raw in zip(parts, asked.parts, strict=True)
            )
            formulas = (became or any(map(self._is_formula, parts))) and all(
                p.is_Symbol or p == 0 or self._is_formula(p) for p in parts
            )
            if len(parts) == 1 and parts[0].is_Symbol and not became:
                continue  # The answer names the letter, which has its line.
            if all(s is not None for s in spans) or formulas:
                for axis, part, span in zip(axes, parts, spans, strict=True):
                    yield asked, Part(axis, part), span

    def _span(self, part: sp.Expr) -> SpanIntegral | None:
        """The quantity over a span that an answer is."""
        return next((s for s in self.found.spans if part in (s.symbol, s.formula)), None)

    def _is_formula(self, p: sp.Expr) -> bool:
        return not (p.is_Symbol or p.is_number or self._is_long(p) or p.free_symbols & self.found.varying)

    def _is_long(self, p: sp.Expr) -> bool:
        """Is it longer than a formula that somebody reads?"""
        if self.phrases.symbolic:
            return longer(p, LONGEST)
        return longer(p, SHORT)

    def _line(self, asked: Request, part: Part, span: SpanIntegral | None) -> Iterator[Block]:
        name = line(Name(asked.find.name), f", {part.axis}" if part.axis else "")
        formula = part.expr if span is None or longer(part.expr, SHORT) else factor_terms(part.expr)
        if span is None and not self.numeric.symbolic and not self.numeric.has_numbers(formula):
            # A mass that the file leaves open may cancel, as in the share of an energy that is lost.
            bare = simplified(formula)
            formula = bare if self.numeric.has_numbers(bare) else formula
        phrases = self.numeric if self.numeric.has_numbers(formula) else self.phrases
        values: list[Value] = []
        if phrases.has_numbers(formula) and asked.unit is not None:
            values = self._values(asked, asked.unit, formula)
            values = values if span is None else [*values[:-1], self.spans.named(span, values[-1])]
        damped = by_damping(asked.find.found.what, self.found, phrases)
        shown = damped or self._shown(formula, span, asked.unit, values, phrases)
        if shown and values and shown[0].expr == sp.Symbol(asked.find.name, real=shown[0].expr.is_real):
            shown = shown[1:]  # the file calls it as the page does
        before = at_its_state(asked.find.name, formula, self.found) if span is None and not part.axis else None
        sides: list[Any] = [name, *([] if before is None else [phrases.math(before)]), *shown, *values]
        ends = () if span is None or not values else by_ends(span, self.found, phrases, values[0])
        if ends or (span is not None and values and (ends := by_force(span, self.found, phrases))):
            yield Equation((name, *ends, *values))
        elif span is not None and (quoted := self._told_before(span)):
            yield Equation((name, *quoted, *(shown if len(quoted[-1]) < 3 else ()), *values))
        elif span is None:
            lead, put = place_put_in(asked.find.name, formula, self.found, self.phrases)
            yield Equation((name, *put, *sides[1:]), None, lead)
        else:
            yield from self.spans.lines(span, (), tuple(sides))

    def _told_before(self, span: SpanIntegral) -> tuple[Line, ...]:
        """The work of one source that a balance between the same states has told, there with its value or as it is by
        what was sought.
        """
        q, value = span.quantity, self.found.value
        if q.word != "work" or q.at is None or self.phrases.symbolic:
            return ()
        sources = ((e.source, leg.unknowns) for leg in self.found.route.steps for e in leg.relations)
        told = [(b, sought) for b, sought in sources if isinstance(b, BalanceTrace) and (b.since, b.stop) == q.at]
        for b, sought in told:
            for words, work in b.brought:
                same = words.split()[-1:] == list(q.things) and span.formula is not None
                if same and value.known(work) and value.known(span.formula) and value.is_zero(work - span.formula):
                    above = () if work.free_symbols & set(sought) else (", as above",)
                    return (line(Name(b.law.bring), f" of the {words}", *above),)
        return ()

    def _shown(
        self, formula: sp.Expr, span: SpanIntegral | None, unit: Unit | None, values: list[Value], phrases: Phrases
    ) -> list[Math]:
        """The formula as it is printed and its numbers, before its values; the numbers alone where it is long or hides
        units.
        """
        if formula.is_number or (span is not None and formula == span.symbol):
            return []
        if formula.is_Symbol:
            own = untold(formula, self.found)
            made = [] if own is None or own.is_number else [own]
            return [self.phrases.math(e) for e in (formula, *made)] if span is None else []
        if span is None and values and (put := at_a_time(formula, self.found)) is not None:
            return [self.phrases.math(put)]
        if span is None and (frequency := by_frequency(formula, self.found, phrases)):
            return frequency
        if values and (longer(formula, FEW) or not self._is_clean(formula, unit)):
            own = formula.free_symbols & set(self.found.general)
            found = in_known(formula, own, values[0], phrases)
            if found or not own:
                return found
        if self._is_long(formula):
            return []
        short = closed_value(formula, self.found)
        short = along_the_line(formula, self.found) if short is None else short
        shown = [formula] if short is None else [formula, short]
        return [*map(self.phrases.math, shown), *(phrases.substituted(shown[-1], values[0]) if values else [])]

    def _is_clean(self, formula: sp.Expr, unit: Unit | None) -> bool:
        """Do its letters make the unit that is asked for?"""
        return is_clean(self.phrases.ledger, formula, dimension=None if unit is None else unit.dimension)

    def _values(self, asked: Request, unit: Unit, part: sp.Expr) -> list[Value]:
        """The value in the units of the page and in that which is asked."""
        energy = is_energy(asked.find.found.what)
        value = Decimal(0) if self.found.value.is_zero(part) else self.found.value(part)
        return self.phrases.in_units(value, unit, energy)

    def _signed(self, expr: sp.Expr) -> sp.Expr:
        """|a| and sign a by the number that a has at its state; the direction of (a cos x, a sin x) where it is x."""
        route = self.found.route
        if self.phrases.symbolic and not longer(expr, SHORT):
            expr = expr.replace(lambda x: x.is_Pow and x.exp in (HALF, -HALF), lambda x: sp.factor(x.base) ** x.exp)
        if not expr.has(sp.Abs, sp.sign, sp.atan2):
            return expr
        if not self.phrases.symbolic:
            expr = expr.replace(lambda x: isinstance(x, sp.atan2), self._direction)

        def sense(a: sp.Expr) -> int:
            if not self.phrases.symbolic or a.free_symbols <= route.settled:
                return int(self.found.value.known(sp.sign(a)) or 0)
            # Of letters without numbers only what they are made of tells a sign.
            made = a
            for _ in route.steps:
                made = made.xreplace(dict(route.formulas))
            made = simplified(made)
            return 1 if made.is_positive else -1 if made.is_negative else 0

        def put(x: Any) -> Any:
            s = sense(x.args[0])
            return x if not s else (s * x.args[0] if isinstance(x, sp.Abs) else sp.Integer(s))

        if not expr.has(sp.Abs, sp.sign):
            return expr
        return simplified(expr.replace(lambda x: isinstance(x, sp.Abs | sp.sign), put))

    def _direction(self, found: sp.Expr) -> sp.Expr:
        y, x = found.args
        for sine in sorted(y.atoms(sp.sin), key=sp.default_sort_key):
            angle = sine.args[0]
            if y / sine == x / sp.cos(angle) and self.found.value.is_zero(found - angle):
                return angle
        return found


def _at(request: Request) -> str:
    """The state at which something is asked; "" of several or none."""
    what = request.find.found.what
    nodes = (n for n in walk(what) if isinstance(n, Quantity | Letter | Grouped | Function))
    found = {n.at for n in nodes if isinstance(n.at, str)}
    return found.pop() if len(found) == 1 else ""


def _along_its_direction(part: sp.Expr) -> sp.Expr:
    """What a component along a slanting line comes to where it was taken of components along x and y: J_N for
    J_N sin² β + J_N cos² β.
    """
    if longer(part, LONGEST) or len(part.atoms(sp.sin, sp.cos)) < 2:
        return part
    found = trigonometric(expanded(part))
    return found if 2 * operations(found) < operations(part) else part


def _without(expr: sp.Expr, zeros: Mapping[sp.Symbol, sp.Expr]) -> sp.Expr:
    """An expression without letters that are zero."""
    found = expr.xreplace(dict(zeros))
    return expr if found.has(sp.nan, sp.zoo) else found
