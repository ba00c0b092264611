"""A motion over time: its states, the regimes between them, its equations, and which of their roots happen."""

from __future__ import annotations

from dataclasses import dataclass, field
from decimal import Decimal

import sympy as sp

from planar_cli.equation.conditions import order
from planar_cli.equation.exact import Unvalued, Valuation
from planar_cli.problem.expression import Relation, Statement
from planar_cli.problem.scene import Problem, State
from planar_cli.solve.course.blow import Blow, arriving, asked_of_blows, make_blow
from planar_cli.solve.course.chain import Chain
from planar_cli.solve.course.equations import (
    Equation,
    Laws,
    at_limits,
    drawn_equations,
    ending_equations,
    kept_equations,
    law_equations,
    laws_of,
    link_equations,
    loop_equations,
    stated_equations,
)
from planar_cli.solve.course.extremes import stationary
from planar_cli.solve.course.laws_between import LawsBetween
from planar_cli.solve.course.oscillation import Oscillation, oscillations_asked, periods
from planar_cli.solve.course.plot import Plot, Workshop, fixed_time
from planar_cli.solve.course.regime import Regime
from planar_cli.solve.course.regime_sequence import RegimeSequence, regime_sequence
from planar_cli.solve.course.span_quantities import SpanQuantity, ask_spans, tell_spans
from planar_cli.solve.course.still import Still, stand_still
from planar_cli.solve.course.takeover import handing_of, later_equations, resting_equations
from planar_cli.solve.course.timeline import Demand, Stop
from planar_cli.solve.course.touch import Touch

TINY = Decimal("1e-15")


