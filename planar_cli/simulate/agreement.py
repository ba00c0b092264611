"""What a file states of its first moment beside places and velocities, compared with what follows from the forces.

Accelerations, forces and modes are not where a motion begins but what comes of it. A file that states others than those
that its bodies, joints and loads give has left out what causes them, so that its motion is another one.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from planar_cli.errors import Diagnostic, NoSolution
from planar_cli.motion.regime.model import Model
from planar_cli.motion.regime.regime import Regime
from planar_cli.problem.language.expression import Equilibrium, Quantity, Relation, Statement
from planar_cli.problem.language.walk import walk
from planar_cli.problem.scene.scene import Problem
from planar_cli.simulate.measures import LATER, START, Measures
from planar_cli.simulate.timetable import Timetable, mode_of

AGREES = 1e-6
"""What differs by less than this part of its scale agrees."""
ASIDE = 1e-4
"""Rates of driven velocities are differences over this part of the time scale."""
HINT = "write under `motion` what is driven, or give the load that causes it"


def demand_agreement(problem: Problem, measures: Measures) -> None:
    """NoSolution: something that the file states at the beginning does not follow."""
    wrong = list(_wrong(problem, measures))
    if wrong:
        raise NoSolution(wrong)


def _stays(model: Model, regime: Regime, t: float, y: Sequence[float]) -> bool:
    """Does nothing move but what is driven, and does it go on so?"""
    if any(drive.rate is None for drive in model.drives):
        # Beside what is driven by its acceleration all goes along with it: only the coordinates tell what stays.
        return True
    half, time = model.layout.count, model.time_scale
    off = [a - b for a, b in zip(regime.rates(t, y), [*_driven(regime, t, y[:half]), *([0.0] * half)], strict=True)]
    if model.drives:
        step = ASIDE * time
        later, before = (
            _driven(regime, t + h, [q + h * v for q, v in zip(y[:half], y[half:], strict=True)]) for h in (step, -step)
        )
        off[half:] = [a - (b - c) / (2 * step) for a, b, c in zip(off[half:], later, before, strict=True)]
    return all(abs(r) * time <= AGREES * s for r, s in zip(off, model.scale, strict=True))


def _driven(regime: Regime, t: float, q: Sequence[float]) -> list[float]:
    """The velocities that what is driven has there, of everything else none."""
    return regime.project(t, [*q, *([0.0] * len(q))])[len(q) :]


def _stated(problem: Problem) -> tuple[Statement, ...]:
    """What is said of the first moment."""
    if problem.instant is not None:
        return problem.instant
    return problem.states[0].relations if problem.states else ()


def _wrong(problem: Problem, measures: Measures) -> Iterator[Diagnostic]:
    scales = Timetable(problem, measures)
    moment = measures.moments[START]
    if moment.after is None:
        return
    regime, y = moment.after
    for statement in _stated(problem):
        if isinstance(statement, Equilibrium) and not _stays(measures.model, regime, moment.t, y):
            text = "this is no equilibrium: what acts sets it in motion"
            yield Diagnostic(statement.mark, "PL704", text, "solve for the place with `planar solve`")
        if not isinstance(statement, Relation) or statement.operator != "=":
            continue
        stated = mode_of(statement)
        if stated is not None:
            if moment.modes.get(stated[0], stated[1]) != stated[1]:
                text = f"{stated[0]} does not {stated[1]} here: it is in the mode {moment.modes[stated[0]]}"
                yield Diagnostic(statement.mark, "PL704", text, HINT)
        elif any(isinstance(n, Quantity) and n.word in LATER for n in walk(statement)):
            off = measures.gap(statement, regime)(moment.t, y)
            if any(abs(v) > AGREES * scales.scale(statement.left, statement.right) for v in off):
                text = f"'{statement.text}' does not follow from what acts on the bodies"
                yield Diagnostic(statement.mark, "PL704", text, HINT)
