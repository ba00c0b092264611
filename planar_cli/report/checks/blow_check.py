"""A check that a person can make of a blow: each impulse does the work J (u + u′)/2, and these make the kinetic energy.

    J (u + u′)/2 = 3.798 (-7.518 + 4.511)/2 = -5.711 J;  T′ - T = 12.05 - 17.76 = -5.711 J

u and u′ are the velocities of its point in its sense just before and just after the blow, of an impulse between two
bodies the velocity at which these part (Thomson and Tait, Treatise on Natural Philosophy, § 308).
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping
from dataclasses import replace
from decimal import Decimal
from typing import Any

import sympy as sp

from planar_cli.equation.values.exact import Unvalued
from planar_cli.equation.values.ledger import display
from planar_cli.problem.scene.facts import Push
from planar_cli.problem.scene.geometry import Vec
from planar_cli.records import record
from planar_cli.report.document.blocks import Line, Math, Name, Text, line
from planar_cli.report.in_numbers.sums import added, agree, chain, counting
from planar_cli.report.notation.enough_figures import figures_of
from planar_cli.report.notation.page_units import coherent_unit
from planar_cli.report.words.words import Phrases
from planar_cli.solve.between.trace.trace import Impact, ImpactEquation, MotionTrace
from planar_cli.units import ANGULAR_MOMENTUM, ENERGY, IMPULSE, RATE, VELOCITY

LETTERS = ("u", "c", "q", "s")
"""For a velocity in the check, the first that the file leaves free."""
DEFINED = "; u, u′: velocities along each J, before and after"
STRUCK = "; u, u′: velocity of the point struck along J, before and after"
PARTING = "; u, u′: velocity at which the two points part, before and after"
TURNING = "; ω, ω′: before and after"
MOST = 5
"""Works of impulses that fit a line."""
NIL = Decimal("1e-25")
"""A velocity that is no more than this part of the other one is rounding."""
STILL = Vec(Decimal(0), Decimal(0))


@record
class _Moving:
    """A body in numbers just before or just after a blow: the velocity of its mass centre, m/s, and ω, rad/s."""

    centre: Vec
    velocity: Vec
    spin: Decimal

    def at(self, point: Vec) -> Vec:
        return self.velocity + (point - self.centre).turned() * self.spin


GROUND = _Moving(STILL, STILL, Decimal(0))


@record
class _Work:
    """One impulse: its letter (None: a load of the file), its size and the velocities in its sense."""

    letter: sp.Expr | None
    size: Decimal
    """In N s; of a couple in N m s."""
    before: Decimal
    after: Decimal
    turns: bool
    """Is it a couple?"""
    pair: bool
    """Does it act between two bodies that move?"""

    @property
    def defined(self) -> str:
        """What the velocities are."""
        return TURNING if self.turns else PARTING if self.pair else STRUCK

    @property
    def done(self) -> Decimal:
        """J."""
        return self.size * (self.before + self.after) / 2


def _bodies(push: Push) -> set[str]:
    return {a.body for a in push.actions}


def blow_check(motion: MotionTrace, phrases: Phrases) -> Line:
    """Of the first blow all of whose impulses that do work have values; empty where there is none."""
    if motion.symbolic:
        return ()
    sources = [e.source for leg in motion.route.steps for e in leg.relations]
    impacts = {s.impact.since: s.impact for s in sources if isinstance(s, ImpactEquation)}
    for impact in impacts.values():
        try:
            if told := _told(impact, phrases, len(impacts) > 1):
                return _in_a_free_letter(told, phrases)
        except Unvalued:
            continue
    return ()


def _in_a_free_letter(told: Line, phrases: Phrases) -> Line:
    """The check with another letter for the velocities u and u′, where u is a letter of the file."""
    letter = next((x for x in LETTERS if x not in phrases.ledger.symbols), LETTERS[0])
    return tuple(Text(re.sub(r"\bu(?=\b|′)", letter, p.text), p.style) if isinstance(p, Text) else p for p in told)


def _told(impact: Impact, phrases: Phrases, several: bool) -> Line:
    if impact.solution is None:
        return ()
    numbers = _Blow(impact, phrases)
    works = [w for w in numbers.works() if not agree([w.before, w.after], [])]
    done = counting([w.done for w in works])
    before, after = numbers.energies()
    if len(done) > MOST or not (done or before) or not agree([*done, before], [after]):
        return ()
    unit = coherent_unit(ENERGY, False, phrases.ledger.us)
    head = f"blow after {impact.since}: " if several else "energy of the blow: "
    energy = numbers.energy
    energies = line(energy, "′ - ", energy, " = ", *chain(counting([after, -before]) or [after], unit, phrases, "J"))
    if not done:
        return line(head, "no impulse does work; ", *energies)
    if len(works) > 1:
        return line(head, "Σ J (u + u′)/2 = ", *chain(done, unit, phrases, "J"), "; ", *energies, DEFINED)
    told = line(*numbers.one(works[0]), " = ", *chain(done, unit, phrases, "J"))
    return line(head, *told, "; ", *energies, works[0].defined)


class _Blow:
    """A blow in numbers."""

    def __init__(self, impact: Impact, phrases: Phrases) -> None:
        assert impact.solution is not None
        self.phrases, self.system = phrases, impact.solution.trial.system
        self.value = impact.solution.value
        self.bodies = self.system.scene.bodies
        self.energy = Name(self.system.scene.problem.kinetic_energy)
        self.first = {b: self._before(b) for b in self.bodies} | {"ground": GROUND}
        self.last = {b: self._after(b) for b in self.bodies} | {"ground": GROUND}

    def number(self, expr: Any) -> Decimal:
        return Decimal(self.value(sp.sympify(expr)))

    def _vector(self, v: Vec) -> Vec:
        return Vec(self.number(v.x), self.number(v.y))

    def _before(self, body: str) -> _Moving:
        """By the momentum that it brings."""
        model, brought = self.bodies[body], [w for w in self.system.wrenches if (w.kind, w.body) == ("momentum", body)]
        forces = [self._vector(w.force) for w in brought if w.force is not None]
        turning = sum((self.number(w.couple) for w in brought), Decimal(0))
        mass = self.number(model.mass)
        velocity = sum(forces, STILL) / mass if mass else STILL
        return _Moving(
            self._vector(model.center), velocity, turning / self.number(model.inertia) if turning else Decimal(0)
        )

    def _after(self, body: str) -> _Moving:
        assert self.system.motion is not None
        twist, centre = self.system.motion.accelerations[body], self._vector(self.bodies[body].center)
        held = _Moving(self._vector(twist.point), self._vector(twist.linear), self.number(twist.angular))
        return _Moving(centre, held.at(centre), held.spin)

    def works(self) -> Iterator[_Work]:
        """Of all impulses, those of the file first."""
        for w in self.system.wrenches:
            if w.kind != "momentum":
                size = Decimal(1) if w.force is None else self._vector(w.force).dot(self._vector(w.force)).sqrt()
                unit = w.force if w.force is None or not size else w.force / sp.Rational(str(size))
                yield self._work(None, size, [(w.body, w.point, unit, w.couple)])
        assert self.system.reactions is not None
        for push, size in self.system.reactions.pushes:
            acting = [(a.body, a.point, a.force, a.couple) for a in push.actions]
            found = self._work(size, Decimal(1), acting)
            if found.before or found.after:
                yield replace(found, size=self._size(push, size))

    def _size(self, push: Push, size: sp.Expr) -> Decimal:
        """An impulse; one without a value by the change of momentum of a body on which nothing else acts. Raises
        Unvalued where there is none.
        """
        if self.value.known(size) is not None:
            return self.number(size)
        assert self.system.reactions is not None
        for a in push.actions:
            others = any(p is not push and a.body in _bodies(p) for p, _ in self.system.reactions.pushes)
            loaded = any(w.kind != "momentum" and w.body == a.body for w in self.system.wrenches)
            if a.body in self.bodies and not others and not loaded and a.force is not None:
                change = self.last[a.body].velocity - self.first[a.body].velocity
                return Decimal(self._own(self.bodies[a.body].mass) * change.dot(self._vector(a.force)))
        raise Unvalued(push.name)

    def _own(self, expr: sp.Expr) -> Decimal:
        """A mass or a moment of inertia. Raises Unvalued where its number was drawn."""
        if not self.phrases.has_numbers(sp.sympify(expr)):
            raise Unvalued(str(expr))
        return self.number(expr)

    def _work(self, letter: sp.Expr | None, size: Decimal, acting: list[Any]) -> _Work:
        speeds = []
        for moving in (self.first, self.last):
            parts = [
                (self._vector(force).dot(moving[body].at(self._vector(point))) if force is not None else 0)
                + self.number(couple) * moving[body].spin
                for body, point, force, couple in acting
            ]
            speeds.append(Decimal(0) if agree(parts, []) else sum(parts, Decimal(0)))
        # One that vanishes among digits that were rounded is none.
        speeds = [Decimal(0) if abs(s) <= NIL * max(map(abs, speeds)) else s for s in speeds]
        turns = all(force is None for _, _, force, _ in acting)
        pair = len({body for body, *_ in acting if body in self.bodies}) > 1
        return _Work(letter, size, speeds[0], speeds[1], turns, pair)

    def energies(self) -> tuple[Decimal, Decimal]:
        """Kinetic energy just before and just after, J."""
        return self._energy(self.first), self._energy(self.last)

    def _energy(self, moving: Mapping[str, _Moving]) -> Decimal:
        twice = Decimal(0)
        for name, model in self.bodies.items():
            v, spin = moving[name].velocity, moving[name].spin
            twice += self._own(model.mass) * v.dot(v) if v.x or v.y else 0
            twice += self._own(model.inertia) * spin**2 if spin else 0
        return twice / 2

    def one(self, work: _Work) -> Line:
        """J (u + u′)/2 with its numbers."""
        kinds = (ANGULAR_MOMENTUM, RATE) if work.turns else (IMPULSE, VELOCITY)
        size, speed = (coherent_unit(kind, False, self.phrases.ledger.us) for kind in kinds)
        words = " (ω + ω′)/2" if work.turns else " (u + u′)/2"
        if work.letter is None and work.turns:
            return line("J", words)
        us, figures = self.phrases.ledger.us, self.phrases.figures
        shown = [display(work.size, size, us), *(display(v, speed, us) for v in (work.before, work.after))]
        figures = figures_of(shown, lambda x: x[0] * (x[1] + x[2]) / 2, figures)
        numbers = line(*added([work.size], size, self.phrases, figures), " (")
        speeds = added([work.before, work.after], speed, self.phrases, figures)
        letter = Math(work.letter) if work.letter is not None else "J"
        return line(letter, words, " = ", *numbers, *speeds, ")/2")
