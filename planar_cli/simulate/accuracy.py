"""What accuracy costs in one scene: every integrator at every tolerance or step, against a reference.

    Subject (can be run) -> Study (rows, reference, growth) -> tables and diagrams

All errors are parts of the scene's scales, the largest over all numbers that were compared: places, velocities and
times of the end and of all states that are reached on the way. Times are those of the integration alone.
"""

from __future__ import annotations

import math
import statistics
from collections.abc import Callable, Iterator, Sequence
from typing import Protocol

from planar_cli.errors import PlanarError
from planar_cli.integrators.base import EPSILON, Integrator
from planar_cli.motion.follow.estimate import Growth, by_halving, growth, tighter
from planar_cli.motion.trajectory.drive import AUTOMATIC
from planar_cli.records import record
from planar_cli.registry import members

TOLERANCES = (1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8, 1e-9, 1e-10, 1e-11, 1e-12, 1e-13)
BRIEF_TOLERANCES = (1e-3, 1e-6, 1e-9, 1e-11)
"""Where a line is told of every scene."""
STEPS = (0.1, 0.03, 0.01, 0.003, 0.001, 0.0003)
"""Of methods with equal steps, in parts of the scene's time scale."""
REFERENCES = (1e-14, 1e-12, 1e-10)
"""The tolerance of the reference: the first with which the motion can be followed."""
FINER = 5.0
"""The run that checks it has so much smaller a tolerance."""
OTHER, COARSER = "radau", 10.0
"""The other method that checks it, and by how much its tolerance is larger."""
DIGITS = (3, 6, 10)
"""Accuracies for which a setting is recommended: errors of 10^-digits."""
UNCHECKED = "no other run meets the same events, so that it is not checked"
SHIFT = 2.0**-40
"""How far apart two starts are whose difference is followed, in parts of the scales."""
SAMPLES = 400
"""At so many times."""
REPEATED, BRIEF = 3, 0.1
"""A run that takes less than so many seconds is timed so often."""


@record
class Ran:
    """What one run gave."""

    values: tuple[float, ...]
    """All that is compared, in parts of the scales."""
    path: Callable[[float], Sequence[float]]
    """The state at a time, in parts of the scales."""
    t0: float
    t1: float
    """Beginning and end [s]."""
    met: tuple[str, ...]
    """What happened on the way, in order: only runs that met the same can be compared."""
    energy: float
    """By how much the balance of energy is off, in parts of its scale."""
    drift: float
    """The largest residual of the joints at the end of a step, in parts of the scales."""
    steps: int
    evaluations: int
    seconds: float
    refused: str = ""
    """Why the motion could not be followed to its end."""
    changed: bool = False
    """Was it given to the implicit method on the way?"""


class Subject(Protocol):
    """A motion that can be run in many ways."""

    @property
    def time_scale(self) -> float:
        """The time in which things change [s]."""

    def run(self, kind: str, tolerance: float, step: float | None = None, shift: float = 0.0) -> Ran:
        """One run. `step` [s]; `shift`: the start is displaced by this part of the scales."""

    def exact(self) -> tuple[float, ...] | None:
        """The closed form of what is compared, where there is one."""

    def peers(self) -> Iterator[Iterator[Row]]:
        """The rows of each other package that follows the whole scene, as far as it is installed."""


@record
class Row:
    """One integrator with one setting."""

    integrator: str
    tolerance: float | None
    step: float | None
    """s."""
    error: float | None
    """Against the reference; None where the run was refused or met other events."""
    estimated: float | None
    """The error that two runs alone tell, without the reference."""
    energy: float
    drift: float
    steps: int
    evaluations: int
    seconds: float
    note: str = ""
    """Why there is no error."""

    @property
    def setting(self) -> str:
        """Tolerance or step as a text."""
        return f"tolerance {self.tolerance:.0e}" if self.tolerance is not None else f"step {self.step:.2e} s"


@record
class Reference:
    """What errors are measured against."""

    values: tuple[float, ...]
    words: str
    tolerance: float
    """Of the run that it is, or is compared with."""
    uncertainty: float
    """Errors below this can not be told from those of the reference."""
    met: tuple[str, ...]


