"""What may stand at a key of a joint or load: the vocabulary from which files are read and the JSON Schema is made.

A member of a shelf is a frozen dataclass; each field is one YAML key, declared with `key(...)`:

    at: str = key(PointKey(), "the common point")
    friction_torque: Side | None = key(SideKey("N*m"), "of a rough axle", default=None)

`structure.py` reads each value by its key type; `schema.py` writes each key type's part of the JSON Schema.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import MISSING, field, fields
from typing import Any

from planar_cli.errors import Mark
from planar_cli.problem.language.expression import Side
from planar_cli.records import record


@record
class PointKey:
    """The name of a point, as str."""


@record
class PointPairKey:
    """Two names of points, as (str, str)."""


@record
class BodyKey:
    """The name of a body, as str."""


@record
class PartnersKey:
    """`between`: names of bodies, surfaces or `ground`, as tuple[str, ...]; two up to `most` (0: no limit)."""

    most: int = 2


@record
class SideKey:
    """One line of mathematics of the given unit's dimension, as Side. `angle`: an angle (a bare number is refused).
    `turns`: an angle that may be counted from that of a body, `theta(rod) + 90 deg`.
    """

    unit: str
    angle: bool = False
    turns: bool = False


@record
class DirectionKey:
    """An angle, or the name of a surface or body, as Side | str."""


@record
class FlagKey:
    """true or false, as bool."""


@record
class WordKey:
    """One of some words, as str."""

    words: tuple[str, ...]


@record
class StatementsKey:
    """A list of relations, as tuple[Statement, ...]."""


@record
class RopePathKey:
    """`[A, over D, under E, T on drum]`, as tuple[RopeStop, ...]."""


@record
class RopeStop:
    """One stop of a rope.

    `way` is "point" (end, or small pulley in the middle), "over", "under", or "on" (wound, leaving the drum `body` at
    the point `name`); for over and under, `name` is the pulley (a body or its centre point).
    """

    way: str
    name: str
    body: str | None = None


@record
class MagnitudeKey:
    """One line of mathematics, or a table of instants and values, as Side | Table; `unit` as in SideKey."""

    unit: str


@record
class Table:
    """`{table: [[0 s, 0 N], [2 s, 50 N]]}`: pairs of an instant and the value then; straight lines between them."""

    rows: tuple[tuple[Side, Side], ...]
    mark: Mark


@record
class FlowKey:
    """`{at: A, speed: 20 m/s, angle: 0 deg}`, as Flow: where and how a stream enters or leaves a body."""


@record
class Flow:
    """A stream at the point `at`: `speed` relative to the body, `angle` of that velocity from the fixed x axis."""

    at: str
    speed: Side
    angle: Side
    mark: Mark


KeyType = (
    PointKey
    | PointPairKey
    | BodyKey
    | PartnersKey
    | SideKey
    | DirectionKey
    | FlagKey
    | WordKey
    | StatementsKey
    | RopePathKey
    | MagnitudeKey
    | FlowKey
)


@record
class Choice:
    """Of several groups of keys exactly one is written, whole; the empty group where none need be.

    Choice((("mu",), ("mu_s", "mu_k"))) takes `mu`, or `mu_s` with `mu_k`. `hint` says what to write.
    """

    groups: tuple[tuple[str, ...], ...]
    hint: str

    def names(self) -> frozenset[str]:
        """All keys that the choice is about."""
        return frozenset(name for group in self.groups for name in group)


@record
class KeySpec:
    """One key of a member: its name in the file, its type, what it means, and whether it must be there."""

    name: str
    type: KeyType
    doc: str
    required: bool


def example_of(spec: KeySpec) -> str:
    """What may stand at a key."""
    match spec.type:
        case SideKey(angle=True) | DirectionKey():
            return "30 deg"
        case SideKey(unit=unit) | MagnitudeKey(unit=unit):
            return "0.3" if unit == "1" else f"20 {unit}"
        case PointKey():
            return "A"
        case PointPairKey():
            return "[A, B]"
        case BodyKey():
            return "b"
        case PartnersKey():
            return "[a, b]"
        case RopePathKey():
            return "[A, over D, B]"
        case _:
            return "…"


SPELT = {"point": "at", "at": "point"}
"""Keys that mean another one, in entries that have only the other."""


def spellings(names: Iterable[str]) -> dict[str, str]:
    """Other spellings of these keys of an entry: each with the key that it means."""
    known = frozenset(names)
    return {other: meant for other, meant in SPELT.items() if meant in known and other not in known}


def key(key_type: KeyType, doc: str, *, default: Any = MISSING, name: str | None = None) -> Any:
    """A dataclass field that is a YAML key; `name` where the key is no Python name."""
    return field(default=default, metadata={"key": key_type, "doc": doc, "name": name})


def keys_of(member: type) -> tuple[KeySpec, ...]:
    """The YAML keys of a member's class, in the order of its fields."""
    return tuple(
        KeySpec(f.metadata["name"] or f.name, f.metadata["key"], f.metadata["doc"], f.default is MISSING)
        for f in fields(member)
        if "key" in f.metadata
    )
