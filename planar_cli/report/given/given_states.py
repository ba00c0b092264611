"""What `motion` and the states of a file give, or its only instant, in the notation of the page."""

from __future__ import annotations

import re
from collections.abc import Collection, Iterator, Sequence
from dataclasses import replace

from planar_cli.problem.implied.stated_clockwise import is_clockwise, states_clockwise
from planar_cli.problem.language.expression import (
    AtRest,
    Binary,
    Equilibrium,
    Extreme,
    JustAfter,
    Name,
    Negate,
    Number,
    Quantity,
    Relation,
    Scaled,
    Side,
    Statement,
    Word,
)
from planar_cli.problem.language.parser import parse_statement
from planar_cli.problem.language.walk import walk, written_alike
from planar_cli.problem.scene.scene import Problem, State
from planar_cli.problem.scene.turning_planes import goes_round
from planar_cli.problem.sections.said_here import said_here
from planar_cli.report.document import blocks
from planar_cli.report.document.blocks import Line, line
from planar_cli.report.words.in_words import in_words, sign_of
from planar_cli.report.words.sides import is_zero, number_of

OF_MODES = {
    "stick": "no slipping at {}",
    "slip": "slipping at {}",
    "apart": "no contact at {}",
    "tip": "tipping at {}",
    "taut": "{} taut",
    "slack": "{} slack",
}
"""What a state says of a contact or a rope."""
TURN = "theta"
_SOLVED_OTHERWISE = re.compile(r"\.t\b| is (?:largest|smallest)$")
REVERSED = {">": "<", ">=": "<="}


def states_given(problem: Problem, figures: int) -> Iterator[list[Line]]:
    """A row for each state: all that the file says of it."""
    if not problem.states:
        yield _row(problem.instant or (), problem, figures, first=True)
    for i, state in enumerate(problem.states):
        yield _of_state(state, problem, figures, first=not i)


def _of_state(state: State, problem: Problem, figures: int, first: bool) -> list[Line]:
    """The data of a state behind its name."""
    row = _row(state.relations, problem, figures, first, state.name)
    return [line(f"{state.name}: ", row[0]), *row[1:]] if row else []


def _row(statements: Sequence[Statement], problem: Problem, figures: int, first: bool, state: str = "") -> list[Line]:
    """Each statement once; two bounds of one quantity as one, 0 < β < 90°. That the clock begins at nought is no
    datum.
    """
    row, bounded = [], set[int]()
    clockwise = states_clockwise(problem)
    statements = list(dict.fromkeys(_as_written(s, state) for s in statements))
    for i, statement in enumerate(statements):
        if i in bounded or (first and isinstance(statement, Relation) and _begins_the_clock(statement)):
            continue
        upper = _upper_bound(statement, statements[i + 1 :])
        if upper is None or not isinstance(statement, Relation):
            told = _told(_as_it_turns(statement) if clockwise else statement, problem, figures)
            turns = clockwise and told != _told(statement, problem, figures)
            row.append(line(*_with_own_masses(told, problem), *([" clockwise"] if turns else [])))
            continue
        bounded.add(i + 1 + statements[i + 1 :].index(upper))
        low = line(_right(statement, figures), f" {sign_of(REVERSED[statement.operator])} ")
        row.append(line(low, _equation(upper, figures)))
    return row


def _as_written(statement: Statement, state: str) -> Statement:
    """What is largest or smallest, and what is tangential, as the file says it and not as it is solved."""
    if not isinstance(statement, Relation) or not _SOLVED_OTHERWISE.search(statement.text):
        return statement
    return said_here(parse_statement(statement.text, statement.mark), state)


def _upper_bound(statement: Statement, others: Sequence[Statement]) -> Relation | None:
    """The relation that bounds the same quantity from above as a statement bounds from below."""
    if not isinstance(statement, Relation) or statement.operator not in REVERSED:
        return None
    return next((r for r in others if isinstance(r, Relation) and _is_upper(r, statement.left)), None)


def _is_upper(relation: Relation, side: Side) -> bool:
    return relation.operator in ("<", "<=") and written_alike(relation.left, side)


