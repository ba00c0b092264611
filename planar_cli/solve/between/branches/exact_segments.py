"""The motion between changes of regime: every letter as a function of time.

Where the laws of motion can be integrated, a segment has formulas in t and in the letters of the state where it begins;
coordinates that only loops tell follow by Newton's method. Everything else is read off the motion that was followed. SI
units; angles in radians.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import field
from decimal import Decimal
from typing import Any

import sympy as sp

from planar_cli.equation.algebra.plain import simplified
from planar_cli.equation.values.exact import Unvalued, Valuation
from planar_cli.errors import Undecided
from planar_cli.records import record
from planar_cli.solve.between.equations.motion_equations import MotionEquations
from planar_cli.solve.between.equations.stated_motion import StatedMotion
from planar_cli.solve.between.roots.events import FollowedSegment, State
from planar_cli.solve.between.roots.followed import Followed
from planar_cli.solve.regimes.constraints import project
from planar_cli.solve.regimes.equations import Laws, law_equations, laws_of, link_equations
from planar_cli.solve.regimes.regime import Regime, number_function
from planar_cli.solve.regimes.regime_sequence import RegimeSequence
from planar_cli.solve.regimes.timeline import Stop

CHECKS = 8
TINY = Decimal("1e-20")


@record
class ExactSegment:
    """One regime from a state on, to the last time that any state asks for; it goes on beyond."""

    regime: Regime
    start: Stop
    t0: Decimal
    t1: Decimal
    value: Valuation
    """Numbers of all names and of the letters of states."""
    formulas: dict[sp.Symbol, sp.Expr]
    """Letters of the general position that have one, in t and the letters of `start`."""
    origin: dict[sp.Symbol, Decimal] = field(default_factory=dict)
    """Numbers of coordinates as drawn, for loops."""
    followed: tuple[FollowedSegment, ...] = ()
    """The same in numbers, stretch by stretch; none where the motion was not followed."""
    _known: dict[Decimal, dict[sp.Symbol, Decimal]] = field(default_factory=dict)

    def formula(self, letter: sp.Symbol) -> sp.Expr | None:
        """A letter of the general position as a formula in t, where there is one."""
        return self.regime.time if letter == self.regime.time else self.formulas.get(letter)

    def over_time(self, expr: sp.Expr) -> sp.Expr | None:
        """A closed formula of the general position as a formula in t alone (and names); None: there is none."""
        inside = {s: self.formula(s) for s in expr.free_symbols & set(self.regime.letters)}
        if any(f is None for f in inside.values()):
            return None
        return expr.xreplace(inside)

    def at(self, t: Decimal) -> dict[sp.Symbol, Decimal]:
        """All letters of the regime at a time, t among them."""
        if t not in self._known:
            self._known[t] = self._at(t)
        return self._known[t]

    def number(self, expr: sp.Expr, t: Decimal) -> Decimal:
        """A closed formula of the general position at a time."""
        return self.value.extended(self.at(t))(expr)

    def function(self, expr: sp.Expr) -> Callable[[float], float]:
        """The same in machine numbers, for searches."""
        time = self.regime.time
        direct = self.over_time(expr)
        if direct is not None:
            f = number_function([direct], [time], self.value)
            return lambda t: f(t)[0]
        g = number_function([expr], self.regime.letters, self.value)

        def along(t: float) -> float:
            here = self.here(t)
            return g(*(here[s] for s in self.regime.letters))[0]

        return along

    def here(self, t: float) -> State:
        """The letters at a time as they were followed. Undecided: they were not."""
        if not self.followed:
            raise Undecided("a quantity over a span has no formula here, and the motion is not followed step by step")
        return next((f for f in self.followed if t <= f.t1), self.followed[-1]).at(t)

    def _at(self, t: Decimal) -> dict[sp.Symbol, Decimal]:
        here = self.value.extended({self.regime.time: t})
        found = {self.regime.time: t, **{s: here(f) for s, f in self.formulas.items()}}
        missing = [s for s in self.regime.letters if s not in found]
        if not missing:
            return found
        guess = self.here(float(t))
        found |= {s: Decimal(repr(guess[s])) for s in missing}
        loops = self.regime.general.constraints
        unknowns = tuple(s for s in missing if any(c.residual.has(s) for c in loops))
        if loops and len(unknowns) == len(missing):
            found |= project(loops, unknowns, self.value.extended({**self.origin, **found}))
        return found


def exact_segments(course: MotionEquations, value: Valuation, followed: Followed | None) -> tuple[ExactSegment, ...]:
    """The motion, one segment for each regime in its turn. `value`: numbers of names and of letters of states;
    `followed`: it in numbers.

    Unvalued: a letter of the state where a segment begins has no number.
    """
    begins = _begins(course)
    origin = {
        c.start: value(course.first.letters[c.symbol])
        for r in course.regimes
        for c in r.coordinates
        if course.first.letters[c.symbol] in value.values
    }
    found = []
    for n, i in enumerate(begins):
        regime, start = course.regimes[i], course.stops[course.states[i].name]
        until = min([j for j in (*begins[n + 1 :], *course.blows) if j > i], default=len(course.states))
        ends = [course.stops[s.name].t for s in course.states[i : until + 1]]
        times = [value(t) for t in ends if t in value.values]
        t0 = value(start.t)
        known = value.extended(_begun(regime, start, course, value))
        known = known.extended({k: v for k, v in origin.items() if k not in known.values})
        if n == 0 and course.departure is not None:
            known = known.extended({start.letters[course.departure.speed]: course.departure.value})
        laws = course.laws[i] if i < len(course.laws) else laws_of(regime)
        formulas = explicit(laws, regime, start, known, t0, max([t0, *times]))
        passed = [f for f in followed.segments if f.regime is regime] if followed is not None else []
        passed = [f for f in passed if f.t1 > t0 or f is passed[-1]]
        found.append(ExactSegment(regime, start, t0, max([t0, *times]), known, formulas, origin, tuple(passed)))
    return tuple(found)


def _begins(course: StatedMotion) -> list[int]:
    """The stretches that begin a segment: the first, one after a blow, one in another regime than that before."""
    found = []
    for i, regime in enumerate(course.regimes):
        if i not in course.blows and (i == 0 or i - 1 in course.blows or regime is not course.regimes[i - 1]):
            found.append(i)
    return found


def _begun(regime: Regime, start: Stop, course: RegimeSequence, value: Valuation) -> dict[sp.Symbol, Decimal]:
    """Letters of a regime that the state where it begins does not tell: places as drawn, speeds at rest."""
    more = {}
    for c in regime.coordinates:
        own = start.letters[c.symbol]
        if own not in value.values and c.drawn is not None:
            more[own] = value(c.drawn)
    for u in regime.free:
        if start.letters[u] not in value.values:
            raise Unvalued(str(start.letters[u]))
    return more


def explicit(
    laws: Laws, regime: Regime, start: Stop, value: Valuation, t0: Decimal, t1: Decimal
) -> dict[sp.Symbol, sp.Expr]:
    """Formulas in t and the letters of `start` for as many letters of a regime as the laws give."""
    running = Stop("", (), {s: s for s in regime.letters}, regime.time)
    found: dict[sp.Symbol, sp.Expr] = {}
    for equation in law_equations(laws, start, running, regime, value):
        span, law = equation.span, equation.law
        if span is None or law is None or span.explicit is None or span.unevaluated:
            continue
        if span.explicit.free_symbols & set(regime.letters) - {regime.time}:
            continue
        if not all(_lasts(w, regime, span.explicit, law, value, t0, t1) for w in span.where):
            continue
        if span.kind == "q(t)":
            found.setdefault(law.coordinate.symbol, span.explicit)
        elif span.kind == "v(t)" and law.speed is not None:
            found.setdefault(law.speed, span.explicit / law.factor)
    for law in laws.laws:
        place = found.get(law.coordinate.symbol)
        if place is not None and law.speed is not None and law.speed not in found:
            found[law.speed] = simplified(sp.diff(place, regime.time) / law.factor)
    for equation in link_equations(laws, start, running, regime):
        symbol = next(k.coordinate.symbol for k in laws.links if equation.family[1] == k.coordinate.symbol.name)
        formula = (symbol - equation.residual).xreplace(found)
        if not formula.free_symbols & set(regime.letters) - {regime.time}:
            found[symbol] = formula
    return found


def _lasts(
    where: sp.Expr, regime: Regime, formula: sp.Expr, law: Any, value: Valuation, t0: Decimal, t1: Decimal
) -> bool:
    """Does the condition of a relation hold from t0 to t1?"""
    v = regime.time
    for symbol in where.free_symbols & set(regime.letters) - {v}:
        rate = formula if symbol == law.speed else None
        if rate is None:
            return False
        where = where.xreplace({symbol: rate / law.factor})
    for k in range(1, CHECKS + 1):
        here = value.extended({v: t0 + (t1 - t0) * k / CHECKS})
        number = here.known(where)
        if number is None or number < -TINY * here.size(where):
            return False
    return True
