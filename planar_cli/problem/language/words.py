"""The closed lists of words of the problem language: functions, quantities, parts, modes, and reserved names."""

from __future__ import annotations

from collections.abc import Mapping
from types import MappingProxyType
from typing import Literal

Form = Literal["things", "side", "relation", "state"]

FUNCTIONS = frozenset(("sin", "cos", "tan", "asin", "acos", "atan", "sqrt", "exp", "log", "abs"))
CONSTANTS = frozenset(("t", "pi", "infinity"))
MODES = frozenset(("stick", "slip", "apart", "tip", "taut", "slack"))
PARTS = frozenset(("x", "y", "mag", "angle", "t", "n", "r", "theta", "along", "across"))
DIRECTED_PARTS = frozenset(("along", "across"))

_THINGS = (
    "x y r v a theta omega alpha coriolis rho IC path hodograph N friction reaction moment tension force mode"
    " mass I KE PE momentum H power work impulse heat path_length"
)

OF_SWINGS = ("period", "frequency", "decrement", "damping_ratio")
"""Quantities of small oscillations about an equilibrium state. Each mode has its own, where there are several."""

# What stands in the bracket of each quantity: one or two names, a side, a relation, or a state.
QUANTITIES: Mapping[str, Form] = MappingProxyType(
    {
        **dict.fromkeys(_THINGS.split(), "things"),
        **dict.fromkeys(("dot", "ddot", "mean"), "side"),
        "count": "relation",
        **dict.fromkeys(("reached", *OF_SWINGS, "stable"), "state"),
    }
)

OF_ALL = frozenset(("KE", "PE", "mass", "momentum"))
"""Quantities that with an empty bracket are those of the whole system."""

_PHRASES = frozenset(("is", "largest", "smallest", "at", "equilibrium", "just", "during", "in", "cw", "ccw"))
_BOOLEANS = frozenset(("on", "off", "yes", "no", "true", "false", "null"))
_OWNERS = frozenset(("ground", "all"))

# Words that no name of a file may be; quantity words and parts are free, as they need a bracket or a dot.
RESERVED = CONSTANTS | MODES | FUNCTIONS | _PHRASES | _BOOLEANS | _OWNERS


def is_reserved(name: str) -> bool:
    """Whether a file may not use `name` for a thing of its own (`Yes` and `NO` are as bad as `yes`)."""
    return name in RESERVED or name.lower() in _BOOLEANS


# What people write instead of a quantity or function, and what it should be.
CALL_HABITS: Mapping[str, str] = MappingProxyType(
    {
        "distance": "the distance from A to B is `r(B/A).mag`",
        "dist": "the distance from A to B is `r(B/A).mag`",
        "length": "the distance from A to B is `r(B/A).mag`",
        "position": "write `r(P)`",
        "pos": "write `r(P)`",
        "velocity": "write `v(P)`",
        "vel": "write `v(P)`",
        "speed": "write `v(P).mag`",
        "acceleration": "write `a(P)`",
        "acc": "write `a(P)`",
        "angle": "write `theta(b)` for a body, `.angle` after a vector: `v(P).angle`",
        "angular_velocity": "write `omega(b)`",
        "angular_acceleration": "write `alpha(b)`",
        "normal": "write `N(j)`",
        "F": "write `force(f)`, `friction(j)` or `reaction(j)`",
        "R": "write `reaction(j)`",
        "T": "write `tension(j)`, or `KE(b)` for the kinetic energy",
        "M": "write `moment(j)`",
        "L": "write `H(b/P)` for the angular momentum, `momentum(b)` for the linear one",
        "p": "write `momentum(b)`",
        "V": "write `PE(b)`",
        "E": "write `KE(b) + PE(b)`",
        "W": "write `work(f) @ 1->2`",
        "P": "write `power(f)`",
        "ln": "write `log(…)`, the natural logarithm",
        "log10": "write `log(…)/log(10)`",
        "arcsin": "write `asin(…)`",
        "arccos": "write `acos(…)`",
        "arctan": "write `atan(…)`",
        "atan2": "write `atan(y/x)`, or the part `.angle` of a vector",
        "cot": "write `1/tan(…)`",
        "sinh": "write `(exp(x) - exp(-x))/2`",
        "cosh": "write `(exp(x) + exp(-x))/2`",
        "sign": "write two cases, or `abs(x)/x`",
        "deg": "write the unit behind the number: `30 deg`",
        "rad": "write the unit behind the number: `0.5 rad`",
        "diff": "write `dot(…)` for the rate in time",
        "time": "write `t`, and `t @ 2` for the time of state 2",
        "mag": "write the part behind the quantity: `v(P).mag`",
        "norm": "write the part behind the quantity: `v(P).mag`",
        "max": "in a state, write `X is largest`",
        "min": "in a state, write `X is smallest`",
        "average": "write `mean(…) @ 1->2`",
    }
)

PART_HABITS: Mapping[str, str] = MappingProxyType(
    {
        "magnitude": "mag",
        "norm": "mag",
        "abs": "mag",
        "length": "mag",
        "speed": "mag",
        "direction": "angle",
        "X": "x",
        "Y": "y",
        "i": "x",
        "j": "y",
        "tangential": "t",
        "normal": "n",
        "radial": "r",
        "transverse": "theta",
        "phi": "theta",
        "tan": "t",
        "rad": "r",
    }
)
