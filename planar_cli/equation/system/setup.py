"""From a problem to the scene of one instant: names become symbols, given numbers exact values, coordinates settle."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import field
from decimal import Decimal

import sympy as sp

from planar_cli.equation.scene.bounded import ranges
from planar_cli.equation.scene.displacement import Displacement
from planar_cli.equation.scene.scene import Scene
from planar_cli.equation.system.system import Statements
from planar_cli.equation.values.evaluate import Evaluator
from planar_cli.equation.values.exact import Valuation
from planar_cli.equation.values.ledger import Kind as RoleKind
from planar_cli.equation.values.ledger import Ledger, Role
from planar_cli.equation.values.parts_of_accelerations import know_marks
from planar_cli.errors import refuse
from planar_cli.problem.language.dimensions import Kind, dimension_of
from planar_cli.problem.language.expression import (
    Binary,
    Function,
    Grouped,
    Name,
    Negate,
    Number,
    Quantity,
    Relation,
    Scaled,
    Side,
)
from planar_cli.problem.scene.facts import Mode
from planar_cli.problem.scene.impulse_letters import impulse_letters
from planar_cli.problem.scene.ordinary import scales_of
from planar_cli.problem.scene.scene import Problem, Symbol
from planar_cli.records import record
from planar_cli.units import ANGULAR_MOMENTUM, DAMPING, PURE, Unit, default_unit, parse_unit

FLOW = "kg/s"
ANGULAR_IMPULSE = "N*m*s"
"""The usual names of units that others share."""


@record
class Earlier:
    """A find of an earlier case: its exact value (or a rational close to sixty digits; a formula in letters of the
    file) and its unit.
    """

    value: sp.Expr
    unit: str


def numbers_of(earlier: Mapping[str, Earlier], letters: Mapping[str, float] | None = None) -> dict[str, float]:
    """Numbers of earlier finds [SI]; those in letters have none without those of the letters."""
    own = letters or {}
    formulas = {name: known.value for name, known in earlier.items()}
    put = {
        n: f.xreplace({s: sp.Float(own[s.name]) for s in f.free_symbols if s.name in own}) for n, f in formulas.items()
    }
    return {name: float(value) for name, value in put.items() if not value.free_symbols}


@record
class Course:
    """A scene in a general position: how it is displaced (None: as drawn), within which ranges letters are drawn or
    beside which formulas, and how draws of coordinates are moved to where loops close. `parted`: modes of joints that
    have parted, as drawn; what they joined may be anywhere.
    """

    displacement: Displacement | None
    ranges: Mapping[str, tuple[Decimal, Decimal]]
    project: Callable[[Valuation], Mapping[sp.Symbol, Decimal]] | None = None
    parted: Mapping[str, tuple[Mode, ...]] = field(default_factory=dict)
    beside: Mapping[str, tuple[sp.Expr, Decimal, Decimal]] = field(default_factory=dict)


class Setup:
    """Makes ledger, evaluator and scene (of class `scene`); `open_form`: coordinates stay letters of the answer (a
    formula that holds throughout).
    """

    def __init__(
        self,
        problem: Problem,
        statements: Statements,
        earlier: Mapping[str, Earlier],
        open_form: bool,
        course: Course | None = None,
        scene: type[Scene] = Scene,
    ) -> None:
        self.problem, self.statements, self.earlier = problem, statements, earlier
        self.open_form = open_form
        self.parted = course.parted if course is not None else {}
        written = (*problem.given, *problem.symbols, *problem.unknowns, *problem.coordinates)
        names = frozenset(s.name for s in written) | differences(problem)
        self.ledger = Ledger(us=problem.us, reserved=names, scales=scales_of(problem))
        self.ledger.coefficients = {s.name: s.coefficient for s in problem.symbols if s.coefficient}
        self._given = {s.name: s for s in problem.given}
        self._waiting: list[str] = []
        self.motions: dict[sp.Symbol, tuple[sp.Expr | None, sp.Expr | None]] = {}
        self.evaluator = Evaluator(self.ledger, self.motions)
        self._names()
        self.settled: list[Relation] = []
        self._settle_coordinates(open_form)
        displacement = None
        self.ledger.ranges = ranges(self.ledger, self.evaluator, statements.inequalities)
        if course is not None:
            displacement = course.displacement
            self._open_course(course)
        self.scene = scene(problem, self.ledger, self.evaluator, displacement)
        if course is not None:
            for symbol in list(self.ledger.sought):
                self.ledger.release(symbol)

    def _open_course(self, course: Course) -> None:
        """Time, coordinates and speeds stay letters; their draws lie where the file says."""
        time = self.ledger.symbols["t"]
        if time not in self.ledger.letters:
            self.ledger.letters.append(time)
        if course.displacement is not None:
            for c in course.displacement.coordinates:
                if c.symbol not in self.ledger.roles:
                    self.ledger.adopt(c.symbol, parse_unit(c.shown), Role(RoleKind.COORDINATE))
                    self.ledger.letters.append(c.symbol)
                self.ledger.adopt(c.start, parse_unit(c.shown), Role(RoleKind.START, c.symbol))
        self.ledger.ranges, self.ledger.beside = dict(course.ranges), dict(course.beside)
        self.ledger.project = course.project

    # --- names -------------------------------------------------------------------------------------------------------

    def _names(self) -> None:
        time = self.ledger.time()
        self.motions[time] = (sp.S.One, sp.S.Zero)
        for symbol in self.problem.symbols:
            self.ledger.letter(symbol.name, symbol.unit or "1")
        for symbol in self.problem.unknowns:
            self.ledger.seek(symbol.name, symbol.unit or "1")
        for symbol in self.problem.coordinates:
            made = self.ledger.seek(symbol.name, symbol.unit or "1", coordinate=True, distance=symbol.distance)
            unit = symbol.unit or "1"
            per = "rad" if parse_unit(unit).angle else unit if unit != "1" else "1"
            self.motions[made] = (
                self.ledger.fresh(f"{symbol.name}_dot", f"{per}/s", role=Role(RoleKind.SPEED, made)),
                self.ledger.fresh(f"{symbol.name}_ddot", f"{per}/s^2", role=Role(RoleKind.ACCELERATION, made)),
            )
        for name, known in self.earlier.items():
            letters = {s.name for s in known.value.free_symbols}
            if "g" in letters and "g" not in self.ledger.symbols:
                self._gravity()
            self.ledger.known(name, known.value, known.unit)
        know_marks(self.ledger, [b.name for b in self.problem.bodies])
        for symbol in self.problem.given:
            self._know(symbol)
        for letter, side in impulse_letters(self.problem).values():
            self.ledger.known(letter, self.evaluator.value(side), "N*s")

    def _know(self, symbol: Symbol) -> None:
        """A given name; the names in its formula come first."""
        if symbol.name in self.ledger.symbols or symbol.value is None:
            return
        if symbol.name in self._waiting:
            raise refuse(symbol.mark, "PL533", f"{symbol.name} is given through itself")
        self._waiting.append(symbol.name)
        for name in sorted(names_in(symbol.value)):
            if name in self._given:
                self._know(self._given[name])
        if "g" in names_in(symbol.value) and "g" not in self.ledger.symbols:
            self._gravity()
        self._waiting.pop()
        self.ledger.known(symbol.name, self.evaluator.value(symbol.value), self.unit_of(symbol.value))

    def _gravity(self) -> None:
        self.ledger.gravity(letter=bool(self.problem.symbols))

    def unit_of(self, side: Side) -> str:
        """The unit in which a value is shown: as written, else the usual one of its dimension."""
        written = first_unit(side)
        if written is not None and isinstance(side, Number | Negate | Scaled):
            return written
        unit = self.unit_for(dimension_of(side, self.lookup))
        streams = any(load.brings_mass for load in self.problem.loads)
        # A mass that flows is no damping, which has its dimension.
        return FLOW if unit.dimension == DAMPING and streams and not self.ledger.us else unit.text

    def unit_asked(self, what: Side, kind: Kind) -> Unit:
        """The unit in which something asked is shown: of a coordinate or unknown that with which it is declared."""
        symbol = self.ledger.symbols.get(what.name) if isinstance(what, Name) else None
        if symbol is not None and self.ledger.roles[symbol].kind in (RoleKind.COORDINATE, RoleKind.SOUGHT):
            return self.ledger.units[symbol]
        if isinstance(what, Quantity) and what.word == "impulse" and kind.dimension == ANGULAR_MOMENTUM:
            return self.unit_for(kind) if self.ledger.us else parse_unit(ANGULAR_IMPULSE)
        return self.unit_for(kind)

    def unit_for(self, kind: Kind) -> Unit:
        return default_unit(kind.dimension or PURE, kind.angle, self.ledger.us)

    def lookup(self, thing: Name | Quantity) -> Kind | None:
        """The dimension of a name; quantities by their table."""
        if isinstance(thing, Name):
            symbol = self.ledger.symbols.get(thing.name)
            if symbol is not None:
                unit = self.ledger.units[symbol]
                return Kind(unit.dimension, unit.angle)
        return None

    # --- coordinates -------------------------------------------------------------------------------------------------

    def _settle_coordinates(self, open_form: bool) -> None:
        """`theta = 30 deg` gives a coordinate its value; with `motion`, its rates as well."""
        for stated, always in self.statements.relations:
            relation = stated
            if isinstance(stated.right, Name) and not isinstance(stated.left, Name):
                relation = Relation(stated.right, "=", stated.left, stated.text, stated.mark)
            symbol = self.ledger.symbols.get(relation.left.name) if isinstance(relation.left, Name) else None
            if symbol is None or symbol not in self.ledger.sought or has_quantity(relation.right):
                continue
            if "g" in names_in(relation.right) and "g" not in self.ledger.symbols:
                self._gravity()
            jet = self.evaluator.jet(relation.right)
            if set(self.ledger.sought) & jet.value.free_symbols:
                continue
            self.ledger.settle(symbol, jet.value)
            self.settled.append(relation)
            if always and symbol in self.ledger.coordinates:
                self.motions[symbol] = (jet.rate, jet.second)
        if open_form:
            for symbol in list(self.ledger.coordinates):
                if symbol in self.ledger.sought:
                    self.ledger.release(symbol)
            if self._uses_time():
                self.ledger.letters.append(self.ledger.symbols["t"])

    def _uses_time(self) -> bool:
        """Does a relation of the file mention t?"""
        sides = [s for relation, _ in self.statements.relations for s in (relation.left, relation.right)]
        return any("t" in names_in(side) for side in sides)


def differences(problem: Problem) -> frozenset[str]:
    """Letters of states that would read like a find which is something else: `t_4: t @ 4 - t @ 3` beside the time t_4
    of state 4.
    """
    made = (f.name.rpartition("_") for f in problem.find if isinstance(f.found.what, Binary))
    return frozenset(f"{stem}__{state}" for stem, _, state in made if stem)


def is_linear(side: Side, names: set[str]) -> bool:
    """Do these bare names enter a side linearly, as far as its signs tell?"""
    match side:
        case Negate() | Scaled() | Grouped():
            return is_linear(side.operand, names)
        case Function():
            return not names_in(side) & names
        case Binary(operator="+" | "-" | "*"):
            both = names_in(side.left) & names and names_in(side.right) & names
            return not (side.operator == "*" and both) and all(is_linear(s, names) for s in (side.left, side.right))
        case Binary(operator="/"):
            return is_linear(side.left, names) and not names_in(side.right) & names
        case Binary():
            return not names_in(side) & names
    return True


def names_in(side: Side) -> set[str]:
    """All bare names of a side."""
    match side:
        case Name():
            return {side.name}
        case Negate() | Scaled() | Grouped():
            return names_in(side.operand)
        case Function():
            return names_in(side.argument)
        case Binary():
            return names_in(side.left) | names_in(side.right)
    return set()


def has_quantity(side: Side) -> bool:
    """Does a quantity stand in the side?"""
    match side:
        case Quantity():
            return True
        case Negate() | Scaled():
            return has_quantity(side.operand)
        case Function():
            return has_quantity(side.argument)
        case Binary():
            return has_quantity(side.left) or has_quantity(side.right)
    return False


def first_unit(side: Side) -> str | None:
    """The first unit written in a side."""
    match side:
        case Number() | Scaled():
            return side.unit
        case Negate():
            return first_unit(side.operand)
        case Function():
            return first_unit(side.argument)
        case Binary():
            return first_unit(side.left) or first_unit(side.right)
    return None
