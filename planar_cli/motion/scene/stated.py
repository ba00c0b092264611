"""Relations of the file as residuals: what vanishes where they hold, at whatever level they are written."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from planar_cli.errors import Mark
from planar_cli.motion.scene.places import length_of, unit_vector
from planar_cli.motion.scene.quantities import Quantities
from planar_cli.motion.terms.terms import Term
from planar_cli.problem.language.expression import Binary, Negate, Quantity, Relation, Side
from planar_cli.problem.scene.geometry import Vec
from planar_cli.problem.scene.polar import VectorStatement, grouped, vector_behind
from planar_cli.records import record


@record
class Stated:
    """One relation of the file, or two about one vector."""

    text: str
    """As written."""
    mark: Mark
    """The place in the file."""
    residuals: tuple[Term, ...]
    """They vanish where it holds; of places, velocities or accelerations, as it is written."""
    sense: Term | None = None
    """What is not negative where it holds, and the residuals let pass."""


def stated(relations: Iterable[Relation], asked: Quantities) -> Iterator[Stated]:
    """Equations of the file. What says the size or the direction of a vector is written without root or arctangent."""
    for item in grouped(r for r in relations if r.operator == "="):
        if isinstance(item, VectorStatement):
            yield _of_vector(item, asked)
            continue
        left, right = either(item.left, asked), either(item.right, asked)
        yield Stated(item.text, item.mark, _parts(_gap(left, right), asked))


def either(side: Side, asked: Quantities) -> Term | Vec:
    """A side as a number, or as a vector where it is a vector, a sum or difference or a multiple of vectors."""
    match side:
        case Quantity():
            return asked.any(side)
        case Negate():
            return -either(side.operand, asked)
        case Binary():
            left, right = either(side.left, asked), either(side.right, asked)
            if isinstance(left, Vec) or isinstance(right, Vec):
                return _combined(side.operator, left, right)
    return asked.sides.value(side)


def _combined(operator: str, left: Term | Vec, right: Term | Vec) -> Vec:
    """An operation in which a vector takes part."""
    match operator, left, right:
        case "+", Vec(), Vec():
            return left + right
        case "-", Vec(), Vec():
            return left - right
        case "*", Vec(), _:
            return left * right
        case "*", _, Vec():
            return right * left
        case "/", Vec(), _:
            return left / right
    raise TypeError(operator)


def _gap(left: Term | Vec, right: Term | Vec) -> Term | Vec:
    """Left less right; a plain zero beside a vector is the zero vector."""
    if isinstance(left, Vec):
        return left - right if isinstance(right, Vec) else left
    return right if isinstance(right, Vec) else left - right


def _parts(found: Term | Vec, asked: Quantities) -> tuple[Term, ...]:
    graph = asked.scene.graph
    return (graph.of(found.x), graph.of(found.y)) if isinstance(found, Vec) else (found,)


def _of_vector(item: VectorStatement, asked: Quantities) -> Stated:
    v = asked.any(item.vector)
    assert isinstance(v, Vec)
    mark = item.relations[0].mark
    size = None if item.size is None else asked.sides.value(item.size)
    if item.angle is None:
        assert size is not None
        if size.constant and size.value == 0:
            return Stated(item.text, mark, _parts(v, asked))
        return Stated(item.text, mark, (asked.scene.graph.of(v.dot(v)) - size * size,), size)
    behind = vector_behind(item.angle, "angle")
    other = asked.any(behind) if behind is not None else None
    if item.vector.word == "r" and behind is None:
        written = asked.written_direction(item.vector, v)
        if written is not None and not written.constant:
            gap = written - asked.sides.value(item.angle)
            if size is None:
                return Stated(item.text, mark, (gap,))
            return Stated(item.text, mark, (length_of(asked.scene.graph, v) - size, gap), size)
    u = other if isinstance(other, Vec) else unit_vector(asked.scene.graph, asked.sides.value(item.angle))
    if size is not None:
        u = u / length_of(asked.scene.graph, u) if isinstance(other, Vec) else u
        return Stated(item.text, mark, _parts(v - u * size, asked), size)
    return Stated(item.text, mark, _parts(v.cross(u), asked), asked.scene.graph.of(v.dot(u)))