@dataclass(slots=True)
class Course(RegimeSequence):
    """The motion of one problem along one plot. `still`: the equilibrium states, solved; `spanned`: quantities over
    spans; `swings`: about equilibrium states. `said`: by regime, what the file states and asks in it. `blows[i]`:
    between state i and the next; `handings`: by regime, the free speeds of others in its own motion; `between`: laws
    of energy and momentum.
    """

    laws: list[Laws] = field(default_factory=list)
    demands: dict[str, list[Demand]] = field(default_factory=dict)
    placed: dict[str, list[Demand]] = field(default_factory=dict)
    equations: list[Equation] = field(default_factory=list)
    touches: list[Equation] = field(default_factory=list)
    differences: list[sp.Symbol] = field(default_factory=list)
    touch: Touch | None = None
    still: Still | None = None
    spanned: dict[sp.Symbol, SpanQuantity] = field(default_factory=dict)
    swings: dict[str, Oscillation] = field(default_factory=dict)
    blows: dict[int, Blow] = field(default_factory=dict)
    handings: dict[int, dict[sp.Symbol, sp.Expr]] = field(default_factory=dict)
    said: dict[int, tuple[sp.Expr, ...]] = field(default_factory=dict)
    between: LawsBetween = field(default_factory=LawsBetween)

    # --- equations ---------------------------------------------------------------------------------------------------

    def read(self) -> None:
        """Read all states, work out every regime, and write the equations of the first state."""
        raw = {s.name: self.readers[s.name].raw(s.relations) for s in self.states}
        always = {s.name: self.readers[s.name].raw(self._places(i)) for i, s in enumerate(self.states)}
        beside = {s.name: self.readers[s.name].raw(s.relations) for s, _ in self.plot.equilibria}
        self.spanned = ask_spans(self)
        self.said = {id(r.regime): tuple(r.exprs) for r in self.distinct_readers()}
        self._ask_handing()
        for regime in self.running():
            next(r for r in self.distinct_readers() if r.regime is regime).exprs += self.between.exprs(regime)
        for regime in self.distinct_regimes():
            exprs = [e for r in self.distinct_readers() if r.regime is regime for e in r.exprs]
            regime.work(exprs, any(r is regime for r in self.running()))
        for s in self.states:
            self.placed[s.name] = self.readers[s.name].demands(self.stops[s.name], always[s.name])
        self._strike()
        self.between.close(self.regimes)
        self.swings = oscillations_asked(self)
        self.told |= periods(self, self.swings)
        if self.spanned:
            tell_spans(self, self.spanned, self.blows, raw)
        self.still = stand_still(self, beside)
        for s in self.states:
            self.demands[s.name] = self.readers[s.name].demands(self.stops[s.name], raw[s.name])
        self.laws = [laws_of(r) if r.runs else Laws((), (), ()) for r in self.regimes]
        self.equations = self._at_limits([*self._stated(), *self._beginning()])

    def relate(self) -> None:
        """All equations, from state to state; they take long, so that only a plot that may happen has them."""
        self.equations = self._at_limits([*self._stated(), *self._beginning(), *self._moving(), *self.touches])
        self.equations += self._stationary()

    def _at_limits(self, equations: list[Equation]) -> list[Equation]:
        return at_limits(equations, self.infinite(), self.regimes[0].general.value) if self.states else []

    def _ask_handing(self) -> None:
        """Letters of other regimes, and how bodies arrive at blows, are worked out with each regime."""
        for reader in self.distinct_readers():
            self.handings[id(reader.regime)] = handing_of(reader.regime, self.distinct_regimes())
            reader.exprs += self.handings[id(reader.regime)].values()
        for i, stretch in enumerate(self.plot.stretches):
            for state in self.states[i : i + 2] if stretch.blow is not None else ():
                reader = self.readers[state.name]
                reader.exprs += [e for v, spin in arriving(reader.regime).values() for e in (v.x, v.y, spin)]

    def _strike(self) -> None:
        """The blows, once the velocities before them are worked out."""
        for i, stretch in enumerate(self.plot.stretches):
            if stretch.blow is not None:
                self.blows[i] = make_blow(
                    self, i, stretch.blow, stretch.blow_choice, bool(self.placed[self.first.name])
                )
                self.blows[i].work(asked_of_blows(self.problem))
                units = self.blows[i].scene.ledger.units
                self.ledger.units |= {x: units[x] for x in self.blows[i].letters if x in units}

    def infinite(self) -> dict[sp.Symbol, sp.Expr]:
        """Letters that become infinite in their state."""
        found = {}
        for state in self.states:
            for d in self.demands[state.name]:
                if d.kind == "limit":
                    letter = max(d.residual.free_symbols, key=lambda s: s in self.stops[state.name].letters.values())
                    found[letter] = sp.oo if sp.diff(d.residual, letter) == 1 else -sp.oo
        return found

    def _places(self, i: int) -> tuple[Statement, ...]:
        """What `motion` says of places all the time, where state i is reached."""
        stretch = self.plot.stretches[max(i - 1, 0)]
        names = {c.name for c in self.problem.coordinates}
        return tuple(s for s in stretch.span.always if isinstance(s, Relation) and order(s, names) == 0)

    def _stated(self) -> list[Equation]:
        found: list[Equation] = []
        for s in self.states:
            stop = self.stops[s.name]
            found += list(stated_equations(self.demands[s.name]))
            found += list(stated_equations(self.placed[s.name], "motion"))
            for d in self.demands[s.name]:
                if d.kind == "extreme" and not self.is_set(s):
                    rate = stop.at(self.readers[s.name].regime.derivative(d.residual))
                    found.append(Equation(rate, "extreme", d.text, s.name, mark=d.mark))
        for name, (expr, words) in self.plot.turnings.items():
            found.append(Equation(self.stops[name].at(expr), "turn", words, name))
        first = self.first
        if not any(first.t in e.residual.free_symbols for e in found if e.stop == first.name):
            found.append(Equation(first.t, "start", "time is counted from here", first.name))
        return found

    def is_set(self, state: State) -> bool:
        """Is the time of a state fixed by something else than what is largest there?"""
        return any(d.kind == "equation" for d in self.demands[state.name])

    def _stationary(self) -> list[Equation]:
        """What is largest or smallest for a constant that is sought."""
        found: list[Equation] = []
        for s in self.states:
            for d in self.demands[s.name]:
                if d.kind == "extreme" and self.is_set(s):
                    chain = self.chain()
                    kept = frozenset((*chain.times, *self.sought()))
                    like = Equation(sp.S.Zero, "extreme", d.text, s.name, mark=d.mark)
                    objective = self.stops[s.name].at(d.residual)
                    found += stationary(self.equations, objective, chain.unknowns, kept, like)
        return found

    def _beginning(self) -> list[Equation]:
        """How the first state is drawn."""
        if not self.states:
            return []
        first = self.first
        placed = {x for d in self.placed[first.name] for x in d.residual.free_symbols} - {first.t}
        found = [e for e in drawn_equations(self.regimes[0], first) if not e.residual.free_symbols & placed]
        later = [*self.regimes, self.beyond] if self.beyond is not None else self.regimes
        found += list(later_equations(later, first, self.handing(self.regimes[0])))
        return found + list(loop_equations(self.readers[first.name].regime, first, first))

    def _moving(self) -> list[Equation]:
        """What the motion from state to state says."""
        found: list[Equation] = []
        since = 0
        for i, state in enumerate(self.states):
            stop = self.stops[state.name]
            regime = self.readers[state.name].regime
            if i - 1 in self.blows:
                found += self.blows[i - 1].equations
            if i == 0 or i - 1 in self.blows:
                continue
            found += list(loop_equations(regime, self.first, stop))
            if i >= 2 and (i - 2 in self.blows or self.regimes[i - 1] is not self.regimes[i - 2]):
                since = i - 1
            start = self.stops[self.states[since].name]
            laws = self.laws[i - 1]
            found += list(law_equations(laws, start, stop, regime, regime.general.value))
            found += list(link_equations(laws, start, stop, regime))
            found += list(kept_equations(regime, start, stop))
            found += list(self.between.equations(self, i))
            if stop.t in self.infinite():
                found += list(ending_equations(laws, stop, regime))
            found += list(resting_equations(regime, self.stops[self.states[i - 1].name], stop, self.handing(regime)))
        return found

    def handing(self, regime: Regime) -> dict[sp.Symbol, sp.Expr]:
        """Letters of other regimes as formulas of this one."""
        other = {s for r in self.distinct_regimes() for s in r.letters} - set(regime.letters)
        found = {u: regime.closed(e) for u, e in self.handings[id(regime)].items()}
        return {u: e for u, e in found.items() if not e.free_symbols & other}

    # --- solution ----------------------------------------------------------------------------------------------------

    def base(self) -> Valuation:
        """Numbers of everything that is known, also of the equilibrium states."""
        known = self.given()
        return known if self.still is None else known.extended(self.still.branch.values)

    def parameters(self) -> set[sp.Symbol]:
        """What has no number of its own: letters of the file, as they were drawn."""
        return set(self.base().drawn)

    @property
    def symbolic(self) -> bool:
        """Do letters of the file stay in the equations?"""
        parameters = self.parameters()
        return any(e.residual.free_symbols & parameters for e in self.equations)

    def chain(self) -> Chain:
        """The solver of the equations."""
        own = [*self.between.impulses.values(), *(s for blow in self.blows.values() for s in blow.letters)]
        letters = [v for s in self.stops.values() for v in s.letters.values()]
        unknowns = frozenset([*letters, *self.sought(), *own, *self.differences])
        times: dict[sp.Symbol, sp.Symbol | None] = {}
        angles: dict[sp.Symbol, sp.Symbol | None] = {}
        before: Stop | None = None
        units = self.ledger.units
        for state in self.states:
            stop = self.stops[state.name]
            struck = any(blow.stop is stop for blow in self.blows.values())
            times[stop.t] = None if before is None or struck or fixed_time(state.relations) else before.t
            for general, own in stop.letters.items():
                if units[own].angle and general.name != "t" and units[own].text in ("rad", "deg", "rev"):
                    angles[own] = before.letters[general] if before is not None else None
            before = stop
        return Chain(unknowns, times, angles, self.base(), self.symbolic, self._possible)

    def _possible(self, values: dict[sp.Symbol, Decimal]) -> bool:
        """Do the inequalities and the order of times hold, as far as they can be told?"""
        number = self.base().extended(values)
        before: Stop | None = None
        for state in self.states:
            stop = self.stops[state.name]
            if (
                before is not None
                and not fixed_time(state.relations)
                and not any(blow.stop is stop for blow in self.blows.values())
                and {stop.t, before.t} <= set(values)
                and values[stop.t] <= values[before.t] + TINY * max(abs(values[before.t]), TINY)
            ):
                return False
            before = stop
            for d in self.demands[state.name]:
                if d.kind == "inequality":
                    try:
                        v = number(d.residual)
                    except (Unvalued, ArithmeticError):
                        continue
                    if v < -TINY or (d.sign and v <= TINY):
                        return False
        return True


def make_course(problem: Problem, plot: Plot, workshop: Workshop) -> Course:
    """The course of a problem along one plot, ready to read finds."""
    found = regime_sequence(problem, plot, workshop)
    parts = (found.regimes, found.beyond, found.stops, found.readers, found.tellers, found.told)
    return Course(problem, plot, workshop, *parts)
