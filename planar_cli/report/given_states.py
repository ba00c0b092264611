"""What `motion` and the states of a file give, or its only instant, in the notation of the page."""

from __future__ import annotations

from collections.abc import Collection, Iterator

from planar_cli.problem.expression import AtRest, Equilibrium, Extreme, Name, Quantity, Relation, Side
from planar_cli.problem.scene import Problem, State
from planar_cli.problem.turning_planes import goes_round
from planar_cli.problem.walk import walk
from planar_cli.report import blocks
from planar_cli.report.blocks import Line, line
from planar_cli.report.mentioned import Mentioned, pieces_of
from planar_cli.report.sides import is_zero, number_of, said
from planar_cli.report.spoken import WORDS

FORCES = ("N", "tension", "friction")
"""What a state says of forces, as where something is about to lift: N = 0."""


OF_BODIES, PLACES = ("mass",), ("x", "y", "r", "theta")
"""What does not change, so that 2.5 m g is a datum; and what a law of motion may be a function of."""


def states_given(problem: Problem, figures: int) -> Iterator[list[Line]]:
    """A row for each state: relations with what is known on one side, rest, and what is largest or smallest."""
    if not problem.states:
        yield [d for r in problem.instant or () for d in _told(r, problem, figures, first=True)]
    for i, state in enumerate(problem.states):
        yield _of_state(state, problem, figures, first=not i)


def _of_state(state: State, problem: Problem, figures: int, first: bool) -> list[Line]:
    """The data of a state behind its name."""
    row = [d for r in state.relations for d in _told(r, problem, figures, first)]
    return [line(f"{state.name}: ", row[0]), *row[1:]] if row else []


def _told(statement: object, problem: Problem, figures: int, first: bool) -> Iterator[Line]:
    """One statement; of the first state only what asks nothing."""
    unknown = {s.name for s in problem.unknowns}
    match statement:
        case AtRest():
            where = " in the plane of the drawing, which goes round" if goes_round(problem) else ""
            yield line(f"{statement.body} at rest{where}" if statement.body else f"at rest{where}")
        case Equilibrium() if problem.motion and statement.body is None:
            # What is driven moves on; what nothing drives stays where it is beside it.
            yield line("in relative equilibrium")
        case Extreme() if not first and (side := said(statement.side, figures)):
            yield line(side, " largest" if statement.sense > 0 else " smallest")
        case Relation(operator="=") if (
            _gives(statement, unknown)
            or (first and _names(statement, unknown))
            or (not first and _says(statement, unknown))
        ):
            yield from (_with_own_masses(told, problem) for told in _equation(statement, figures))


def _with_own_masses(told: Line, problem: Problem) -> Line:
    """The mass of the only heavy body by its letter on the page."""
    heavy = [b.name for b in problem.bodies if not b.is_massless]
    named = f"m_{heavy[0]}" if len(heavy) == 1 else ""
    return tuple(blocks.Name("m") if isinstance(p, blocks.Name) and p.name == named else p for p in told)


def _equation(relation: Relation, figures: int) -> Iterator[Line]:
    left, right = said(relation.left, figures) or _named(relation.left), said(relation.right, figures)
    number = number_of(relation.right)
    right = line("0") if number is not None and not number[0] and number[1] != "deg" else right
    if left and right:
        yield line(left, " = ", right)


def _named(side: Side) -> Line:
    """What has no letters, or only where a diagram shows it: `the tension in cord`, `the way of P from 1 to 2`."""
    if not isinstance(side, Quantity) or side.parts or len(side.things) != 1:
        return ()
    if side.word == "path_length" and isinstance(side.at, tuple):
        return line(f"{WORDS[side.word].format(side.things[0])} from {side.at[0]} to {side.at[1]}")
    return line(WORDS[side.word].format(side.things[0])) if side.word in FORCES and not side.at else ()


def laws_given(problem: Problem, page: Mentioned, figures: int) -> Iterator[Line]:
    """How something is driven: the number of its speed, or its law; letters stand on the page itself."""
    unknown = {s.name for s in problem.unknowns}
    for law in problem.motion:
        relation = law.statement
        if isinstance(relation, Relation) and relation.operator == "=" and _gives(relation, unknown, PLACES):
            left = said(relation.left, figures)
            names = {p.name for p in pieces_of(left) if isinstance(p, blocks.Name)}
            number = number_of(relation.right) is not None and not is_zero(relation.right)
            varies = _varies(relation.right, problem) and law.during is None
            if varies or law.during is not None or (number and (page.numeric or page.words.isdisjoint(names))):
                span = f" from {law.during[0]} to {law.during[1]}" if law.during is not None else ""
                yield from (line(told, span) for told in _equation(relation, figures))


def _varies(side: Side, problem: Problem) -> bool:
    """Does time or a coordinate stand in it?"""
    running = {"t", *(s.name for s in problem.coordinates)}
    return any(isinstance(n, Name) and n.name in running for n in walk(side))


def _names(relation: Relation, unknown: set[str]) -> bool:
    """Does it say what a letter that is sought stands for: |v| = v_0?"""
    return isinstance(relation.left, Quantity) and isinstance(relation.right, Name) and relation.right.name in unknown


def _says(relation: Relation, unknown: set[str]) -> bool:
    """Does a state say where it is, in letters that are known?"""
    names = {n.name for side in (relation.left, relation.right) for n in walk(side) if isinstance(n, Name)}
    return not names & unknown and any(isinstance(n, Quantity) for n in walk(relation.left))


def _gives(relation: Relation, unknown: set[str], constant: Collection[str] = OF_BODIES) -> bool:
    """Does it say what something is, without asking anything? That the clock begins at nought is no datum. `constant`:
    quantities that may stand in what it is.
    """
    if not isinstance(relation.left, Quantity | Name) or _begins_the_clock(relation):
        return False
    nodes = list(walk(relation.right))
    asked = any(isinstance(n, Quantity) and n.word not in constant for n in nodes)
    return not asked and not any(isinstance(n, Name) and n.name in unknown for n in nodes)


def _begins_the_clock(relation: Relation) -> bool:
    return isinstance(relation.left, Name) and relation.left.name == "t" and is_zero(relation.right)
