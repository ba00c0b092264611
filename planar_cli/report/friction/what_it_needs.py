"""What friction would have to be where an assumption fails, worked out by the equations of that case.

then a_B = (P - μ_B N_B)/(m_A + m_B) = (90 - 0.1 · 127.5)/(5 + 8) = 5.942 m/s²; it would need |F_A| = m_A a_B = …

The normal force on which its limit rests stands before it, N_A = m_A g = 5 · 9.81 = 49.05 N.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import field, replace
from decimal import Decimal

import sympy as sp

from planar_cli.equation.algebra.plain import longer, simplified
from planar_cli.equation.values.exact import Valuation
from planar_cli.errors import PlanarError
from planar_cli.problem.scene.facts import Push
from planar_cli.records import record
from planar_cli.report.document.blocks import Line, line
from planar_cli.report.words.words import Phrases
from planar_cli.solve.instant.finish import Finisher
from planar_cli.solve.instant.instant import Trial
from planar_cli.solve.instant.stages import Stage
from planar_cli.solve.solution import InstantSolution

FEW, LONGEST = 3, 20
"""So many lines, of so many operations each, stand before the one of the friction."""
NEAR = Decimal("1e-20")
DENOMINATOR = 10**6
"""A fraction of the file has no larger one."""
PRIME = "′"


@record
class Working:
    """The size of a friction as a formula, and what is told before it: letters and their formulas, each in what stands
    before it. `value`: the numbers of the rejected case; `senses`: in words the sense of an angular acceleration that
    is told with a positive size.
    """

    size: sp.Expr
    before: tuple[tuple[sp.Symbol, sp.Expr], ...]
    value: Valuation
    senses: Mapping[sp.Symbol, str] = field(default_factory=dict)

    def told(self, phrases: Phrases) -> Line:
        """then a = (P - μ N)/m = 5.942 m/s², α = …; empty where nothing is told before."""
        told = listed(self.before, self.value, phrases, self.senses)
        return line("then ", *told) if told else ()


def listed(
    letters: Iterable[tuple[sp.Symbol, sp.Expr]],
    value: Valuation,
    phrases: Phrases,
    senses: Mapping[sp.Symbol, str] | None = None,
) -> Line:
    """`a = (P - μ N)/m = 5.942 m/s², α = …`: letters with their formulas, numbers, and senses in words."""
    there, parts = replace(phrases, value=value), line()
    for symbol, formula in letters:
        size = there.shown(symbol)
        numbers = [piece for side in there.substituted(formula, size) for piece in (" = ", side)]
        comma = (", ",) if parts else ()
        parts += line(*comma, there.math(symbol), " = ", there.math(formula), *numbers, " = ", size)
        parts += line(f" {senses[symbol]}") if senses and symbol in senses else ()
    return parts


@record
class Presses:
    """Normal forces of a rejected case: letters with their formulas, and the numbers of that case."""

    letters: tuple[tuple[sp.Symbol, sp.Expr], ...]
    value: Valuation

    def told(self, phrases: Phrases) -> Line:
        """`N_A = m_A g = 5 · 9.81 = 49.05 N, N_B = m_B g + N_A = 127.5 N`."""
        return listed(self.letters, self.value, phrases)

    def without(self, before: Presses) -> Presses | None:
        """Those that were not told before with the same number; None: that is none."""
        told = dict(before.letters)
        new = tuple((s, e) for s, e in self.letters if s not in told or self.value.known(s) != before.value.known(s))
        return replace(self, letters=new) if new else None


def presses(trial: Trial, limit: sp.Expr, instant: InstantSolution) -> Presses | None:
    """The normal forces on which a limit of friction rests, by the equations of a case that is rejected, each with
    those behind it. None: the limit rests on none, or the way to them is long.
    """
    if not trial.outcomes:
        return None
    symbols, outcome = trial.system.symbols, trial.outcomes[0]
    normal = {symbols[p.name]: outcome.push(p.name) for p in trial.system.pushes if p.kind == "normal"}
    wanted = sorted(normal.keys() & limit.free_symbols, key=lambda s: s.name)
    if not wanted or any(normal[s] is None for s in wanted):
        return None
    try:
        _, stages, value = Finisher(instant.instant, trial, (), {}).work(wanted, ())
    except PlanarError:
        return None
    told = _Told.of(stages, value, instant, aside=False)
    letters: dict[sp.Symbol, sp.Expr] = {}
    for symbol in wanted:
        own = told.formula(symbol)
        if own is not None:
            letters |= {**dict(told.behind(own, (symbol,))), symbol: own}
    # A weight that the file gives is its letter: the page has the mass by it.
    definitions = dict(instant.instant.scene.ledger.definitions)
    weights = {s: simplified(e.xreplace(definitions)) for s, e in letters.items()}
    letters |= {s: e for s, e in weights.items() if e.is_Symbol}
    whole = all(s in letters or s not in told.formulas for e in letters.values() for s in e.free_symbols)
    short = len(letters) <= FEW and all(_is_plain(e) and not longer(e, LONGEST) for e in letters.values())
    return Presses(tuple(letters.items()), value) if whole and short and set(wanted) <= set(letters) else None


def working(trial: Trial, push: Push, size: Decimal, instant: InstantSolution) -> Working | None:
    """How large friction has to be in a case that is rejected, by the equations of that case. None: it is not unique,
    or the way to it is long. `size`: its number, SI.
    """
    symbol = trial.system.symbols[push.name]
    if not trial.outcomes or trial.outcomes[0].push(push.name) is None:
        return None
    finisher = Finisher(instant.instant, trial, (), {})
    try:
        _, stages, value = finisher.work([symbol, *trial.system.tree.acceleration_unknowns()], ())
    except PlanarError:
        return None
    told = _Told.of(stages, value, instant)
    own = told.formula(symbol)
    number = None if own is None else value.known(own)
    if own is None or number is None or abs(abs(number) - size) > NEAR * size:
        return None
    own = own if number > 0 else simplified(-own)
    before = tuple(told.behind(own, ()))
    if len(before) > FEW or any(longer(e, LONGEST) or not _is_plain(e) for e in (own, *(e for _, e in before))):
        return None
    return _turned(Working(own, before, value), trial)


def _turned(way: Working, trial: Trial) -> Working:
    """The same with each angular acceleration that is negative told as a positive size, with its sense in words."""
    turns = {e.spin_rate: e.turn for e in trial.system.tree.edges if e.spin_rate is not None}
    back = {s: n for s, _ in way.before if s in turns and (n := way.value.known(s)) is not None and n < 0}
    if not back:
        return way
    opposite = {s: -s for s in back}
    before = tuple((s, simplified((-e if s in back else e).xreplace(opposite))) for s, e in way.before)
    senses = {s: "clockwise" if turns[s] > 0 else "counterclockwise" for s in back}
    value = way.value.extended({s: -n for s, n in back.items()})
    return Working(simplified(way.size.xreplace(opposite)), before, value, senses)


@record
class _Told:
    """The formulas of a rejected case. `put`: what is zero there, and letters that the page has for others. What the
    page tells of its own case with the same number has no line of its own here.
    """

    formulas: Mapping[sp.Symbol, sp.Expr]
    put: Mapping[sp.Symbol, sp.Expr]
    value: Valuation
    instant: InstantSolution
    aside: bool = True

    @classmethod
    def of(cls, stages: Iterable[Stage], value: Valuation, instant: InstantSolution, aside: bool = True) -> _Told:
        """What the stages of a rejected case tell. `aside`: is what the page tells with the same number left out?"""
        stages = tuple(stages)
        named = {x.symbol: x.expression for stage in stages for x in stage.lines}
        formulas = {s: e for s, e in named.items() if not s.name.endswith(PRIME)}
        formulas |= {x.symbol: x.formula for s in stages for b in s.blocks for x in b.lines if not x.letters}
        # The page has the letter without a prime for its own case.
        put = {s: e for s, e in named.items() if s.name.endswith(PRIME)}
        put |= {s: sp.S.Zero for stage in stages for s in stage.zero}
        put |= {s: sp.S.Zero for s in formulas if value(s) == 0}
        return cls(formulas, put, value, instant, aside)

    def formula(self, symbol: sp.Symbol) -> sp.Expr | None:
        """The formula of an unknown without what is zero, and without names that the page does not explain."""
        found = self.formulas.get(symbol)
        if found is None:
            return None
        found = found.xreplace(dict(self.put))
        definitions, held = self.instant.instant.scene.ledger.definitions, self._held()
        while inside := {s: definitions[s] for s in found.free_symbols - held if s in definitions}:
            found = found.xreplace(inside)
        return _plain(simplified(found) if inside else found)

    def behind(self, expr: sp.Expr, seen: tuple[sp.Symbol, ...]) -> Iterator[tuple[sp.Symbol, sp.Expr]]:
        """The unknowns in a formula with their own, those first on which others rest."""
        for symbol in sorted(expr.free_symbols, key=lambda s: s.name):
            own = None if symbol in seen or (self.aside and self._is_told(symbol)) else self.formula(symbol)
            if own is not None:
                seen = (*seen, symbol)
                for one, formula in self.behind(own, seen):
                    seen = (*seen, one)
                    yield one, formula
                yield symbol, own

    def _held(self) -> set[sp.Symbol]:
        """The letters in the equations of the page."""
        stages = self.instant.stages
        return {s for stage in stages for b in stage.blocks for w in b.equations for s in w.residual.free_symbols}

    def _is_told(self, symbol: sp.Symbol) -> bool:
        """Does the page give it the same number?"""
        mine, other = self.value.known(symbol), self.instant.value.known(symbol)
        unknowns = {s for stage in self.instant.stages for b in stage.blocks for s in b.unknowns}
        return symbol in unknowns and mine is not None and other is not None and abs(mine - other) <= NEAR * abs(mine)


def _plain(expr: sp.Expr) -> sp.Expr:
    """The same with short fractions for those that only sixty digits make of them."""
    short = {n: n.limit_denominator(DENOMINATOR) for n in expr.atoms(sp.Rational) if n.q > DENOMINATOR}
    return expr.xreplace({n: f for n, f in short.items() if abs(n - f) < NEAR})


def _is_plain(expr: sp.Expr) -> bool:
    """Has it no fraction that only sixty digits make?"""
    return all(n.q <= DENOMINATOR for n in expr.atoms(sp.Rational))
