"""The ledger of energy along a motion: what moves, what is stored, what has gone and what has come in.

    kinetic + potential + stored in springs + dissipated - supplied = constant

Powers are integrated by Gauss's rule from moment to moment: that which becomes heat, and what the rest does; what
impacts take is told by them. That the sum stays the same is a check, as the motion follows from accelerations alone.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from planar_cli.errors import Undecided
from planar_cli.integrators.base import OUTSIDE
from planar_cli.motion.regime.regime import Regime
from planar_cli.motion.terms.terms import Term
from planar_cli.motion.trajectory.balance import nodes
from planar_cli.motion.trajectory.segment import Segment
from planar_cli.problem.language.expression import Quantity
from planar_cli.problem.scene.scene import ALL
from planar_cli.records import changing, record
from planar_cli.simulate.heat import heat_of
from planar_cli.simulate.measures import Asked
from planar_cli.simulate.run import Run
from planar_cli.simulate.sampled import moments_of_segment
from planar_cli.simulate.table import HERE

SPRING = "spring"
HEAT = Quantity("heat", (ALL,), None, (), None, HERE)
NOTHING = 1e-9
"""An account that stays below this part of the largest one is left out."""


@record
class Account:
    """One account of the ledger over the time: its name, its moments [s] and values [J], segment by segment."""

    name: str
    pieces: tuple[tuple[tuple[float, float], ...], ...]

    @property
    def largest(self) -> float:
        """J."""
        return max((abs(v) for piece in self.pieces for _, v in piece), default=0.0)


NAMES = ("kinetic", "potential", "spring", "dissipated", "supplied")


def energies(run: Run, count: int) -> tuple[Account, ...]:
    """The accounts that are not empty, with their sum at the end. Undecided: a power has no value."""
    ledger = _Ledger(run, 0.0, 0.0)
    rows = [list(ledger.rows(segment, count)) for segment in _followed(run)]
    accounts = [
        Account(name, tuple(tuple((row[0], row[k + 1]) for row in piece) for piece in rows))
        for k, name in enumerate(NAMES)
    ]
    least = NOTHING * max(a.largest for a in accounts)
    kept = [a for a in accounts if a.largest > least]
    total = tuple(tuple((row[0], sum(row[1:5]) - row[5]) for row in piece) for piece in rows)
    return (*kept, Account("sum", total))


def _followed(run: Run) -> Iterator[Segment]:
    yield from (s for s in run.trajectory.segments if isinstance(s.regime, Regime))


@changing
class _Ledger:
    """The accounts as the motion goes on."""

    run: Run
    dissipated: float
    """J, so far."""
    supplied: float
    entered: int = 0
    """So many transitions have been entered."""

    def rows(self, segment: Segment, count: int) -> Iterator[tuple[float, ...]]:
        """The time and all accounts along a segment."""
        regime = segment.regime
        assert isinstance(regime, Regime)
        self._enter(segment.t0)
        stored = regime.routine([self._springs(regime), regime.parts.potential], ())
        before: float | None = None
        for t in moments_of_segment(self.run.trajectory, segment, count):
            if before is not None and not regime.conservative:
                self._work(segment, regime, before, t)
            before = t
            y = segment.at(t)
            self.run.measures.wind(t)
            springs, potential = stored(t, y)
            yield t, regime.energy(t, y) - potential, potential - springs, springs, self.dissipated, self.supplied

    def _springs(self, regime: Regime) -> Term:
        """The potential of all springs that act: one that is free for now stores nothing."""
        springs = [load for load in regime.parts.acting if load.kind == SPRING]
        return self.run.model.scene.stored_energy("", springs)

    def _enter(self, t0: float) -> None:
        """What impacts took until a segment begins."""
        transitions = self.run.trajectory.transitions
        while self.entered < len(transitions) and transitions[self.entered].t <= t0:
            self._take(transitions[self.entered].lost)
            self.entered += 1

    def _work(self, segment: Segment, regime: Regime, start: float, end: float) -> None:
        """What friction takes while a force pulls is not told as part of what the force does."""
        heat = self.run.measures.routine("heat", HEAT, regime, self._heat)
        lost = fed = 0.0
        try:
            for t, weight in nodes(start, end):
                y = segment.at(t)
                (power,) = heat(t, y)
                lost += weight * power
                fed += weight * (regime.power(t, y) + power)
            self._take(lost)
            # A force that works against the motion takes back of what was supplied; that is no heat.
            self.supplied += fed
        except OUTSIDE as outside:
            raise Undecided(f"a power has no value between t = {start:.6g} s and t = {end:.6g} s") from outside

    def _heat(self, what: Asked, regime: Regime) -> list[Term]:
        return [heat_of(ALL, self.run.measures.quantities(regime), regime, self.run.model.scene)]

    def _take(self, energy: float) -> None:
        if energy > 0:
            self.dissipated += energy
        else:
            self.supplied -= energy


def off(accounts: Sequence[Account]) -> float:
    """By how much the sum changes, in parts of the largest account."""
    values = [v for piece in accounts[-1].pieces for _, v in piece]
    largest = max(a.largest for a in accounts)
    return (max(values) - min(values)) / largest if largest else 0.0
