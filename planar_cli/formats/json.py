"""A solution as JSON: plain mappings, lists, numbers and words in, text out; the same input gives the same bytes."""

from __future__ import annotations

import json
import math
import re
from collections.abc import Mapping
from decimal import Decimal
from fractions import Fraction
from typing import Any

SCHEMA_VERSION = 1


def dumps(mapping: Mapping[str, Any]) -> str:
    """The mapping as JSON text, `schema_version` first, other keys in their own order; ends with a line feed.

    Exact numbers become the shortest decimal number that a double keeps. Raises ValueError for a number that is not
    finite and TypeError for a value that JSON does not know.
    """
    whole = {"schema_version": mapping.get("schema_version", SCHEMA_VERSION), **mapping}
    text = json.dumps(_plain(whole), ensure_ascii=False, indent=2, allow_nan=False)
    # Characters that steer a terminal are written as escapes, so that the text can be looked at safely.
    return re.sub(r"[^\n -~]", _escaped, text) + "\n"


def _plain(value: Any) -> Any:
    """The value in types of JSON."""
    if value is None or isinstance(value, bool | str | int):
        return value
    if isinstance(value, Decimal | Fraction | float):
        return _number(value)
    if isinstance(value, Mapping):
        return {_key(k): _plain(v) for k, v in value.items()}
    if isinstance(value, list | tuple):
        return [_plain(v) for v in value]
    raise TypeError(f"{type(value).__name__} has no JSON form")


def _key(key: object) -> str:
    if not isinstance(key, str):
        raise TypeError(f"a key must be text, not {type(key).__name__}")
    return key


def _number(value: Decimal | Fraction | float) -> int | float:
    if isinstance(value, Fraction) and value.denominator == 1:
        return value.numerator
    try:
        number = float(value)
    except OverflowError:
        number = math.inf
    if not math.isfinite(number):
        raise ValueError(f"{value} is not a finite number")
    return number + 0.0  # -0.0 becomes 0.0


def _escaped(match: re.Match[str]) -> str:
    character = match[0]
    return character if character.isprintable() else json.dumps(character)[1:-1]
