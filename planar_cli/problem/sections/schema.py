"""The JSON Schema (draft-07) of problem files, made from the same declarations by which files are read.

It helps editors: it knows keys, kinds and forms. What lines of mathematics say is left to `planar validate`.
"""

from __future__ import annotations

from functools import cache
from typing import Any

from planar_cli.problem.scene.keys import (
    BodyKey,
    Choice,
    DirectionKey,
    FlagKey,
    FlowKey,
    KeySpec,
    KeyType,
    MagnitudeKey,
    PartnersKey,
    PointKey,
    PointPairKey,
    RopePathKey,
    SideKey,
    StatementsKey,
    WordKey,
    keys_of,
    spellings,
)
from planar_cli.problem.sections.read_points import SIDES
from planar_cli.problem.sections.read_sections import PLANES
from planar_cli.problem.sections.schema_bodies import BODY
from planar_cli.problem.sections.schema_parts import NAME, SIDE, TEXT, group, listing, named, record, ref
from planar_cli.registry import members, modules

Schema = dict[str, Any]

STATEMENT: Schema = {"type": "string", "description": "one relation: `v(P).mag = 2 m/s`, `at rest`, `X is largest`"}
SPAN: Schema = {"type": "string", "pattern": r"^\s*\w+\s*->\s*\w+\s*$", "description": "acts only between these states"}
TITLES = {
    "title": "what the problem is called",
    "text": "what the student reads",
    "source": "where the problem comes from",
    "note": "how the answers were found",
}


@cache
def schema() -> Schema:
    """The whole schema."""
    cases = record({**_sections(), "find": ref("finds")}, [])
    return {
        "$schema": "http://json-schema.org/draft-07/schema#",
        "title": "planar problem file",
        **record({**_sections(), **_own(), "cases": named(cases, "name: any keys above")}, []),
        "definitions": {
            "name": NAME,
            "side": SIDE,
            "statement": STATEMENT,
            "statements": listing(ref("statement"), 0),
            "finds": named(TEXT, "name: quantity, expression or relation, with `in unit` if wanted"),
            "point": _point(),
            "place": {"anyOf": [NAME, ref("point")]},
            "surface": _surface(),
            "body": BODY,
            "joint": _member("joints"),
            "load": _member("loads"),
        },
    }


def _sections() -> Schema:
    """The sections that a file and its cases have in common."""
    units = named({"type": ["string", "number"]}, "name: unit; `1` for a pure number")
    return {
        **{key: {"type": "string", "description": words} for key, words in TITLES.items()},
        "plane": {"enum": list(PLANES), "description": "vertical: weight acts, -y"},
        "given": named({"anyOf": [ref("side"), *_varied()]}, "name: value, or values of variants"),
        "symbols": {**units, "description": "known, kept as letters: name: unit"},
        "unknowns": {**units, "description": "to be solved for: name: unit"},
        "coordinates": {**units, "description": "positions that vary: name: unit"},
        "assume": {**ref("statements"), "description": "relations between names that hold by choice"},
        "points": named(ref("point"), "name: place, as drawn"),
        "surfaces": named(ref("surface"), "name: line, circle or curve"),
        "bodies": named(ref("body"), "name: shape and mass"),
        "joints": listing(ref("joint"), 0),
        "loads": listing(ref("load"), 0),
        "motion": listing(ref("statement"), 0),
        "instant": ref("statements"),
        "states": {"type": "object", "additionalProperties": ref("statements")},
    }


def _varied() -> list[Schema]:
    """A range, or a choice, of values of a name."""
    ranged = record(dict.fromkeys(("from", "to", "step"), ref("side")), ["from", "to", "step"])
    return [ranged, record({"one_of": listing(ref("side"), 1)}, ["one_of"])]


def _own() -> Schema:
    """The sections that only a file has."""
    value = {"anyOf": [ref("side"), {"type": "boolean"}, listing(ref("side"), 2)]}
    variant = {"anyOf": [listing(ref("side"), 1), *_varied()]}
    answer = {"anyOf": [value, record({"value": value, "tolerance": ref("side")}, ["value"])]}
    return {
        "find": ref("finds"),
        "answers": named(answer, "what a key says, by find name"),
        "tolerance": ref("side"),
        "method": {"enum": list(modules("principles"))},
        "variants": named(variant, "ranges or lists of given values"),
        "figure": record({"hide": listing(ref("name"), 0)}, []),
    }


