"""What to write instead of what is no unit: habits, prefixes, slips of the pen."""

from __future__ import annotations

from collections.abc import Collection, Mapping
from types import MappingProxyType

from planar_cli.near import nearest

HABITS: Mapping[str, str] = MappingProxyType(
    {
        "t": "the tonne is written `tonne`; `t` is time",
        "ton": "write `tonne` (1000 kg); a ton of 2000 lb is `2000 lb`, as a weight `2000 lbf`",
        "tons": "write `tonne` (1000 kg); a ton of 2000 lb is `2000 lb`, as a weight `2000 lbf`",
        "Mg": "write `tonne`: 1 Mg is 1000 kg",
        "lbs": "write `lb` for a mass, `lbf` for a force",
        "pound": "write `lb` for a mass, `lbf` for a force",
        "pounds": "write `lb` for a mass, `lbf` for a force",
        "lbm": "write `lb`",
        "Nm": "write `N*m`",
        "kNm": "write `kN*m`",
        "Ns": "write `N*s`",
        "Nms": "write `N*m*s`",
        "Ws": "write `J`",
        "kWh": "write `MJ`: 1 kWh is 3.6 MJ",
        "gm": "write `g`",
        "knot": "write `km/h`: 1 knot is 1.852 km/h",
        "knots": "write `km/h`: 1 knot is 1.852 km/h",
        "bar": "write `kPa`: 1 bar is 100 kPa",
        "oz": "write `lb`: 1 oz is 1/16 lb, as a force 1/16 lbf",
        "kgm": "write `kg*m`",
        "kph": "write `km/h`",
        "kmh": "write `km/h`",
        "kmph": "write `km/h`",
        "fps": "write `ft/s`",
        "mps": "write `m/s`",
        "kgf": "write the force in `N`: 1 kgf is 9.80665 N",
        "sec": "write `s`",
        "secs": "write `s`",
        "second": "write `s`",
        "seconds": "write `s`",
        "hr": "write `h`",
        "hrs": "write `h`",
        "hour": "write `h`",
        "hours": "write `h`",
        "minute": "write `min`",
        "minutes": "write `min`",
        "degree": "write `deg`",
        "degrees": "write `deg`",
        "degs": "write `deg`",
        "rads": "write `rad`, or `rad/s` for a rate",
        "radian": "write `rad`",
        "radians": "write `rad`",
        "revs": "write `rev`",
        "rps": "write `rev/s`",
        "RPM": "write `rpm`",
        "meter": "write `m`",
        "meters": "write `m`",
        "metre": "write `m`",
        "metres": "write `m`",
        "inch": "write `in`: `3 in`, and `in in` for the unit wanted",
        "inches": "write `in`: `3 in`, and `in in` for the unit wanted",
        "foot": "write `ft`",
        "feet": "write `ft`",
        "mile": "write `mi`",
        "miles": "write `mi`",
        "Kg": "write `kg`",
        "KG": "write `kg`",
        "kgs": "write `kg`",
        "gram": "write `g`",
        "grams": "write `g`",
        "gr": "write `g`",
        "newton": "write `N`",
        "newtons": "write `N`",
        "Newton": "write `N`",
        "joule": "write `J`",
        "joules": "write `J`",
        "watt": "write `W`",
        "watts": "write `W`",
        "ksi": "write `kip/in^2`",
        "percent": "write a fraction, `0.05`",
    }
)
"""What people write instead, and what it should be."""
_PREFIXED = ("g", "m", "s", "N", "Pa", "J", "W", "Hz")
_PREFIXES = {
    "G": "10^9",
    "M": "10^6",
    "k": "1000",
    "h": "100",
    "d": "0.1",
    "c": "0.01",
    "m": "0.001",
    "u": "10^-6",
    "n": "10^-9",
}
"""What a prefix of the metric system says, where the unit with it is not one of ours."""


def suggestion(name: str, atoms: Collection[str]) -> str:
    """What may be meant by what is no unit: never one of another size because its letters are alike."""
    if name in HABITS:
        return HABITS[name]
    if name.lower() in HABITS and len(name) > 1:
        return HABITS[name.lower()]
    base = next((unit for unit in _PREFIXED if unit.lower() == name[1:].lower()), None)
    if base is not None and name[0] in _PREFIXES and name[1:] == base:
        return f"write it in `{base}`: 1 {name} is {_PREFIXES[name[0]]} {base}"
    if base is not None and name[0] in "mM":
        return f"write it in `{base}`: with a small m it would be a thousandth, with a capital M a million"
    same = [unit for unit in atoms if unit.lower() == name.lower()]
    # Of short units nearly every one is close to every other.
    near = same[0] if same else nearest(name, atoms)
    return f"did you mean `{near}`?" if same or (len(near) > 2 and len(name) > 3) else ""
