"""What a motion does that its file tells altogether: it is followed once before any equation is written.

Then the equations are written in the modes that happen. Letters of the file take numbers for which the motion passes
all states; where it does not with those that are drawn first, others are drawn.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from typing import Any

from planar_cli.equation.system.setup import numbers_of
from planar_cli.equation.values.sample import further_draws, other_draws, seeded
from planar_cli.problem.scene.scene import Problem
from planar_cli.solve.following.traced import Traced, as_told
from planar_cli.solve.regimes.mode_sequence import ModeSequence, Stretch, Workshop, spans_of

ENOUGH = 5_000
"""After so many steps of motions that do not pass all states no other numbers are tried."""


def foreseen(problem: Problem, workshop: Workshop, trial: bool = False) -> Traced | None:
    """The motion; None: the file does not tell all of it. `trial`: it is only to tell which states are passed."""
    if problem.unknowns or not problem.states[1:]:
        return None
    letters = _letters(problem, workshop)
    return as_told(problem, {**numbers_of(workshop.earlier, letters), **letters}, trial)


def _letters(problem: Problem, workshop: Workshop) -> dict[str, float]:
    """Numbers that are drawn for the letters of a file."""
    if not problem.symbols:
        return {}
    scene = workshop.drawn(spans_of(problem, problem.states)[0]).scene
    names = [s.name for s in problem.symbols] + ["g"]
    symbols = {n: scene.ledger.symbols[n] for n in names if n in scene.ledger.symbols}
    return {n: float(scene.valuations[0](s)) for n, s in symbols.items()}


def fitting_draws(problem: Problem, earlier: Mapping[str, Any]) -> tuple[int, bool]:
    """A seed whose draws let the motion pass all states, and whether it draws widely; the present one where none does,
    or nothing is drawn.
    """
    own, *others = (*other_draws(), *further_draws())
    if not problem.symbols or problem.unknowns or not problem.states[1:]:
        return own
    steps = 0
    for seed, wide in (own, *others):
        with seeded(seed, wide):
            found = foreseen(problem, Workshop(earlier), trial=True)
        if found is not None and all(found.moment(s.name) is not None for s in problem.states):
            return seed, wide
        steps += 0 if found is None else found.run.trajectory.work.steps
        if steps > ENOUGH:
            break
    return own


def as_it_happens(modes: ModeSequence, motion: Traced, workshop: Workshop) -> ModeSequence:
    """The modes with which every stretch begins, as far as the motion gets."""
    stretches, beyond = list(modes.stretches), modes.beyond
    for i, stretch in enumerate(stretches):
        if stretch.blow is None:
            stretches[i] = _begun(modes, i, stretch, motion, workshop) or _as_before(stretches[:i], stretch)
    if beyond is not None:
        beyond = _begun(modes, len(stretches), beyond, motion, workshop) or _as_before(stretches, beyond)
    return replace(modes, stretches=tuple(stretches), beyond=beyond)


def _as_before(stretches: Sequence[Stretch], stretch: Stretch) -> Stretch:
    """A stretch that the motion does not get to, in the modes before it where the same things act."""
    before = stretches[-1] if stretches else stretch
    return replace(stretch, choice=before.choice) if before.span.key == stretch.span.key else stretch


def _begun(modes: ModeSequence, i: int, stretch: Stretch, motion: Traced, workshop: Workshop) -> Stretch | None:
    """A stretch in the modes with which it begins; None: the motion does not get there."""
    moment = motion.moment(modes.states[i].name)
    begins = None if moment is None else motion.begins(moment.t, motion.run.model.time_scale)
    if begins is None:
        return None
    return replace(stretch, choice=motion.choice(workshop, stretch, begins[0]))
