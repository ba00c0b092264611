"""The words of a file as they are printed: units in sentences as on the page, 3 m/s^2 as 3 m/s²."""

from __future__ import annotations

import re

from planar_cli.units import UnitError, parse_unit, pretty_unit

_BEHIND_NUMBER = re.compile(r"(?<=\d )(?=\S*[\^*])[A-Za-z][A-Za-z0-9/*^]*")
"""What may be a unit that is printed otherwise than it is typed."""


def with_pretty_units(text: str) -> str:
    """Only what is a unit, behind a number."""
    return _BEHIND_NUMBER.sub(lambda m: _pretty(m[0]), text)


def _pretty(word: str) -> str:
    try:
        parse_unit(word)
    except UnitError:
        return word
    return pretty_unit(word)
