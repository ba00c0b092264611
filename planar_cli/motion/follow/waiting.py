"""The states of a schedule that are still to come, looked for while the motion is followed."""

from __future__ import annotations

from collections.abc import Iterable, Sequence

from planar_cli.motion.terms.crossings import Watch
from planar_cli.motion.trajectory.automaton import Automaton, Choice, Regime
from planar_cli.motion.trajectory.drive import Run
from planar_cli.motion.trajectory.schedule import Crossing, Event, Reached, Schedule
from planar_cli.motion.trajectory.segment import Segment
from planar_cli.motion.trajectory.settling import next_look, settled

NEAR = 1e-9
"""A number below this part of its scale is zero."""


SOON = 1e-9
"""Within this part of the time scale after a state the next one is not looked for."""
SMALL = 0.5
"""At a zero a number is below this part of what it was so long before."""
PAST = 1e-12
"""So many time scales lead past a pole."""
LOOKS = (0.01, 0.03, 0.1)
"""So many time scales before a zero its function must have been more than rounding."""

EDGE = 0.01
"""So much of a run before its end its functions are looked at."""
SHARP = 1e-4
"""So many time scales before the end of a run it is looked how fast a number comes to zero."""
FLAT = 0.1
"""What comes to zero more slowly than this part of the fastest is only touched there."""
ALSO = 1e-9
"""Below this part of its scale what comes to zero faster is zero at the same instant."""


