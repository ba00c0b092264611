"""What is largest or smallest at t = infinity: in the steady vibration that is left when the start has died away.

Nothing is derived here. The motion is followed until it repeats itself from one such instant to the next; twice that
time after the start, which squares what is left of it, it is steady to all digits that are printed, and the state is
the first of its kind from then on.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import replace
from fractions import Fraction

from planar_cli.errors import Diagnostic, NoSolution, PlanarError, refuse
from planar_cli.problem.language.expression import Extreme, Name, Number, Relation
from planar_cli.problem.language.walk import is_endless
from planar_cli.problem.scene.scene import Problem, State
from planar_cli.simulate.measures import Moment
from planar_cli.simulate.run import Settings, followed, prepared

NAME = "steady"
CODE = "PL724"
DISPLACED, SAME = 0.1, 1e-6
"""From a start that is displaced by this part of the scales, the motion is the same in the end up to this part."""
STEPS = 6000
"""So many are enough for what dies away; at resonance there is no end."""
FIGURES = 2
"""The time is rounded up to so many."""


def with_steady_states(problem: Problem, known: Mapping[str, float]) -> Problem:
    """The problem in which such states come after a time by which the motion is steady. `known`: numbers of names.

    Raises FileProblem where letters or unknowns have no numbers, NoSolution where the motion does not become steady.
    """
    asked = [s for s in problem.states[1:] if _recurs(s)]
    if not asked:
        return problem
    if problem.symbols or problem.unknowns:
        text = f"{_extreme(asked[0]).text} at t = infinity is looked for in numbers, and here are letters without any"
        raise refuse(asked[0].mark, CODE, text, "give them numbers under `given`")
    others = tuple(s for s in problem.states if not _recurs(s))
    time = max(_time(replace(problem, states=(*others, s)), s, known) for s in asked)
    begin = _rounded_up(2 * time)
    taken = {s.name for s in problem.states}
    name = next(n for k in range(len(taken) + 1) if (n := f"{NAME}_{k}" if k else NAME) not in taken)
    mark = asked[0].mark
    text = f"t = {begin} s"
    dated = Relation(Name("t", None, mark), "=", Number(Fraction(begin), "s", 1, mark), text, mark)
    later = (replace(s, relations=tuple(r for r in s.relations if not is_endless((r,)))) for s in asked)
    return replace(problem, states=(*others, State(name, (dated,), mark, steady=True), *later))


def _recurs(state: State) -> bool:
    return is_endless(state.relations) and any(isinstance(r, Extreme) for r in state.relations)


def _extreme(state: State) -> Extreme:
    return next(r for r in state.relations if isinstance(r, Extreme))


def _time(problem: Problem, state: State, known: Mapping[str, float]) -> float:
    """How long after the start the motion has become steady [s], whatever the start was."""
    settings = Settings(values=known, balanced=False, most_steps=STEPS)
    text = f"`{_extreme(state).text}` at t = infinity: the motion does not become steady"
    hint = "without damping the start does not die away, and at resonance the vibration grows for ever"
    try:
        scene = prepared(replace(problem, find=()), known)
        run, other = followed(scene, settings), followed(scene, settings, DISPLACED)
    except PlanarError as error:
        raise NoSolution([Diagnostic(state.mark, CODE, f"{text}: {error}", hint)]) from error
    here, there = (r.measures.moments.get(state.name) for r in (run, other))
    if here is None or there is None or not _alike(here, there, scene.model.time_scale):
        raise NoSolution([Diagnostic(state.mark, CODE, text, hint)])
    return here.t - run.trajectory.segments[0].t0


def _alike(here: Moment, there: Moment, span: float) -> bool:
    """Do velocities and accelerations agree there? `span`: the time scale [s]."""
    one, other = ([*m.regime.rates(m.t, m.y)] for m in (here, there))
    half = len(one) // 2
    size = sum(map(abs, one[:half])) / span + sum(map(abs, one[half:]))
    off = [abs(a - b) / (span if k < half else 1.0) for k, (a, b) in enumerate(zip(one, other, strict=True))]
    return max(off) <= SAME * size


def _rounded_up(time: float) -> str:
    """A little more than that [s], as a decimal number."""
    step = Fraction(10) ** (math.floor(math.log10(time)) - FIGURES + 1)
    return f"{float(math.ceil(Fraction(time) / step) * step):.12g}"
