"""What a find asks, in words for a sheet: `a(b).x @ 2` is the x component of the acceleration of b in state 2."""

from __future__ import annotations

from planar_cli.homework.printed_names import printed
from planar_cli.problem.expression import Quantity, Relation
from planar_cli.problem.scene import Find

WORDS = {
    "x": "x of {}",
    "y": "y of {}",
    "r": "position of {}",
    "v": "velocity of {}",
    "a": "acceleration of {}",
    "theta": "angle of {}",
    "omega": "angular velocity of {}",
    "alpha": "angular acceleration of {}",
    "coriolis": "Coriolis acceleration of {}",
    "rho": "radius of curvature of the path of {}",
    "IC": "instantaneous centre of {}",
    "N": "normal force on {}",
    "friction": "friction at {}",
    "reaction": "reaction at {}",
    "moment": "moment at {}",
    "tension": "tension in {}",
    "force": "force of {}",
    "mode": "does {} stick or slip, stay or part",
    "mass": "mass of {}",
    "I": "moment of inertia of {}",
    "KE": "kinetic energy of {}",
    "PE": "potential energy of {}",
    "momentum": "momentum of {}",
    "H": "angular momentum of {}",
    "power": "power of {}",
    "work": "work of {}",
    "impulse": "impulse of {}",
    "heat": "heat at {}",
    "path_length": "length of the path of {}",
    "period": "period of small oscillations about {}",
    "frequency": "frequency of small oscillations about {}",
    "decrement": "logarithmic decrement about {}",
    "damping_ratio": "damping ratio about {}",
    "reached": "is {} reached",
    "stable": "is {} stable",
}
PARTS = {
    "x": "x component of the {}",
    "y": "y component of the {}",
    "mag": "size of the {}",
    "angle": "direction of the {}",
    "t": "tangential component of the {}",
    "n": "normal component of the {}",
    "r": "radial component of the {}",
    "theta": "transverse component of the {}",
    "along": "component along a given direction of the {}",
    "across": "component across a given direction of the {}",
}
SEEN = {"v", "a", "r", "omega", "alpha"}


def asked_words(find: Find | None) -> str:
    """The words; of an expression or relation the name of the find, as its formula may tell how it is solved."""
    if find is None:
        return ""
    what = find.found.what
    if isinstance(what, Relation):
        return f"{printed(find.name)}, yes or no"
    if not isinstance(what, Quantity) or what.word not in WORDS or what.word == "dot":
        return printed(find.name)
    said = WORDS[what.word].format(_things(what))
    for part in what.parts:
        said = PARTS[part.kind].format(said) if part.kind in PARTS else said
    return f"{said}{_when(what)}"


def _things(what: Quantity) -> str:
    if not what.things:
        return "the system"
    if len(what.things) == 1:
        return "the whole system" if what.things[0] == "all" else what.things[0]
    joined = " seen from " if what.word in SEEN else " about "
    return joined.join(what.things[:2])


def _when(what: Quantity) -> str:
    if isinstance(what.at, tuple):
        return f" from {what.at[0]} to {what.at[1]}"
    return "" if what.at is None else f" in state {what.at}"
