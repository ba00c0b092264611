"""What begins at rest where it may stay: is that what is asked about, and what is said of it."""

from __future__ import annotations

from planar_cli.solve.between.branches.solved_motion import SolvedMotion
from planar_cli.solve.between.equations.asked_finds import asks_rates_throughout
from planar_cli.solve.between.equations.motion_equations import MotionEquations
from planar_cli.solve.following.departure import DEPARTS

STAYS = "it begins at rest in equilibrium, where every acceleration vanishes: nothing moves"
STAYS_BESIDE = "it begins at rest in equilibrium beside what is driven: nothing else moves"


def told_of_rest(found: SolvedMotion, departs: bool, balanced: bool) -> tuple[str, ...]:
    """What is said of how it begins. `departs`: it is left by a slight touch; `balanced`: everything rests and nothing
    is driven.
    """
    course = found.course
    if departs:
        return (DEPARTS,)
    throughout = asks_rates_throughout(course.problem)
    # A start alone, beside an equilibrium about which it swings, is no motion that would be told.
    if balanced and not course.regimes[0].free and (throughout or len(course.states) > 1):
        return (STAYS,)
    zero = throughout and len(course.states) == 1 and all(p == 0 for a in found.finds for p in a.parts())
    return (STAYS_BESIDE,) if zero and course.modes.stretches[0].resting else ()


def asks_about_touch(course: MotionEquations) -> bool:
    """Is the motion asked for, as a formula that is zero at rest, that only a slight touch begins? No other state that
    would not be reached says so.
    """
    return len(course.states) == 1 and asks_rates_throughout(course.problem)
