"""Relations that give the size or the direction of a vector, as equations between its components.

    |v| = m            v_x² + v_y² = m²                     where m is not negative
    angle of v = a     v_x sin a = v_y cos a                where v points along the direction, not against it
    both               v_x = m cos a,   v_y = m sin a       where m is not negative

So a known direction stays linear, and no root or arctangent hides an unknown.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass, replace
from typing import Any

import sympy as sp

from planar_cli.equation.jets import Jet
from planar_cli.problem.expression import Quantity, Relation, Side
from planar_cli.problem.geometry import Vec

TOGETHER = "; "
"""Stands between the texts of two relations that are one statement about a vector."""
Read = Callable[[Side], Any]


@dataclass(frozen=True, slots=True)
class VectorStatement:
    """What one relation, or two together, say of a vector: its size, its direction, or both (None: not said)."""

    relations: tuple[Relation, ...]
    vector: Quantity
    size: Side | None
    angle: Side | None

    @property
    def text(self) -> str:
        return TOGETHER.join(r.text for r in self.relations)

    def equations(self, read: Read) -> tuple[Jet | Vec, sp.Expr | None]:
        """A Jet, or a Vec of jets, that vanishes; and an expression that must not be negative. `read`: a side as a Jet
        or a Vec of jets.
        """
        v: Vec = read(self.vector)
        if self.size is not None and self.angle is not None:
            m, u = read(self.size), _unit(read(self.angle))
            return v - u * m, _told(m.value)
        if self.size is not None:
            m = read(self.size)
            if m.value == 0 and m.rate == 0:
                return v, None
            return v.dot(v) - m * m, _told(m.value)
        assert self.angle is not None
        other = _part(self.angle, "angle")
        u = read(other) if other is not None else _unit(read(self.angle))
        return v.x * u.y - v.y * u.x, v.x.value * u.x.value + v.y.value * u.y.value


def grouped(relations: Iterable[Relation], read: Read) -> Iterator[Relation | VectorStatement]:
    """Relations in their order; those about size or direction of a vector as such, two about one vector as one."""
    found: list[Relation | VectorStatement] = []
    places: dict[str, int] = {}
    for relation in relations:
        polar = _polar(relation, read)
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


def _polar(relation: Relation, read: Read) -> VectorStatement | None:
    if relation.operator != "=":
        return None
    for one, other in ((relation.left, relation.right), (relation.right, relation.left)):
        for kind in ("mag", "angle"):
            vector = _part(one, kind)
            if vector is not None and isinstance(read(vector), Vec) and isinstance(read(other), Jet):
                size, angle = (other, None) if kind == "mag" else (None, other)
                return VectorStatement((relation,), vector, size, angle)
    return None


def _part(side: Side, kind: str) -> Quantity | None:
    """The vector of which a side is the size or the angle."""
    if isinstance(side, Quantity) and side.at is None and side.parts and side.parts[-1].kind == kind:
        return replace(side, parts=side.parts[:-1])
    return None


def _key(q: Quantity) -> str:
    return f"{q.word}({'/'.join(q.things)})" + "".join(f".{p.kind}" for p in q.parts)


def _unit(angle: Jet) -> Vec:
    return Vec(angle.through(sp.cos), angle.through(sp.sin))


def _told(size: sp.Expr) -> sp.Expr | None:
    """A size that a number already tells needs no test, unless it is negative."""
    return None if size.is_nonnegative and not size.free_symbols else size


def dotted(residual: Jet, times: int) -> sp.Expr:
    """A residual differentiated. ValueError: one instant does not tell that rate."""
    for _ in range(times):
        residual = residual.dotted()
    return residual.value
