"""The sense of an answer in words: counterclockwise, to the right, upward, at 20° above +x."""

from __future__ import annotations

import math
from collections.abc import Collection
from decimal import Decimal

import sympy as sp

from planar_cli.equation.algebra.bounds import certain_sign
from planar_cli.equation.values.exact import Valuation
from planar_cli.equation.values.ledger import Ledger
from planar_cli.problem.language.expression import Binary, Grouped, Name, Number, Part, PointPair, Quantity, Side
from planar_cli.report.notation.numbers import rotation_words, vector_words
from planar_cli.report.words.sides import number_of
from planar_cli.report.words.slopes import Slope, direction_of, slope_words
from planar_cli.solve.solution import Found
from planar_cli.units import ANGULAR_MOMENTUM, FORCE, MOMENTUM

AXES = ("x", "y")
WAYS = ("to the right", "upward", "to the left", "downward")
TURNS = ("omega", "alpha", "moment", "H")
MOVES = ("v", "a", "friction", "reaction", "force", "coriolis", "momentum")
TIME_OF = "t__"
"""Stands before a state in the name of its time; times are made in the order of the states."""


def direction_words(
    found: Found, number: Decimal, ledger: Ledger, value: Valuation, slopes: tuple[Slope, ...] = ()
) -> str:
    """Words for rotations and for parts along axes, given directions and `slopes`; empty of all else, and where there
    is no number.
    """
    if not number or found.values is None:
        return ""
    return _words(found, number > 0, ledger) or _oblique(found, number > 0, ledger, value, slopes)


def steepness_words(found: Found, degrees: Decimal) -> str:
    """An asked direction of a vector that is not between 0 and 90 degrees, from the nearer end of the x axis."""
    what = found.find.found.what if found.find is not None else None
    if not isinstance(what, Quantity) or what.word not in MOVES or not what.parts or what.parts[-1].kind != "angle":
        return ""
    if 0 <= degrees <= 90 or found.unit.text != "deg":
        return ""
    turn = float(degrees) * math.pi / 180
    ends = {180: (-1, 0), -90: (0, -1), 270: (0, -1), -180: (-1, 0)}
    x, y = ends.get(int(degrees) if degrees == int(degrees) else 0, (math.cos(turn), math.sin(turn)))
    return f", that is {vector_words(Decimal(x), Decimal(y)).removeprefix('at ')}"


def _oblique(found: Found, positive: bool, ledger: Ledger, value: Valuation, slopes: tuple[Slope, ...]) -> str:
    """The direction of a part along a slanting line that the file gives by its angle, or across such a line."""
    what = found.find.found.what if found.find is not None else None
    if not isinstance(what, Quantity) or not _moves(found, what) or len(what.parts) != 1:
        return ""
    (part,) = what.parts
    if part.kind not in ("along", "across") or not isinstance(part.direction, Side):
        return ""
    way = direction_of(part.direction, ledger, value)
    if way is None:
        return ""
    if words := slope_words(part, positive, way, slopes, ledger, value):
        return words
    if part.kind == "across":
        return ""
    cosine, sine = value(way[0]), value(way[1])
    return vector_words(cosine, sine) if positive else vector_words(-cosine, -sine)


def _moves(found: Found, what: Quantity) -> bool:
    """Is it a vector that has a direction of its own?"""
    return what.word in MOVES or (what.word == "impulse" and found.unit.dimension != ANGULAR_MOMENTUM)


def sense_of_formula(found: Found, acute: Collection[sp.Symbol], ledger: Ledger) -> str:
    """The same behind a formula, where its letters tell its sign: " counterclockwise". `acute`: angles among them."""
    (formula, *others) = found.expressions or (None,)
    if formula is None or others or formula.free_symbols == set():
        return ""
    sign = _sign(formula, acute)
    if sign < 0 and _is_tension(found):
        return ", that is compression"
    words = _words(found, sign > 0, ledger) if sign else ""
    return f"{', that is' if sign < 0 else ''} {words}" if words else ""


def _is_tension(found: Found) -> bool:
    what = found.find.found.what if found.find is not None else None
    return isinstance(what, Quantity) and what.word == "tension"


