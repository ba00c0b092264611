"""The lines that tell how a pair of particles moves: its mass centre by itself, and both about it."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from decimal import Decimal
from typing import Any

import sympy as sp

from planar_cli.equation.values.exact import Valuation
from planar_cli.equation.values.ledger import NAMED, Kind, Role
from planar_cli.problem.scene.geometry import Vec
from planar_cli.records import record
from planar_cli.report.recast.line_of_blow import direction_of
from planar_cli.solve.between.trace.trace import PAIR, MotionTrace, Relation, Result, RouteStep
from planar_cli.units import parse_unit

NEAR = Decimal("1e-8")
"""An integration in numbers differs from the formula by less, in parts of it."""

LINE = "the line between them"
"""Of two whose names are no single letters."""


@record
class Particle:
    """One of the pair, with its place and velocity in letters of the general position. `name`: in words."""

    name: str
    mass: sp.Expr
    place: Vec
    velocity: Vec


@record
class Course:
    """Between which states a pair goes by itself: from just before a blow in which no impulse from outside acts, or
    from the beginning of its regime. `joint`: how the tie is called; `apart`: the speed of one relative to the other
    after the blow, positive as the line turns counterclockwise.
    """

    pair: tuple[Particle, Particle]
    before: str
    start: str
    joint: str
    apart: sp.Expr


class PairTelling:
    """Makes the steps of a route. `value`: with the numbers of what they give; `formulas`: of the same."""

    def __init__(self, motion: MotionTrace, course: Course) -> None:
        self.motion, self.course = motion, course
        self.value: Valuation = motion.value
        self.formulas: dict[sp.Symbol, sp.Expr] = {}
        self._steps: list[RouteStep] = []
        first, second = course.pair
        self._whole = first.mass + second.mass
        names = sorted((first.name, second.name))
        self._both = " and ".join(names)
        self._line = "".join(names) if len("".join(names)) == len(names) else LINE

    def known(self, general: sp.Expr, state: str) -> sp.Expr:
        """A place or a velocity at a state; a time or a place that a blow keeps is that before it."""
        here = {g: own for own, g in self.motion.general.items() if self.motion.ledger.roles[own].at == state}
        return sp.sympify(general).xreplace(here).xreplace(dict(self.motion.route.plain))

    def is_told(self, expr: sp.Expr) -> bool:
        """Are all its letters known on the way, and the numbers of none come from an integration?"""
        told = self.motion.route.formulas.keys() | self.motion.ledger.values.keys() | self.formulas.keys()
        return not expr.free_symbols - (told - self.motion.guessed)

    # --- what a step gives -------------------------------------------------------------------------------------------

    def give(self, name: str, formula: sp.Expr, unit: str, words: str, state: str = "") -> sp.Expr:
        """A letter for a formula, with its step; the formula itself where it is nought. `state`: at which it holds."""
        if formula == 0:
            return formula
        symbol = sp.Symbol(name, positive=True) if unit == "m" and not state else sp.Symbol(name, real=True)
        ledger = self.motion.ledger
        ledger.units[symbol] = parse_unit(unit)
        ledger.roles[symbol] = Role(Kind.STATE, None, state) if "__" in name else NAMED
        self._add(symbol, formula, words, state)
        return symbol

    def _add(self, symbol: sp.Symbol, formula: sp.Expr, words: str, state: str) -> None:
        number = self.value(formula)
        self.value = self.value.extended({symbol: number})
        self.formulas[symbol] = formula
        relation = Relation(symbol - formula, PAIR, words, state)
        needs = frozenset(formula.free_symbols & (self.motion.unknowns | self.formulas.keys()))
        self._steps.append(RouteStep((relation,), (symbol,), needs, (Result(symbol, formula, number),), False))

    def told(self, wanted: Iterable[sp.Expr]) -> Iterator[RouteStep]:
        """The steps on which wanted formulas rest, and those of wanted letters."""
        used = {s for e in wanted for s in e.free_symbols}
        kept = []
        for step in reversed(self._steps):
            if used & set(step.unknowns):
                kept.append(step)
                used |= {s for r in step.results if r.formula is not None for s in r.formula.free_symbols}
        yield from reversed(kept)

    # --- the pair ----------------------------------------------------------------------------------------------------

    def begin(self, pull: bool) -> bool:
        """Place and velocity of the mass centre, how far both are from it, and how fast they turn; False: something
        that this needs is not told. `pull`: is the force in the tie asked?
        """
        before, (first, second) = self.course.before, self.course.pair
        places = [self.known(e, before) for p in self.course.pair for e in (*_pair(p.place), *_pair(p.velocity))]
        apart, length = self.known(self.course.apart, self.course.start), self._length()
        if length is None or not all(map(self.is_told, (*places, apart))) or self._is_taken():
            return False
        words = f"G is the mass centre of {self._both}"
        falls = self.motion.problem.plane == "vertical"
        (x, y), (vx, vy) = (
            [self._mean([self.known(e, before) for e in parts]) for parts in zip(*map(_pair, both), strict=True)]
            for both in ([p.place for p in self.course.pair], [p.velocity for p in self.course.pair])
        )
        if not length.is_Symbol:
            length = self.give("l" if self._line == LINE else self._line, length, "m", words, before)
        self.x = self.give(f"x_G__{before}", x, "m", words, before)
        self.y = self.give(f"y_G__{before}", y, "m", words, before)
        self.vx = self.give("v_Gx", vx, "m/s", words, before)
        self.vy = self.give(f"v_Gy__{before}" if falls else "v_Gy", vy, "m/s", words, before)
        arms = zip(self.course.pair, (second.mass, first.mass), strict=True)
        self.arms = [self.give(_arm(p), m * length / self._whole, "m", words, before) for p, m in arms]
        self.words = self._why(falls, pull)
        self.g = self.motion.ledger.symbols["g"] if falls else sp.S.Zero
        self.omega = self.give("omega", apart / length, "rad/s", self.words)
        return True

    def _is_taken(self) -> bool:
        """Has the file one of the letters for something else?"""
        own = {"G", "x_G", "y_G", "v_Gx", "v_Gy", "omega", self._line, *map(_arm, self.course.pair)}
        return bool(own & self.motion.ledger.reserved)

    def _mean(self, parts: list[sp.Expr]) -> sp.Expr:
        """Of a component of both that of their mass centre."""
        return sp.cancel(sp.Add(*(p.mass * e for p, e in zip(self.course.pair, parts, strict=True))) / self._whole)

    def _why(self, falls: bool, pull: bool) -> str:
        """Why they move so. `falls`: they have weights; `pull`: and the acceleration by which the pull is told."""
        first = self.course.pair[0]
        outer = f"No force from outside acts on {self._both}: G keeps its velocity"
        through = f"The pull of {self.course.joint} passes through G"
        if falls:
            outer = f"Beside the weights no force from outside acts on {self._both}: G is in free flight"
            through = f"Weights and the pull of {self.course.joint} have no moment about G"
        towards = "towards G, beside g" if falls else "towards G"
        given = f", and the pull gives {first.name} the acceleration {_arm(first)} ω² {towards}" if pull else ""
        return f"{outer}. {through}, so that {self._line} turns at a constant rate{given}"

    def _length(self) -> sp.Expr | None:
        """The length of the tie: a letter of the file to which the distance was set, else a number."""
        first, second = (p.place for p in self.course.pair)
        x, y = (self.known(e, self.course.before) for e in _pair(second - first))
        whole = sp.sqrt(x**2 + y**2)
        number = self.value.known(whole)
        if number is None or not number:
            return None
        given = (e.residual for leg in self.motion.route.steps for e in leg.relations if e.kind == "given")
        for residual in given:
            own = list(residual.free_symbols & self.motion.ledger.values.keys())
            if (x.free_symbols | y.free_symbols) & residual.free_symbols:
                same = [s for s in own if self.value.is_zero(whole - s)]
                if same:
                    return same[0]
                square = -residual.as_coeff_Add()[0]
                if not own and square.is_Rational and self.value.is_zero(whole - sp.sqrt(square)):
                    return sp.sqrt(square)
        return whole

    def angle(self, state: str) -> sp.Expr:
        """The direction of the line from the first to the second at a state."""
        first, second = (p.place for p in self.course.pair)
        reach = second - first
        x, y = (self.known(e, self.course.before) for e in _pair(reach))
        own, formula = direction_of(self.motion, x, y)
        if own not in self.formulas and own not in self.motion.route.formulas:
            self._add(own, formula, f"the direction of {self._line}", self.course.before)
        name = f"{own.name}__{state}"
        made = next((s for s in self.formulas if s.name == name), None)
        return made or self.give(name, own + self.omega * self.since(state), "deg", self.words)

    def since(self, state: str) -> sp.Expr:
        """The time from the beginning to a state."""
        time = sp.Symbol("t", real=True)
        now = self.known(time, state)
        if now.is_Symbol and now not in self.formulas and now not in self.motion.route.formulas:
            self._date(now, state)
        return now - self.known(time, self.course.before)

    def _date(self, time: sp.Symbol, state: str) -> None:
        """The time of a state as the file gives it, which nothing else on the way tells."""
        number = self.value(time)
        told = sp.Rational(str(number))
        relation = Relation(time - told, "given", "", state, is_datum=True)
        self.formulas[time] = told
        self._steps.append(RouteStep((relation,), (time,), frozenset(), (Result(time, told, number),), True))

    def pull(self) -> sp.Expr:
        """The force in the tie: the mass of the first times its acceleration towards the mass centre."""
        return sp.Mul(self.course.pair[0].mass, self.arms[0], self.omega**2)

    def sought(self, general: sp.Symbol, state: str) -> sp.Expr | None:
        """The formula of a coordinate or of a velocity at a state; None: it is something else."""
        for i, p in enumerate(self.course.pair):
            sense = -1 if i == 0 else 1
            if general in _pair(p.place):
                turned = self.angle(state)
                along, went, arm = self.since(state), (self.x, self.y), sense * self.arms[i]
                fallen = -self.g * along**2 / 2
                if general == p.place.x:
                    return went[0] + self.vx * along + arm * sp.cos(turned)
                return went[1] + self.vy * along + fallen + arm * sp.sin(turned)
            if general in _pair(p.velocity):
                turned, speed = self.angle(state), sense * self.arms[i] * self.omega
                if general == p.velocity.x:
                    return self.vx - speed * sp.sin(turned)
                return self.vy - self.g * self.since(state) + speed * sp.cos(turned)
        return self.known(self.course.apart, self.course.start) if general == self.course.apart else None

    def step(self, unknown: sp.Symbol, state: str) -> bool:
        """The step to an unknown that an integration in numbers has given; False: it is not told so, or its number is
        another.
        """
        formula = self.sought(self.motion.general[unknown], state)
        if formula is None or not self.is_told(formula):
            return False
        number = self.value.known(unknown)
        if number is None or not self.is_same(formula, unknown):
            return False
        self._add(unknown, formula, "", state)
        return True

    def is_same(self, one: sp.Expr, other: sp.Expr) -> bool:
        """Have two formulas the same number, but for the errors of an integration?"""
        first, second = self.value.known(one), self.value.known(other)
        return first is not None and second is not None and bool(abs(first - second) <= NEAR * (1 + abs(first)))


def _arm(p: Particle) -> str:
    """The name of the distance of one of both from their mass centre."""
    return f"{p.name}G" if len(p.name) == 1 else f"r_{p.name}"


def _pair(v: Vec) -> tuple[Any, Any]:
    return v.x, v.y
