"""Laws between two states told: balances of an amount, and blows."""

from __future__ import annotations

import re
from collections.abc import Collection, Iterator, Mapping, Sequence
from dataclasses import field, replace
from typing import Any

import sympy as sp

from planar_cli.equation.algebra.plain import longer, simplified
from planar_cli.problem.language.expression import Number
from planar_cli.problem.scene.impulse_letters import impulse_letters
from planar_cli.records import changing
from planar_cli.report.document.blocks import Block, Equation, Forces, Line, Math, Name, Paragraph, Text, line
from planar_cli.report.energy.alike import told_of_each, weights_of_each
from planar_cli.report.energy.earlier_balances import EarlierBalances
from planar_cli.report.energy.energies import EnergyTelling
from planar_cli.report.energy.energy_lines import comes_at_once
from planar_cli.report.energy.energy_of_groups import balance_in_letters, by_turning_and_sliding
from planar_cli.report.energy.energy_pieces import EnergyPieces
from planar_cli.report.energy.idle_reactions import MOST_NAMED
from planar_cli.report.energy.same_heights import with_same_heights
from planar_cli.report.energy.standing import standing, standing_lines
from planar_cli.report.energy.turning_groups import Turning, by_group, group_lines, turning_group
from planar_cli.report.in_numbers.put_in import put_in
from planar_cli.report.kinetics.forces import force_rows
from planar_cli.report.kinetics.one_body import NOTHING, struck_together
from planar_cli.report.momentum.given_momenta import by_given_letters
from planar_cli.report.momentum.heads_of_blows import is_conserved, no_rebound, passing, together, unchanged
from planar_cli.report.momentum.modes_of_blows import said_of_modes
from planar_cli.report.momentum.momenta import MomentumTelling, in_its_sense
from planar_cli.report.momentum.moments_of_blows import Named, with_letters
from planar_cli.report.momentum.negligible import FiniteForces
from planar_cli.report.momentum.nil_impulses import nil_beside
from planar_cli.report.notation.by_geometry import by_geometry
from planar_cli.report.notation.clean import is_clean
from planar_cli.report.notation.reciprocals import with_reciprocals
from planar_cli.report.notation.spread import each_half
from planar_cli.report.words.counted import counts_the_other_way, opposite
from planar_cli.report.words.sides import said
from planar_cli.report.words.words import Phrases
from planar_cli.solve.between.trace.trace import BalanceTrace, Impact, ImpactEquation
from planar_cli.solve.solution import InstantSolution
from planar_cli.units import ANGULAR_MOMENTUM, ENERGY, IMPULSE, LENGTH, Dimension

LONGEST = 60
SHORT, SOME, FEW = 36, 24, 16
"""A longer equation is told with its numbers, where it has some; one whose parts were told with theirs; and such a one
in which one unknown stands plainly.
"""
AT_ONCE = "each with its own restitution: Newton's law at every contact. One after the other they would end otherwise."
BLOW = ("momentum before + impulses", "momentum after")
"""What stands over both sides of the diagrams of a blow."""


