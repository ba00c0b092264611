"""Formulas of a file as its author wrote them, in the notation of the page: `2*l` as 2 l."""

from __future__ import annotations

from decimal import Decimal

from planar_cli.equation.scene.line_names import line_name
from planar_cli.problem.language.expression import (
    Binary,
    Function,
    Grouped,
    Name,
    Negate,
    Number,
    PointPair,
    Quantity,
    Relation,
    Scaled,
    Side,
    Word,
)
from planar_cli.problem.language.walk import Tree, changed, walk
from planar_cli.report.document import blocks
from planar_cli.report.document.blocks import Line, Text, Value, line
from planar_cli.report.notation.numbers import superscript
from planar_cli.report.words.spoken import LETTERS, RELATIVE, SHORT, TOWARDS
from planar_cli.units import pretty_unit

SUM, FACTOR, POWER = 0, 1, 2
"""How closely a place binds: what stands there in a looser formula gets brackets."""
AS_WRITTEN = 6
"""A number of the file with at most so many figures is not rounded."""
TURNING = ("omega", "ω", "alpha", "α")
WAVES = ("sin", "cos", "tan")
RATES = ("dot", "ddot")
MASS = "mass"
CONSTANTS = {"pi": "π", "infinity": "∞"}


def said(side: Side, figures: int) -> Line | None:
    """A side as written; None where it asks a quantity that has no short name."""
    return _said(side, figures, SUM) if all(map(_has_a_name, walk(side))) else None


def said_of_force(side: Side, figures: int) -> Line | None:
    """A magnitude as written, with distances by the letters of their points: m K/SP², where a sentence has no place."""
    return said(changed(side, _distance), figures)


def _distance(node: Side) -> Side | None:
    """SP for r(P/S).mag"""
    if not isinstance(node, Quantity) or node.word != "r" or node.at is not None or len(node.things) != 2:
        return None
    end, start = node.things
    plain = [p.kind for p in node.parts] == ["mag"] and len(start) == len(end) == 1
    return Name(f"{start}{end}", None, node.mark) if plain else None


def _has_a_name(node: Tree) -> bool:
    """Is it nothing that only a sentence can tell?"""
    match node:
        case Quantity():
            known = (*RELATIVE, *TURNING) if len(node.things) == 2 else LETTERS
            parts = ("x", "y", "mag", "angle", "along", "across") + (("t", "n") if len(node.things) == 1 else ())
            one = len(node.parts) == 0 or (len(node.parts) == 1 and node.parts[0].kind in parts)
            if node.word in RATES and isinstance(node.argument, Name):
                return node.at is None
            massive = node.word == MASS and len(node.things) == 1 and not node.parts
            return node.at is None and node.argument is None and (massive or (node.word in known and one))
        case Name() | Function():
            return node.at is None
    return not isinstance(node, Grouped | Word | Relation)


def number_of(side: Side) -> tuple[Decimal, str] | None:
    """The number of a side and its unit, where it is one number."""
    sign = 1
    while isinstance(side, Negate):
        side, sign = side.operand, -sign
    if not isinstance(side, Number):
        return None
    return Decimal(side.value.numerator) / Decimal(side.value.denominator) * side.sense * sign, side.unit or "1"


def is_zero(side: Side) -> bool:
    """Is nought written?"""
    number = number_of(side)
    return number is not None and not number[0]


def _said(side: Side, figures: int, place: int) -> Line:
    number = number_of(side)
    if number is not None:
        shown = line(Value(*number, max(figures, AS_WRITTEN)))
        # A power of a number with a unit, and a product with a negative one, need brackets.
        loose = (place == POWER and number[1] != "1") or (place != SUM and number[0] < 0)
        return _bracketed(shown) if loose else shown
    match side:
        case Name(at=None):
            return line(CONSTANTS[side.name] if side.name in CONSTANTS else blocks.Name(side.name))
        case Negate():
            inside = line("-", _said(side.operand, figures, FACTOR))
            return _bracketed(inside) if place != SUM else inside
        case Scaled():
            return line("(", _said(side.operand, figures, SUM), f") {pretty_unit(side.unit)}")
        case Binary():
            return _combined(side, figures, place)
        case Function(at=None):
            name = {"sqrt": "√", "log": "ln"}.get(side.name, side.name)
            argument = _said(side.argument, figures, SUM)
            if len(argument) > 1 or side.name == "abs":
                return line(f"{name}(", argument, ")")
            return line(name, "" if side.name == "sqrt" else " ", argument)
        case Quantity():
            return _quantity(side, figures)
    raise TypeError(type(side).__name__)


