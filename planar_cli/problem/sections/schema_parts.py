"""The small pieces from which the JSON Schema is put together."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from typing import Any

Schema = dict[str, Any]

PATTERN = "^[A-Za-z][A-Za-z0-9_]*$"
NAME: Schema = {"type": "string", "pattern": PATTERN}
SIDE: Schema = {"type": ["string", "number"], "description": "a line of mathematics: `2*m*g`, `30 deg`, `50 kg`"}
TEXT: Schema = {"type": ["string", "number"]}


def ref(name: str) -> Schema:
    """A reference to a definition."""
    return {"$ref": f"#/definitions/{name}"}


def record(keys: Mapping[str, Any], required: Iterable[str]) -> Schema:
    """An object with these keys and no others."""
    needed = list(required)
    made: Schema = {"type": "object", "properties": dict(keys), "additionalProperties": False}
    return {**made, "required": needed} if needed else made


def named(value: Schema, words: str) -> Schema:
    """An object whose keys are names of the file."""
    return {
        "type": "object",
        "patternProperties": {PATTERN: value},
        "additionalProperties": False,
        "description": words,
    }


def listing(item: Schema, least: int, most: int = 0) -> Schema:
    """A list of at least `least` and at most `most` items (0: no limit)."""
    made: Schema = {"type": "array", "items": item, "minItems": least}
    return {**made, "maxItems": most} if most else made


def group(keys: tuple[str, ...], all_keys: frozenset[str], meant: Mapping[str, str]) -> Schema:
    """These keys, and none of the others of a choice; `meant`: other spellings of keys, each stands for its key."""
    others = sorted(all_keys - frozenset(keys))
    others += [meant[key] for key in others if key in meant]
    plain = [key for key in keys if key not in meant]
    made: Schema = {"required": plain} if plain else {}
    either = [{"oneOf": [{"required": [key]}, {"required": [meant[key]]}]} for key in keys if key in meant]
    if either:
        made["allOf"] = either
    return {**made, "not": {"anyOf": [{"required": [key]} for key in others]}} if others else made
