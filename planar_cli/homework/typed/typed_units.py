"""Units as students write them."""

from __future__ import annotations

import re
from functools import lru_cache

from planar_cli.homework.typed.unreadable import Unreadable
from planar_cli.units import ATOMS, Unit, UnitError, parse_unit

_SPELT = {
    **dict.fromkeys(("meter", "meters", "metre", "metres"), "m"),
    **dict.fromkeys(("foot", "feet"), "ft"),
    **dict.fromkeys(("inch", "inches"), "in"),
    **dict.fromkeys(("second", "seconds", "sec", "secs"), "s"),
    **dict.fromkeys(("minute", "minutes"), "min"),
    **dict.fromkeys(("hour", "hours", "hr"), "h"),
    **dict.fromkeys(("newton", "newtons"), "N"),
    **dict.fromkeys(("joule", "joules"), "J"),
    **dict.fromkeys(("watt", "watts"), "W"),
    **dict.fromkeys(("kilogram", "kilograms", "kgs"), "kg"),
    **dict.fromkeys(("radian", "radians", "rads"), "rad"),
    **dict.fromkeys(("degree", "degrees", "°"), "deg"),
    **dict.fromkeys(("lbs", "pound", "pounds"), "lb"),
    **dict.fromkeys(("kips",), "kip"),
    **dict.fromkeys(("slugs",), "slug"),
    **dict.fromkeys(("rev", "revolution", "revolutions"), "rev"),
    **dict.fromkeys(("Nm",), "N*m"),
    **dict.fromkeys(("kNm",), "kN*m"),
    **dict.fromkeys(("Ns",), "N*s"),
    **dict.fromkeys(("fps",), "ft/s"),
}


def atom_of(word: str) -> str:
    """The name of the one unit that a word is, as problem files have it; "" if it is none."""
    name = _SPELT.get(word, word)
    return name if name in ATOMS and name != "1" else ""


@lru_cache(maxsize=4096)
def unit_of(text: str) -> Unit:
    """A unit as students write it: `N m`, `N-m`, `ft-lb`, `rad/sec`, `m/s/s`, `meters per second`."""
    plain = re.sub(r"\s+per\s+", "/", text.strip().rstrip("."))
    plain = re.sub(r"\s+squared\b", "^2", re.sub(r"\s+cubed\b", "^3", plain))
    plain = re.sub(r"\s*([*/^])\s*", r"\1", plain).replace("**", "^")
    plain = re.sub(r"(?<=[A-Za-z0-9])[ -](?=[A-Za-z])", "*", plain)
    plain = re.sub(r"\^\(([0-9])\)", r"^\1", plain)
    plain = re.sub(r"\b(?:ft\*lbs?|lbs?\*ft)\b(?!\^)", "lbf*ft", plain)
    plain = re.sub(r"[A-Za-z°]+", lambda m: _SPELT.get(m[0], _SPELT.get(m[0].lower(), m[0])), plain)
    plain = re.sub(r"\b(m|s|ft|in|mm|cm|km)([23])\b", r"\1^\2", plain)
    try:
        return parse_unit(plain)
    except UnitError as error:
        hint = f" ({error.hint})" if error.hint else ""
        raise Unreadable(f"the unit '{text.strip()[:40]}' is not known{hint}") from None
