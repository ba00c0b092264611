"""What a find asks, in words for a sheet: `a(b).x @ 2` is the x component of the acceleration of b in state 2."""

from __future__ import annotations

from planar_cli.homework.sets.own_names import own_names
from planar_cli.homework.sets.printed_names import printed
from planar_cli.problem.language.expression import Name, Negate, Number, Part, PointPair, Quantity, Relation, Word
from planar_cli.problem.language.walk import walk
from planar_cli.problem.nodes.placeholders import told
from planar_cli.problem.scene.scene import Find, Problem

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
    "along": "component of the {} along",
    "across": "component of the {} across",
}
ENERGIES = {"KE", "PE", "work", "heat"}
SEEN = {"v", "a", "r", "omega", "alpha"}
REACTIONS = {"N", "friction", "reaction", "moment", "tension", "force"}
"""Of a joint or load, and on which body."""
IN_MODE = {
    "stick": "whether it sticks at {}",
    "slip": "whether it slips at {}",
    "apart": "whether contact is lost at {}",
    "tip": "whether it tips at {}",
    "taut": "whether the rope {} is taut",
    "slack": "whether the rope {} is slack",
}


def asked_words(find: Find | None) -> str:
    """The words; of an expression or relation the name of the find, as its formula may tell how it is solved."""
    if find is None:
        return ""
    what = find.found.what
    if isinstance(what, Relation):
        said = _in_mode(what)
        return f"{said or printed(find.name)}, yes or no"
    if not isinstance(what, Quantity) or what.word not in WORDS or what.word == "dot":
        return printed(find.name)
    said = WORDS[what.word].format(_things(what))
    for part in what.parts:
        said = PARTS[part.kind].format(said) if part.kind in PARTS else said
        said += _direction(part)
    return f"{said}{_when(what)}"


def _in_mode(what: Relation) -> str:
    """The question that `mode(A) = stick @ 2` asks; "" of another relation."""
    if not (isinstance(what.left, Quantity) and what.left.word == "mode" and isinstance(what.right, Word)):
        return ""
    return f"{IN_MODE[what.right.word].format(_things(what.left))}{_when(what.left)}"


def mode_asked(find: Find | None) -> str:
    """The mode of a contact or rope that is asked by yes or no; "" where something else is asked."""
    what = find.found.what if find is not None else None
    return what.right.word if isinstance(what, Relation) and _in_mode(what) and isinstance(what.right, Word) else ""


def in_case(case: str, part: Problem, whole: Problem, words: str) -> str:
    """What is asked in a case, with its name and the data that it gives itself: `case strong (P = 300 N): …`."""
    if not case:
        return words
    own = own_names(part, whole)
    data = ", ".join(f"{printed(s.name)} = {told(s.written)}" for s in part.given if s.name in own and s.written)
    return f"case {case}{f' ({data})' if data else ''}: {words}"


def couples_of(problem: Problem) -> frozenset[str]:
    """The names that stand alone for the moment of a couple: they count counterclockwise."""
    moments = (getattr(load, "moment", None) for load in problem.loads if load.turns_only)
    return frozenset(side.name for side in moments if isinstance(side, Name))


def is_energy(find: Find | None) -> bool:
    """Is it an energy, a work, or an expression of these alone?"""
    if find is None or isinstance(find.found.what, Relation):
        return False
    inside = [q for q in walk(find.found.what) if isinstance(q, Quantity)]
    return bool(inside) and all(q.word in ENERGIES for q in inside)


def _direction(part: Part) -> str:
    """The direction of a component, where it is a name or a number; points by their names."""
    side, sign = part.direction, ""
    if isinstance(side, Negate):
        side, sign = side.operand, "-"
    match side:
        case None:
            return ""
        case Name(name=name):
            return f" the direction {sign}{printed(name)}"
        case Number(value=value, unit=unit):
            return f" the direction {sign}{float(value):g}{'°' if unit == 'deg' else f' {unit}' if unit else ' rad'}"
        case PointPair() as pair:
            return f" {pair.origin}{pair.to}"
    return " the direction that is asked"


def _things(what: Quantity) -> str:
    if not what.things:
        return "the system"
    if len(what.things) == 1:
        return "the whole system" if what.things[0] == "all" else what.things[0]
    joined = " seen from " if what.word in SEEN else " on " if what.word in REACTIONS else " about "
    return joined.join(what.things[:2])


def _when(what: Quantity) -> str:
    if isinstance(what.at, tuple):
        return f" from {what.at[0]} to {what.at[1]}"
    return "" if what.at is None else f" in state {what.at}"