class Waiting:
    """Which states have been reached, and which one comes next."""

    def __init__(self, schedule: Schedule, t: float) -> None:
        self.schedule = schedule
        self.chains = chains_of(schedule.events)
        """What is still to come: in each chain every state comes after the one before it."""
        self.since = [t] * len(self.chains)
        """When the latest state of each chain was reached."""
        self.reached: list[Reached] = []
        self._rates: dict[str, tuple[float, ...]] = {}
        """By state at t = infinity: the velocities and accelerations at the latest instant that could be it."""

    @property
    def done(self) -> bool:
        """Has every state been reached?"""
        return bool(self.schedule.events) and not any(self.chains)

    @property
    def names(self) -> tuple[str, ...]:
        """The states that have been reached, the first one of the file among them."""
        return (self.schedule.start, *(r.name for r in self.reached))

    def left(self) -> list[Event]:
        """The states that have not been reached."""
        waiting = {e.name for chain in self.chains for e in chain}
        return [e for e in self.schedule.events if e.name in waiting]

    def times(self, t: float, span: float) -> list[float]:
        """Times at which something is to be looked at: those that the file names and that are still to come.

        Where the next state is at t = infinity, also when to see whether the motion has settled. `span`: time scale.
        """
        found = [_time(chain[0]) for chain in self.chains if chain and chain[0].time is not None]
        return [*found, *(next_look(self._since(e), t, span) for e in self._endless)]

    @property
    def _endless(self) -> list[Event]:
        """The next states that are at t = infinity."""
        return [e for e in self.next() if e.endless]

    @property
    def wanting(self) -> str:
        """What is still wanting for the next state, in words, where the time is over."""
        return ", and the motion has not settled" if self._endless else ""

    def settles(self, automaton: Automaton, segments: Sequence[Segment], tolerance: float) -> Event | None:
        """The next state at t = infinity, if the motion has come to where it goes without end."""
        if not segments:
            return None
        end = segments[-1]
        for event in self._endless:
            since = self._since(event)
            if (
                event.crossing is None
                and end.t1 - since >= automaton.time_scale
                and settled(segments, since, automaton.scale, tolerance)
                and fits(event, automaton.regime(end.choice), end.choice, end.t1, end.end)
            ):
                return event
        return None

    def just_after(self, state: str) -> Event | None:
        """The state that is `just after` this one."""
        return next((e for chain in self.chains for e in chain if e.after and e.after == state), None)

    def next(self) -> list[Event]:
        """The states that are looked for now, the first of every chain; one `just after` another or at a given time is
        not looked for. Where the motion goes without end is looked for when all listed before that has been reached.
        """
        heads = [chain[0] for chain in self.chains if chain and chain[0].time is None and not chain[0].after]
        return [e for e in heads if not e.endless or self.left()[0] is e]

    def _chain(self, event: Event) -> int:
        return next(k for k, chain in enumerate(self.chains) if event in chain)

    def _since(self, event: Event) -> float:
        """When the state before this one was reached."""
        return self.since[self._chain(event)]

    def arrive(self, event: Event, t: float, y: Sequence[float], choice: Choice, segment: int) -> None:
        """A state has been reached."""
        reached = Reached(event.name, t, tuple(y), choice, segment)
        self.reached.append(reached)
        if self.schedule.heard is not None:
            self.schedule.heard(reached)
        chain = self._chain(event)
        self.chains[chain].remove(event)
        for k, left in enumerate(self.chains):
            if k == chain or (left and left[0].endless):
                self.since[k] = t

    def already(self, regime: Regime, choice: Choice, t: float, y: tuple[float, ...]) -> Event | None:
        """A next state that what has just happened reaches."""
        for event in self.next():
            if event.crossing is None or event.endless or event.crossing.sense or t <= self._since(event):
                continue
            value = event.crossing.value(regime, choice, t, y)
            if abs(value) <= NEAR * event.crossing.scale and fits(event, regime, choice, t, y):
                return event
        return None

    def at_rest(self, regime: Regime, choice: Choice, t: float, y: tuple[float, ...]) -> Event | None:
        """A next state that is one at which nothing moves any more."""
        for event in self.next():
            late = event.rest and event.crossing is None and t > self._since(event)
            if late and fits(event, regime, choice, t, y):
                return event
        return None

    def counts(
        self, event: Event, crossing: Crossing, regime: Regime, choice: Choice, run: Run, noise: float, span: float
    ) -> bool:
        """Is a change of sign at the end of a run, of what tells a state, a zero, and more than rounding?

        Just after the state before it is still that one's zero; what has died out has no zeros; at a pole or a jump it
        does not become small; and what is only touched does not tell a state before that does which crosses. `noise`:
        what has come of the tolerance, in parts of scales; `span`: the time scale [s].
        """
        if run.t1 - self._since(event) <= max(SOON, noise) * span:
            return False
        looks = [t for part in LOOKS if (t := run.t1 - part * span) >= run.t0]
        values = [crossing.value(regime, choice, t, run.at(t)) for t in looks]
        here = abs(crossing.value(regime, choice, run.t1, run.y1))
        if here > max(noise * crossing.scale, SMALL * max(map(abs, values), default=0.0)):
            return False
        if values and max(map(abs, values)) <= noise * crossing.scale:
            return False
        if event.others and not _is_sharpest(event, crossing, regime, choice, run, span):
            return False
        return not event.endless or self._recurs(event, regime.rates(run.t1, run.y1), noise, span)

    def _recurs(self, event: Event, rates: Sequence[float], noise: float, span: float) -> bool:
        """Does everything move there as it did the time before? Then what is left of the start has died away."""
        before, self._rates[event.name] = self._rates.get(event.name), tuple(rates)
        half = len(rates) // 2
        size = sum(map(abs, rates[:half])) / span + sum(map(abs, rates[half:]))
        return before is not None and all(
            abs(a - b) <= noise * size * (span if k < half else 1.0)
            for k, (a, b) in enumerate(zip(rates, before, strict=True))
        )

    def due(self, t: float) -> list[Event]:
        """The states whose time has come."""
        timed = [chain[0] for chain in self.chains if chain and chain[0].time is not None]
        return sorted((e for e in timed if _time(e) <= t), key=_time)

    def by_modes(self, automaton: Automaton, choice: Choice, t: float, y: tuple[float, ...]) -> Event | None:
        """A next state that says nothing but modes, if these are the modes now."""
        present = {j: automaton.choices[j][k].name for j, k in zip(automaton.choices, choice, strict=True)}
        for event in self.next():
            if event.crossing is not None or not event.modes:
                continue
            has = all(present.get(joint) == mode for joint, mode in event.modes)
            if has and fits(event, automaton.regime(choice), choice, t, y):
                return event
        return None