def _point() -> Schema:
    place, side = ref("place"), ref("side")
    pair = {"type": "array", "items": [place, side], "minItems": 2, "maxItems": 2}
    line = {"anyOf": [pair, record({"through": place, "angle": side}, ["through", "angle"])]}
    lines = {"line": line, "on": line}
    facts = {
        "x": side,
        "y": side,
        **lines,
        "lines": listing(line, 1),
        "distances": named(side, "point: distance"),
        "side": {"enum": list(SIDES)},
    }
    return {
        "anyOf": [
            listing(side, 2, 2),
            record({"from": place, "distance": side, "angle": side}, ["from", "distance", "angle"]),
            record(
                {"from": place, "towards": place, "distance": side, "offset": side}, ["from", "towards", "distance"]
            ),
            *(record({"from": place, "distance": side, k: line, "side": facts["side"]}, ["from", k]) for k in lines),
            record({"midpoint": listing(place, 2, 2)}, ["midpoint"]),
            record(facts, []),
        ]
    }


def _surface() -> Schema:
    name, place, side = ref("name"), ref("place"), ref("side")
    extra = {"body": name, "speed": side}
    return {
        "anyOf": [
            record({"through": place, "angle": side, **extra}, ["through", "angle"]),
            record({"center": place, "radius": side, **extra}, ["center", "radius"]),
            record({"y": side, **extra}, ["y"]),
            record({"r": side, **extra}, ["r"]),
        ]
    }


def _member(shelf: str) -> Schema:
    """One entry of `joints` or `loads`: an object with one key, its kind."""
    kinds = {kind: _kind(member) for kind, member in members(shelf).items() if kind != "weight"}
    return {
        "type": "object",
        "properties": kinds,
        "additionalProperties": False,
        "minProperties": 1,
        "maxProperties": 1,
    }


def _kind(member: type) -> Schema:
    specs = keys_of(member)
    choices: tuple[Choice, ...] = vars(member).get("choices", ())
    keys = {spec.name: {**_key(spec.type, spec), "description": spec.doc} for spec in specs}
    keys |= {"name": ref("name"), "during": SPAN}
    others = spellings(keys)
    meant = {key: other for other, key in others.items()}
    keys |= {other: keys[key] for other, key in others.items()}
    made = record(keys, [spec.name for spec in specs if spec.required and spec.name not in meant])
    made["description"] = (member.__doc__ or "").partition("\n")[0]
    chosen = [{"oneOf": [group(g, choice.names(), meant) for g in choice.groups]} for choice in choices]
    needed = [{"oneOf": [group((s.name,), frozenset(), meant)]} for s in specs if s.required and s.name in meant]
    if chosen or needed:
        made["allOf"] = chosen + needed
    return made


def _key(key_type: KeyType, spec: KeySpec) -> Schema:
    match key_type:
        case PointKey() | BodyKey():
            return {**NAME} if isinstance(key_type, BodyKey) else ref("place")
        case PointPairKey():
            return listing(ref("place"), 2, 2)
        case PartnersKey(most=most):
            return listing(ref("name"), 2, most)
        case SideKey() | DirectionKey():
            return {**SIDE}
        case MagnitudeKey():
            table = record({"table": listing(listing(ref("side"), 2, 2), 1)}, ["table"])
            return {"anyOf": [ref("side"), table]}
        case FlagKey():
            return {"type": "boolean"}
        case WordKey(words=words):
            return {"enum": list(words)}
        case StatementsKey():
            return listing(ref("statement"), 1)
        case RopePathKey():
            return listing({"type": "string", "pattern": r"^\s*((over|under)\s+)?\w+(\s+on\s+\w+)?\s*$"}, 2)
        case FlowKey():
            return record({"at": ref("place"), "speed": ref("side"), "angle": ref("side")}, ["at", "speed", "angle"])
