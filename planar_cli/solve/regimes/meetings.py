"""What moves with the same acceleration has a constant relative velocity: two balls in the air that meet.

r_A/B at the second state = r_A/B at the first + (v_A - v_B) Δt      (An Introduction to Planar Dynamics, 1.5)
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence

import sympy as sp

from planar_cli.equation.algebra.plain import by_name, derivative, letters, simplified
from planar_cli.records import record
from planar_cli.solve.law import RELATIVE, Law
from planar_cli.solve.regimes.equations import Equation, Laws
from planar_cli.solve.regimes.regime import Regime
from planar_cli.solve.regimes.timeline import Demand, Stop


@record
class Together:
    """Two coordinates with the same constant acceleration."""

    laws: tuple[Law, Law]
    falling: bool
    """Does the weight alone act, so that no balance of forces is needed to know it?"""


@record
class _Meeting:
    """What a statement says of two coordinates: `apart` is how far the first is beyond the other."""

    demand: Demand
    one: Law
    other: Law
    apart: sp.Expr

    @property
    def names(self) -> tuple[str, ...]:
        """What moves."""
        return tuple(law.coordinate.words.partition(" of ")[2] for law in (self.one, self.other))


def meeting_equations(
    demands: Iterable[Demand], laws: Laws, since: Stop, stop: Stop, regime: Regime
) -> Iterator[Equation]:
    """One for each statement about a state that says how far apart two such coordinates are there."""
    own = {stop.letters[law.coordinate.symbol]: law for law in laws.laws if _is_constant(law, regime)}
    found = list(_meetings(demands, own, set(stop.letters.values())))
    falling = _is_falling(regime)
    elapsed = stop.letters[regime.time] - since.letters[regime.time]
    for m in found:
        before = since.letters[m.one.coordinate.symbol] - since.letters[m.other.coordinate.symbol]
        apart = _speed(m.one, since) - _speed(m.other, since)
        yield Equation(
            m.apart - before - apart * elapsed,
            RELATIVE,
            _words([x for x in found if x.names == m.names], falling),
            stop.name,
            since.name,
            source=Together((m.one, m.other), falling),
            surcharge=m.one.effort,
        )


def _meetings(demands: Iterable[Demand], own: Mapping[sp.Symbol, Law], inside: set[sp.Symbol]) -> Iterator[_Meeting]:
    """`own`: the laws by the letters of their places at the state; `inside`: all letters of the state."""
    for d in demands:
        pair = by_name(d.residual.free_symbols & inside) if d.kind == "equation" else []
        if len(pair) != 2 or not set(pair) <= own.keys():
            continue
        one, other = (own[x] for x in pair)
        slopes = [derivative(d.residual, x) for x in pair]
        if not slopes[0].is_number or slopes[0] == 0 or slopes[0] + slopes[1] != 0:
            continue
        if simplified(_rate(one) - _rate(other)) == 0:
            rest = d.residual.xreplace(dict.fromkeys(pair, sp.S.Zero))
            yield _Meeting(d, one, other, -rest / slopes[0])


def _is_constant(law: Law, regime: Regime) -> bool:
    return law.order == 2 and law.speed is not None and not letters(_rate(law)) & set(regime.letters)


def _is_falling(regime: Regime) -> bool:
    """Are all bodies particles in free flight, which fall alike?"""
    problem = regime.general.instant.scene.problem
    apart = not (problem.joints or problem.loads or problem.motion)
    return apart and problem.plane == "vertical" and all(body.is_particle for body in problem.bodies)


def _rate(law: Law) -> sp.Expr:
    return law.f if law.constant is None else law.f.xreplace(dict([law.constant]))


def _speed(law: Law, stop: Stop) -> sp.Expr:
    assert law.speed is not None
    return law.factor * stop.letters[law.speed]


def _words(meetings: Sequence[_Meeting], falling: bool) -> str:
    one, other = meetings[0].names
    still = all(_rate(m.one) == 0 for m in meetings)
    why = "no acceleration" if still else "the same acceleration"
    met = " and ".join(m.demand.text for m in meetings)
    verb = "fall freely, with" if falling and not still else "have"
    return f"{one} and {other} {verb} {why}, so that their relative velocity is constant, up to {met}"