def chains_of(events: Sequence[Event]) -> list[list[Event]]:
    """The states after the first one in chains, in each of which every one comes after the one before it.

    A state at a given time may stand anywhere in the file: it begins a chain of its own, as what is listed behind it
    comes after it, whenever what is listed before it happens. Nothing comes after t = infinity.
    """
    chains: list[list[Event]] = [[]]
    places = [0]
    for event in events:
        if event.endless:
            chains.append([event])
            places.append(places[-1])
            continue
        if event.time is not None:
            chains.append([])
            places.append(len(chains) - 1)
        else:
            places.append(places[-1 - event.back])
        chains[places[-1]].append(event)
    return chains


def beyond(regime: Regime, t: float, y: Sequence[float], span: float) -> tuple[float, tuple[float, ...]]:
    """Just beyond a pole at which a segment begins: what tells a state changes its sign there, and is not zero.

    `span`: the time scale [s].
    """
    step = PAST * span
    return t + step, tuple(v + step * r for v, r in zip(y, regime.rates(t, y), strict=True))


def fits(event: Event, regime: Regime, choice: Choice, t: float, y: Sequence[float]) -> bool:
    """Do the other relations of a state hold, where its crossing is?"""
    return all(condition(regime, choice, t, y) for condition in event.conditions)


def at_edge(event: Event, regime: Regime, choice: Choice, run: Run, tolerance: float) -> bool:
    """Does what tells a state become zero just where a run ends?"""
    crossing = event.crossing
    if crossing is None or event.endless or run.t1 <= run.t0:
        return False
    look = run.t1 - EDGE * (run.t1 - run.t0)
    before = crossing.value(regime, choice, look, run.at(look))
    near = max(NEAR, tolerance) * crossing.scale
    if abs(crossing.value(regime, choice, run.t1, run.y1)) > near or abs(before) <= near:
        return False
    way = "falls" if before > 0 else "rises"
    return meant(crossing, way) and fits(event, regime, choice, run.t1, run.y1)


def meant(crossing: Crossing, way: str) -> bool:
    """Does the number pass zero in the way that the state means?"""
    return crossing.sense == 0 or way == ("falls" if crossing.sense < 0 else "rises")


def telling_of(events: Iterable[Event]) -> list[tuple[Event, Crossing]]:
    """What tells that states are reached, in the order in which it is watched."""
    return [(e, crossing) for e in events for crossing in e.crossings]


def _is_sharpest(event: Event, crossing: Crossing, regime: Regime, choice: Choice, run: Run, span: float) -> bool:
    """Does nothing else that tells the state come to zero there much faster, a little later?

    The instant at which a height is largest is known to half the digits by the height, to all by its rate.
    """
    before = max(run.t1 - SHARP * span, run.t0)

    def ways(one: Crossing) -> tuple[float, float]:
        values = [one.value(regime, choice, t, run.at(t)) / one.scale for t in (before, run.t1)]
        return abs(values[1] - values[0]), abs(values[1])

    own, _ = ways(crossing)
    return all(here <= ALSO or own >= FLAT * way for way, here in map(ways, event.crossings))


def watch_of(regime: Regime, choice: Choice, events: Iterable[Event]) -> Watch:
    """The guards, and behind them what tells that the next states are reached."""
    scales, falling = [g.scale for g in regime.guards], [True] * len(regime.guards)
    crossings = [crossing for _, crossing in telling_of(events)]
    if not crossings:
        return Watch(regime.watch, scales, falling)

    def values(t: float, y: list[float]) -> list[float]:
        return [*regime.watch(t, y), *(c.value(regime, choice, t, y) for c in crossings)]

    return Watch(values, [*scales, *(c.scale for c in crossings)], [*falling, *(False for _ in crossings)])


def _time(event: Event) -> float:
    assert event.time is not None
    return event.time
