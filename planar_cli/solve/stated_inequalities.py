"""The inequalities and modes of a file's states, looked at where the motion has come to these states.

Those of places and velocities choose among roots already; here it is seen that none is false, of whatever it speaks:
forces, accelerations, the time, numbers of the file, how contacts and ropes hold.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

from planar_cli.base_units import in_base
from planar_cli.equation.system.setup import first_unit
from planar_cli.equation.system.system import mode_of
from planar_cli.errors import Diagnostic, FileProblem, NoSolution, Undecided
from planar_cli.problem.checks.check_dimensions import Kinds
from planar_cli.problem.checks.scope import Scope
from planar_cli.problem.language.expression import Relation
from planar_cli.problem.scene.scene import Problem
from planar_cli.simulate.answers import usual_unit
from planar_cli.simulate.measures import Moment, modes_of
from planar_cli.simulate.run import Run
from planar_cli.simulate.timetable import Timetable
from planar_cli.units import Unit, parse_unit

CERTAIN = 1e-6
"""What is wrong by less than this part of its sides, or of the scale of its kind, may be rounding."""
SAME = 1e-14
"""What is apart by less than this part of it is one number."""
FALSE = "PL617"


def demand_inequalities(problem: Problem, run: Run) -> None:
    """NoSolution: an inequality or a mode is false at its state, where the motion came to it. Letters may have other
    numbers.
    """
    wrong = [] if problem.symbols else [*_wrong(problem, run), *_wrong_modes(problem, run)]
    if wrong:
        raise NoSolution(wrong)


def _wrong(problem: Problem, run: Run) -> Iterator[Diagnostic]:
    return (_told(problem, state, relation, sides) for state, relation, sides in false_ones(problem, run))


def false_ones(problem: Problem, run: Run) -> Iterator[tuple[str, Relation, tuple[float, float]]]:
    """The inequalities that are false at their states, with the numbers of both sides [SI]."""
    for k, state in enumerate(problem.states):
        moment = run.measures.moments.get(state.name)
        for relation in state.relations if moment is not None else ():
            if isinstance(relation, Relation) and relation.operator != "=":
                assert moment is not None
                # Where something changes, it may be meant of what comes or of what goes; at the first nothing comes.
                meant = (moment, replace(moment, after=None)) if k else (moment,)
                sides = [_sides(run, relation, m) for m in meant]
                if all(found is not None and _is_false(problem, run, relation, found) for found in sides):
                    assert sides[0] is not None
                    yield state.name, relation, sides[0]


def _wrong_modes(problem: Problem, run: Run) -> Iterator[Diagnostic]:
    """Modes in which joints are neither when the motion comes to a state nor when it goes on from there."""
    for state in problem.states:
        moment = run.measures.moments.get(state.name)
        for relation in state.relations if moment is not None else ():
            said = mode_of(relation) if isinstance(relation, Relation) and relation.operator == "=" else None
            if said is None:
                continue
            assert moment is not None
            found = [m for m in (modes_of(moment.regime).get(said[0]), moment.modes.get(said[0])) if m is not None]
            if found and said[1] not in found:
                text = f"`{relation.text}` does not hold at {state.name}: there it is {found[-1]}"
                hint = "leave it out, or ask for a state before that"
                yield Diagnostic(relation.mark, FALSE, text, hint)


def _sides(run: Run, relation: Relation, moment: Moment) -> tuple[float, float] | None:
    """Both sides at a moment [SI]; None: one of them has no value there."""
    try:
        return run.measures.number(relation.left, moment), run.measures.number(relation.right, moment)
    except (Undecided, FileProblem):
        return None


def _is_false(problem: Problem, run: Run, relation: Relation, sides: tuple[float, float]) -> bool:
    left, right = sides
    size = max(abs(left), abs(right), Timetable(problem, run.measures).scale(relation.left, relation.right))
    apart = left - right if relation.operator in ("<", "<=") else right - left
    return apart > CERTAIN * size or (relation.operator in ("<", ">") and abs(apart) <= SAME * size)


def _told(problem: Problem, state: str, relation: Relation, sides: tuple[float, float]) -> Diagnostic:
    written = first_unit(relation.left) or first_unit(relation.right)
    unit = parse_unit(written) if written else usual_unit(relation.left, Kinds(Scope(problem, ())), problem.us)
    shown = " and ".join(_shown(side, unit, problem.us) for side in sides)
    text = f"`{relation.text}` does not hold at {state}: the sides are {shown}"
    return Diagnostic(relation.mark, FALSE, text, "leave it out, or change what its sides rest on")


def _shown(value: float, unit: Unit, us: bool) -> str:
    return f"{value / in_base(unit, us):.4g} {unit.text}".removesuffix(" 1")
