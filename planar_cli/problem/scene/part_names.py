"""What the parts of a body are called on a page: by their shapes where these differ, else by their numbers.

A half disk with a rectangle on it: m_1 is the mass of the half disk, I_2 the moment of inertia of the rectangle.
"""

from __future__ import annotations

from collections import Counter

from planar_cli.problem.language.expression import Binary, Grouped, Negate, Number, Scaled, Side
from planar_cli.problem.scene.scene import Body, Composite, Particle, Piece, Plate, Problem, Rod, Round, Sector

STEMS = ("m", "I", "d", "x", "y")
"""The letters of a part."""


def part_names(body: Body, problem: Problem) -> tuple[str, ...]:
    """`the half disk`, or `part 1 of wheel`, for each part; with its body where other bodies have parts."""
    assert isinstance(body.shape, Composite)
    words = [_shape_word(piece) for piece in body.shape.pieces]
    count = Counter(words)
    owner = "" if _is_alone(body, problem) else f" of {body.name}"
    return tuple(
        f"the {word}{owner}" if word and count[word] == 1 else f"part {i} of {body.name}"
        for i, word in enumerate(words, 1)
    )


def part_letter(stem: str, number: int, body: Body, problem: Problem) -> str:
    """m_1, or m_wheel_1 where the file has the letter or another body has parts."""
    assert isinstance(body.shape, Composite)
    letters = (*problem.given, *problem.symbols, *problem.unknowns, *problem.coordinates)
    taken = {*(s.name for s in letters), *(p.name for p in problem.points), *(b.name for b in problem.bodies)}
    numbers = range(1, len(body.shape.pieces) + 1)
    free = not any(f"{letter}_{i}" in taken for letter in STEMS for i in numbers)
    return f"{stem}_{number}" if free and _is_alone(body, problem) else f"{stem}_{body.name}_{number}"


def _is_alone(body: Body, problem: Problem) -> bool:
    """Is it the only body with a mass?"""
    return [b for b in problem.bodies if not b.is_massless or isinstance(b.shape, Composite)] == [body]


def _shape_word(piece: Piece) -> str:
    if any(side is not None and _is_negative(side) for side in (piece.mass, piece.weight)):
        return "hole"
    match piece.shape:
        case Sector(span=span):
            half = isinstance(span, Number) and span.value == 180 and span.unit == "deg"
            return "half disk" if half else "sector"
        case Plate():
            return "rectangle"
        case Rod():
            return "rod"
        case Particle():
            return "point mass"
        case Round(kind=kind):
            return kind
    return ""


def _is_negative(side: Side) -> bool:
    """Does a formula begin with a minus?"""
    match side:
        case Negate():
            return True
        case Binary(left=left):
            return _is_negative(left)
        case Grouped(operand=inside) | Scaled(operand=inside):
            return _is_negative(inside)
    return False
