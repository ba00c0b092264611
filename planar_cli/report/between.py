"""Laws between two states told: work and kinetic energy, impulse and momentum, and blows."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field, replace
from typing import Any

import sympy as sp

from planar_cli.equation.plain import longer, simplified
from planar_cli.report.blocks import Block, Equation, Line, Math, Name, Paragraph, line
from planar_cli.report.forces import force_rows
from planar_cli.report.words import Phrases
from planar_cli.solve.course.blow import Blow
from planar_cli.solve.course.impulse_momentum import Momentum
from planar_cli.solve.course.unfolded import Unfolded
from planar_cli.solve.course.work_energy import Balance
from planar_cli.solve.solution import InstantSolution
from planar_cli.solve.stages import Stage
from planar_cli.solve.write import Written

LONGEST, MOST_NAMED = 60, 8
AT_ONCE = "each with its own restitution: Newton's law at every contact. One after the other they would end otherwise."
FINITE = "weights, springs and other finite forces have no impulse in no time"


@dataclass(slots=True)
class BetweenTelling:
    """Tells equations between states. `plain`: letters that are data, with what they are."""

    found: Unfolded
    phrases: Phrases
    plain: Mapping[sp.Symbol, sp.Expr]
    told: set[int] = field(default_factory=set)

    def blocks(self, source: Any, number: int) -> Iterator[Block]:
        """One equation with its heading; `source`: what it was planned from."""
        if isinstance(source, Balance):
            yield from self._energy(source, number)
        elif isinstance(source, Momentum):
            yield from self._momentum(source, number)
        else:
            blow, written = source
            yield from self._drawn(blow)
            yield from self._blow(blow, written, number)

    def _put(self, expr: sp.Expr) -> sp.Expr:
        put = sp.sympify(expr).xreplace(dict(self.plain))
        return put if longer(put, LONGEST) else simplified(put)

    # --- work and energy ---------------------------------------------------------------------------------------------

    def _energy(self, b: Balance, number: int) -> Iterator[Block]:
        head = f"From {b.since.name} to {b.stop.name}, work and kinetic energy"
        yield Paragraph(line(head, *self._idle(b), ":"))
        before = self._put(b.before)
        first, last = f"T_{b.since.name}", f"T_{b.stop.name}"
        yield Equation((line(Name(first)), self.phrases.math(before)))
        for body, kinetic in b.kinetic if len(b.kinetic) > 1 else ():
            put = self._put(kinetic)
            if put != 0:
                yield Equation((line(Name(last), f" of {body}"), self.phrases.math(put)))
        after = self._put(b.after)
        yield Equation((line(Name(last)), self.phrases.math(after)))
        works = [(w.words, put) for w in b.works if (put := self._put(w.value)) != 0]
        for words, put in works:
            yield Equation((line(Name("U"), f" of the {words}"), self.phrases.math(put)))
        work = sp.Add(*(w for _, w in works))
        lead = line(Name(first), " + ", Name("U"), " = ", Name(last), ":")
        yield Equation((self.phrases.math(before + work), self.phrases.math(after)), number, lead)

    @staticmethod
    def _idle(b: Balance) -> list[Any]:
        """Which reactions do no work."""
        if len(b.idle) > MOST_NAMED:
            return ["; the reactions of all ideal joints do no work"]
        named = [part for i, s in enumerate(b.idle) for part in (", " if i else "; ", Math(s))]
        return [*named, " do no work" if len(b.idle) > 1 else " does no work"] if named else []

    # --- impulse and momentum ----------------------------------------------------------------------------------------

    def _momentum(self, m: Momentum, number: int) -> Iterator[Block]:
        group = ", ".join(m.bodies)
        kept = m.impulse == 0
        law = "conservation of momentum" if kept and not m.about else "impulse and momentum"
        if m.about:
            law = f"{'conservation of angular' if kept else 'angular impulse and'} momentum about "
        head = line(f"From {m.since.name} to {m.stop.name}, {group}: {law}", Name(m.about) if m.about else "", ":")
        yield Paragraph(head)
        before, after = self._put(m.before), self._put(m.after)
        lead = line("↺ ", Name(f"H_{m.about}"), ":") if m.about else line(m.arrow)
        left = before + self._put(m.impulse)
        yield Equation((self.phrases.math(left), self.phrases.math(after)), number, lead)

    # --- blows -------------------------------------------------------------------------------------------------------

    def _drawn(self, blow: Blow) -> Iterator[Block]:
        """The bodies with their momenta before the blow and all impulses, once."""
        if id(blow) in self.told or blow.stage is None:
            return
        self.told.add(id(blow))
        words = f"Just after {blow.since.name}: momentum before + impulses = momentum after ({FINITE})."
        yield Paragraph(line(words))
        hits = [j for j in blow.struck.joints if j.strikes and blow.system.modes[j.name].facts.pushes]
        if len(hits) > 1:
            yield Paragraph(line(f"{len(hits)} impacts at once, {AT_ONCE}"))
        value = self._value(blow)
        solution = InstantSolution("", blow.struck, blow.trial, (), (blow.stage,), blow.stage.lines, value)
        phrases = Phrases(blow.scene.ledger, value, self.phrases.figures, self.phrases.symbolic)
        yield from force_rows(solution, _in_velocities(blow.stage), phrases, inertia_as_force=False)

    def _value(self, blow: Blow) -> Any:
        known = dict(self.found.value.values)
        places = {s: known[own] for s, own in blow.stop.letters.items() if own in known}
        return blow.scene.valuations[0].extended({**known, **places})

    def _blow(self, blow: Blow, w: Written, number: int) -> Iterator[Block]:
        left, right = self._put(blow.here(w.left)), self._put(blow.here(w.right))
        sides = (self.phrases.math(left), self.phrases.math(right))
        yield Paragraph(line(*self._head(blow, w), ":"))
        yield Equation(sides, number, _lead(w))

    def kept(self, source: tuple[Blow, Written], result: Equation) -> Iterator[Block]:
        """An equation of a blow that gives at once a velocity that is zero. `result`: its letter with the value."""
        blow, w = source
        yield from self._drawn(blow)
        before = self._put(blow.here(w.left))
        why = ", zero before, and no impulse changes it" if before == 0 and w.law != "relation" else ""
        yield Paragraph(line(*self._head(blow, w), f"{why}:"))
        yield result

    def _head(self, blow: Blow, w: Written) -> Line:
        """Of which bodies an equation of a blow is, and what it balances."""
        group = ", ".join(w.bodies)
        if w.law == "relation":
            words = w.lead or w.words
            return line(f"{words[:1].upper()}{words[1:]}")
        if w.law == "moment":
            return self._about(blow, w, group)
        if w.lead:
            return line(f"{group}, momentum along {w.lead}")
        return line(f"{group}, momentum ", *_across(w.words))

    def _about(self, blow: Blow, w: Written, group: str) -> Line:
        centre = None if blow.stage is None else blow.stage.centres.get(w.lead)
        if centre is None:
            return line(f"{group}, angular momentum about ", Name(w.lead))
        place, through = centre
        x, y = (self.phrases.math(self._put(blow.here(e))) for e in (place.x, place.y))
        parts: list[Any] = [f"{group}, angular momentum about ", Name(w.lead), " at (", x, ", ", y, ")"]
        if through:
            parts += [", where ", self.phrases.math(through[0]), " and ", self.phrases.math(through[1]), " meet"]
        return line(*parts)


def _lead(w: Written) -> Line:
    """What stands before an equation of a blow: the sense in which it counts."""
    if w.law == "relation":
        return ()
    if w.law == "moment":
        return line("↺ ", Name(f"H_{w.lead}"), ":")
    return line({"x": "→ ", "y": "↑ "}.get(w.lead, "↗ "))


def _across(words: str) -> Line:
    """`across J_N_hit`, with the names of impulses set as mathematics: across their line of action."""
    pieces = re.split(r"(\bJ_\w+)", words)
    named = line(*(Name(p) if i % 2 else p for i, p in enumerate(pieces) if p))
    return line("across the line of ", *named[1:]) if words.startswith("across J_") else named


def _in_velocities(stage: Stage) -> Stage:
    """A plan of a blow with the velocities just after it by its unknowns, where an instant names accelerations."""
    explicit = {x.symbol: x.expression for x in stage.lines}
    put = {b: [(d, c.xreplace(explicit)) for d, c in parts] for b, parts in stage.accelerations.items()}
    return replace(stage, accelerations=put)
