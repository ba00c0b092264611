"""Angles, and distances of points, that a file writes as numbers: what a student does wrong with a slope of 30° is the
same whether the file says `angle: -30 deg` or gives the angle a letter.
"""

from __future__ import annotations

import re
from fractions import Fraction

from planar_cli.homework.sets.printed_names import ANGLE, LENGTH, POINT
from planar_cli.problem.nodes.nodes import Mapping, Node, Scalar, Sequence

PLACES = ("points", "bodies", "surfaces", "guides", "joints", "loads", "frames")
"""Sections in which an angle is one of the drawing; what is known of a state is no part of it."""
_ANGLE = re.compile(r"([+-]?)\s*(\d{1,3}(?:\.\d{1,6})?)\s*(?:deg|°)")
_LENGTH = re.compile(r"(\d{1,6}(?:\.\d{1,6})?)\s*(mm|cm|m|km|in|ft|yd)")


def with_names(node: Node) -> Node:
    """A file in which each such angle, from the nearest level line, and each distance by which a point is placed from
    others has a name in `given`. Level and upright directions stay: nobody has their sine and cosine wrong.
    """
    if not isinstance(node, Mapping):
        return node
    names: dict[str, str] = {}
    found = _of_file(node, names)
    if not names:
        return node
    given = node.get("given")
    pairs = given.pairs if isinstance(given, Mapping) else ()
    more = tuple((_scalar(name, node), _scalar(text, node)) for text, name in names.items())
    kept = tuple((k, v) for k, v in found.pairs if k.text != "given")
    return Mapping(((_scalar("given", node), Mapping((*pairs, *more), node.mark)), *kept), node.mark)


def _of_file(node: Mapping, names: dict[str, str]) -> Mapping:
    """A file, or a case of it."""
    return Mapping(tuple((key, _section(key.text, value, names)) for key, value in node.pairs), node.mark)


def _section(key: str, value: Node, names: dict[str, str]) -> Node:
    if key in PLACES:
        return _named(value, names)
    if key == "cases" and isinstance(value, Mapping):
        cases = ((name, _of_file(case, names) if isinstance(case, Mapping) else case) for name, case in value.pairs)
        return Mapping(tuple(cases), value.mark)
    return value


def _named(node: Node, names: dict[str, str]) -> Node:
    match node:
        case Mapping(pairs=pairs):
            on_line = any(key.text in ("on", "line") for key, _ in pairs)
            of_places = ("distances", "distance") if on_line else ("distances",)
            return Mapping(
                tuple((k, (_distances if k.text in of_places else _named)(v, names)) for k, v in pairs), node.mark
            )
        case Sequence(items=items):
            return Sequence(tuple(_named(item, names) for item in items), node.mark)
    written = _ANGLE.fullmatch(node.text.strip())
    parts = None if written is None else _parts(Fraction(written[2]) * (-1 if written[1] == "-" else 1))
    if parts is None:
        return node
    before, angle = parts
    name = names.setdefault(f"{_number(angle)} deg", ANGLE + _number(angle).replace(".", POINT))
    return Scalar(f"{before}{name}", False, node.mark, node.end)


def _distances(node: Node, names: dict[str, str]) -> Node:
    """A distance of a place that has two of them, or one and a line; or which it has from which points."""
    if isinstance(node, Mapping):
        return Mapping(tuple((key, _distances(value, names)) for key, value in node.pairs), node.mark)
    written = _LENGTH.fullmatch(node.text.strip()) if isinstance(node, Scalar) else None
    if written is None or not isinstance(node, Scalar):
        return node
    number, unit = written.groups()
    name = names.setdefault(f"{number} {unit}", f"{LENGTH}{number.replace('.', POINT)}_{unit}")
    return Scalar(name, False, node.mark, node.end)


def _parts(angle: Fraction) -> tuple[str, Fraction] | None:
    """`150 deg` as `180 deg - ` and 30; None: it lies along an axis."""
    turns = {0: "", 180: "180 deg + ", -180: "-180 deg + "}
    for level, before in turns.items():
        rest = angle - level
        if 0 < abs(rest) < 90:
            sign = before[:-2] + "- " if before else "-"
            return (before if rest > 0 else sign), abs(rest)
    return None


def _number(angle: Fraction) -> str:
    return f"{float(angle):g}"


def _scalar(text: str, node: Mapping) -> Scalar:
    return Scalar(text, False, node.mark, node.mark)
