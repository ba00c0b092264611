"""The generated equations of motion of all problem files: constraints keep, energy is accounted for, forces fit."""

from __future__ import annotations

import math
import random
from pathlib import Path

import pytest
from conftest import ROOT

from planar_cli.errors import FileProblem
from planar_cli.motion.regime.model import Model
from planar_cli.motion.regime.regime import Regime
from planar_cli.motion.scene.scene import MovingScene
from planar_cli.problem.structure import load

FILES = sorted((ROOT / "problems").rglob("*.yaml"))


def model_of(path: Path) -> Model | None:
    """The model of a file; None where letters or unknowns have no numbers."""
    problem, wrong, _ = load(str(path))
    assert problem is not None, wrong
    try:
        return Model(MovingScene(problem))
    except FileProblem as error:
        if {d.code for d in error.diagnostics} - {"PL504", "PL704", "PL705"}:
            raise
        return None


ALL_BUT_SINGULAR = {"cables-almost-in-line"}
"""Files whose drawing is so nearly singular that a random motion is not certain to fulfil the constraints."""


NOT_AT_ONCE = {"plank-on-two-turning-rollers"}
"""Files whose first assumption contradicts the drives: nothing sticks to two rollers that turn against each other."""


def moving(model: Model, regime: Regime, seed: str) -> tuple[float, list[float]]:
    """A state in which everything moves that can."""
    draw = random.Random(seed)
    t, y = model.reference
    half = len(y) // 2
    speeds = [draw.uniform(-1, 1) * s for s in model.scale[half:]]
    state = regime.project(t, [*y[:half], *speeds])
    # Where the drawing is all but singular, only rest is certain to fulfil the constraints.
    fits = max(map(abs, regime.residuals(t, state)), default=0.0) < 1e-12
    assert fits or seed in ALL_BUT_SINGULAR, seed
    return t, state if fits else y


@pytest.mark.parametrize("path", FILES, ids=lambda p: p.stem)
def test_power_is_the_rate_of_energy_and_constraints_keep(path: Path) -> None:
    model = model_of(path)
    if model is None or path.stem in NOT_AT_ONCE:
        return
    regime = model.regime()
    t, y = moving(model, regime, path.stem)
    rates = regime.rates(t, y)
    h = 1e-5 * min([model.time_scale, *(s / abs(r) for s, r in zip(model.scale, rates, strict=True) if r)])
    ahead, behind = ([a + s * h * b for a, b in zip(y, rates, strict=True)] for s in (1, -1))
    energy = (regime.energy(t + h, ahead) - regime.energy(t - h, behind)) / (2 * h)
    size = model.scales.energy / model.scales.time
    assert energy == pytest.approx(regime.power(t, y), abs=1e-5 * size, rel=1e-5)
    for now, then in zip(regime.residuals(t + h, ahead), regime.residuals(t - h, behind), strict=True):
        assert (now - then) / (2 * h) * model.time_scale == pytest.approx(0.0, abs=1e-4)


def test_cables_almost_in_line_pull_as_they_must() -> None:
    model = model_of(ROOT / "problems" / "hard" / "cables-almost-in-line.yaml")
    assert model is not None
    regime = model.regime()
    assert regime.forces(*model.reference) == pytest.approx([10 / (2 * math.sin(1e-9))] * 2, rel=1e-6)
    assert regime.rates(*model.reference) == pytest.approx([0.0] * 4, abs=1e-6)
