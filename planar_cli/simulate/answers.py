"""What a file asks, answered from a motion that was followed, each number with an estimate of its error."""

from __future__ import annotations

from collections.abc import Mapping

from planar_cli.base_units import in_base
from planar_cli.errors import FileProblem, Undecided
from planar_cli.motion.regime.regime import Regime
from planar_cli.motion.terms.functions import FUNCTIONS
from planar_cli.motion.trajectory.trajectory import Trajectory
from planar_cli.problem.checks.check_dimensions import Kinds
from planar_cli.problem.checks.scope import Scope
from planar_cli.problem.language.dimensions import dimension_of
from planar_cli.problem.language.expression import (
    Binary,
    Function,
    Grouped,
    Name,
    Negate,
    Quantity,
    Relation,
    Scaled,
    Side,
)
from planar_cli.problem.language.outermost import is_energy
from planar_cli.problem.language.walk import names_of_states, walk
from planar_cli.problem.language.words import OF_SWINGS
from planar_cli.problem.scene.scene import Find, Problem
from planar_cli.records import record
from planar_cli.simulate.measures import START, Measures, Moment
from planar_cli.simulate.spans import Spans
from planar_cli.simulate.timetable import Timetable, mode_of
from planar_cli.units import PURE, Unit, default_unit, parse_unit

NOT_FOLLOWED = {
    "path": "a curve has an equation, which no step method gives",
    "hodograph": "a curve has an equation, which no step method gives",
    **dict.fromkeys((*OF_SWINGS, "stable"), "small oscillations are about an equilibrium, not along a motion"),
}
NO_UNIT = parse_unit("1")
JOULE = parse_unit("J")
LOOKS, SAME = 4, 1e-7
"""What is asked without a state is looked at so often in every part of the motion, and may vary by this part of it."""
EQUAL = 1e-9
"""Two sides that differ by less than this part of them are equal."""


@record
class Answered:
    """One find."""

    name: str
    values: tuple[float, ...] = ()
    """In base units: one number, or the two components of a vector; none of a word or where there is no answer."""
    word: str = ""
    """true, false, or a mode."""
    unit: Unit = NO_UNIT
    """In which it is shown."""
    one: float = 1.0
    """What one of that unit is in base units."""
    error: float | None = None
    """The estimated error, in base units; None where there is none."""
    why: str = ""
    """Why there is no answer."""
    scale: float = 0.0
    """The size of usual values of this kind in the scene, in base units: what the error of a zero is measured by."""

    sides: tuple[float, ...] = ()
    """Of a relation between numbers: both of its sides, in the unit."""

    @property
    def shown(self) -> tuple[float, ...]:
        """The values in the unit."""
        return tuple(v / self.one for v in self.values)


def usual_unit(what: Side, kinds: Kinds, us: bool) -> Unit:
    """In which a quantity is shown where nobody said: a coordinate or unknown as declared; an energy in joule."""
    declared = kinds.scope.numbers.get(what.name) if isinstance(what, Name) else None
    if declared is not None and declared.value is None and declared.unit is not None:
        return parse_unit(declared.unit)
    kind = dimension_of(what, kinds.of)
    usual = default_unit(kind.dimension or PURE, kind.angle, us)
    return JOULE if usual.text == "N*m" and is_energy(what) else usual


