"""Relations that give the size or the direction of a vector: found among others, two about one vector as one.

    |v| = m            v_x² + v_y² = m²                     where m is not negative
    angle of v = a     v_x sin a = v_y cos a                where v points along the direction, not against it
    both               v_x = m cos a,   v_y = m sin a       where m is not negative

So a known direction stays linear, and no root or arctangent hides an unknown.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import replace

from planar_cli.problem.language.expression import Quantity, Relation, Side
from planar_cli.records import record

TOGETHER = "; "
"""Stands between the texts of two relations that are one statement about a vector."""


@record
class VectorStatement:
    """What one relation, or two together, say of a vector: its size, its direction, or both (None: not said)."""

    relations: tuple[Relation, ...]
    vector: Quantity
    size: Side | None
    angle: Side | None

    @property
    def text(self) -> str:
        """The relations as written."""
        return TOGETHER.join(r.text for r in self.relations)


def grouped(relations: Iterable[Relation]) -> Iterator[Relation | VectorStatement]:
    """Relations in their order; those about size or direction of a vector as such, two about one vector as one."""
    found: list[Relation | VectorStatement] = []
    places: dict[str, int] = {}
    for relation in relations:
        polar = _polar(relation)
        if polar is None:
            found.append(relation)
            continue
        key = _key(polar.vector)
        other = found[places[key]] if key in places else None
        if isinstance(other, VectorStatement) and (other.size is None) == (polar.angle is None):
            both = (*other.relations, relation)
            size, angle = other.size or polar.size, other.angle or polar.angle
            found[places.pop(key)] = VectorStatement(both, polar.vector, size, angle)
        else:
            places[key] = len(found)
            found.append(polar)
    yield from found


def vector_behind(side: Side, kind: str) -> Quantity | None:
    """The vector of which a side is the size (`mag`) or the angle."""
    if isinstance(side, Quantity) and side.at is None and side.parts and side.parts[-1].kind == kind:
        return replace(side, parts=side.parts[:-1])
    return None


def _polar(relation: Relation) -> VectorStatement | None:
    if relation.operator != "=":
        return None
    for one, other in ((relation.left, relation.right), (relation.right, relation.left)):
        for kind in ("mag", "angle"):
            vector = vector_behind(one, kind)
            if vector is not None:
                size, angle = (other, None) if kind == "mag" else (None, other)
                return VectorStatement((relation,), vector, size, angle)
    return None


def _key(q: Quantity) -> str:
    return f"{q.word}({'/'.join(q.things)})" + "".join(f".{p.kind}" for p in q.parts)
