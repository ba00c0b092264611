"""Scenes written in a few lines of Python for tests of the fast model, and following them in one regime."""

from __future__ import annotations

import tempfile
from dataclasses import dataclass
from pathlib import Path

from planar_cli.integrators.base import Counts, Setting, Step
from planar_cli.motion.regime.model import Model
from planar_cli.motion.regime.regime import Regime
from planar_cli.motion.scene.scene import MovingScene
from planar_cli.motion.start.start import start_of
from planar_cli.motion.trajectory.drive import drive
from planar_cli.problem.structure import load


def model_of(text: str) -> Model:
    """The model of a problem file, given as its text."""
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "scene.yaml"
        path.write_text(text, encoding="utf-8")
        problem, wrong, _ = load(str(path))
    assert problem is not None, wrong
    return Model(MovingScene(problem))


def written(points: dict[str, str], bodies: dict[str, str], pins: list[tuple[str, str]], rest: str) -> str:
    """A file of pinned bodies: places, bodies, pairs (point, bodies), and what stands below."""
    lines = ["title: pinned bodies", "plane: vertical", "points:"]
    lines += [f"  {name}: {place}" for name, place in points.items()]
    lines += ["bodies:", *(f"  {name}: {{{body}}}" for name, body in bodies.items())]
    lines += ["joints:", *(f"  - pin: {{at: {at}, between: [{names}]}}" for at, names in pins)]
    return "\n".join(lines) + "\n" + rest + "\n"


def four_bars(count: int, rest: str = "instant: [v(B0).x = 1 m/s]", angle: str = "90 deg") -> str:
    """N four-bars in a row: cranks A_i B_i of 1 m, couplers of 1 m, all 1 kg (MBS benchmark A02)."""
    points, bodies, pins = {}, {}, []
    for i in range(count + 1):
        points[f"A{i}"] = f"[{i} m, 0]"
        points[f"B{i}"] = f"{{from: A{i}, distance: 1 m, angle: {angle}}}"
        bodies[f"crank{i}"] = f"rod: [A{i}, B{i}], mass: 1 kg"
        pins.append((f"A{i}", f"ground, crank{i}"))
    for i in range(count):
        bodies[f"rod{i}"] = f"rod: [B{i}, B{i + 1}], mass: 1 kg"
    for i in range(count + 1):
        beside = [f"rod{k}" for k in (i - 1, i) if 0 <= k < count]
        pins.append((f"B{i}", ", ".join([f"crank{i}", *beside])))
    return written(points, bodies, pins, rest)


def chain(count: int, angle: float, rest: str = "instant: [at rest]", masses: tuple[float, ...] = ()) -> str:
    """A chain of rods of 1 m that hangs from the first point; all at one angle from the x axis [rad]."""
    points, bodies, pins = {"P0": "[0, 0]"}, {}, []
    for i in range(count):
        points[f"P{i + 1}"] = f"{{from: P{i}, distance: 1 m, angle: ({angle!r}) rad}}"
        bodies[f"rod{i}"] = f"rod: [P{i}, P{i + 1}], mass: {masses[i] if masses else 1} kg"
        pins.append((f"P{i}", f"{'ground' if i == 0 else f'rod{i - 1}'}, rod{i}"))
    return written(points, bodies, pins, rest)


@dataclass(frozen=True)
class Followed:
    """A motion in one regime."""

    regime: Regime
    time: float
    state: list[float]
    counts: Counts
    energy: float
    """By how much the energy has changed at most [J]."""
    drift: float
    """The largest residual of a constraint, in parts of its scale."""

    def at(self, name: str) -> float:
        """A coordinate or a rate, by the name of its variable."""
        layout = self.regime.layout
        return next(v for term, v in zip(layout.state, self.state, strict=True) if layout.graph.names[term] == name)


def followed(model: Model, until: float, tolerance: float) -> Followed:
    """The motion from the start of the file in the natural regime."""
    regime, start = model.regime(), start_of(model)
    setting = Setting(scale=model.scale, tolerance=tolerance, project=regime.project)
    first = regime.energy(start.time, start.state)
    energy = drift = 0.0

    def seen(step: Step) -> None:
        nonlocal energy, drift
        model.note(step.t1, step.y1)
        energy = max(energy, abs(regime.energy(step.t1, step.y1) - first))
        drift = max([drift, *map(abs, regime.residuals(step.t1, step.y1))])

    part = regime.reduced(start.time, start.state)
    run = drive(regime.rates, start.time, start.state, until, setting, kind="dop853", on_step=seen, reduced=part)
    return Followed(regime, until, run.y1, run.counts, energy, drift)