class Answers:
    """Answers the finds of one problem."""

    def __init__(self, problem: Problem, measures: Measures, trajectory: Trajectory, units: Mapping[str, str]) -> None:
        """`units`: those of the stated answers, by find."""
        self.problem, self.measures, self.trajectory, self.units = problem, measures, trajectory, units
        self.scope = Scope(problem, ())
        self.kinds = Kinds(self.scope)
        self.spans = Spans(measures, trajectory, self.scope)

    def all(self) -> tuple[Answered, ...]:
        """Every find of the problem."""
        return tuple(self.answer(f) for f in self.problem.find)

    def answer(self, find: Find) -> Answered:
        """One find; `why` tells what keeps it from having an answer."""
        try:
            return self._answer(find)
        except Undecided as error:
            return Answered(find.name, why=str(error).partition(": ")[2] or str(error))
        except FileProblem as error:
            if any(d.code not in ("PL590", "PL704", "PL705") for d in error.diagnostics):
                raise
            return Answered(find.name, why=error.diagnostics[0].message)

    def _answer(self, find: Find) -> Answered:
        what = find.found.what
        if isinstance(what, Relation):
            word = "true" if self._holds(what) else "false"
            if mode_of(what) is not None:
                return Answered(find.name, word=word)
            unit = usual_unit(what.left, self.kinds, self.problem.us)
            values = (*self.value(what.left), *self.value(what.right))
            one = in_base(unit, self.problem.us)
            return Answered(find.name, word=word, unit=unit, sides=tuple(v / one for v in values))
        if isinstance(what, Quantity) and what.word == "reached":
            return Answered(find.name, word="true" if self._reached(what) else "false")
        if isinstance(what, Quantity) and what.word == "mode":
            return Answered(find.name, word=self._mode(what.things[0], what.at))
        scale = Timetable(self.problem, self.measures).scale(what)
        values = self._throughout(what, scale) if self._stateless(what) else self.value(what)
        unit = self.unit(find)
        return Answered(find.name, values, unit=unit, one=in_base(unit, self.problem.us), scale=scale)

    # --- values ------------------------------------------------------------------------------------------------------

    def value(self, side: Side) -> tuple[float, ...]:
        """A side in numbers: every quantity at its state or over its span."""
        match side:
            case Quantity() if side.word in NOT_FOLLOWED:
                raise Undecided(f"{side.mark.file}:{side.mark.line}: {NOT_FOLLOWED[side.word]}")
            case Quantity() if isinstance(side.at, tuple):
                return self.spans.value(side)
            case Quantity() | Name() | Grouped():
                return self._leaf(side)
            case Negate():
                return tuple(-v for v in self.value(side.operand))
            case Scaled():
                factor = side.sense * in_base(parse_unit(side.unit), self.problem.us)
                return tuple(v * factor for v in self.value(side.operand))
            case Binary():
                return self._binary(side)
            case Function() if side.at is None:
                (argument,) = self.value(side.argument)
                return (FUNCTIONS[side.name](argument),)
            case Function():
                assert side.at is not None
                return self.measures.elsewhere(side.at, Function(side.name, side.argument, None, side.mark))
        return (self.measures.model.scene.sides.value(side).value,)

    def _leaf(self, side: Quantity | Name | Grouped) -> tuple[float, ...]:
        if isinstance(side, Grouped):
            return self.measures.elsewhere(side.at, side.operand)
        state = side.at
        assert not isinstance(state, tuple)
        if isinstance(side, Name):
            bare: Side = Name(side.name, None, side.mark)
        else:
            bare = Quantity(side.word, side.things, side.argument, side.parts, None, side.mark)
        if state is not None:
            return self.measures.elsewhere(state, bare)
        if isinstance(side, Name) and side.name not in self.measures.model.scene.coordinates and side.name != "t":
            return self.measures.at(side, self._start())
        if self.problem.instant is not None or not self.problem.states:
            return self.measures.at(bare, self._start())
        raise Undecided(f"{_place(side)}: it varies; say at which state")

    def _stateless(self, what: Side) -> bool:
        """Is it asked without a state, in a file that has states?"""
        if self.problem.instant is not None or not self.problem.states or names_of_states(what):
            return False
        known = self.measures.model.scene.coordinates
        nodes = [n for n in walk(what) if isinstance(n, Quantity | Name)]
        asked = [n for n in nodes if isinstance(n, Quantity) or n.name in known]
        return bool(asked) and not any(isinstance(n, Quantity) and n.word in NOT_FOLLOWED for n in asked)

    def _throughout(self, what: Side, scale: float) -> tuple[float, ...]:
        """What has the same value all the time. Undecided: it varies."""
        found = self.measures.at(what, self._start())
        for segment in self.trajectory.segments:
            assert isinstance(segment.regime, Regime)
            for k in range(LOOKS + 1):
                t = segment.t0 + (segment.t1 - segment.t0) * k / LOOKS
                now = self.measures.at(what, Moment(segment.regime, {}, t, tuple(segment.at(t))))
                off = max(abs(a - b) for a, b in zip(now, found, strict=True))
                if off > SAME * max(scale, *map(abs, found)):
                    raise Undecided(f"{_place(what)}: it varies; say at which state")
        return found

    def _start(self) -> Moment:
        """The moment at which the motion begins."""
        return self.measures.moments[START]

    def _binary(self, side: Binary) -> tuple[float, ...]:
        left, right = self.value(side.left), self.value(side.right)
        match side.operator:
            case "+":
                return tuple(a + b for a, b in zip(left, right, strict=True))
            case "-":
                return tuple(a - b for a, b in zip(left, right, strict=True))
            case "*" if len(left) == 1:
                return tuple(left[0] * b for b in right)
            case "*":
                return tuple(a * right[0] for a in left)
            case "/" if right[0] == 0:
                raise Undecided(f"{_place(side)}: this has no value (division by zero)")
            case "/":
                return tuple(a / right[0] for a in left)
        return (left[0] ** right[0],)

    # --- truths ------------------------------------------------------------------------------------------------------

    def _holds(self, relation: Relation) -> bool:
        stated = mode_of(relation)
        if stated is not None:
            side = relation.left if isinstance(relation.left, Quantity) else relation.right
            assert isinstance(side, Quantity)
            return self._mode(stated[0], side.at) == stated[1]
        left, right = self.value(relation.left), self.value(relation.right)
        size = max((abs(v) for v in (*left, *right)), default=0.0)
        # A state is found to some rounding, so that what is zero there is one beside the ordinary sizes of the scene.
        measured = any(isinstance(n, Quantity) for n in walk(relation))
        usual = Timetable(self.problem, self.measures).scale(relation.left, relation.right) if measured else 0.0
        same = all(abs(a - b) <= EQUAL * max(size, usual) for a, b in zip(left, right, strict=True))
        if relation.operator == "=" or same:
            return same and relation.operator in ("=", "<=", ">=")
        less = left[0] < right[0] if relation.operator in ("<", ">=") else left[0] > right[0]
        return less if relation.operator in ("<", ">") else not less

    def _reached(self, q: Quantity) -> bool:
        state = q.argument.name if isinstance(q.argument, Name) else q.things[0]
        return state in self.measures.moments

    def _mode(self, joint: str, at: object) -> str:
        state = at if isinstance(at, str) else START
        moment = self.measures.moments.get(state)
        if moment is None:
            raise Undecided(f"{self.problem.file}: the state {state} is not reached, so {joint} has no mode there")
        if joint not in moment.modes:
            raise Undecided(f"{self.problem.file}: {joint} has one mode only")
        return moment.modes[joint]

    # --- units -------------------------------------------------------------------------------------------------------

    def unit(self, find: Find) -> Unit:
        """As the find says, else as its stated answer, else the usual one."""
        if find.found.unit is not None:
            return parse_unit(find.found.unit)
        if find.name in self.units:
            return parse_unit(self.units[find.name])
        assert not isinstance(find.found.what, Relation)
        return usual_unit(find.found.what, self.kinds, self.problem.us)


def _place(side: Side) -> str:
    """Where it stands in the file."""
    return f"{side.mark.file}:{side.mark.line}"
