"""A check that a person can make of a stretch of a motion, from the law of a coordinate alone.

    mean velocity times the time:  (0 + 25)/2 · 12.5 = 156.2 m,  x_2 - x_1 = 156.2 m             constant acceleration
    ÿ = g constant:   2 · 9.81 · 3 = 58.86 m²/s²,  v_2² - v_1² = 58.86 m²/s²
    ẍ = 4 - 2 t:      mean acceleration times the time, (4 + 0)/2 · 2 = 4 m/s,  v_2 = 4 m/s      a straight line
    θ̈ = -g sin θ/l:   Simpson's rule, 0.5236/6 (8.496 + 4 · 4.905 + 0) = 2.453 rad²/s² ...       the law at three places

It rests neither on the integral in closed form nor on a balance of energy by which the motion was found. The law that
it starts from stands in it, in letters: of an acceleration that is nowhere on the page nobody could check anything.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from decimal import Decimal

import sympy as sp

from planar_cli.equation.algebra.plain import longer, simplified
from planar_cli.equation.values.exact import ZERO, Sample, Unvalued
from planar_cli.records import record
from planar_cli.report.document.blocks import Inline, Line, Math, Name, Value, line
from planar_cli.report.energy.energy_pieces import STATE
from planar_cli.report.in_numbers.sums import ROUNDING, agree
from planar_cli.report.laws.laws import counted
from planar_cli.report.notation.clean import is_clean
from planar_cli.report.notation.enough_figures import figures_of
from planar_cli.report.words.words import Phrases
from planar_cli.solve.between.trace.trace import MotionTrace
from planar_cli.solve.law import Law
from planar_cli.units import LENGTH

COARSE = Decimal("0.005")
"""In parts of the result: where Simpson's rule is off by more, three places are too few to check anything."""
UNEVEN = tuple(Decimal(x) for x in ("0.137", "0.289", "0.5", "0.643", "0.911"))
"""Places in parts of a stretch: a wave may cross its chord halfway, but not at all of these as well."""
SHORT = 14
"""A law of more operations is not written out."""


@record
class _Check:
    told: Line
    error: Decimal
    """Of Simpson's rule, in parts of the result; of what is exact 0."""
    exact: bool = True
    mean: bool = False
    """Is it the mean velocity times the time? Where one acceleration gave both it tests the arithmetic alone."""


NONE = _Check((), ZERO)


def law_check(motion: MotionTrace, phrases: Phrases) -> Line:
    """What is exact; empty where no coordinate has such a law, with ends whose values are on the page."""
    return next((c.told for c in _checks(motion, phrases) if c.exact and not c.mean), ())


def mean_check(motion: MotionTrace, phrases: Phrases) -> Line:
    """The mean velocity times the time, by constant acceleration."""
    return next((c.told for c in _checks(motion, phrases) if c.mean), ())


def simpson_check(motion: MotionTrace, phrases: Phrases) -> Line:
    """The best of the stretches on which a law is no straight line."""
    return min((c for c in _checks(motion, phrases) if not c.exact), key=lambda c: c.error, default=NONE).told


def _checks(motion: MotionTrace, phrases: Phrases) -> Iterator[_Check]:
    relations = [e for leg in motion.route.steps for e in leg.relations]
    for since, stop, laws in motion.stretches:
        kinds = {e.kind for e in relations if (e.since, e.stop) == (since, stop)}
        for law in laws:
            try:
                yield from _Ends(motion, (since, stop), law, phrases).checks(kinds)
            except Unvalued:
                continue


