"""What friction would have to be where an assumption fails, worked out by the equations of that case.

then a_B = (P - μ_B N_B)/(m_A + m_B) = (90 - 0.1 · 127.5)/(5 + 8) = 5.942 m/s²; it would need |F_A| = m_A a_B = …
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import replace
from decimal import Decimal

import sympy as sp

from planar_cli.equation.exact import Valuation
from planar_cli.equation.plain import longer, simplified
from planar_cli.errors import PlanarError
from planar_cli.problem.facts import Push
from planar_cli.records import record
from planar_cli.report.blocks import Line, line
from planar_cli.report.words import Phrases
from planar_cli.solve.instant.finish import Finisher
from planar_cli.solve.instant.instant import Trial
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
    before it. `value`: the numbers of the rejected case.
    """

    size: sp.Expr
    before: tuple[tuple[sp.Symbol, sp.Expr], ...]
    value: Valuation

    def told(self, phrases: Phrases) -> Line:
        """then a = (P - μ N)/m = 5.942 m/s², α = …; empty where nothing is told before."""
        there = replace(phrases, value=self.value)
        parts = line("then ")
        for symbol, formula in self.before:
            value = there.shown(symbol)
            numbers = [piece for side in there.substituted(formula, value) for piece in (" = ", side)]
            comma = ", " if len(parts) > 1 else ""
            parts += line(comma, there.math(symbol), " = ", there.math(formula), *numbers, " = ", value)
        return parts if len(parts) > 1 else ()


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
    named = {x.symbol: x.expression for stage in stages for x in stage.lines}
    formulas = {s: e for s, e in named.items() if not s.name.endswith(PRIME)}
    formulas |= {x.symbol: x.formula for s in stages for b in s.blocks for x in b.lines if not x.letters}
    # The page has the letter without a prime for its own case.
    put = {s: e for s, e in named.items() if s.name.endswith(PRIME)}
    put |= {s: sp.S.Zero for stage in stages for s in stage.zero} | {s: sp.S.Zero for s in formulas if value(s) == 0}
    told = _Told(formulas, put, value, instant)
    own = told.formula(symbol)
    number = None if own is None else value.known(own)
    if own is None or number is None or abs(abs(number) - size) > NEAR * size:
        return None
    own = own if number > 0 else simplified(-own)
    before = tuple(told.behind(own, ()))
    if len(before) > FEW or any(longer(e, LONGEST) or not _is_plain(e) for e in (own, *(e for _, e in before))):
        return None
    return Working(own, before, value)


@record
class _Told:
    """The formulas of a rejected case. `put`: what is zero there, and letters that the page has for others. What the
    page tells of its own case with the same number has no line of its own here.
    """

    formulas: Mapping[sp.Symbol, sp.Expr]
    put: Mapping[sp.Symbol, sp.Expr]
    value: Valuation
    instant: InstantSolution

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
            own = None if symbol in seen or self._is_told(symbol) else self.formula(symbol)
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
