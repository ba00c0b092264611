"""What dimension an expression has, read from the tree alone: no algebra, and every mismatch with its place.

The file decides what names are, so that the caller gives a `Lookup`: the kind of a name or quantity, None for what it
does not know. For quantities, None means the table of this module.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from fractions import Fraction
from types import MappingProxyType

from planar_cli import units
from planar_cli.errors import Diagnostic, Mark
from planar_cli.problem.language.expression import (
    Binary,
    Extreme,
    Found,
    Function,
    Grouped,
    Law,
    Name,
    Negate,
    Number,
    PointPair,
    Quantity,
    Relation,
    Scaled,
    Side,
    Statement,
    Word,
)
from planar_cli.problem.language.logarithms import same_in_all_units
from planar_cli.problem.language.walk import rational, walk
from planar_cli.records import record
from planar_cli.units import Dimension, UnitError, default_unit, describe, parse_unit


@record
class Kind:
    """The dimension of a side; None fits every dimension (0, infinity, what is not known).

    `angle`: an angle or a rate of angle. `word`: what it is if it is no number (`a mode`, `a curve`, `true or false`).
    """

    dimension: Dimension | None
    angle: bool = False
    word: str = ""

    def __str__(self) -> str:
        if self.word or self.dimension is None:
            return self.word or "a quantity"
        return describe(self.dimension, self.angle)


Lookup = Callable[[Name | Quantity], Kind | None]
Report = list[Diagnostic]

ANY = Kind(None)
PURE = Kind(units.PURE)
ANGLE = Kind(units.PURE, angle=True)
MODE = Kind(None, word="a mode")
TRUTH = Kind(None, word="true or false")
CURVE = Kind(None, word="a curve")

_CONSTANTS: Mapping[str, Kind] = MappingProxyType({"t": Kind(units.TIME), "pi": PURE, "infinity": ANY})

QUANTITY_KINDS: Mapping[str, Kind] = MappingProxyType(
    {
        **dict.fromkeys(("x", "y", "r", "rho", "IC", "path_length"), Kind(units.LENGTH)),
        "v": Kind(units.VELOCITY),
        **dict.fromkeys(("a", "coriolis"), Kind(units.ACCELERATION)),
        "theta": ANGLE,
        "omega": Kind(units.RATE, angle=True),
        "alpha": Kind(units.RATE_OF_RATE, angle=True),
        **dict.fromkeys(("path", "hodograph"), CURVE),
        **dict.fromkeys(("N", "friction", "reaction", "tension", "force"), Kind(units.FORCE)),
        **dict.fromkeys(("moment", "KE", "PE", "work", "heat"), Kind(units.ENERGY)),
        "mode": MODE,
        "mass": Kind(units.MASS),
        "I": Kind(units.INERTIA),
        "momentum": Kind(units.MOMENTUM),
        "impulse": Kind(units.IMPULSE),
        "H": Kind(units.ANGULAR_MOMENTUM),
        "power": Kind(units.POWER),
        **dict.fromkeys(("count", "decrement", "damping_ratio"), PURE),
        "period": Kind(units.TIME),
        "frequency": Kind(units.RATE),
        **dict.fromkeys(("reached", "stable"), TRUTH),
    }
)


def dimension_of(side: Side, lookup: Lookup, report: Report | None = None) -> Kind:
    """The kind of a side; mismatches inside are appended to `report`."""
    return _Inference(lookup, [] if report is None else report).kind(side)


def _counts_turns(side: Side) -> bool:
    """Is it pi, or a number of times that?"""
    leaves = [node for node in walk(side) if isinstance(node, Name | Quantity | Scaled)]
    return bool(leaves) and all(isinstance(node, Name) and node.name == "pi" for node in leaves)


def check_side(side: Side, expected: Dimension | None, lookup: Lookup, report: Report, angle: bool = False) -> Kind:
    """The kind of a side that should have the dimension `expected` (None: any number)."""
    inference = _Inference(lookup, report)
    kind = inference.number(side)
    if expected is None:
        return kind
    wanted = Kind(expected, angle)
    if _is_bare(side) and (angle or expected != units.PURE):
        message = f"a number without a unit stands where {wanted} is due"
        inference.complain(_mark(side), "PL225", message, _with_unit(wanted))
    elif kind.dimension is not None and kind.dimension != expected:
        inference.complain(_mark(side), "PL224", f"{kind} stands where {wanted} is due", _slip(side))
    return kind


def check_relation(relation: Relation, lookup: Lookup, report: Report) -> Kind:
    """Both sides of a relation must agree; the kind of the left one, or of the right if that says more."""
    inference = _Inference(lookup, report)
    left, right = inference.kind(relation.left), inference.kind(relation.right)
    return inference.agree(relation, left, right)


def check_statement(statement: Statement | Law, lookup: Lookup, report: Report) -> None:
    """Dimensions inside any statement."""
    inner = statement.statement if isinstance(statement, Law) else statement
    if isinstance(inner, Relation):
        check_relation(inner, lookup, report)
    elif isinstance(inner, Extreme):
        check_side(inner.side, None, lookup, report)


def check_found(found: Found, lookup: Lookup, report: Report) -> Kind:
    """What is asked for, and whether the unit that is wanted fits it; a relation is true or false."""
    if isinstance(found.what, Relation):
        check_relation(found.what, lookup, report)
        kind = TRUTH
    else:
        kind = dimension_of(found.what, lookup, report)
    if found.unit is None:
        return kind
    unit = parse_unit(found.unit)
    wrong = bool(kind.word) or (kind.dimension is not None and kind.dimension != unit.dimension)
    if wrong:
        hint = "" if kind.dimension is None else f"write `in {default_unit(kind.dimension, kind.angle).text}`"
        message = f"{kind} cannot be given in {unit.text}, {describe(unit.dimension, unit.angle)}"
        report.append(Diagnostic(found.mark, "PL227", message, hint or "leave the unit out"))
    return kind


class _Inference:
    """One walk over a tree."""

    def __init__(self, lookup: Lookup, report: Report) -> None:
        self.lookup = lookup
        self.report = report
        self.sums: list[Side] = []
        """The sums in which the side stands that is looked at."""

    def complain(self, mark: Mark, code: str, message: str, hint: str = "") -> None:
        self.report.append(Diagnostic(mark, code, message, hint))

    def number(self, side: Side) -> Kind:
        """The kind of a side that has to be a number."""
        kind = self.kind(side)
        if not kind.word:
            return kind
        hint = "write `mode(C) = stick` as a relation" if kind == MODE else "ask for it by itself under `find`"
        self.complain(_mark(side), "PL226", f"{kind.word} stands where a number is due", hint)
        return ANY

    def kind(self, side: Side) -> Kind:
        match side:
            case Number():
                return self._literal(side)
            case Name():
                return _CONSTANTS.get(side.name) or self.lookup(side) or ANY
            case Word():
                return MODE
            case Negate(operand=operand) | Grouped(operand=operand):
                return self.number(operand)
            case Scaled():
                return self._scaled(side)
            case Function():
                return self._function(side)
            case Quantity():
                return self._quantity(side)
            case Binary():
                return self._chain(side)

    def _literal(self, number: Number) -> Kind:
        if number.unit is not None:
            return self._unit(number.unit, number.mark)
        return ANY if number.value == 0 else PURE

    def _unit(self, text: str, mark: Mark) -> Kind:
        try:
            unit = parse_unit(text)
        except UnitError as error:
            self.complain(mark, "PL203", error.message.replace("`", ""), error.hint)
            return ANY
        return Kind(unit.dimension, unit.angle)

    def _scaled(self, side: Scaled) -> Kind:
        self._pure(side.operand, "PL224", "a bracket with a unit behind it holds a pure number, not {}", "`(pi/4) rad`")
        return self._unit(side.unit, side.mark)

    def _pure(self, side: Side, code: str, message: str, example: str) -> None:
        """Complain with `message`, which has the kind for its {}, unless the side is a pure number or angle."""
        kind = self.number(side)
        if kind.dimension not in (None, units.PURE):
            self.complain(_mark(side), code, message.format(kind), f"write it as in {example}")

    def _function(self, side: Function) -> Kind:
        if side.name in ("abs", "sqrt"):
            kind = self.number(side.argument)
            if side.name == "abs" or kind.dimension is None:
                return kind
            return Kind(kind.dimension ** Fraction(1, 2))
        if side.name == "log" and self._in_whole_sum(side):
            return PURE
        message = side.name + "(…) is taken of an angle or a pure number, not of {}"
        example = f"`{side.name}(30 deg)`" if side.name in ("sin", "cos", "tan") else f"`{side.name}(x/l)`"
        self._pure(side.argument, "PL222", message, example)
        return ANGLE if side.name in ("asin", "acos", "atan") else PURE

    def _in_whole_sum(self, log: Function) -> bool:
        """Is it a logarithm of something with a unit, in a sum with others that make up for it?"""

        def dimension(side: Side) -> Dimension | None:
            return _Inference(self.lookup, []).number(side).dimension

        if not self.sums or dimension(log.argument) in (None, units.PURE):
            return False
        return any(same_in_all_units(s, dimension) for s in self.sums)

    # -- quantities -----------------------------------------------------------------------------

    def _quantity(self, quantity: Quantity) -> Kind:
        kind = self._argument(quantity)
        kind = self.lookup(quantity) or kind or self._table(quantity)
        for part in quantity.parts:
            # A name may be that of a body or surface.
            named = isinstance(part.direction, Name) and self.lookup(part.direction) is None
            if part.direction is not None and not isinstance(part.direction, PointPair) and not named:
                self._pure(part.direction, "PL222", "a direction is an angle, not {}", "`.along(30 deg)`")
            if part.kind == "angle":
                kind = ANGLE
        return kind

    def _argument(self, quantity: Quantity) -> Kind | None:
        """The kind of dot, ddot, mean and count, from what stands in the bracket; None for other quantities."""
        argument = quantity.argument
        if argument is None:
            return None
        if isinstance(argument, Relation):
            self.agree(argument, self.kind(argument.left), self.kind(argument.right))
            return PURE
        kind = self.number(argument)
        order = {"dot": 1, "ddot": 2}.get(quantity.word, 0)
        return kind if kind.dimension is None else Kind(kind.dimension / units.TIME**order, kind.angle)

    def _table(self, quantity: Quantity) -> Kind:
        if quantity.word == "impulse" and len(quantity.things) == 2:
            return Kind(units.ANGULAR_MOMENTUM)
        return QUANTITY_KINDS.get(quantity.word, ANY)

    # -- operators ------------------------------------------------------------------------------

    def _chain(self, side: Binary) -> Kind:
        """Long sums lean to the left, so that the left spine is walked in a loop."""
        spine: list[Binary] = []
        left: Side = side
        while isinstance(left, Binary):
            spine.append(left)
            left = left.left
        self.sums.append(side)
        kind = self.number(left)
        for binary in reversed(spine):
            kind = self._binary(binary, kind)
        self.sums.pop()
        return kind

    def _binary(self, side: Binary, left: Kind) -> Kind:
        right = self.number(side.right)
        if side.operator in "+-":
            return self._sum(side, left, right)
        if side.operator == "^":
            return self._power(side, left, right)
        if left.dimension is None or right.dimension is None:
            return ANY
        if side.operator == "*":
            product, angle = left.dimension * right.dimension, left.angle or right.angle
        else:
            product, angle = left.dimension / right.dimension, left.angle != right.angle
            # An angle in parts of pi is a number: so many turns, or half turns.
            angle = angle and not (left.angle and _counts_turns(side.right))
        return Kind(product, angle and product.length == 0 and product.mass == 0)

    def _sum(self, side: Binary, left: Kind, right: Kind) -> Kind:
        if left.dimension is None or right.dimension is None:
            return left if right.dimension is None else right
        if left.dimension != right.dimension:
            verb = "added to" if side.operator == "+" else "subtracted from"
            hint = _slip(side.right) or _slip(side.left)
            for bare, other in ((side.right, left), (side.left, right)):
                hint = hint or (_with_unit(other) if _is_bare(bare) else "")
            self.complain(side.mark, "PL220", f"{right} is {verb} {left}", hint)
            return ANY
        return Kind(left.dimension, left.angle or right.angle)

    def _power(self, side: Binary, left: Kind, right: Kind) -> Kind:
        if right.dimension not in (None, units.PURE):
            self.complain(_mark(side.right), "PL223", f"an exponent is a pure number, not {right}", "")
            return ANY
        if left.dimension is None or left.dimension == units.PURE:
            return PURE if left.dimension is not None else ANY
        exponent = rational(side.right)
        if exponent is None:
            hint = "divide by a reference value first: `(x/l)^n`"
            self.complain(_mark(side.right), "PL223", f"{left} can only be raised to a number", hint)
            return ANY
        return Kind(left.dimension**exponent, left.angle and exponent == 1)

    def agree(self, relation: Relation, left: Kind, right: Kind) -> Kind:
        """Both sides of a relation have one dimension, or are both modes."""
        if left.word or right.word:
            self._agree_words(relation, left, right)
            return left
        if left.dimension is None or right.dimension is None:
            return left if right.dimension is None else right
        for bare, other, kind in ((relation.right, relation.left, left), (relation.left, relation.right, right)):
            plain_angle = kind.angle and kind.dimension == units.PURE and isinstance(other, Name | Quantity)
            if _is_bare(bare) and (kind.dimension != units.PURE or plain_angle):
                message = f"a number without a unit stands where {kind} is due"
                self.complain(_mark(bare), "PL225", message, _with_unit(kind))
                return kind
        if left.dimension != right.dimension:
            verb = "set equal to" if relation.operator == "=" else "compared with"
            hint = _slip(relation.right) or _slip(relation.left)
            self.complain(relation.mark, "PL221", f"{left} is {verb} {right}", hint)
        return left

    def _agree_words(self, relation: Relation, left: Kind, right: Kind) -> None:
        if left == right == MODE and relation.operator == "=":
            return
        hint = "modes stick, slip, apart, tip, taut, slack stand behind `mode(j) =`; other words only under `find`"
        words = left.word or right.word
        self.complain(relation.mark, "PL226", f"{words} cannot be compared with {right if left.word else left}", hint)


def _mark(side: Side) -> Mark:
    """Where a side begins: the mark of a sum is its operator, so that its left end is taken."""
    while isinstance(side, Binary):
        side = side.left
    return side.mark


def _is_bare(side: Side) -> bool:
    """A literal number without a unit; zero needs none."""
    while isinstance(side, Negate):
        side = side.operand
    return isinstance(side, Number) and side.unit is None and side.value != 0


def _with_unit(kind: Kind) -> str:
    if kind.dimension is None:
        return ""
    if kind.angle and kind.dimension == units.PURE:
        return "write the unit behind the number: `deg` or `rad`"
    return f"write the unit behind the number, such as `{default_unit(kind.dimension, kind.angle).text}`"


def _slip(side: Side) -> str:
    """The hint for a unit that is often taken for something else."""
    while isinstance(side, Binary | Negate):
        side = side.left if isinstance(side, Binary) else side.operand
    unit = side.unit if isinstance(side, Number) else None
    if unit == "g":
        return "`g` behind a number is the gram; gravity is `2*g`"
    if unit == "lb":
        return "`lb` is a mass; the force is `lbf`"
    if unit == "h":
        return "`h` behind a number is the hour; a height is `2*h`"
    return ""
