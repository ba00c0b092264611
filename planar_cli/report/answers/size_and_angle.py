"""The size and the direction of a vector that an answer gives by its components, with formula and numbers.

|a_B| = √(0.2282² + 0.1704²) = 0.2848 m/s²     direction of a_B = arctan(0.1704/0.2282) = 36.7° below -x
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import replace
from decimal import Decimal

import sympy as sp

from planar_cli.equation.values.ledger import display
from planar_cli.problem.language.expression import Quantity
from planar_cli.report.answers.letter_vectors import letter_size_and_angle
from planar_cli.report.answers.on_axles import Sized, sized
from planar_cli.report.document.blocks import Block, Equation, Line, Math, Name, Text, Value, line
from planar_cli.report.instant.on_circle import by_direction, in_degrees, with_degrees
from planar_cli.report.notation.enough_figures import figures_of
from planar_cli.report.notation.numbers import significant
from planar_cli.report.notation.ordering import NUMBER
from planar_cli.report.words.words import Phrases, told_unit
from planar_cli.solve.solution import Found
from planar_cli.solve.solved_problem import PartSolution

PLACES = ("IC", "r")
"""Of a place the answer gives its coordinates alone."""
FRAME, ROW = 62, 92
"""Characters of a row beside both names and numbers, and how many have room: else the direction has its own row."""
OF_ANGLES = 3
"""Figures of a direction, as the answer has them."""
DIRECTION = "direction of "


def with_size_and_angle(
    blocks: Sequence[Block], found: Iterable[Found], phrases: Phrases, part: PartSolution
) -> list[Block]:
    """The blocks of a part, with the size and the direction of each vector after its components."""
    told = list(blocks)
    lettered: list[tuple[sp.Expr, ...]] = []
    for one in found:
        place, name = _components(told, one, phrases)
        by = sized(one, part, phrases)
        if by is not None and not {*by.parts} <= {_letter(b) for b in told[:place] if isinstance(b, Equation)}:
            # Its parts follow below.
            by = None
        lines = list(size_and_angle(one, phrases, told, name, by))
        if by is not None and by.angle is not None and name == one.name:
            degrees = Decimal(math.degrees(by.theta))
            told = with_degrees(told, by.angle, degrees, phrases.figures)
            told = [in_degrees(b, by.angle, degrees, phrases.figures) for b in told]
            own = told[place - 2 : place]
            if by.components:
                above = [by.vectors] if by.vectors is not None else []
                told[place - 2 : place] = [*above, *map(_by_parts, own, by.components)]
                place += len(above)
            elif lines:
                whole = [display(v, one.unit, phrases.ledger.us) for v in one.values or ()]
                told[place - 2 : place] = by_direction(own, whole, phrases.figures)
                place -= 2
        if (one.expressions or ()) not in lettered:
            lines += (read := list(letter_size_and_angle(one, phrases)))
            place = _in_letters(told, one, place) if read else place
            lettered.append(one.expressions or ())
        told[place:place] = lines
    return told


def _by_parts(block: Block, shown: tuple[Math, Math]) -> Block:
    """A component by its parts along and across the path."""
    assert isinstance(block, Equation)
    return replace(block, sides=(block.sides[0], *shown, block.sides[-1]))


def size_and_angle(
    found: Found, phrases: Phrases, told: Sequence[Block], called: str, by: Sized | None
) -> Iterator[Block]:
    """√(x² + y²) and arctan(y/x) with numbers; nothing of a vector in letters, of a place, or along an axis.
    `told`: the page, which may have the size; `called`: the name of the vector there; `by`: what tells it better.
    """
    what = found.find.found.what if found.find is not None else None
    place = isinstance(what, Quantity) and what.word in PLACES
    if found.kind != "vector" or found.values is None or found.word or found.curve is not None or place:
        return
    x, y = (display(v, found.unit, phrases.ledger.us) for v in found.values)
    if x.is_infinite() or y.is_infinite() or not x or not y:
        return
    name = Name(called)
    one, other = (sp.Symbol(f"{NUMBER}{axis}", positive=True) for axis in ("x", "y"))
    figures = figures_of((abs(x), abs(y)), _size, phrases.figures)
    texts = {one: significant(abs(x), figures), other: significant(abs(y), figures)}
    root = sp.sqrt(sp.Add(one**2, other**2, evaluate=False), evaluate=False)
    size = Value(_size((x, y)), told_unit(found.unit, found.energy), phrases.figures)
    own = line("|", name, "|")
    if called != found.name:
        yield Equation((line(Name(found.name)), line(name)))
    steep = Value(Decimal(math.degrees(math.atan(abs(y) / abs(x)))), "deg", OF_ANGLES)
    where = f"{'above' if y > 0 else 'below'} {'+x' if x > 0 else '-x'}"
    quotient = line("arctan(", Math(other / one, texts), ")")
    apart = Equation((line(DIRECTION, name), quotient, steep), None, note=line(where))
    if by is not None:
        yield Equation((own, *by.size, size))
        beside = by.beside if where == "above +x" else line(*by.beside, ", that is ", steep, f" {where}")
        yield Equation((line(DIRECTION, name), *by.direction), None, note=beside) if by.direction else apart
    elif any(isinstance(b, Equation) and (own in b.sides or _is_root(b, size)) for b in told):
        yield apart
    elif 2 * (len(called) + sum(map(len, texts.values()))) + FRAME > ROW:
        yield Equation((own, Math(root, texts), size), None)
        yield apart
    else:
        beside = line(DIRECTION, name, " = ", quotient, " = ", steep, f" {where}")
        yield Equation((own, Math(root, texts), size), None, note=beside)


def _components(told: Sequence[Block], found: Found, phrases: Phrases) -> tuple[int, str]:
    """Where the components of a vector have been told, and its name there; the end of the page where they have not."""
    lines = [(i, b) for i, b in enumerate(told) if isinstance(b, Equation)]
    own = [i for i, b in lines if _is_of(b, found.name)]
    if own:
        return own[-1] + 1, found.name
    same = [(i + 1, name) for i, b in lines if (name := _letter(b)) and _has_numbers(b, found, phrases)]
    return same[-1] if same else (len(told), found.name)


def _in_letters(told: Sequence[Block], found: Found, end: int) -> int:
    """Where the second component of a vector in letters has been told; `end`, where it has not."""
    last = (found.expressions or (None,))[-1]
    sides = ((i, b.sides[-1]) for i, b in enumerate(told) if isinstance(b, Equation))
    return next((i + 1 for i, side in sides if isinstance(side, Math) and last is not None and side.expr == last), end)


def _left(equation: Equation) -> Line:
    """The left side of an equation."""
    side = equation.sides[0]
    return tuple(p for p in side if p != Text("")) if isinstance(side, tuple) else (side,)


def _letter(equation: Equation) -> str:
    """The vector that an equation gives; "" of a component."""
    match _left(equation):
        case (Name(name),):
            return name
    return ""


def _is_of(equation: Equation, name: str) -> bool:
    """Does it give the second component of a vector with numbers, or both?"""
    match _left(equation):
        case (Name(other), Text(", y")):
            return other == name
        case (Name(other),):
            return other == name and len(_numbers(equation)) == 2
    return False


def _numbers(equation: Equation) -> list[Value]:
    """The numbers of a vector at the end of an equation."""
    last = equation.sides[-1]
    is_vector = isinstance(last, tuple) and str(getattr(last[0], "text", "")).startswith("[")
    return [p for p in last if isinstance(p, Value)] if is_vector and isinstance(last, tuple) else []


def _has_numbers(equation: Equation, found: Found, phrases: Phrases) -> bool:
    """Does an equation end with the components of what is asked?"""
    shown = [display(v, found.unit, phrases.ledger.us) for v in found.values or ()]
    numbers = _numbers(equation)
    return len(numbers) == len(shown) and all(_alike(n, x) for n, x in zip(numbers, shown, strict=True))


def _alike(value: Value, number: Decimal) -> bool:
    return significant(value.number, value.figures) == significant(number, value.figures)


def _is_root(equation: Equation, size: Value) -> bool:
    """Does an equation end with that size, as a root, and under a name that is not the size of another vector?"""
    last = equation.sides[-1]
    if not isinstance(last, Value) or last.unit != size.unit or Text("|") in _left(equation):
        return False
    root = any(isinstance(s, Math) and s.expr.is_Pow and s.expr.exp == sp.Rational(1, 2) for s in equation.sides[1:])
    return root and _alike(size, last.number)


def _size(parts: Sequence[Decimal]) -> Decimal:
    x, y = parts
    return (x * x + y * y).sqrt()
