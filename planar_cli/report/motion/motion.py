"""A motion over time told: the law of every coordinate, integrated from state to state, solved for what is asked."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import Any

import sympy as sp

from planar_cli.equation.algebra.plain import longer, simplified
from planar_cli.problem.checks.check_dimensions import Kinds
from planar_cli.problem.checks.scope import Scope
from planar_cli.report.answers.asked_of_states import HENCE, AskedTelling
from planar_cli.report.document.blocks import Block, Equation, Heading, Math, Paragraph, line
from planar_cli.report.energy.energies_told import as_told
from planar_cli.report.equations.eliminated import lead_of, with_others_put_in
from planar_cli.report.equations.left_out import rejected
from planar_cli.report.equations.one_in_another import one_in_another, told_inserted
from planar_cli.report.equations.solved_in_letters import solved_in_letters, solved_in_numbers
from planar_cli.report.given.as_stated import as_written
from planar_cli.report.given.by_data import by_data
from planar_cli.report.given.data_of_states import datum_blocks
from planar_cli.report.given.terminal_speeds import terminal_first
from planar_cli.report.given.times_given import with_times_given
from planar_cli.report.given.told_at_once import is_by_functions, told_at_once
from planar_cli.report.in_numbers.angles_found import by_trial
from planar_cli.report.in_numbers.in_numbers import divides_by_zero
from planar_cli.report.in_numbers.put_in import in_known, put_in
from planar_cli.report.in_numbers.with_units import in_units_held
from planar_cli.report.laws.along_both_axes import headed_once
from planar_cli.report.laws.evaluated_integrals import by_its_function
from planar_cli.report.laws.flights import FlightTelling
from planar_cli.report.laws.inside_integrals import by_trial_values, inside_an_integral
from planar_cli.report.laws.integrals import in_times, over_coordinates, plain_integral
from planar_cli.report.laws.laws import LawTelling
from planar_cli.report.laws.passing import passing_blocks
from planar_cli.report.laws.products import product_blocks
from planar_cli.report.laws.rate_first import ToldRate, rate_first
from planar_cli.report.laws.roots_of_squares import is_long_root, rooted
from planar_cli.report.laws.span_integrals import SpanTelling
from planar_cli.report.laws.speed_by_balance import speed_by_balance
from planar_cli.report.laws.speed_laws import integrals_told
from planar_cli.report.laws.steady import in_order, with_law
from planar_cli.report.laws.zeros import that_vanish, without_zeros
from planar_cli.report.momentum.heads_of_blows import keeps
from planar_cli.report.momentum.idle_zeros import is_untold
from planar_cli.report.momentum.impulse_rows import before_leg
from planar_cli.report.momentum.motion_title import last_title
from planar_cli.report.momentum.nil_impulses import nil_impulses
from planar_cli.report.motion.between import dimension_of_balance
from planar_cli.report.motion.centres_put_in import centres_put_in
from planar_cli.report.motion.extremes import aims_told
from planar_cli.report.motion.first_state import first_state_first
from planar_cli.report.motion.in_order_of_time import states_of, states_told
from planar_cli.report.motion.integrated import integration_blocks
from planar_cli.report.motion.own_ways import told_by_itself, told_elsewhere
from planar_cli.report.motion.states_put_in import turning_blocks
from planar_cli.report.motion.telling_between import telling_between
from planar_cli.report.notation.by_geometry import geometry_beside
from planar_cli.report.notation.clean import is_clean
from planar_cli.report.notation.logarithms import of_ratios
from planar_cli.report.oscillation.at_quarters import with_number
from planar_cli.report.oscillation.harmonic import HarmonicTelling
from planar_cli.report.oscillation.periods_given import swings
from planar_cli.report.oscillation.phases import by_the_tangent, function_first
from planar_cli.report.words.motion_phrases import settled_phrases
from planar_cli.report.words.origins import (
    balanced,
    head,
    is_explicit,
    is_handed_on,
    is_outright,
    is_steady,
    letter_of,
    needed_results,
    needed_steps,
    says_zero,
    sides_of,
)
from planar_cli.report.words.state_words import at
from planar_cli.report.words.words import Phrases
from planar_cli.solve.between.trace.trace import (
    BalanceTrace,
    ImpactEquation,
    MotionTrace,
    Relation,
    Result,
    RouteStep,
    RouteTrace,
)

LONGEST, LETTERED, SHORT, PLAIN = 90, 30, 26, 12
"""A longer formula is told by its value alone, after its equation in numbers: of letters without numbers, of letters
that have numbers, of numbers, and of what mixes letters and numbers with units.
"""
FEW, MOST_SHOWN = 20, 60
"""Of more operations a balance of energies is solved in numbers; an equation in numbers is told in letters alone."""


class MotionTelling:
    """Tells the way to what is asked. `first`: the number of its first equation; `wanted`: names of letters whose
    derivation is told (None: all).
    """

    def __init__(self, found: MotionTrace, phrases: Phrases, first: int, wanted: frozenset[str] | None = None) -> None:
        self.found, self.phrases, self.next, self.wanted = found, phrases, first, wanted
        self.general, self.varying = found.general, found.varying
        self.numeric = settled_phrases(found, phrases)
        self.rates: list[ToldRate] = []
        self._steady: set[str] = set()
        self._laws = LawTelling(phrases, found.varying, found.regimes)
        self._flights = FlightTelling.of(found, phrases)
        self._open: set[sp.Symbol] = set()
        self._swings = HarmonicTelling(found, phrases, self._law)
        self.between = telling_between(found, phrases, self.numeric)
        self.aims: list[tuple[BalanceTrace, int]] = []
        """Balances that were told before their turn, with their numbers."""
        self.early: list[RouteStep] = []
        """What was told before the forces of a later part of the motion."""

    def blocks(self, step: int) -> list[Block]:
        """Step `step` of the solution; empty when the motion needs no step of its own."""
        if not (body := headed_once(self._body())):
            return []
        if not (title := last_title(self.found, self.early)):
            return body
        states = states_told(self.found.states, states_of(self.early, self.found))
        return [Heading(f"STEP {step}", title, states), *(body[1:] if body[0] == HENCE else body)]

    def _body(self) -> Iterator[Block]:
        yield from turning_blocks(self.found, self.phrases)
        yield from () if self.early else nil_impulses(self.found, self.phrases)
        functions = passing_blocks(self.found, self.phrases, self.told_route)
        yield from functions if is_by_functions(self.found) else ()
        way = [*self.told_route(self.found.route), *swings(self.found, self.phrases, self._one)]
        spans = SpanTelling(Kinds(Scope(self.found.problem, ())).of, self.phrases, self.varying)
        made = self.found, self.phrases, self.numeric, self.wanted, spans, self.rates, self.between.groups
        asked = as_told(AskedTelling(*made).blocks(), way, self.numeric)
        told = first_state_first(way, list(asked), self.found)
        yield from (*with_times_given(list(told), self.found, self.phrases), *functions)

    # --- the route ---------------------------------------------------------------------------------------------------

    def told_route(self, route: RouteTrace, only: Sequence[RouteStep] | None = None) -> Iterator[Block]:
        """What was not told yet of a route. `only`: these steps of it."""
        held = told_elsewhere(self.found)
        every = [leg for leg in needed_steps(route, self.wanted) if leg not in held and leg not in self.early]
        legs = [leg for leg in every if only is None or leg in only]
        given = [leg for leg in legs if leg.is_datum]
        followed = [leg for leg in given if leg.relations[0].kind == "followed"]
        derived = [leg for leg in legs if not is_untold(leg, self.found)]
        ahead, law = terminal_first(given, derived)
        yield from (b for leg in ahead for b in self._datum(leg))
        yield from self._laws.terminal_speed(law)
        yield from (b for leg in given if leg not in (*ahead, *followed) for b in self._datum(leg))
        first = [leg for leg in followed if any(not x.needs.isdisjoint(leg.unknowns) for x in derived)]
        yield from self._integrated(followed if first else [])
        for leg in derived:
            i = legs.index(leg)
            self._open = {x for later in every if later not in legs[:i] for x in later.unknowns}
            own, put = rooted(without_zeros(leg, route, [*self.early, *legs[:i]]), self.found)
            at_once = list(told_at_once(own, legs[i:], self.found, self.phrases, self._law))
            yield from at_once or self._leg(own, put)
        yield from self._integrated([] if first else followed)

    def _one(self, leg: RouteStep) -> Iterator[Block]:
        yield from self._datum(leg) if leg.is_datum else self._leg(*without_zeros(leg, self.found.route, []))

    def _integrated(self, legs: Sequence[RouteStep]) -> Iterator[Block]:
        """What only numbers tell: all of it together, where a later line rests on some of it before that line."""
        if legs:
            yield from integration_blocks(self.found, self.numeric, [r for leg in legs for r in leg.results])
        for leg in legs:
            yield from self._datum(leg)

    def _datum(self, leg: RouteStep) -> Iterator[Block]:
        return datum_blocks(leg, self.found, (self.phrases, self.numeric), self._chain, self._others, not self.wanted)

    def _leg(self, leg: RouteStep, route: RouteTrace) -> Iterator[Block]:
        yield from before_leg(leg, self.found, self.phrases, self.between.made)
        yield from self._flights.before(leg, self.number, lambda e: self._sides(e, route))
        equations, ledger = leg.relations, self.found.ledger
        numbers, single = list[int](), len(equations) == 1
        special = told_by_itself(leg, self.found, self.phrases, self.next, self._chain)
        if told := special or self._flights.at_state(leg, self._chain) or self._swings.by_phase(leg, self.next):
            self.next += sum(isinstance(b, Equation) and (b.number or 0) >= self.next for b in told)
            return (yield from told)
        for e in equations:
            yield from aims_told(e, leg, self)
            if before := [number for law, number in self.aims if law == e.source] or self._flights.number(e):
                numbers += before
                continue
            if single and e.kind == "link" and is_handed_on(leg.results[0]):
                return (yield Equation(self._chain(leg.results[0]), None, line(at(e.stop)), line(e.words)))
            if single and is_explicit(e, leg, route, ledger):
                yield from self._law(e)
                chain = by_its_function(e, route, self) or with_number(leg, self._chain, route, self.phrases)
                return (yield from (self._head(e, *chain), *self._integral(e, route), Equation(chain, self.number())))
            if single and (by_rate := list(rate_first(e, leg, route, self.numeric, self.next, self.rates))):
                self.next += 1
                yield from self._law(e)
                return (yield from by_rate)
            if single and e.span is not None and e.span.unevaluated and e.kind == "t(q)":
                yield from self._law(e)
                yield Paragraph(head(e, self.found.ledger.symbols))
                yield from self._integral(e, route)
                law = inside_an_integral(e, route, self.found, {*self.varying, *self._open}, self.phrases)
                return (yield from by_trial_values(law, (r := leg.results[0]), self._shown(r), self.number()))
            r = leg.results[0]
            if single and (keeps(e, r) or says_zero(e, r, route, ledger) or is_outright(e, r, route, ledger)):
                return (yield from self._zero(e, r, route))
            yield from self._relation(e, leg, route)
            numbers.append(self.next - 1)
        if (inserted := one_in_another(leg, self.found, route.plain)) is not None:
            return (yield from told_inserted(inserted, numbers, self.phrases, self._chain))
        named = () if len(leg.results) > 1 else self.between.solved(leg.results[0].unknown, self._shown(leg.results[0]))
        put = with_others_put_in(leg, route, numbers, self.phrases, self._is_told)
        yield from put or (() if named else self._in_numbers(leg, numbers, route))
        lead = lead_of(numbers, put)
        for i, r in enumerate(needed_results(leg, self.found)):
            plain = (formula := self._formula(r)) is not None and not longer(formula, PLAIN)
            known = not plain and set(numbers) <= self.between.counted
            sides = (self.phrases.math(r.unknown), self._shown(r)) if known else self._chain(r, explicit=False)
            if first := function_first(leg, r, route, set(numbers) <= self.between.counted, self.numeric):
                yield Equation(first, None, lead if i == 0 else ())
                by = by_the_tangent(leg, r, route, self.numeric)
                yield Equation((sides[0], *by, sides[-1], *self.phrases.converted(r.unknown, r.value)))
            else:
                if len(sides) == 2:
                    sides = (
                        sides[0],
                        *(solved_in_numbers(leg, r, route, self._shown(r), self.numeric) or self._short(r)),
                        sides[1],
                    )
                sides = (*(named or sides), *self.phrases.converted(r.unknown, r.value))
                yield Equation(sides, None, *((lead, by_trial(leg, r, len(sides), self.phrases)) if i == 0 else ()))
            if i == 0:
                yield from self._others(r)

    def _in_numbers(self, leg: RouteStep, numbers: list[int], route: RouteTrace) -> Iterator[Block]:
        """The equations once more with their numbers, where a value follows from them without a formula."""
        letters = self.phrases.symbolic and not set(leg.unknowns) <= route.settled
        if letters or all(self._is_told(r) or r.value.is_infinite() for r in leg.results):
            return
        for e, number in zip(leg.relations, numbers, strict=True):
            if number in self.between.counted or e.residual.free_symbols <= set(leg.unknowns):
                continue
            left, right = sides_of(e, route)
            balanced = dimension_of_balance(e.source) if isinstance(e.source, BalanceTrace) else None
            found = put_in(left, right, leg.unknowns, self.numeric, balanced)
            if found is not None and found.length <= MOST_SHOWN and not found.gives_value:
                yield Equation(found.sides, None, line(f"({number}) in numbers:"), found.note)

    def _short(self, r: Result) -> list[Math]:
        """A short formula whose numbers hide units, with its numbers."""
        return [] if r.formula is None or longer(r.formula, PLAIN) else self._in_known(r, PLAIN, explicit=False)

    def _is_told(self, r: Result) -> bool:
        """Does a formula stand before its value, or nothing at all?"""
        formula = self._formula(r)
        if formula is None:
            return r.formula is not None and r.formula.has(*self.general) and bool(self._in_known(r, 2 * PLAIN, False))
        return not formula.is_number or formula == 0

    def _zero(self, e: Relation, r: Result, route: RouteTrace) -> Iterator[Block]:
        """A relation that says at once that its letter is zero."""
        sides = self._chain(r)
        if isinstance(e.source, ImpactEquation):
            zeros = {s: sp.S.Zero for s, f in route.formulas.items() if f == 0}
            self.between.plain = {**zeros, **route.plain}
            return (yield from self.between.kept(e.source, Equation(sides, self.number())))
        yield from (Paragraph(head(e, self.found.ledger.symbols)), Equation(sides, self.number()))

    def _head(self, e: Relation, *sides: Any) -> Paragraph:
        """The heading of a relation with these sides; of constant acceleration with its law, once."""
        return with_law(head(e, self.found.ledger.symbols), e, sides, self._steady, self.phrases)

    def number(self) -> int:
        self.next += 1
        return self.next - 1

    def _law(self, e: Relation) -> Iterator[Block]:
        """The law of a coordinate, once."""
        told = speed_by_balance(e, self.found, self.phrases)
        yield from self._laws.blocks(e, self.found.route, self._open) if told is None else told

    def _relation(self, e: Relation, leg: RouteStep, route: RouteTrace) -> Iterator[Block]:
        if e.source is not None:
            self.between.plain, self.between.unknowns = route.plain, leg.unknowns
            self.between.geometry = geometry_beside(leg, route, self.found)
            self.between.long = any(r.formula is not None and longer(r.formula, FEW) for r in leg.results)
            self.between.lettered = solved_in_letters(leg, route, self.found, self.phrases, self._is_told)
            yield from self.between.blocks(e.source, self.number())
            return
        yield from self._law(e)
        swings = self._swings.blocks(e, leg, route, number := self.number())
        own = Equation(self._sides(e, route), number)
        yield self._swings.head(e, swings) or self._head(e, *(() if swings else own.sides))
        yield from swings or (*self._integral(e, route), own, *centres_put_in(e, self.phrases))

    def _integral(self, e: Relation, route: RouteTrace) -> Iterator[Block]:
        """The definite integrals with matching limits."""
        yield from product_blocks(e, route, self.found, self.phrases)
        span = e.span
        if span is None or span.left is None or span.right is None or is_steady(e):
            return
        if span.unevaluated and (e.kind != "t(q)" or span.explicit is not None):
            return
        sides = tuple(plain_integral(side, e, route, self.general) for side in (span.left, span.right))
        yield from integrals_told(e, sides, route, self, (self._laws.places, {*self.varying, *self._open}))

    def _sides(self, e: Relation, route: RouteTrace) -> tuple[Any, ...]:
        """A relation as left = right, its own letter on the left."""
        if ordered := in_order(e, dict(route.plain), self._neat, self.phrases) or as_written(e, self, route):
            return ordered
        residual = e.residual.xreplace(route.plain)
        if longer(residual, LONGEST) and e.kind == "extreme":
            return line("the rate of this quantity"), line("0")
        if (letter := letter_of(e, self.found.ledger)) is not None:
            own = letter**2 if e.kind == "v(q)" else letter
            if sp.diff(residual, own) == 1 if own.is_Symbol else residual.coeff(letter, 2) == 1:
                return self.phrases.math(own), in_units_held(own, self._neat(own - residual), self.phrases)
        explicit = e.span.explicit if e.span is not None and not e.span.unevaluated else None
        if explicit is not None and letter in route.plain:
            explicit = explicit.xreplace(route.plain)
            explicit = explicit if letter in self.found.route.plain else self._neat(explicit)
            explicit = explicit if route.plain[letter] else that_vanish(explicit, self._open)
            return self.phrases.math(explicit), self.phrases.math(route.plain[letter])
        if e.span is not None and e.span.unevaluated:
            left = plain_integral(e.span.left, e, route, self.general) if e.span.left is not None else residual
            right = plain_integral(e.span.right, e, route, self.general) if e.span.right is not None else sp.S.Zero
            return self.phrases.math(left), self.phrases.math(right)
        left, right = balanced(e, residual)
        return self.phrases.math(left), in_units_held(left, right, self.phrases)

    def _neat(self, expr: sp.Expr) -> sp.Expr:
        return expr if longer(expr, LONGEST) else in_times(simplified(expr), self.found)

    # --- results -----------------------------------------------------------------------------------------------------

    def _chain(self, r: Result, explicit: bool = True) -> tuple[Any, ...]:
        """letter = formula = numbers = value. `explicit`: no equation stands before it."""
        sides: list[Any] = [self.phrases.math(r.unknown)]
        if (formula := r.formula) is not None and formula.free_symbols & self.varying:
            return self.phrases.math(r.unknown), self.phrases.math(formula)
        self.between.earlier.ends.add((r.unknown, formula if formula is not None else r.unknown))
        formula, radians = self._formula(r), self.phrases.in_radians(r.unknown, r.formula, r.value)
        if formula is None and (known := self._in_known(r, LONGEST if explicit else 2 * PLAIN, explicit)):
            return self.phrases.math(r.unknown), *known, *radians, self._shown(r)
        phrases = self.numeric if r.unknown in self.found.route.settled else self.phrases
        if formula is not None and (not formula.is_number or phrases.symbolic):
            sides.append(in_units_held(r.unknown, formula, self.phrases))
            if not formula.is_Symbol:
                sides += phrases.substituted(formula, self._shown(r))
        if not phrases.symbolic:
            own = self.phrases.converted(r.unknown, r.value) if explicit else []
            sides += [*(radians if len(sides) > 1 else ()), self._shown(r), *own]
        elif formula is None:
            sides.append(line("the root that this motion reaches"))
        return tuple(sides)

    def _formula(self, r: Result) -> sp.Expr | None:
        """The formula of a result as it is printed; None: it is too long, or its numbers would hide units."""
        if r.formula is None or divides_by_zero(r.formula, self.numeric):
            return None
        formula = over_coordinates(of_ratios(r.formula, self.found.ledger), self.general)
        formula = by_data(in_times(formula, self.found), r.unknown, self.found)
        if self.phrases.symbolic:
            return None if longer(formula, LONGEST) else formula
        if formula.is_number or formula.has(sp.Integral):
            return formula
        long = longer(formula, LONGEST if formula.free_symbols & self._laws.natural else LETTERED)
        hides = long or is_long_root(formula, self.phrases) or not is_clean(self.found.ledger, r.unknown, formula)
        return None if hides else formula

    def _in_known(self, r: Result, most: int, explicit: bool) -> list[Math]:
        """The formula with its numbers, or letters of states and numbers for all else. `explicit`: as `_chain`; else a
        long formula is left out, as its equation stands in numbers.
        """
        if r.formula is None or self.phrases.symbolic or r.value.is_infinite() or r.formula.has(sp.Integral):
            return []
        long = not explicit and (longer(r.formula, SHORT) or is_long_root(r.formula, self.phrases))
        if long or divides_by_zero(r.formula, self.numeric):
            return []
        told = in_times(r.formula, self.found)
        return in_known(told, {*self.general}, self._shown(r), self.phrases, min(most, SHORT))

    def _shown(self, r: Result) -> Any:
        if r.value.is_infinite() or (self.phrases.symbolic and not r.value):
            return line("0" if not r.value else "∞" if r.value > 0 else "-∞")
        shown = self.phrases.shown(r.unknown, r.value)
        integrated = r.formula is not None and r.formula.has(sp.Integral)
        return line(shown, " by numerical integration") if integrated else shown

    def _others(self, r: Result) -> Iterator[Block]:
        """Roots that do not belong to this motion, each with the reason."""
        if r.unknown in self.general or r.unknown in self.found.named:
            phrases = self.numeric if r.unknown in self.found.route.settled else self.phrases
            told = {x for leg in needed_steps(self.found.route, self.wanted) for x in leg.unknowns}
            yield from rejected(self.found, r, phrases, told)
