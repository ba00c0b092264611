"""How joints act just after a blow, where its equations leave that open: the motion that is followed tells it.

Whether a cord is slack or a block slides then is asked of what acts next, which the blow itself need not know. Such a
find is told by itself, so that all others keep their equations.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

from planar_cli.equation.system.setup import Earlier, numbers_of
from planar_cli.equation.system.system import mode_of
from planar_cli.errors import NoSolution, Undecided
from planar_cli.problem.language.expression import JustAfter, Quantity, Relation
from planar_cli.problem.scene.scene import Find, Problem
from planar_cli.solve.instant.verify import Disagreement
from planar_cli.solve.orders import in_each_order
from planar_cli.solve.roads import without
from planar_cli.solve.solved_problem import PartSolution

Solve = Callable[[Problem, str, dict[str, str], dict[str, Earlier]], PartSolution]


def with_modes_followed(
    solve: Solve, problem: Problem, case: str, units: dict[str, str], earlier: dict[str, Earlier]
) -> PartSolution:
    """One part by `solve`. Where that fails for the modes that are asked just after a blow, these are read off the
    motion that is followed, and the others are solved without them.
    """

    def by_equations(asked: Problem) -> PartSolution:
        return in_each_order(asked, earlier, lambda p: solve(p, case, units, earlier))

    try:
        return by_equations(problem)
    except Disagreement:
        raise
    except (Undecided, NoSolution):
        apart = _asked_after_blows(problem)
        if not apart or len(apart) == len(problem.find):
            raise
        from planar_cli.solve.followed import SOME_STEPS, can_be_followed, followed_part

        if not can_be_followed(problem):
            raise
        rest = _otherwise_solved(by_equations, without(problem, apart))
        own = replace(problem, find=apart)
        told = None if rest is None else followed_part(own, case, numbers_of(earlier), units, SOME_STEPS)
        if rest is None or told is None:
            raise
    found = {f.name: f for f in (*rest.found, *told.found)}
    motion = rest.motion and replace(rest.motion, read_off=frozenset(f.name for f in apart))
    return replace(rest, found=tuple(found[f.name] for f in problem.find), motion=motion)


def _otherwise_solved(solve: Callable[[Problem], PartSolution], problem: Problem) -> PartSolution | None:
    """The part with fewer finds; None: it is not solved either."""
    try:
        return solve(problem)
    except Disagreement:
        raise
    except (Undecided, NoSolution):
        return None


def _asked_after_blows(problem: Problem) -> tuple[Find, ...]:
    """The finds that ask how a joint acts in a state just after another."""
    struck = {s.name for s in problem.states if any(isinstance(r, JustAfter) for r in s.relations)}
    return tuple(f for f in problem.find if struck and _mode_at(f) in struck)


def _mode_at(find: Find) -> str | None:
    """The state of `mode(j) @ s`, alone or compared with a word; None: something else is asked."""
    what = find.found.what
    if isinstance(what, Relation):
        sides = [what.left, what.right] if mode_of(what) is not None else []
    else:
        sides = [what] if isinstance(what, Quantity) and what.word == "mode" else []
    return next((at for s in sides if isinstance(at := getattr(s, "at", None), str)), None)
