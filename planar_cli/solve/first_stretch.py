"""What holds throughout a motion, beside that motion as it was followed.

A formula in the place holds from the first state to the next, as long as nothing that moves turns round: a root has
one sign so far. It is compared at these two states and at places between them. At the states alone it would be only
half seen: from rest both sides are zero there, and the rounding of a place may put what is zero below a root below it.
"""

from __future__ import annotations

from collections.abc import Iterator
from decimal import Decimal

import sympy as sp

from planar_cli.errors import Mark, NoValue
from planar_cli.motion.regime.regime import Regime
from planar_cli.problem.language.expression import Name, Side
from planar_cli.records import record
from planar_cli.simulate.measures import START, Moment
from planar_cli.simulate.run import Run
from planar_cli.simulate.timetable import Timetable
from planar_cli.solve.between.trace.trace import MotionTrace
from planar_cli.solve.contradicted import Seen, shown
from planar_cli.solve.instances import Instance
from planar_cli.solve.solution import Found

CERTAIN = 1e-6
"""Numbers that are apart by less than this part of them, or of the scale of their kind, agree."""
ALONG = 0.5
"""So many characteristic times a motion is followed that the file does not end, where a formula is to hold along it."""
PARTS = (0.2, 0.45, 0.8)
"""The places between the states, in parts of the time."""
FAINT = 1e-9
"""Speeds below this part of their scale may be the rounding of rest."""
STAYS = "the place of which it is a formula does not change in the motion that was followed"


def varies(f: Found, trace: MotionTrace) -> bool:
    """Is an answer a formula in what changes along the motion?"""
    return f.values is None and any(sp.sympify(e).free_symbols & trace.varying for e in f.expressions or ())


@record
class FirstStretch:
    """The first stretch of one motion."""

    run: Run
    """The motion."""
    trace: MotionTrace
    """How it was solved."""
    instance: Instance
    """Numbers of the letters."""

    def see(self, f: Found, what: Side) -> Seen:
        """One find that holds throughout, a number or a formula."""
        if f.values is None and not f.expressions:
            return Seen(f.name, "its formula is not printed")
        formulas = [sp.sympify(e) for e in f.expressions or ()] if f.values is None else []
        if formulas and not self._told(formulas):
            return Seen(f.name, "its formula holds more than the time and coordinates")
        between = list(self._between())
        for moment in (*self._states(bool(formulas)), *between):
            found, others = self._found(f, formulas, moment), self.run.measures.at(what, moment)
            if found is None and moment not in between:
                continue
            if found is None or not self._agree(what, found, others):
                us = self.run.problem.us
                told = "no real value" if found is None else shown(found, f.unit, us)
                other = shown([Decimal(repr(v)) for v in others], f.unit, us)
                return Seen(f.name, "", other, told, f"t = {moment.t:.9g} s")
        return Seen(f.name, "" if not formulas or self._changes(formulas, between) else STAYS)

    def _agree(self, what: Side, found: list[Decimal], others: tuple[float, ...]) -> bool:
        scale = Timetable(self.run.problem, self.run.measures).scale(what)
        apart = max(abs(float(x) - y) for x, y in zip(found, others, strict=True))
        return apart <= CERTAIN * max([*map(abs, others), scale])

    def _changes(self, formulas: list[sp.Expr], between: list[Moment]) -> bool:
        """Do the time or the coordinates in these formulas change? Beside what moves others may rest."""
        letters = {s for e in formulas for s in e.free_symbols}
        places = [self._now(m) for m in (self.run.measures.moments[START], *between)]
        return any(now[s] != places[0][s] for now in places for s in letters & now.keys())

    def _told(self, formulas: list[sp.Expr]) -> bool:
        """Do the letters, the time and the coordinates tell these formulas?"""
        value = self.instance.value.extended(self._now(self.run.measures.moments[START]))
        letters = {s for e in formulas for s in e.free_symbols}
        return all(value.known(s) is not None for s in letters)

    def _found(self, f: Found, formulas: list[sp.Expr], moment: Moment) -> list[Decimal] | None:
        """What was solved, at one moment; None: the formula is not real there."""
        if not formulas:
            return [Decimal(v) for v in f.values or ()]
        value = self.instance.value.extended(self._now(moment))
        try:
            return [value(e) for e in formulas]
        except NoValue:
            return None

    def _now(self, moment: Moment) -> dict[sp.Symbol, Decimal]:
        """Time and coordinates at a moment."""
        known, measures, problem = self.trace.ledger.symbols, self.run.measures, self.run.problem
        names = [n for n in ("t", *(c.name for c in problem.coordinates)) if n in known]
        here = {n: measures.at(Name(n, None, Mark(problem.file, 1, 1)), moment)[0] for n in names}
        return {known[n]: Decimal(repr(v)) for n, v in here.items()}

    # --- where it is compared ----------------------------------------------------------------------------------------

    def _states(self, first: bool) -> Iterator[Moment]:
        """The states that were reached; `first`: the first stretch alone."""
        names = [s.name for s in self.run.problem.states] or [START]
        moments = self.run.measures.moments
        yield from (moments[n] for n in (names[:2] if first else names) if n in moments)

    def _between(self) -> Iterator[Moment]:
        """Moments of the first stretch, as long as what moves keeps its sense; none where nothing moves."""
        segment = next((s for s in self.run.trajectory.segments if s.steps), None)
        if segment is None:
            return
        assert isinstance(segment.regime, Regime)
        second = [self.run.measures.moments.get(s.name) for s in self.run.problem.states[1:2]]
        until = min([segment.t1, *(m.t for m in second if m is not None)])
        senses: list[int] = []
        for t in (min(step.t1, until) for step in segment.steps):
            now = self._senses(segment.at(t))
            if any(a * b < 0 for a, b in zip(senses, now, strict=False)):
                break
            senses, end = [b or a for a, b in zip(senses or now, now, strict=True)], t
        if any(senses):
            for part in PARTS:
                t = segment.t0 + part * (end - segment.t0)
                yield Moment(segment.regime, {}, t, tuple(segment.at(t)))

    def _senses(self, y: list[float]) -> list[int]:
        """Of every speed 1 or -1; 0: it is no more than rounding."""
        model = self.run.measures.model
        half = model.layout.count
        speeds = zip(y[half:], model.scale[half:], strict=True)
        return [0 if abs(v) < FAINT * s else 1 if v > 0 else -1 for v, s in speeds]