@changing
class BetweenTelling:
    """Tells equations between states. `plain`: letters that are data, with what they are."""

    phrases: Phrases
    plain: Mapping[sp.Symbol, sp.Expr]
    numeric: Phrases
    """In which is told what rests on no letter without a number."""
    unknowns: Collection[sp.Symbol] = ()
    """What the equation at hand is solved for."""
    geometry: Collection[sp.Expr] = ()
    """What vanishes by relations of places from which these follow together with the equation at hand."""
    long: bool = False
    """Is its solution a long formula?"""
    lettered: bool = False
    """Does it come as a formula of letters, in which numbers are put in last?"""
    told: set[str] = field(default_factory=set)
    earlier: EarlierBalances = field(default_factory=EarlierBalances)
    made: set[sp.Symbol] = field(default_factory=set)
    """What momenta are made of, and impulses, that were told."""
    groups: dict[str, Turning] = field(default_factory=dict)
    """By the state, bodies that turn together, whose moment of inertia was told."""
    counted: set[int] = field(default_factory=set)
    """The numbers of equations in which numbers were put in at once."""
    used: Collection[sp.Symbol] = ()
    """The letters in all equations of blows, and in what is asked."""
    nil: Collection[tuple[sp.Symbol, str]] = ()
    """Impulses that the file says are zero, each with the state before its blow."""
    axes: Mapping[sp.Symbol, sp.Expr] = field(default_factory=dict)
    """Moments of inertia about the points at which blows hold bodies."""
    drawn: Mapping[sp.Symbol, sp.Expr] = field(default_factory=dict)
    """Letters of states in the given position, with what they are in letters of the file."""
    springs: Mapping[str, tuple[str, sp.Symbol]] = field(default_factory=dict)
    """By their words those that have a natural length: their length by their ends, and the letter of that."""
    alone: Collection[str] = ()
    """The states before blows of which one equation tells all, which changes nothing."""
    by_rule: Collection[str] = ()
    """The states before blows of which only the law of restitution is used: they need no diagram."""
    balanced: Mapping[str, Sequence[tuple[str, ...]]] = field(default_factory=dict)
    """By the state before a blow, the groups of bodies of its balances."""
    finite: FiniteForces | None = None
    """The finite forces whose impulses are negligible."""
    named: Named | None = None
    """The equation that was told last, where arms in it have names."""

    def blocks(self, source: BalanceTrace | ImpactEquation, number: int) -> Iterator[Block]:
        """One equation with its heading; `source`: what it was planned from."""
        self.named = None
        if isinstance(source, BalanceTrace):
            if source.law.letter and self._has_numbers(source):
                yield from self.earlier.headed(self._heading(source), self._energies(source, number), source.since)
            else:
                yield from (Paragraph(self._heading(source)), *self._balance(source, number))
        else:
            yield from self._drawn(source.impact)
            yield from self._impact(source, number)

    def _put(self, expr: sp.Expr) -> sp.Expr:
        put = sp.sympify(expr).xreplace(dict(self.plain))
        return put if longer(put, LONGEST) else with_reciprocals(simplified(put))

    # --- balances ----------------------------------------------------------------------------------------------------

    def _balance(self, b: BalanceTrace, number: int) -> Iterator[Block]:
        """An amount at two states, and what is brought between them."""
        b = in_its_sense(b, self._put)
        law, before, after = b.law, self._put(b.before), self._put(b.after)
        lead = line(law.lead, Name(law.name), ":") if law.name else line(law.lead)
        if not law.letter:
            yield from MomentumTelling(b, self.unknowns, self.numeric, self.plain, self.made).lines()
            whole = self._equation(before + self._put(b.gain), after, number, lead, dimension_of_balance(b))
            group = turning_group(b, self.numeric, self._put) if number in self.counted else None
            if group is not None:
                yield from group_lines(group, number, lead, law.about)
                self.groups |= {b.since: group[0], b.stop: group[1]}
                whole = replace(whole, number=None, lead=line(f"({number}) in numbers:"))
            yield whole
            return
        first, last = f"{law.letter}__{b.since}", f"{law.letter}__{b.stop}"
        telling = EnergyTelling(b, self.unknowns, self.phrases, self.plain, set(), ())
        still = standing(telling)
        after = self._put(after - sp.Add(*still.values())) if still else after
        amounts = [(body, put) for body, e in b.amounts if body not in still and (put := self._put(e)) != 0]
        at_rest = before == 0 and not amounts and not still
        yield Equation((line(Name(first)), *([line(Name(last))] if at_rest else []), self.phrases.math(before)))
        yield from standing_lines(telling)
        for i, bodies in told_of_each(amounts).items():
            each = f" of {bodies}" if len(amounts) > 1 else ""
            put = amounts[i][1]
            own = [body for body, e in amounts if e == put]
            yield from telling.in_letters(own, put, line(Name(last), each))
        if len(amounts) > 1 or not (amounts or at_rest):
            yield Equation((line(Name(last)), self.phrases.math(after)))
        brought = [(words, put) for words, e in b.brought if (put := self._put(e)) != 0]
        for i, words in weights_of_each(brought).items():
            yield Equation((line(Name(law.bring), f" of the {words}"), self.phrases.math(brought[i][1])))
        gain = sp.Add(*(put for _, put in brought))
        lead = line(Name(first), " + ", Name(law.bring), " = ", Name(last), ":")
        told = self._ordered(before + gain, [before, *(put for _, put in brought)])
        yield Equation((told, self.phrases.math(after)), number, lead)

    def _has_numbers(self, b: BalanceTrace) -> bool:
        """Has everything a number that is not sought?"""
        letters = (b.before + b.after + b.gain).xreplace(dict(self.plain)).free_symbols
        return all(self.numeric.has_numbers(s) for s in letters - set(self.unknowns))

    def _energies(self, b: BalanceTrace, number: int) -> Iterator[Block]:
        """Energies one by one with their numbers, then their balance."""
        first, last = f"{b.law.letter}__{b.since}", f"{b.law.letter}__{b.stop}"
        lead = line(Name(first), " + ", Name(b.law.bring), " = ", Name(last), ":")
        pieces = EnergyPieces(b, self.unknowns, self.numeric, self.plain, set(), self.geometry, drawn=self.drawn)
        b = with_same_heights(pieces)
        gains = [by_geometry(self._put(e), self.geometry, self.unknowns) for _, e in b.brought]
        parts = [put for put in (self._put(b.before), *gains) if put != 0]
        gain = self._put(b.gain)
        # What is the same in all works is not taken out of their sum: each of them was told.
        apart = bool(self.geometry) or (gain.is_Mul and bool(gain.free_symbols & set(self.unknowns)))
        whole = self._put(b.before) + (sp.Add(*gains) if apart else gain)
        ending = tuple(self._put(e) for _, e in b.amounts)
        told = self._equation(whole, each_half(self._put(b.after)), number, lead, ENERGY, parts, ending)
        bare = self.lettered and number not in self.counted
        made = (self.unknowns, self.numeric, self.plain, self.earlier.ends, self.geometry, self.axes)
        telling = EnergyTelling(b, *made, bare=bare, drawn=self.drawn, springs=self.springs)
        lines = by_group(telling.lines(), first, self._put(b.before), self.groups.get(b.since), self.numeric)
        moving = () if b.parts is None else tuple(zip(b.parts.moving, (m.mass for m in b.law.moving), strict=True))
        at_end = self._put(b.after), self.unknowns, moving
        listed = list(by_turning_and_sliding(lines, (first, last), at_end, self.groups.get(b.stop), self.numeric))
        sides = balance_in_letters(telling, LONGEST) if number in self.counted else ()
        sides = () if self.earlier.have_works(listed, b) else sides
        at_once = comes_at_once(listed, () if self._put(b.before) else sides, told)
        yield from self.earlier.lines(listed, b, at_once, told)
        if sides:
            yield Equation(sides, number, lead)
            told = replace(told, number=None, lead=line(f"({number}) in numbers:"))
        yield told

    def _equation(
        self,
        left: sp.Expr,
        right: sp.Expr,
        number: int,
        lead: Line,
        dimension: Dimension | None = None,
        parts: Sequence[sp.Expr] = (),
        ending: Sequence[sp.Expr] = (),
    ) -> Equation:
        """An equation in letters where that is short and hides no unit; else with its numbers put in. `parts`,
        `ending`: of both sides, which were told one by one.
        """
        plain = bool(parts) and self._is_plain(left - right)
        most = (0 if self.long else FEW) if plain else SOME if parts else SHORT
        short = not longer(left - right, most) and is_clean(self.phrases.ledger, left, right, dimension=dimension)
        found = None if short else put_in(parts or left, right, self.unknowns, self.numeric, dimension, ending)
        if found is None:
            return Equation((self._ordered(left, parts), self.phrases.math(right)), number, lead)
        self.counted.add(number)
        return Equation(found.sides, number, lead, found.note)

    def _ordered(self, left: sp.Expr, parts: Sequence[sp.Expr]) -> Math | Line:
        """A side with its terms in the order in which they were told: the kinetic energy, then the works."""
        shown = self.phrases.math(left)
        terms = [self.phrases.math(p) for p in parts]
        if len(parts) < 2 or {t.expr for t in terms} != set(sp.Add.make_args(shown.expr)):
            return shown
        pieces: list[Any] = []
        for term in terms:
            negative = bool(pieces) and term.expr.could_extract_minus_sign()
            pieces += [" - " if negative else " + "] if pieces else []
            pieces.append(Math(-term.expr) if negative else term)
        return line(*pieces)

    def _is_plain(self, residual: sp.Expr) -> bool:
        """Does one unknown alone stand in it, as itself or as its square?"""
        unknown, *more = residual.free_symbols & set(self.unknowns) or (None,)
        if unknown is None or more:
            return False
        once, twice = sp.diff(residual, unknown), sp.diff(residual, unknown, 2)
        return unknown not in twice.free_symbols and (twice == 0 or simplified(once - twice * unknown) == 0)

    def _heading(self, b: BalanceTrace) -> Line:
        law = b.law
        group = f"{', '.join(law.bodies)}: " if law.bodies else ""
        words = (law.kept if b.gain == 0 else "") or law.heading or law.words
        head = f"From {b.since} to {b.stop}, {group}{words}"
        about = Name(law.about) if law.about else ""
        return line(head, about, law.explained, *self._through(law.passing), *self.earlier.said_idle(law), ":")

    def _through(self, forces: tuple[sp.Expr, ...]) -> list[Any]:
        """The forces that have no moment, as they pass through the point."""
        if not forces or len(forces) > MOST_NAMED or any(longer(f, FEW) for f in forces):
            return []
        parts: list[Any] = [", through which "]
        for i, force in enumerate(forces):
            parts += [" and " if i == len(forces) - 1 and i else ", " if i else "", self.phrases.math(force)]
        return [*parts, " pass" if len(forces) > 1 else " passes"]

    # --- blows -------------------------------------------------------------------------------------------------------

    def _drawn(self, impact: Impact) -> Iterator[Block]:
        """The bodies with their momenta before the blow and all impulses, once."""
        solution = impact.solution
        if impact.since in self.told or solution is None or impact.since in self.by_rule:
            return
        self.told.add(impact.since)
        rows, nil = self._rows(impact, solution)
        finite = self.finite.beside(impact.since, solution, nil, rows) if self.finite else ()
        yield Paragraph(line(f"Just after {impact.since}: momentum before + impulses = momentum after", *finite, "."))
        if impact.impacts > 1:
            yield Paragraph(line(f"{impact.impacts} impacts at once, {AT_ONCE}"))
        yield from said_of_modes(solution)
        for letter, side in impulse_letters(solution.instant.scene.problem).values():
            if not isinstance(side, Number) and (written := said(side, self.phrases.figures)):
                symbol = solution.instant.scene.ledger.symbols[letter]
                yield Equation((self.phrases.math(symbol), written, self.phrases.shown(symbol)))
        yield from struck_together(rows, solution, impact.since, self.balanced.get(impact.since, ()))

    def _rows(self, impact: Impact, solution: InstantSolution) -> tuple[list[Forces], set[sp.Symbol]]:
        """The diagrams of a blow, and the impulses that they do without."""
        scene, stage = solution.instant.scene, solution.stages[0]
        phrases = Phrases(scene.ledger, solution.value, self.phrases.figures, self.phrases.symbolic)
        # A velocity that is zero after the blow and stands in no equation is not drawn.
        speeds = dict.fromkeys(s for parts in stage.accelerations.values() for _, c in parts for s in c.free_symbols)
        idle = [s for s in speeds if s not in self.used and self.phrases.value.vanishes(s)]
        stage = replace(stage, zero=(*stage.zero, *idle))
        nil = {symbol for symbol, since in self.nil if since == impact.since} | nil_beside(solution, stage, self.used)
        rows = force_rows(solution, stage, phrases, inertia_as_force=False, impulsive=True, nil=nil)
        rows = [by_given_letters(row, self.plain) for row in rows]
        return [replace(row, heads=BLOW) for row in rows if (row.left, row.right) != (NOTHING, NOTHING)], nil

    def _impact(self, e: ImpactEquation, number: int) -> Iterator[Block]:
        left, right = self._put(e.left), self._put(e.right)
        self.named = None if self.phrases.symbolic else with_letters(e, left, right, self.phrases)
        if self.named is not None:
            left, right = self.named.left, self.named.right
        terms = [t for side in (left, right) for t in sp.Add.make_args(side) if t != 0]
        if e.law == "force" and not e.lead and e.along and all(t.could_extract_minus_sign() for t in terms):
            # Counted in the sense in which its terms are positive.
            left, right, e = -left, -right, replace(e, along=(-e.along[0], -e.along[1]))
        turn = -1 if e.law != "force" and counts_the_other_way(left, right, e.law == "moment") else 1
        left, right = (left, right) if turn > 0 else (opposite(left), opposite(right))
        self.named = None if self.named is None else replace(self.named, left=left, right=right)
        if e.together is not None:
            yield Paragraph(together(*e.together))
        yield Paragraph(self._at_blow(e))
        told = self._equation(left, right, number, self._lead(e, turn))
        yield told if self.named is None or told.note else replace(told, note=self._arms(self.named))

    def _at_blow(self, e: ImpactEquation) -> Line:
        """The heading of an equation, after which blow where no diagram has told it."""
        head = line(*self._head(e), ":")
        if e.impact.since not in self.by_rule or not isinstance(head[0], Text):
            return head
        words = head[0].text
        return line(f"Just after {e.impact.since}, {words[:1].lower()}{words[1:]}", *head[1:])

    def _arms(self, named: Named) -> Line:
        """The lengths of arms that have their letters from their ends, where they come first."""
        units = self.phrases.ledger.units
        lengths = [s for s in named.sizes if units[s].dimension == LENGTH and s not in self.made]
        self.made |= set(lengths)
        values = [self.phrases.of_dimension(named.sizes[s], LENGTH) for s in lengths]
        pieces = (
            p for i, (s, v) in enumerate(zip(lengths, values, strict=True)) for p in (", " * bool(i), Math(s), " = ", v)
        )
        return line(*pieces)

    def solved(self, unknown: sp.Symbol, shown: Any) -> tuple[Any, ...]:
        """unknown = formula = numbers = value, by the letters of the equation told last; empty: it has none."""
        formula = None if self.named is None else self.named.solved(unknown)
        if self.named is None or formula is None or longer(formula, FEW):
            return ()
        if not is_clean(self.phrases.ledger, unknown, formula):
            return ()
        put = self.numeric.numbers(formula, self.named.sizes)
        return () if put is None else (self.phrases.math(unknown), Math(formula), put, shown)

    def kept(self, e: ImpactEquation, result: Equation) -> Iterator[Block]:
        """An equation of a blow that gives at once a velocity that is zero, or what it was. `result`: its letter with
        the value.
        """
        if e.impact.since not in self.alone:
            yield from self._drawn(e.impact)
        zero = self._put(e.left) == 0 and e.law != "relation"
        stays = () if zero else unchanged(e, self._through(passing(e, self.used)))
        why = ", zero before, and no impulse changes it" if zero else ""
        yield Paragraph(line(*(stays or self._head(e, kept=zero)), f"{why}:"))
        yield result

    def _head(self, e: ImpactEquation, kept: bool = False) -> Line:
        """Of which bodies an equation of a blow is, and what it balances; `kept`: as no impulse changes it."""
        group = ", ".join(e.bodies)
        if e.law == "relation":
            words = no_rebound(e) or e.lead or e.words
            return line(f"{words[:1].upper()}{words[1:]}")
        if e.law == "moment":
            return self._about(e, group, () if kept else passing(e, self.used))
        if e.lead and is_conserved(e):
            return line(f"{group}: conservation of momentum along {e.lead} (no external impulse)")
        if e.lead:
            return line(f"{group}, momentum along {e.lead}")
        return line(f"{group}, momentum ", *_across(e.words))

    def _lead(self, e: ImpactEquation, turn: int = 1) -> Line:
        """What stands before an equation of a blow: the sense in which it counts."""
        if e.law == "relation":
            return ()
        if e.law == "moment":
            return line("↺ " if turn > 0 else "↻ ", Name(f"H_{point_at(e) or e.lead}"), ":")
        return line(f"{self.phrases.along(e.along)} ")

    def _about(self, e: ImpactEquation, group: str, passing_by: tuple[sp.Expr, ...]) -> Line:
        if e.centre is None:
            return line(f"{group}, angular momentum about ", Name(e.lead), *self._through(passing_by))
        if at := point_at(e):
            return line(f"{group}, angular momentum about ", Name(at), *self._through(e.centre.through))
        x, y = (self.phrases.math(self._put(p)) for p in (e.centre.x, e.centre.y))
        through = e.centre.through
        parts: list[Any] = [f"{group}, angular momentum about ", Name(e.lead), " at (", x, ", ", y, ")"]
        if through:
            parts += [", where ", self.phrases.math(through[0]), " and ", self.phrases.math(through[1]), " meet"]
        return line(*parts)


def point_at(e: ImpactEquation) -> str:
    """The point of the file that lies where two impulses meet, which needs no other name; "" for none."""
    solution = e.impact.solution
    if e.centre is None or solution is None:
        return ""
    value, points = solution.value, solution.instant.scene.points
    apart = {name: (place.x - e.centre.x, place.y - e.centre.y) for name, place in points.items()}
    return next((name for name, (x, y) in apart.items() if value.is_zero(x) and value.is_zero(y)), "")


def dimension_of_balance(b: BalanceTrace) -> Dimension:
    """What a balance counts: energy, or linear or angular momentum."""
    return ENERGY if b.law.letter else ANGULAR_MOMENTUM if b.law.about else IMPULSE


def _across(words: str) -> Line:
    """`across J_N_hit`, with the names of impulses set as mathematics: across their line of action."""
    pieces = re.split(r"(\bJ_\w+)", words)
    named = line(*(Name(p) if i % 2 else p for i, p in enumerate(pieces) if p))
    return line("across the line of ", *named[1:]) if words.startswith("across J_") else named