def _told(statement: Statement, problem: Problem, figures: int) -> Line:
    """One statement."""
    match statement:
        case AtRest():
            where = " in the plane of the drawing, which goes round" if goes_round(problem) else ""
            return line(f"{statement.body} at rest{where}" if statement.body else f"at rest{where}")
        case Equilibrium():
            # What is driven moves on; what nothing drives stays where it is beside it.
            relative = "relative " if problem.motion and statement.body is None else ""
            return line(f"{statement.body} " if statement.body else "", f"in {relative}equilibrium")
        case JustAfter():
            return line(f"just after {statement.state}")
        case Extreme():
            return line(in_words(statement.side, figures), " largest" if statement.sense > 0 else " smallest")
    left, right = statement.left, statement.right
    if isinstance(left, Quantity) and isinstance(right, Word) and right.word in OF_MODES:
        return line(OF_MODES[right.word].format(left.things[0]))
    return _turned(statement, problem, figures) or _equation(statement, figures)


def _turned(relation: Relation, problem: Problem, figures: int) -> Line:
    """By how much a body has turned since an earlier state; nothing of another relation, or where only the number of a
    letter tells in which sense.
    """
    left, right = relation.left, relation.right
    if isinstance(left, Quantity) and isinstance(right, Binary) and right.operator in "+-":
        left = Binary("-", left, right.left, left.mark)
        right = right.right if right.operator == "+" else Negate(right.right, right.mark)
    if relation.operator != "=" or not isinstance(left, Binary) or left.operator != "-":
        return ()
    now, then = left.left, left.right
    if not (isinstance(now, Quantity) and isinstance(then, Quantity) and isinstance(then.at, str)):
        return ()
    if now.word != TURN or now.at is not None or now.parts or now.things != then.things or len(now.things) > 1:
        return ()
    sense, size = _sense_of(right, {s.name for s in problem.symbols})
    if not sense:
        return ()
    way = "counterclockwise" if sense > 0 else "clockwise"
    return line(f"{now.things[0]} has turned ", in_words(size, figures), f" {way} since {then.at}")


def _sense_of(side: Side, positive: Collection[str]) -> tuple[int, Side]:
    """+1 or -1 with the size of a side; 0: its letters may have either sign."""
    if isinstance(side, Negate):
        sense, size = _sense_of(side.operand, positive)
        return -sense, size
    if isinstance(side, Number):
        sense = side.sense if side.value > 0 else -side.sense
        return sense, replace(side, value=abs(side.value), sense=1)
    known = {"pi", *positive}
    parts = list(walk(side))
    plain = all(isinstance(n, Number | Name) or (isinstance(n, Binary) and n.operator in "*/") for n in parts)
    return int(plain and all(n.name in known for n in parts if isinstance(n, Name))), side


def _with_own_masses(told: Line, problem: Problem) -> Line:
    """The mass of the only heavy body by its letter on the page."""
    heavy = [b.name for b in problem.bodies if not b.is_massless]
    named = f"m_{heavy[0]}" if len(heavy) == 1 else ""
    return tuple(blocks.Name("m") if isinstance(p, blocks.Name) and p.name == named else p for p in told)


def _equation(relation: Relation, figures: int) -> Line:
    """Both sides with what stands between them."""
    return line(in_words(relation.left, figures), f" {sign_of(relation.operator)} ", _right(relation, figures))


def _right(relation: Relation, figures: int) -> Line:
    """Nought is nought in every unit but that of an angle."""
    number = number_of(relation.right)
    nought = number is not None and not number[0] and number[1] != "deg"
    return line("0") if nought else in_words(relation.right, figures)


def laws_given(problem: Problem, figures: int) -> Iterator[Line]:
    """What `motion` says, which holds all the time, or from one state to another."""
    for law in problem.motion:
        span = f" from {law.during[0]} to {law.during[1]}" if law.during is not None else ""
        yield line(_with_own_masses(_told(_as_written(law.statement, ""), problem, figures), problem), span)


def _as_it_turns(statement: Statement) -> Statement:
    """A rotation that is stated clockwise, in that sense."""
    if not isinstance(statement, Relation) or not isinstance(statement.right, Number | Scaled):
        return statement
    return replace(statement, right=replace(statement.right, sense=1)) if is_clockwise(statement.right) else statement


def _begins_the_clock(relation: Relation) -> bool:
    return isinstance(relation.left, Name) and relation.left.name == "t" and is_zero(relation.right)