def _sign(formula: sp.Expr, acute: Collection[sp.Symbol]) -> int:
    """1 or -1 where a product has that sign for positive letters and acute angles; 0: it is not known."""
    if formula == 0:
        return 0
    sign = 1
    for factor in sp.Mul.make_args(formula):
        base = factor.as_base_exp()[0]
        if not (isinstance(base, sp.sin | sp.cos | sp.tan) and base.args[0] in acute):
            sign *= certain_sign(factor)
    return sign


def _words(found: Found, positive: bool, ledger: Ledger) -> str:
    what = found.find.found.what if found.find is not None else None
    what = what.operand if isinstance(what, Grouped) else what
    if isinstance(what, Binary):
        if (axis := _displaced(what)) is not None:
            return WAYS[axis + (0 if positive != _is_turned_round(what, ledger) else 2)]
        what = _times_mass(what, found)
    if not isinstance(what, Quantity):
        return ""
    turns = what.word in TURNS or (what.word == "impulse" and found.unit.dimension == ANGULAR_MOMENTUM)
    if turns and not what.parts:
        return rotation_words(found.turn if positive else -found.turn)
    if _moves(found, what) and len(what.parts) == 1:
        (part,) = what.parts
        if part.kind == "along" and isinstance(part.direction, PointPair):
            ends = (part.direction.origin, part.direction.to)
            return "from {} towards {}".format(*(ends if positive else reversed(ends)))
        if part.kind == "across" and isinstance(part.direction, PointPair):
            named = f"{part.direction.origin}{part.direction.to}"
            return f"perpendicular to {named}, {'counter' if positive else ''}clockwise from it"
        if part.kind == "t":
            return f"{'in' if positive else 'against'} the direction of motion" if what.word == "a" else ""
        quarter = _quarter(part)
        return "" if quarter is None else WAYS[(quarter + (0 if positive else 2)) % 4]
    return ""


def _displaced(what: Binary) -> int | None:
    """The axis, x 0 and y 1, along which a thing has moved between two states: x(b) @ 2 - x(b) @ 1; None: it is no such
    difference.
    """
    end, start = what.left, what.right
    if what.operator != "-" or not isinstance(end, Quantity) or not isinstance(start, Quantity):
        return None
    same = (end.word, end.things) == (start.word, start.things) and not end.parts and not start.parts
    return AXES.index(end.word) if same and end.word in AXES and end.at != start.at else None


def _is_turned_round(what: Binary, ledger: Ledger) -> bool:
    """Is the place in the later state taken from that in the earlier one, y(b) @ 1 - y(b) @ 2?"""
    times = [name for name in ledger.symbols if name.startswith(TIME_OF)]
    ends = [f"{TIME_OF}{side.at}" for side in (what.left, what.right) if isinstance(side, Quantity)]
    return all(end in times for end in ends) and times.index(ends[0]) < times.index(ends[1])


def _times_mass(what: Binary, found: Found) -> Quantity | None:
    """The acceleration or velocity that is asked times a mass, which has its direction; None: it is another product."""
    kinds = {"a": FORCE, "v": MOMENTUM}
    sides = (what.left, what.right) if what.operator == "*" else ()
    moved = [s for s in sides if isinstance(s, Quantity) and kinds.get(s.word) == found.unit.dimension]
    rest = [s for s in sides if s not in moved]
    massive = len(rest) == 1 and (isinstance(rest[0], Name | Quantity) or _is_above_zero(rest[0]))
    return moved[0] if len(moved) == 1 and massive else None


def _is_above_zero(side: Side) -> bool:
    """Is it a positive number?"""
    return isinstance(side, Number) and side.value > 0


def _quarter(part: Part) -> int | None:
    """How many right angles a component along an axis, or along a direction in degrees, is turned from x."""
    if part.kind in ("x", "y"):
        return int(part.kind == "y")
    number = number_of(part.direction) if part.kind == "along" and isinstance(part.direction, Side) else None
    if number is None or number[1] != "deg" or number[0] % 90 != 0:
        return None
    return int(number[0] // 90) % 4
