"""The part of the JSON Schema that is about bodies."""

from __future__ import annotations

from typing import Any

from planar_cli.problem.sections.read_bodies import MASS_KEYS, SHAPE_KEYS
from planar_cli.problem.sections.schema_parts import SIDE, listing, record, ref

Schema = dict[str, Any]

NEEDED = {
    "sector": ("radius", "span"),
    "plate": ("width", "height"),
}
DOCS = {
    "mass": "its mass; `any` where it is not given and must cancel",
    "weight": "its weight instead of its mass",
    "inertia": "moment of inertia about the mass centre, or about `about`; `any` where it must cancel",
    "radius_of_gyration": "about the mass centre, or about `about`",
}


def _value(shape: str) -> Schema:
    """What stands at the key of a shape."""
    match shape:
        case "particle":
            return ref("place")
        case "rod":
            ends = [ref("place"), {"anyOf": [ref("place"), ref("side")]}]
            return {"type": "array", "items": ends, "minItems": 2, "maxItems": 2}
        case "parts":
            return listing({"anyOf": [_shape(part, False) for part in SHAPE_KEYS if part != "parts"]}, 1)
        case "points":
            return listing(ref("place"), 1)
        case _:
            return ref("place")


def _shape(shape: str, whole: bool) -> Schema:
    """A body, or a part of one, of one shape."""
    keys: Schema = {shape: _value(shape)}
    for key in SHAPE_KEYS[shape]:
        keys[key] = ref("place") if key == "center" else ref("side")
    keys |= {key: {**SIDE, "description": DOCS[key]} for key in MASS_KEYS}
    keys["points"] = listing(ref("place"), 1)
    if whole:
        keys["about"] = ref("place")
    return record(keys, [shape, *NEEDED.get(shape, ())])


BODY: Schema = {"anyOf": [_shape(shape, True) for shape in SHAPE_KEYS]}