class _Ends:
    """A coordinate at both ends of a stretch."""

    def __init__(self, motion: MotionTrace, states: tuple[str, str], law: Law, phrases: Phrases) -> None:
        self.states = states
        self.over = "" if states[0] == motion.stretches[0][0] else "; from {} to {}".format(*states)
        """Which stretch it is: without it the reader would take the first."""
        self.law, self.phrases, self.plain = law, phrases, motion.route.plain
        self.certain = not motion.symbolic and not (isinstance(motion.value, Sample) and motion.value.drawn)
        self.running = {"q": law.coordinate.symbol, "v": law.v, "t": phrases.ledger.symbols["t"]}
        straight = law.order == 2 and law.speed is not None and law.factor == 1 and law.coordinate.extra == 0
        own = {(general, s.name.rpartition(STATE)[2]): s for s, general in motion.general.items()}
        found = {r.unknown for leg in motion.route.steps for r in leg.results} | set(motion.route.plain)
        found |= {s for asked in motion.named.values() for s in asked.free_symbols}
        self.letters: dict[str, tuple[sp.Symbol, sp.Symbol]] = {}
        self.told: set[str] = set()
        """What has its values on the page."""
        for name, general in {**self.running, "v": law.speed if straight else None}.items():
            one, other = (own.get((general, state)) for state in states)
            if one is not None and other is not None and self._has_numbers(one, other):
                self.letters[name] = (one, other)
                self.told |= {name} if all(s in found or phrases.value(s) == 0 for s in (one, other)) else set()

    def _has_numbers(self, *exprs: sp.Expr) -> bool:
        """Have they numbers that rest on none that was drawn for a letter?"""
        known = [self.phrases.value.known(e) for e in exprs]
        settled = (
            x == 0 or self.certain or self.phrases.has_numbers(self.plain.get(e, e))
            for e, x in zip(exprs, known, strict=True)
        )
        return None not in known and all(settled)

    def checks(self, kinds: set[str]) -> Iterator[_Check]:
        """`kinds`: of the relations by which the page goes over the stretch."""
        f, order = self.law.f, self.law.order
        if not self.phrases.has_numbers(f.xreplace(dict.fromkeys(self.running.values(), sp.S.One))):
            return
        depends = {n for n, s in self.running.items() if f.has(s)}
        if order == 2 and not depends:
            yield from self._constant(kinds)
        elif order == 2 and depends == {"q"} and "v" in self.told:
            yield from self._simpson("q", f, "v", squared=True)
        elif order == 2 and depends == {"t"}:
            yield from self._simpson("t", f, "v")
        elif order == 2 and depends == {"v"} and "t" in self.told:
            yield from self._simpson("v", 1 / f, "t")
        elif order == 1 and depends == {"t"}:
            yield from self._simpson("t", f, "q")
        elif order == 1 and depends == {"q"}:
            yield from self._simpson("q", 1 / f, "t")

    def _constant(self, kinds: set[str]) -> Iterator[_Check]:
        """The mean speed times the time, or 2 a Δq."""
        a = self.phrases.certain(self.law.f)
        if a == 0 or "v" not in self.told or "q" not in self.letters:
            return
        (v, u), (q, p) = self._values("v"), self._values("q")
        if {"t", "q"} <= self.told:
            t, s = self._values("t")
            # Of a way there and back to where it began there is no name to set beside it.
            if (p or q) and agree([(v + u) / 2 * (s - t)], [p - q]):
                figures = self._enough([(v, "v"), (u, "v"), (s - t, "t")], _mean)
                pair = line("(", self._bare(v, "v", figures), *self._plus(u, "v", figures))
                mean = line(*pair, ")/2 · ", self._bare(s - t, "t", figures))
                turned = self.law.coordinate.unit == "rad"
                what = f"mean {'angular ' if turned else ''}velocity times the time"
                words = f"{what}, {counted(self.law.coordinate.words)}: "
                yield _Check(
                    line(words, *mean, " = ", self._value(p - q, "q"), "; ", *self._difference("q")), ZERO, mean=True
                )
        elif "v(q)" not in kinds and agree([2 * a * (p - q)], [u * u, -v * v]) and len(self._law()) > 1:
            product = line("2 · ", *self._factor(a, "a"), " · ", *self._factor(p - q, "q"))
            name = line("2 ", Name(self._letter("a")), " Δ", Name(self._letter("q")))
            sides = line(*product, " = ", self._value(2 * a * (p - q), "v", 2), "; ", *self._difference("v", 2))
            yield _Check(line(*self._law(), " = ", self._value(a, "a"), ", constant; ", *name, " = ", *sides), ZERO)

    def _simpson(self, over: str, rate: sp.Expr, of: str, squared: bool = False) -> Iterator[_Check]:
        """The integral of a rate by its values at three places, against what it must come to."""
        if not {over, of} <= self.told:
            return
        (start, end), (one, other) = self._values(over), self._values(of)
        change = (other * other - one * one) / 2 if squared else other - one
        found = self._rates(rate, over, (ZERO, Decimal("0.5"), Decimal(1)))
        if change == 0 or not found:
            # It comes to a place where 1/a grows without bound: a body that is brought to rest by -c √v.
            return
        largest = max(map(abs, found))
        first, half, last = rates = [ZERO if abs(r) <= largest * ROUNDING else r for r in found]
        if not (over == "t" or squared or all(rates)):
            # It begins with an acceleration that grows without bound, of which there is no number to print.
            return
        total = (end - start) * (first + 4 * half + last) / 6
        error = abs(total / change - 1)
        if error > COARSE:
            return
        law = self._law()
        if first == half == last:
            return
        result = self._value(total, "v", 2) if squared else self._value(total, of)
        ends = self._difference(of, 2, half=True) if squared else self._difference(of)
        if (over == "t" or (squared and len(law) > 1)) and self._is_straight(rate, over, largest):
            # Over time the rates at both ends are easily found from the forces there; else it takes the formula.
            told = line(*law, *(() if len(law) > 1 else (" changes uniformly",)), self.over)
            figures = self._enough([(first, self._per), (last, self._per), (end - start, over)], _mean)
            pair = line("(", self._bare(first, self._per, figures), *self._plus(last, self._per, figures))
            mean = line(*pair, ")/2 · ")
            per = "time" if over == "t" else self._way()
            words = line(*told, f": mean {self._rate_word()} times the {per}, ", *mean)
            yield _Check(line(*words, *self._factor(end - start, over, figures), " = ", result, "; ", *ends), ZERO)
            return
        if len(law) < 2:
            return
        sides = line(f" {_sign(error)} ", result, "; ", *ends)
        yield _Check(self._at_three((over, end - start), rates, law, sides), error, exact=False)

    def _rates(self, rate: sp.Expr, over: str, parts: Sequence[Decimal]) -> list[Decimal]:
        """A rate at such parts of the stretch; empty where it has no value at one of them."""
        start, end = self._values(over)
        places = (sp.Rational(str(start + part * (end - start))) for part in parts)
        known = [self.phrases.value.known(rate.xreplace({self.running[over]: p})) for p in places]
        found = [r for r in known if r is not None and r.is_finite()]
        return found if len(found) == len(known) else []

    def _is_straight(self, rate: sp.Expr, over: str, largest: Decimal) -> bool:
        """Does a rate change uniformly over the stretch? `largest`: of its sizes."""
        first, *between, last = self._rates(rate, over, (ZERO, *UNEVEN, Decimal(1))) or (ZERO, ZERO)
        chord = [first + part * (last - first) for part in UNEVEN]
        return bool(between) and all(abs(r - c) <= largest * ROUNDING for r, c in zip(between, chord, strict=True))

    def _at_three(self, step: tuple[str, Decimal], rates: list[Decimal], law: Line, result: Line) -> Line:
        """Simpson's rule in numbers. `step`: over what, and how far."""
        over, width = step
        squared = over == "q" and self.law.order == 2
        kind = self._per if over == "t" or squared else f"1/{self._per}"
        first, half, last = rates
        numbers = [(first, kind), (half, kind), (last, kind), (width, over)]
        figures = self._enough(numbers, lambda x: (x[0] + 4 * x[1] + x[2]) * x[3] / 6)
        half_way = line(" - " if half < 0 else " + ", "4 · ", self._bare(abs(half), kind, figures))
        inside = line(self._bare(first, kind, figures), *half_way, *self._plus(last, kind, figures))
        stretch = "; from {} to {}: ".format(*self.states)
        rule = line(" by Simpson's rule = ", self._bare(width, over, figures), "/6 (")
        words = line(*law, stretch, *self._integral(over, squared), *rule)
        return line(*words, *inside, ")", *result)

    # --- pieces ------------------------------------------------------------------------------------------------------

    @property
    def _per(self) -> str:
        """The kind of the rate that the law gives."""
        return "a" if self.law.order == 2 else "v"

    def _rate_word(self) -> str:
        turned = "angular " if self.law.coordinate.unit == "rad" else ""
        return f"{turned}{'acceleration' if self.law.order == 2 else 'velocity'}"

    def _way(self) -> str:
        return "angle" if self.law.coordinate.unit == "rad" else "way"

    def _values(self, name: str) -> tuple[Decimal, Decimal]:
        one, other = self.letters[name]
        return self.phrases.certain(one), self.phrases.certain(other)

    def _letter(self, name: str) -> str:
        """The name of the coordinate, of its rate or of the rate of that."""
        q: str = self.law.coordinate.symbol.name
        return {"q": q, "v": f"{q}_dot", "a": f"{q}_ddot", "t": "t"}[name]

    def _law(self) -> Line:
        """q̈ = f, in letters where these are few: no letter of a rate that has its formula elsewhere."""
        law, name = self.law, Name(self._letter(self._per))
        f = law.f.xreplace({law.constant[0]: law.constant[1]}) if law.constant is not None else law.f
        f = simplified(f) if law.constant is not None else f
        clean = (
            str(f) != self._letter(self._per)
            and not longer(f, SHORT)
            and not f.has(law.v)
            and is_clean(self.phrases.ledger, f)
        )
        return line(name, *((" = ", self.phrases.math(f)) if clean and (law.order == 1 or not f.is_number) else ()))

    def _integral(self, over: str, squared: bool) -> Line:
        """What Simpson's rule is taken of."""
        rate = self._letter("a" if self.law.order == 2 else "v")
        if over == "t" or squared:
            return line("∫ ", Name(rate), " d", Name(self._letter(over)))
        return line("∫ d", Name(self._letter(over)), "/", Name(rate))

    def _unit(self, kind: str, power: int = 1) -> str:
        if kind == "t":
            return "s"
        own = "rad" if self.law.coordinate.unit == "rad" else "ft" if self.phrases.ledger.us else "m"
        seconds = {"q": 0, "v": 1, "a": 2}[kind] * power
        return own + (f"^{power}" if power > 1 else "") + {0: "", 1: "/s"}.get(seconds, f"/s^{seconds}")

    def _number(self, value: Decimal, kind: str, power: int = 1) -> Decimal:
        length, power = kind != "t" and self.law.coordinate.unit != "rad", -power if kind.startswith("1/") else power
        return value * self.phrases.of_dimension(Decimal(1), LENGTH).number ** power if length else value

    def _enough(self, numbers: Sequence[tuple[Decimal, str]], worked: Callable[[Sequence[Decimal]], Decimal]) -> int:
        """The figures of numbers, each with its kind, that give the printed result."""
        return figures_of([self._number(x, kind) for x, kind in numbers], worked, self.phrases.figures)

    def _bare(self, value: Decimal, kind: str, figures: int = 0) -> Value:
        return Value(self._number(value, kind), "1", figures or self.phrases.figures)

    def _value(self, value: Decimal, kind: str, power: int = 1) -> Value:
        return Value(self._number(value, kind, power), self._unit(kind, power), self.phrases.figures)

    def _plus(self, value: Decimal, kind: str, figures: int = 0) -> Line:
        return line(" - " if value < 0 else " + ", self._bare(abs(value), kind, figures))

    def _factor(self, value: Decimal, kind: str, figures: int = 0) -> Line:
        shown = self._bare(value, kind, figures)
        return line("(", shown, ")") if value < 0 else line(shown)

    def _difference(self, name: str, power: int = 1, half: bool = False) -> Line:
        """x_2 - x_1, or of squares, with its value; what is zero is left out."""
        (one, other), (a, b) = self._values(name), self.letters[name]
        change = other**power - one**power
        parts: list[Inline | str] = [Math(b**power)] if other else [] if half or power > 1 else ["0"]
        if one:
            parts += [" - " if parts else "-", Math(a**power)]
        told = line("(", *parts, ")") if half and one and other else line(*parts)
        told = line(*told, "/2") if half else told
        return line(*told, " = ", self._value(change / 2 if half else change, name, power))


def _mean(x: Sequence[Decimal]) -> Decimal:
    return (x[0] + x[1]) / 2 * x[2]


def _sign(error: Decimal) -> str:
    return "=" if error <= ROUNDING else "≈"
