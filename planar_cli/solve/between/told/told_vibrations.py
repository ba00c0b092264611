"""Driven vibrations as they are told: what the force keeps up, and a free vibration with A and B from its start."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from decimal import Decimal

import sympy as sp

from planar_cli.calculus.linear_laws import EQUATION
from planar_cli.calculus.vibrations import Vibration
from planar_cli.equation.algebra.plain import simplified
from planar_cli.equation.values.exact import Valuation
from planar_cli.solve.between.equations.stated_motion import StatedMotion
from planar_cli.solve.between.trace.trace import Relation, Result


class VibrationTracer:
    """Writes relations of driven vibrations with A and B. `value`: numbers of everything."""

    def __init__(self, course: StatedMotion, value: Valuation) -> None:
        self.course, self.value = course, value
        self.numbers: dict[sp.Symbol, Decimal] = {}
        self._begun: dict[tuple[sp.Symbol, str], tuple[tuple[sp.Symbol, sp.Expr], ...]] = {}

    def told(self, e: Relation, plain: Mapping[sp.Symbol, sp.Expr]) -> Relation:
        """A relation by the time of a driven vibration in A and B; any other as it is. `plain`: what needs no line."""
        own = e.law.vibration if e.law is not None else None
        if own is None or e.law is None or e.span is None or e.span.explicit is None or EQUATION not in e.span.words:
            return e
        time = self.course.ledger.symbols["t"]
        if time not in own.steady.free_symbols or e.stop not in self.course.stops or e.since not in self.course.stops:
            return e
        begun = self._amplitudes(e, own, time, plain)
        t0, t1 = (self.course.stops[s].t.xreplace(dict(plain)) for s in (e.since, e.stop))
        a, b = (x if self.numbers[x] else sp.S.Zero for x, _ in begun)
        place = own.steady + own.free_motion(time - t0, a, b)
        formula = (place if e.span.kind == "q(t)" else sp.diff(place, time)).xreplace({time: t1})
        residual = e.span.residual + e.span.explicit - formula
        law = replace(e.law, vibration=replace(own, begun=begun))
        return replace(e, residual=residual, span=replace(e.span, residual=residual, explicit=formula), law=law)

    def _amplitudes(
        self, e: Relation, own: Vibration, time: sp.Symbol, plain: Mapping[sp.Symbol, sp.Expr]
    ) -> tuple[tuple[sp.Symbol, sp.Expr], ...]:
        """A and B since a state, with their formulas."""
        key = (own.natural, e.since)
        if key in self._begun:
            return self._begun[key]
        assert e.law is not None
        start, law, ledger = self.course.stops[e.since], e.law, self.course.ledger
        speed = sp.S.Zero if law.speed is None else law.factor * start.letters[law.speed]
        kept = [x.xreplace({time: start.t}) for x in (own.steady, sp.diff(own.steady, time))]
        q0, v0 = start.letters[law.coordinate.symbol] - kept[0], speed - kept[1]
        a, b = (ledger.fresh(name, law.coordinate.unit) for name in ("A", "B"))
        formulas = own.amplitudes(q0.xreplace(dict(plain)), v0.xreplace(dict(plain)), a)
        for letter, formula in zip((a, b), formulas, strict=True):
            known = self.value.extended(self.numbers)
            self.numbers[letter] = Decimal(0) if known.is_zero(formula) else known(formula)
        self._begun[key] = tuple(zip((a, b), map(simplified, formulas), strict=True))
        return self._begun[key]

    @staticmethod
    def results(relations: Sequence[Relation], results: tuple[Result, ...]) -> tuple[Result, ...]:
        """The results of a step whose relation gives its letter."""
        (e, *more) = relations
        if more or e.law is None or e.law.vibration is None or not e.law.vibration.begun or e.span is None:
            return results
        assert e.span.explicit is not None
        own = e.span.residual + e.span.explicit
        return tuple(replace(r, formula=e.span.explicit) if r.unknown == own else r for r in results)
