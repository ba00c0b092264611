"""Reading one value of a joint or load by its declared key type."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from planar_cli.problem.language.expression import Side, Statement
from planar_cli.problem.nodes import reading
from planar_cli.problem.nodes.fields import Fields
from planar_cli.problem.nodes.nodes import Mapping, Node, Scalar, Sequence
from planar_cli.problem.scene.keys import (
    BodyKey,
    DirectionKey,
    FlagKey,
    Flow,
    FlowKey,
    KeySpec,
    KeyType,
    MagnitudeKey,
    PartnersKey,
    PointKey,
    PointPairKey,
    RopePathKey,
    RopeStop,
    SideKey,
    StatementsKey,
    Table,
    WordKey,
)
from planar_cli.problem.sections.read_points import pair_of_names
from planar_cli.records import record

FLOW_KEYS = ("at", "speed", "angle")
PATH_EXAMPLE = "path: [A, over D, under E, T on drum]"
TABLE_EXAMPLE = "{table: [[0 s, 0 N], [2 s, 50 N]]}"


@record
class Names:
    """Names already known when joints and loads are read; `unnamed`: of points that the file writes out in place."""

    bodies: frozenset[str]
    surfaces: frozenset[str]
    unnamed: frozenset[str] = frozenset()


def read_value(node: Node | None, spec: KeySpec, fields: Fields, names: Names) -> Any:
    """The value at a key; a stand-in of the right type where it is missing."""
    if node is None:
        return _stand_in(spec.type, fields)
    return _READERS[type(spec.type)](node, spec, fields, names)


def _stand_in(key_type: KeyType, fields: Fields) -> Any:
    match key_type:
        case PointKey() | BodyKey():
            return ""
        case PointPairKey():
            return "", ""
        case SideKey() | MagnitudeKey() | DirectionKey():
            return reading.unreadable(fields.mark)
        case _:
            return ()


def _point(node: Node, spec: KeySpec, fields: Fields, names: Names) -> str:
    return reading.name(node, "a point", fields.report)


def _pair(node: Node, spec: KeySpec, fields: Fields, names: Names) -> tuple[str, str]:
    return pair_of_names(node, f"{spec.name}: [A, B]", fields.report)


def _body(node: Node, spec: KeySpec, fields: Fields, names: Names) -> str:
    return reading.name(node, "a body", fields.report)


def _partners(node: Node, spec: KeySpec, fields: Fields, names: Names) -> tuple[str, ...]:
    read = tuple(
        reading.name(item, "a body, a surface or ground", fields.report)
        for item in reading.items(node, spec.name, fields.report, f"{spec.name}: [ground, AB]")
    )
    most = spec.type.most if isinstance(spec.type, PartnersKey) else 2
    if isinstance(node, Sequence) and (len(read) < 2 or (most and len(read) > most)):
        wanted = "two" if most == 2 else "two or more"
        hint = f"write `{spec.name}: [ground, AB]`" if len(read) < 2 else "write one entry for each pair"
        fields.report.add(node.mark, "PL315", f"{fields.what} is between {wanted}, here are {len(read)}", hint)
    return read


def _side(node: Node, spec: KeySpec, fields: Fields, names: Names) -> Side:
    return reading.side(node, spec.name, fields.report)


def _magnitude(node: Node, spec: KeySpec, fields: Fields, names: Names) -> Side | Table:
    if isinstance(node, Mapping):
        return _table(node, spec, fields)
    return reading.side(node, spec.name, fields.report)


def _table(node: Mapping, spec: KeySpec, fields: Fields) -> Side | Table:
    inner = Fields(node, ("table",), f"the {spec.name} of {fields.what}", fields.report)
    listed = inner.need("table", f"write `{TABLE_EXAMPLE}`")
    if listed is None:
        return reading.unreadable(node.mark)
    rows = []
    for row in reading.items(listed, "table", fields.report, TABLE_EXAMPLE):
        if isinstance(row, Sequence) and len(row.items) == 2:
            instant, value = (reading.side(cell, "table", fields.report) for cell in row.items)
            rows.append((instant, value))
        else:
            fields.report.add(
                row.mark, "PL316", "a row of a table is an instant and a value", f"write `{TABLE_EXAMPLE}`"
            )
    return Table(tuple(rows), node.mark)


def _direction(node: Node, spec: KeySpec, fields: Fields, names: Names) -> Side | str:
    if isinstance(node, Scalar) and node.text in names.bodies | names.surfaces:
        return node.text
    return reading.side(node, spec.name, fields.report)


def _flag(node: Node, spec: KeySpec, fields: Fields, names: Names) -> bool:
    word = reading.text(node, spec.name, fields.report)
    if word not in ("true", "false"):
        fields.report.add(node.mark, "PL317", f"'{word}' is neither true nor false", f"write `{spec.name}: true`")
    return word == "true"


def _word(node: Node, spec: KeySpec, fields: Fields, names: Names) -> str | None:
    words = spec.type.words if isinstance(spec.type, WordKey) else ()
    word = reading.text(node, spec.name, fields.report)
    if word in words:
        return word
    fields.report.add(
        node.mark, "PL317", f"'{word}' does not stand at '{spec.name}'", reading.did_you_mean(word, words, "write ")
    )
    return None


def _statements(node: Node, spec: KeySpec, fields: Fields, names: Names) -> tuple[Statement, ...]:
    return reading.statements(node, spec.name, fields.report)


def _path(node: Node, spec: KeySpec, fields: Fields, names: Names) -> tuple[RopeStop, ...]:
    stops = tuple(_stop(item, fields) for item in reading.items(node, spec.name, fields.report, PATH_EXAMPLE))
    if isinstance(node, Sequence) and len(stops) < 2:
        fields.report.add(node.mark, "PL318", "the path of a rope has two stops or more", f"write `{PATH_EXAMPLE}`")
    for item, stop in list(zip(node.items, stops, strict=True))[1:-1] if isinstance(node, Sequence) else ():
        if stop.way == "on":
            fields.report.add(
                item.mark, "PL318", "a rope is wound on a drum at one of its ends", "begin or end with `T on drum`"
            )
    return stops


def _stop(node: Node, fields: Fields) -> RopeStop:
    words = reading.text(node, "a stop of a rope", fields.report).split()
    match words:
        case [point]:
            return RopeStop("point", point)
        case [("over" | "under") as way, pulley]:
            return RopeStop(way, pulley)
        case [point, "on", drum]:
            return RopeStop("on", point, drum)
        case []:
            return RopeStop("point", "")
    said = " ".join(words)
    fields.report.add(node.mark, "PL318", f"'{said}' is no stop of a rope", f"write `{PATH_EXAMPLE}`")
    return RopeStop("point", "")


def _flow(node: Node, spec: KeySpec, fields: Fields, names: Names) -> Flow:
    inner = Fields(node, FLOW_KEYS, f"{spec.name} of {fields.what}", fields.report)
    return Flow(inner.need_name("at", "a point"), inner.need_side("speed"), inner.need_side("angle"), node.mark)


_READERS: dict[type, Callable[[Node, KeySpec, Fields, Names], Any]] = {
    PointKey: _point,
    PointPairKey: _pair,
    BodyKey: _body,
    PartnersKey: _partners,
    SideKey: _side,
    MagnitudeKey: _magnitude,
    DirectionKey: _direction,
    FlagKey: _flag,
    WordKey: _word,
    StatementsKey: _statements,
    RopePathKey: _path,
    FlowKey: _flow,
}