@record
class Advice:
    """The quickest setting of our own that reaches an accuracy."""

    digits: int
    row: Row | None
    """None: none of those that were tried."""


@record
class Study:
    """All that was found out."""

    rows: tuple[Row, ...]
    reference: Reference
    growth: Growth | None
    advice: tuple[Advice, ...]
    ran: Ran
    """The run of the reference."""


@record
class Wanted:
    """What to try."""

    integrators: tuple[str, ...] = ()
    """() for all of our own."""
    peers: bool = False
    """Those of other packages too, as far as they are installed?"""
    tolerances: tuple[float, ...] = TOLERANCES
    steps: tuple[float, ...] = STEPS
    """In parts of the scene's time scale."""
    budget: float = 5.0
    """A method whose run took longer [s] is not tried with anything finer."""
    progress: Callable[[str], None] | None = None
    """Told what is tried."""


def study(subject: Subject, wanted: Wanted) -> Study:
    """Try all settings. Raises PlanarError where not even the reference can be followed."""
    reference, ran = _reference(subject)
    rows: list[Row] = []
    for kind in _kinds(wanted, ran):
        rows += _within(_rows(subject, kind, reference, wanted), wanted)
    own = [r for r in rows if r.integrator == AUTOMATIC or (kind_of(r.integrator) and not peer_of(r.integrator))]
    if wanted.peers:
        for others in subject.peers():
            rows += _within(others, wanted)
    if wanted.progress is not None:
        wanted.progress("")
    return Study(
        tuple(rows),
        reference,
        _growth(subject, reference.tolerance),
        tuple(_advice(own, d, reference) for d in DIGITS),
        ran,
    )


def _within(rows: Iterator[Row], wanted: Wanted) -> Iterator[Row]:
    """Rows from coarse to fine, as far as the budget goes: what took too long is not refined."""
    for row in rows:
        yield row
        if row.seconds > wanted.budget:
            return


def kind_of(name: str) -> type[Integrator] | None:
    """The member of the shelf; None for the choice by the scene."""
    found: type[Integrator] | None = members("integrators").get(name)
    return found


def peer_of(name: str) -> str:
    """The package that an integrator comes from; "" for our own."""
    member = kind_of(name)
    return member.peer if member is not None else ""


def _kinds(wanted: Wanted, ran: Ran) -> Iterator[str]:
    """Our own first. The choice by the scene is one of them, and has rows of its own where it changes its method."""
    if wanted.integrators:
        yield from wanted.integrators
        return
    if ran.changed:
        yield AUTOMATIC
    every: dict[str, type[Integrator]] = {**members("integrators")}
    for kind in sorted(every, key=lambda kind: (every[kind].peer, kind)):
        if not every[kind].peer or (wanted.peers and every[kind]().available()):
            yield kind


def _rows(subject: Subject, kind: str, reference: Reference, wanted: Wanted) -> Iterator[Row]:
    """One integrator at all its settings, the coarsest first."""
    member = kind_of(kind)
    if member is not None and member.peer:
        # Its package is imported now, which is no part of a run.
        _row(subject, kind, max(wanted.tolerances), None, reference)
    for tolerance, step in (
        [(t, None) for t in wanted.tolerances]
        if member is None or member.adaptive
        else [(wanted.tolerances[0], s * subject.time_scale) for s in wanted.steps]
    ):
        if wanted.progress is not None:
            wanted.progress(f"{kind} {tolerance:.0e}" if step is None else f"{kind} step {step:.2e} s")
        yield _row(subject, kind, tolerance, step, reference)


