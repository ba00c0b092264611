"""A motion whose equations date a state that is told by a quantity over a span: then it is followed to that time."""

from __future__ import annotations

from planar_cli.equation.values.exact import Valuation
from planar_cli.solve.between.branches.matching import same_motion
from planar_cli.solve.between.equations.motion_equations import MotionEquations
from planar_cli.solve.between.roots.chain import Branch
from planar_cli.solve.between.roots.followed import Followed
from planar_cli.solve.following.dated import is_told_by_a_span
from planar_cli.solve.following.follower import Follower


def followed_by_ways(course: MotionEquations, branch: Branch, value: Valuation) -> Followed | None:
    """The motion of one branch, followed from state to state; None: no state is told so, or following it leads
    elsewhere. `value`: numbers of everything that the branch gives.
    """
    if not any(is_told_by_a_span(s) for s in course.problem.states):
        return None
    letters = course.first.letters
    if not set(letters.values()) <= set(branch.values):
        return None
    followed = Follower(course, value).run({s: float(branch.values[own]) for s, own in letters.items()})
    happens = not followed.lost and followed.missed is None and same_motion(course, followed, branch)
    return followed if happens else None