def _combined(side: Binary, figures: int, place: int) -> Line:
    if side.operator == "^":
        if (wave := _power_of_wave(side, figures)) is not None:
            return wave
        base = _said(side.left, figures, POWER)
        power = number_of(side.right)
        if power is not None and power[0] == int(power[0]) >= 0:
            return line(base, superscript(str(int(power[0]))))
        return line(base, "^(", _said(side.right, figures, SUM), ")")
    if side.operator in "+-":
        right = _said(side.right, figures, SUM if side.operator == "+" else FACTOR)
        found = line(_said(side.left, figures, SUM), f" {side.operator} ", right)
        return _bracketed(found) if place != SUM else found
    left, right = _said(side.left, figures, FACTOR), _said(side.right, figures, FACTOR)
    if side.operator == "/":
        compound = isinstance(side.right, Binary) and side.right.operator in "*/"
        found = line(left, "/", _bracketed(right) if compound or _has_unit(right[-1]) else right)
    else:
        opens = right[0]
        numeral = isinstance(opens, Value) or (isinstance(opens, Text) and opens.text[:1].isdigit())
        found = line(left, " · " if numeral or _has_unit(left[-1]) else " ", right)
    return _bracketed(found) if place == POWER else found


def _power_of_wave(side: Binary, figures: int) -> Line | None:
    """sin² θ, which is not sin θ²; None: it is no power of a sine."""
    power = number_of(side.right)
    if not isinstance(side.left, Function) or side.left.name not in WAVES or side.left.at is not None:
        return None
    if power is None or power[0] != int(power[0]) or power[0] < 2:
        return line("(", _said(side.left, figures, SUM), ")^(", _said(side.right, figures, SUM), ")")
    argument = _said(side.left.argument, figures, SUM)
    inside = line("(", argument, ")") if len(argument) > 1 else line(" ", argument)
    return line(f"{side.left.name}{superscript(str(int(power[0])))}", inside)


def _has_unit(piece: blocks.Inline) -> bool:
    return isinstance(piece, Value) and piece.unit != "1"


def _bracketed(inside: Line) -> Line:
    return line("(", inside, ")")


def _quantity(asked: Quantity, figures: int) -> Line:
    """`v(crate).x` as v_crate,x; `v(P).along(30 deg)` as v_P along 30°."""
    if asked.word in RATES and isinstance(asked.argument, Name):
        return line(blocks.Name(f"{asked.argument.name}_{asked.word}"))
    part = asked.parts[0] if asked.parts else None
    thing, *relative = asked.things
    name = f"{'m' if asked.word == MASS else LETTERS[asked.word]}_{thing}"
    if relative:
        base = line(blocks.Name(name, of_thing=True), f"/{relative[0]}")
    elif part is not None and part.kind in ("x", "y", "t", "n"):
        return line(blocks.Name(name + ("" if len(thing) <= SHORT else "_") + part.kind, of_thing=True))
    else:
        # m_A may be the file's own letter for that mass.
        base = line(blocks.Name(name, of_thing=asked.word != MASS))
    if part is None:
        return base
    if part.kind == "mag":
        return line("|", base, "|")
    if part.kind == "angle":
        return line("direction of ", base)
    if part.kind in ("x", "y"):
        return line(base, f" along {part.kind}")
    number = None if relative or not isinstance(part.direction, Side) else number_of(part.direction)
    if part.kind == "along" and number is not None and number[1] == "deg" and f"{number[0]}" in TOWARDS:
        return line(base, f" {TOWARDS[str(number[0])]}")
    return line(base, f" {part.kind} ", *_direction(part.direction, figures))


def _direction(direction: Side | PointPair | None, figures: int) -> Line:
    if isinstance(direction, PointPair):
        return line(line_name(direction.origin, direction.to))
    return () if direction is None else _said(direction, figures, SUM)