def _row(subject: Subject, kind: str, tolerance: float, step: float | None, reference: Reference) -> Row:
    try:
        ran, seconds = _timed(lambda: subject.run(kind, tolerance, step))
        finer = subject.run(kind, tighter(tolerance), None) if step is None else subject.run(kind, tolerance, step / 2)
    except PlanarError as error:
        return Row(kind, None if step else tolerance, step, None, None, math.nan, math.nan, 0, 0, 0.0, str(error))
    member = kind_of(kind)
    part = 1.0 if step is None or member is None else by_halving(member.order)
    note = ran.refused
    if not note and ran.met != reference.met:
        alike = ran.met[-1:] == reference.met[-1:]
        note = (
            "meets other events than the reference"
            if alike
            else f"ends otherwise than the reference, at {ran.t1:.4g} s"
        )
    return Row(
        integrator=kind,
        tolerance=None if step else tolerance,
        step=step,
        error=None if note else largest(ran.values, reference.values),
        estimated=part * largest(ran.values, finer.values) if not note and finer.met == ran.met else None,
        energy=ran.energy,
        drift=ran.drift,
        steps=ran.steps,
        evaluations=ran.evaluations,
        seconds=seconds,
        note=note,
    )


def _timed(run: Callable[[], Ran]) -> tuple[Ran, float]:
    """A run with the median of its times."""
    ran = run()
    times = [ran.seconds]
    if ran.seconds < BRIEF:
        times += [run().seconds for _ in range(REPEATED - 1)]
    return ran, statistics.median(times)


def largest(values: Sequence[float], others: Sequence[float]) -> float:
    """The largest difference."""
    return max((abs(a - b) for a, b in zip(values, others, strict=True)), default=0.0)


def _reference(subject: Subject) -> tuple[Reference, Ran]:
    """The closed form, or the finest run, checked by a still finer one and by another method."""
    for finest in REFERENCES:
        ran = subject.run(AUTOMATIC, finest)
        if not ran.refused:
            break
    exact = subject.exact()
    if exact is not None and len(exact) == len(ran.values):
        return Reference(exact, "closed form", finest, EPSILON, ran.met), ran
    checks = list(_checks(subject, ran, ((AUTOMATIC, finest / FINER), (OTHER, finest * COARSER))))
    if len(checks) < 2:
        # Where not both can be followed, coarser runs tell no less than how good the reference is.
        coarser = ((AUTOMATIC, COARSER), (OTHER, COARSER**2), (AUTOMATIC, COARSER**2))
        checks += _checks(subject, ran, [(kind, finest * times) for kind, times in coarser])
    told = [f"{kind} at {tolerance:.0e} differs by {apart:.1e}" for kind, tolerance, apart in checks]
    words = f"{AUTOMATIC} at {finest:.0e}; " + (", ".join(told) or UNCHECKED)
    uncertainty = max(min((apart for _, _, apart in checks), default=math.inf), EPSILON)
    return Reference(ran.values, words, finest, uncertainty, ran.met), ran


def _checks(subject: Subject, ran: Ran, settings: Sequence[tuple[str, float]]) -> Iterator[tuple[str, float, float]]:
    """Method, tolerance, and how far the run with these is from the reference, where it meets the same events."""
    for kind, tolerance in settings:
        try:
            check = subject.run(kind, tolerance)
        except PlanarError:
            continue
        if check.met == ran.met:
            yield kind, tolerance, largest(ran.values, check.values)


def _growth(subject: Subject, finest: float) -> Growth | None:
    """How the difference of two starts grows until they meet different events, or the end; None: that is at once."""
    other = subject.run(AUTOMATIC, finest, None, SHIFT)
    plain = subject.run(AUTOMATIC, finest)
    end = min(plain.t1, other.t1)
    if end == plain.t0:
        return None
    times = [plain.t0 + (end - plain.t0) * k / SAMPLES for k in range(SAMPLES + 1)]
    return growth([(t, largest(plain.path(t), other.path(t))) for t in times], SHIFT)


def _advice(rows: Sequence[Row], digits: int, reference: Reference) -> Advice:
    """Both what is true and what is estimated must be small enough."""
    enough = [
        r
        for r in rows
        if r.error is not None
        and r.error <= 10.0**-digits
        and (r.estimated or 0.0) <= 3.0 * 10.0**-digits
        and reference.uncertainty <= 10.0**-digits
    ]
    return Advice(digits, min(enough, key=lambda r: r.seconds, default=None))
