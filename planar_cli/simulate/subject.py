"""A problem's scene as the subject of a study of accuracy."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace

from planar_cli.errors import PlanarError
from planar_cli.integrators.base import MOST_STEPS
from planar_cli.motion.regime.regime import Regime
from planar_cli.motion.trajectory.drive import IMPLICIT
from planar_cli.motion.trajectory.trajectory import Trajectory, Transition
from planar_cli.problem.scene.scene import Problem
from planar_cli.simulate.accuracy import REFERENCES, Ran, Row
from planar_cli.simulate.peers import PEERS, Peer, largest_of
from planar_cli.simulate.run import Prepared, Run, Settings, followed, prepared

PATIENCE = 50_000
"""More steps of an adaptive method than that are no setting for this scene: rounding holds them down."""


class SceneSubject:
    """Runs of one scene; it is prepared once."""

    def __init__(self, problem: Problem, until: float | None = None, values: Mapping[str, float] | None = None) -> None:
        self.scene: Prepared = prepared(problem, values or {})
        self.settings = Settings(until=until, estimate=False, check=False)

    @property
    def time_scale(self) -> float:
        """The time in which things change [s]."""
        return self.scene.model.time_scale

    def run(self, kind: str, tolerance: float, step: float | None = None, shift: float = 0.0) -> Ran:
        """One run."""
        most = PATIENCE if step is None else MOST_STEPS
        settings = replace(self.settings, tolerance=tolerance, integrator=kind, step=step, most_steps=most)
        run = followed(self.scene, settings, shift)
        trajectory, model = run.trajectory, self.scene.model

        def path(t: float) -> Sequence[float]:
            return [a / s for a, s in zip(trajectory.at(t), model.scale, strict=True)]

        return Ran(
            values=self._compared(trajectory),
            path=path,
            t0=trajectory.t0,
            t1=trajectory.t1,
            met=_met(trajectory),
            energy=max((s.balance.off for s in trajectory.segments if s.balance is not None), default=0.0),
            drift=_drift(run),
            steps=trajectory.work.steps,
            evaluations=trajectory.work.evaluations,
            seconds=run.seconds,
            refused=trajectory.outcome.words if trajectory.outcome.refused else "",
            changed=any(IMPLICIT in note for note in trajectory.notes),
        )

    def exact(self) -> tuple[float, ...] | None:
        """None: a file states single answers, not the whole state."""
        return None

    def peers(self) -> Iterator[Iterator[Row]]:
        """The rows of other packages, by the end of the motion."""
        run = followed(self.scene, replace(self.settings, tolerance=REFERENCES[0]))
        for member in PEERS:
            peer = member()
            if peer.available():
                yield self._rows_of(peer, run)

    def _rows_of(self, peer: Peer, run: Run) -> Iterator[Row]:
        scale = self.scene.model.scale
        end = [a / s for a, s in zip(run.trajectory.at(run.trajectory.t1), scale, strict=True)]
        settings: list[tuple[float | None, float | None]] = [(t, None) for t in peer.tolerances]
        settings += [(None, s * self.time_scale) for s in peer.steps]
        for tolerance, step in settings:
            try:
                found = peer.follow(run, tolerance or step or 0.0)
            except PlanarError as refusal:
                yield Row(peer.name, tolerance, step, None, None, math.nan, math.nan, 0, 0, 0.0, str(refusal))
                return
            error = largest_of(found.end, end, scale)
            yield Row(peer.name, tolerance, step, error, None, math.nan, math.nan, 0, 0, found.seconds)

    def _compared(self, trajectory: Trajectory) -> tuple[float, ...]:
        """Time and state of every state of the file, and of the end; nothing where not a step was made."""
        if not trajectory.segments:
            return ()
        scale, time_scale = self.scene.model.scale, self.time_scale
        instants = [(e.t, e.y) for e in trajectory.events]
        instants.append((trajectory.t1, tuple(trajectory.at(trajectory.t1))))
        found: list[float] = []
        for t, y in instants:
            found += [t / time_scale, *(a / s for a, s in zip(y, scale, strict=True))]
        return tuple(found)


def _met(trajectory: Trajectory) -> tuple[str, ...]:
    """Impacts, changes of mode and states in their order, and how it ended. Of impacts without number those count that
    are no part of the sequence: how many of it are followed depends on the tolerance.
    """
    happened = [(x.t, f"{x.kind} {' '.join(x.joints)}") for x in _told(trajectory.transitions)]
    happened += [(e.t, e.name) for e in trajectory.events]
    return (*(words for _, words in sorted(happened)), trajectory.outcome.kind)


def _told(transitions: Sequence[Transition]) -> list[Transition]:
    """What happened, without the impacts of the same joints, and what belongs to them, that lead to a rest."""
    found: list[Transition] = []
    for x in transitions:
        if x.kind == "rest":
            while found and set(found[-1].joints) <= set(x.joints):
                found.pop()
        found.append(x)
    return found


def _drift(run: Run) -> float:
    """The largest residual of the joints at the end of a step, in parts of the scales."""
    largest = 0.0
    for segment in run.trajectory.segments:
        assert isinstance(segment.regime, Regime)
        for step in segment.steps:
            if step.t1 <= segment.t1:
                left = segment.regime.residuals(step.t1, step.y1)
                largest = max([largest, *map(abs, left)])
    return largest
