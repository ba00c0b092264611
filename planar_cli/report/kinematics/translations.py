"""Bodies that could turn and do not, as their linkage keeps them from it: said before their points move."""

from __future__ import annotations

from collections.abc import Collection, Iterator

import sympy as sp

from planar_cli.problem.scene.scene import with_article
from planar_cli.report.document.blocks import Block, Paragraph, line
from planar_cli.report.words.spoken import begun
from planar_cli.report.words.words import Phrases
from planar_cli.solve.instant.instant import Trial


def translations(trial: Trial, zero: Collection[sp.Symbol], phrases: Phrases) -> Iterator[Block]:
    """The coupler translates: ω = 0, α = 0. `zero`: accelerations that vanish and have no line of their own."""
    tree, speeds = trial.system.tree, trial.velocities[0].values if trial.velocities else {}
    closed = {body for j in tree.closures for body in (j.mover, j.base)}
    for e in tree.edges:
        if e.spin is None or e.spin_rate is None or e.joining is None or e.body not in closed:
            continue
        turns_not = e.spin_rate in zero and speeds.get(e.spin) == 0 and any(speeds.values())
        if turns_not and not _rests(trial, e.body):
            letters = (phrases.math(e.spin), " = 0, ", phrases.math(e.spin_rate), " = 0")
            yield Paragraph(line(f"{begun(with_article(e.body))} translates: ", *letters))


def _rests(trial: Trial, body: str) -> bool:
    """Does the centre of a body that does not turn have no velocity?"""
    motion = trial.system.motion
    if motion is None or not trial.outcomes:
        return False
    value = trial.outcomes[0].value.extended(trial.velocities[0].values)
    v = motion.velocity(trial.system.scene.center(body), body)
    return bool(value.is_zero(v.x) and value.is_zero(v.y))
