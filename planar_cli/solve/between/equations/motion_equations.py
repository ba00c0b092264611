"""The equations of a motion over several states, and which of their roots are possible."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from decimal import Decimal

import sympy as sp

from planar_cli.equation.algebra.plain import derivative
from planar_cli.equation.values.exact import Valuation
from planar_cli.errors import refuse
from planar_cli.problem.scene.scene import Round
from planar_cli.records import record
from planar_cli.solve.between.equations.lasting_laws import lasting_equations
from planar_cli.solve.between.equations.mass_centres import mass_centre_equations
from planar_cli.solve.between.equations.stated_motion import StatedMotion
from planar_cli.solve.between.roots.chain import Chain
from planar_cli.solve.between.roots.extremes import stationary
from planar_cli.solve.following.departure import Departure
from planar_cli.solve.regimes.along_curves import arc_lengths, curve_equations
from planar_cli.solve.regimes.equations import (
    Equation,
    at_limits,
    drawn_equations,
    ending_equations,
    kept_equations,
    law_equations,
    link_equations,
    loop_equations,
    stated_equations,
)
from planar_cli.solve.regimes.kepler import anomalies
from planar_cli.solve.regimes.meetings import meeting_equations
from planar_cli.solve.regimes.mode_sequence import fixed_time
from planar_cli.solve.regimes.orbits import orbit_equations
from planar_cli.solve.regimes.standing import begun_at, standing_at, standing_equations
from planar_cli.solve.regimes.symmetric import symmetric_equations
from planar_cli.solve.regimes.timeline import Stop
from planar_cli.solve.regimes.transfer import later_equations, resting_equations
from planar_cli.units import TIME

TINY = Decimal("1e-15")


@record
class MotionEquations(StatedMotion):
    """The equations of a motion between the symbols of its states, and the search for their roots."""

    equations: tuple[Equation, ...]
    """What must hold: of the first state alone, or from state to state."""
    separations: tuple[Equation, ...] = ()
    """What has just parted at the first state has no velocity apart."""
    differences: tuple[sp.Symbol, ...] = ()
    """Differences of places that are unknowns of their own."""
    departure: Departure | None = None
    """The disturbance that sends it off from an unstable equilibrium; None: it begins by itself."""

    @property
    def symbolic(self) -> bool:
        """Do letters of the file stay in the equations?"""
        parameters = self.parameters()
        rows = (r for swing in self.swings.values() for r in (*swing.stiffness, *swing.damping))
        every = (*(e.residual for e in self.equations), *(sp.sympify(e) for row in rows for e in row))
        return any(e.free_symbols & parameters for e in every)

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
                if units[own].angle and general != stop.time and units[own].text in ("rad", "deg", "rev"):
                    angles[own] = before.letters[general] if before is not None else None
            before = stop
        natural = self.natural(unknowns)
        return Chain(unknowns, times, angles, self.base(), self.symbolic, self._possible, natural=natural)

    def _possible(self, values: dict[sp.Symbol, Decimal]) -> bool:
        """Do the inequalities and the order of times hold, as far as they can be told?"""
        number = self.base().extended(values)
        nothing = TINY * self.scales.exact(TIME)
        before: Stop | None = None
        for state in self.states:
            stop = self.stops[state.name]
            if (
                before is not None
                and not fixed_time(state.relations)
                and not any(blow.stop is stop for blow in self.blows.values())
                and {stop.t, before.t} <= set(values)
                and values[stop.t] <= values[before.t] + TINY * max(abs(values[before.t]), nothing)
            ):
                return False
            before = stop
            for d in self.demands[state.name]:
                if d.kind == "inequality":
                    v = number.known(d.residual)
                    slack = Decimal(0) if v is None else TINY * number.size(d.residual)
                    if v is not None and (v < -slack or (d.sign and v <= slack)):
                        return False
        return True


def first_equations(motion: StatedMotion) -> MotionEquations:
    """The equations of the first state."""
    written = [*_stated(motion), *_beginning(motion)]
    return MotionEquations(**motion.parts(), equations=_at_limits(motion, written))


def all_equations(motion: MotionEquations) -> MotionEquations:
    """All equations, from state to state; they take long, so that only modes that may happen have them."""
    first = [*_stated(motion), *_beginning(motion)]
    begun = {} if motion.departure is not None else begun_at(first, motion.first)
    written = [*first, *_moving(motion, begun, first), *motion.separations]
    equations = _at_limits(motion, written)
    found = replace(motion, equations=equations, differences=(*arc_lengths(equations), *anomalies(equations)))
    return replace(found, equations=(*found.equations, *_stationary(found)))


def _at_limits(motion: StatedMotion, equations: list[Equation]) -> tuple[Equation, ...]:
    """The equations where letters become infinite in their state."""
    return tuple(at_limits(equations, motion.infinite(), motion.regimes[0].general.value)) if motion.states else ()


def _stated(motion: StatedMotion) -> list[Equation]:
    found: list[Equation] = []
    for s in motion.states:
        stop = motion.stops[s.name]
        found += list(stated_equations(motion.demands[s.name]))
        found += list(stated_equations(motion.placed[s.name], "motion"))
        for d in motion.demands[s.name]:
            if d.kind == "extreme" and not motion.is_set(s):
                rate = stop.at(motion.readers[s.name].regime.derivative(d.residual))
                found.append(Equation(rate, "extreme", d.text, s.name, mark=d.mark, of=stop.at(d.residual)))
    for name, (expr, words) in motion.modes.turnings.items():
        found.append(Equation(motion.stops[name].at(expr), "turn", words, name))
    first = motion.first
    if not any(first.t in e.residual.free_symbols for e in found if e.stop == first.name):
        if motion.states and motion.states[0].dated:
            text = "what depends on t has a value only at a time that is known"
            raise refuse(first.mark, "PL590", text, "say at which time, `t = 2 s`, or what tells it: a place, a speed")
        found.append(Equation(first.t, "start", "time is counted from here", first.name))
    return found


def _stationary(motion: MotionEquations) -> list[Equation]:
    """What is largest or smallest for a constant that is sought."""
    found: list[Equation] = []
    for s in motion.states:
        for d in motion.demands[s.name]:
            if d.kind == "extreme" and motion.is_set(s):
                chain = motion.chain()
                sought = frozenset(motion.sought())
                kept = sought.union(chain.times)
                like = Equation(sp.S.Zero, "extreme", d.text, s.name, mark=d.mark)
                stop = motion.stops[s.name]
                told = stationary(motion.equations, stop.at(d.residual), chain.unknowns, kept, like, sought)
                if any(e.kind == "extreme" and e.residual == 0 for e in told):
                    # As it is the same whatever the constant is, it is largest in time, and the constant is told by
                    # what else is stated there.
                    regime = motion.readers[s.name].regime
                    rate = regime.derivative(d.residual)
                    bend = stop.at(regime.derivative(rate))
                    told = [replace(like, residual=stop.at(rate), trend=-d.extreme * bend)]
                found += told
    return found


def _beginning(motion: StatedMotion) -> list[Equation]:
    """How the first state is drawn."""
    if not motion.states:
        return []
    first = motion.first
    placed = _placed(motion)
    speeds = {first.letters[u] for u in motion.regimes[0].free}
    told = (d.residual.free_symbols for d in motion.demands[first.name])
    # Where an equilibrium is drawn, that is where the motion begins as far as nothing else tells it.
    before = any(s.before for s in motion.problem.states)
    shown = set(first.letters.values()) if before else _unseen(motion)
    placed |= shown & {x for inside in told if not inside & speeds for x in inside}
    found = [e for e in drawn_equations(motion.regimes[0], first) if not e.residual.free_symbols & placed]
    later = [*motion.regimes, motion.beyond] if motion.beyond is not None else motion.regimes
    found += list(later_equations(later, first, motion.transfer(motion.regimes[0])))
    return found + list(loop_equations(motion.readers[first.name].regime, first, first))


def _placed(motion: StatedMotion) -> set[sp.Symbol]:
    """Letters of the first state that `motion` tells. Where it only ties several of them to each other, as on a
    slanting line, and is met in the drawn position, the drawing tells them.
    """
    first, told = motion.first, motion.placed[motion.first.name]
    found = {x for d in told for x in d.residual.free_symbols} - {first.t}
    drawn = {first.letters[c.symbol]: c.drawn for c in motion.regimes[0].coordinates if c.drawn is not None}
    dated = [d.residual for d in motion.demands[first.name] if d.residual.free_symbols == {first.t}]
    if dated and derivative(dated[0], first.t) == 1:
        drawn[first.t] = first.t - dated[0]
    ties = len(found) > len(told) and found <= set(drawn)
    met = ties and all(motion.given().vanishes(d.residual.xreplace(drawn)) for d in told)
    return set() if met else found


def _not_forward(known: Mapping[sp.Symbol, sp.Expr], value: Valuation) -> Iterator[tuple[sp.Symbol, Decimal]]:
    """Letters of a start that are negative or zero: a root of a formula in time goes that way, where it would be
    positive, and what starts at rest stays below the speed at which its drag carries it.
    """
    for letter, told in known.items():
        number = value.known(told)
        if number is not None and number <= 0:
            yield letter, number


def _unseen(motion: StatedMotion) -> set[sp.Symbol]:
    """Angles in the first state that no drawing shows: of round bodies that carry nothing but their centre."""
    scene = motion.regimes[0].general.instant.scene
    carrying = {s.body for s in scene.problem.surfaces}
    marks = {b.name: {p for p, names in scene.owners.items() if b.name in names} for b in scene.problem.bodies}
    plain = {
        b.name
        for b in scene.problem.bodies
        if isinstance(b.shape, Round) and marks[b.name] <= {b.shape.center} and b.name not in carrying
    }
    letters = motion.first.letters
    return {letters[c.symbol] for c in motion.regimes[0].coordinates if c.unit == "rad" and c.body in plain}


def _moving(motion: StatedMotion, begun: Mapping[sp.Symbol, sp.Expr], data: Sequence[Equation]) -> list[Equation]:
    """What the motion from state to state says. `begun`: what is known of the letters of the first state; `data`: what
    is stated of all states.
    """
    found: list[Equation] = []
    known, settled = dict(begun), motion.settled()
    since = 0
    for i, state in enumerate(motion.states):
        stop = motion.stops[state.name]
        regime = motion.readers[state.name].regime
        if i - 1 in motion.blows:
            found += motion.blows[i - 1].equations
        if i == 0 or i - 1 in motion.blows:
            continue
        found += list(loop_equations(regime, motion.first, stop))
        if i >= 2 and (i - 2 in motion.blows or motion.regimes[i - 1] is not motion.regimes[i - 2]):
            since = i - 1
        start = motion.stops[motion.states[since].name]
        laws, value = motion.laws[i - 1], regime.general.value.extended(settled)
        stated = known | begun_at(data, start)
        by_laws = law_equations(laws, start, stop, regime, value.extended(dict(_not_forward(stated, value))))
        found += [replace(e, offered=frozenset(motion.between.integrating)) for e in by_laws]
        found += list(lasting_equations(motion, i, since))
        met = meeting_equations(motion.demands[state.name], laws, start, stop, regime)
        found += [replace(e, offered=frozenset(motion.between.integrating)) for e in met]
        found += list(link_equations(laws, start, stop, regime))
        standing = list(standing_equations(laws, start, stop, regime, known))
        found, known = [*found, *standing], known | standing_at(standing, known)
        found += list(symmetric_equations(start, stop, regime, begun))
        curved = curve_equations(start, stop, regime, value)
        found += [replace(e, offered=frozenset(motion.between.integrating)) for e in curved]
        between = [motion.stops[s.name] for s in motion.states[since + 1 : i]]
        orbits = orbit_equations(start, between, stop, regime, stated, data)
        found += [replace(e, offered=frozenset(motion.between.integrating)) for e in orbits]
        found += list(kept_equations(regime, start, stop))
        balances = list(motion.between.equations(motion, i))
        found += [*balances, *mass_centre_equations(balances, regime, motion.first, begun)]
        if stop.t in motion.infinite():
            found += list(ending_equations(laws, stop, regime))
        found += list(resting_equations(regime, motion.stops[motion.states[i - 1].name], stop, motion.transfer(regime)))
    return found
