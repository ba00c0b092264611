"""The scene at a moving configuration: residuals vanish as drawn, their slopes are right, loads fit potentials."""

from __future__ import annotations

import random
from pathlib import Path

import pytest
from conftest import ROOT

from planar_cli.errors import FileProblem
from planar_cli.motion.scene import MovingScene
from planar_cli.motion.terms import Term, evaluate
from planar_cli.problem.geometry import Vec
from planar_cli.problem.structure import load

FILES = sorted((ROOT / "problems").rglob("*.yaml"))
NO_NUMBER = {"PL704", "PL705"}
"""Refusals of files whose letters or unknowns have no number."""


def only_numbers_missing(error: FileProblem) -> None:
    """A refusal of anything else is an error of ours."""
    if {d.code for d in error.diagnostics} - NO_NUMBER:
        raise error


def scene_of(path: Path) -> MovingScene | None:
    """The scene of a file; None where letters or unknowns have no numbers."""
    problem, wrong, _ = load(str(path))
    assert problem is not None, wrong
    try:
        return MovingScene(problem)
    except FileProblem as error:
        only_numbers_missing(error)
        return None


def residuals(scene: MovingScene) -> list[tuple[str, Term]]:
    """All residuals of all modes of all joints, and of points written with coordinates."""
    found = [(tie.title, tie.residual) for tie in scene.ties]
    for joint in scene.problem.joints:
        try:
            modes = joint.modes(scene)
        except FileProblem as error:
            only_numbers_missing(error)
            continue
        for mode in modes:
            for residual in joint.residuals(scene, mode):
                off = residual.of(scene.poses)
                parts = (off.x, off.y) if isinstance(off, Vec) else (off,)
                found += [(residual.title, scene.graph.of(part)) for part in parts]
    return found


@pytest.mark.parametrize("folder", sorted({p.parent for p in FILES}), ids=lambda p: p.name)
def test_residuals_vanish_as_drawn_and_have_right_slopes(folder: Path) -> None:
    rng = random.Random(7)
    for path in (p for p in FILES if p.parent == folder):
        scene = scene_of(path)
        if scene is None:
            continue
        size = scene.extent
        spans = {q: 1.0 if q.size == 1.0 else size for q in scene.rates() if q is not scene.time}
        for title, term in residuals(scene):
            assert abs(term.value) <= 1e-9 * max(size, 1e-3), (path.name, title)
            at = {q: q.value + 0.02 * span * rng.uniform(-1, 1) for q, span in spans.items()}
            way = {q: span * rng.uniform(-1, 1) for q, span in spans.items()}
            step = 1e-5
            ends = [evaluate([term], {q: at[q] + s * step * way[q] for q in at})[0] for s in (-1, 1)]
            slopes = scene.graph.gradient(term)
            told = sum(evaluate([slopes[q]], at)[0] * way[q] for q in way if q in slopes)
            slope = (ends[1] - ends[0]) / (2 * step)
            assert slope == pytest.approx(told, rel=1e-5, abs=1e-5 * size), (path.name, title)
