"""The equations of a motion solved beside the numbers with which it was followed."""

from __future__ import annotations

from dataclasses import replace
from decimal import Decimal

from planar_cli.equation.algebra.plain import by_name
from planar_cli.solve.between.branches.agreement import demand_fulfilled
from planar_cli.solve.between.branches.differences import by_differences
from planar_cli.solve.between.branches.matching import beside
from planar_cli.solve.between.branches.solved_motion import SolvedMotion
from planar_cli.solve.between.equations.asked_finds import AskedFind
from planar_cli.solve.between.equations.motion_equations import MotionEquations
from planar_cli.solve.between.equations.newton import refined_left
from planar_cli.solve.between.roots.followed import Followed
from planar_cli.solve.between.roots.integrals_that_hold import holding
from planar_cli.solve.diagnosis.motions import demand_agreement
from planar_cli.solve.diagnosis.unbounded_times import demand_no_times, without_endless_places, without_times

NOTHING = Decimal("1e-13")


def solved_beside(course: MotionEquations, finds: tuple[AskedFind, ...], followed: Followed) -> SolvedMotion:
    """The roots of all equations that happen; what no equation gives in closed form keeps the number that was followed.
    NoSolution: what is asked is not unique, or a state does not satisfy all that is stated of it.
    """
    for regime in course.distinct_regimes():
        regime.general.demand_unique(regime.undetermined)
    if course.departure is not None:
        demand_no_times(course, finds)
        followed.values[course.first.letters[course.departure.speed]] = 0.0
        course = replace(course, equations=without_times(course))
    if followed.tends:
        course = replace(course, equations=without_endless_places(course, followed))
    course = replace(course, equations=holding(course.equations, followed.values, course.base()))
    course, differences = by_differences(course, finds, followed.values)
    followed.values |= differences
    chain = course.chain()
    chain = replace(chain, truth=followed.values, tends=followed.tends)
    course, branch = beside(course, finds, chain)
    open_letters = [s for s in followed.values if s not in branch.values]
    more = refined_left(course, branch, open_letters, followed.values)
    guessed = {s for s in open_letters if s not in more}
    natural = course.natural(guessed)
    more |= {s: _number(followed.values[s], natural[s]) for s in by_name(guessed)}
    value = course.base().extended({**more, **branch.values})
    demand_agreement(course, value, guessed)
    demand_fulfilled(course, value, guessed)
    return SolvedMotion(course, finds, branch, followed, value, frozenset(guessed))


def _number(followed: float, natural: Decimal) -> Decimal:
    """What a step method gave; what it leaves of a zero is none, beside an ordinary size."""
    number = Decimal(repr(followed))
    return number if abs(number) >= NOTHING * natural else Decimal(0)
