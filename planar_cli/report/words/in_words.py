"""Sides of a file with all that they ask: what has no short name is told in words, what holds at another state is
told by the letter with that state.

`x(cyl) @ 2` as x_cyl,2; `work(punch) @ 1->2` as the work of punch from 1 to 2; `r(A/O).mag` as the distance of A from
O.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

from planar_cli.equation.scene.line_names import line_name
from planar_cli.errors import NOWHERE
from planar_cli.problem.language.expression import Function, Grouped, Name, Part, PointPair, Quantity, Relation, Side
from planar_cli.problem.language.walk import changed
from planar_cli.report.document import blocks
from planar_cli.report.document.blocks import Line, Text, line
from planar_cli.report.words.sides import said
from planar_cli.report.words.spoken import LETTERS, RELATIVE, WORDS

WHOLE = "all"
OF_FORCES = {"N": "N", "tension": "T"}
"""Forces that are numbers, by their letters in formulas."""
MORE = {
    "KE": "the kinetic energy of {}",
    "PE": "the potential energy of {}",
    "power": "the power of {}",
    "H": "the angular momentum of {}",
    "I": "the moment of inertia of {}",
    "force": "the force {}",
    "moment": "the moment at {}",
    "coriolis": "the Coriolis acceleration of {}",
}
OF_FORMULAS = {"mean": "the mean of ", "dot": "the rate of ", "ddot": "the second rate of ", "count": "how often "}
"""Quantities of a formula, of a relation."""
AXES = ("x", "y")
POLAR = {"r": "r", "theta": "theta"}


def in_words(side: Side, figures: int) -> Line:
    """A side as written, with every quantity told."""
    places: dict[str, Line] = {}

    def rule(node: Side) -> Side | None:
        if isinstance(node, Grouped):
            return changed(_then(node.operand, node.at), rule)
        if isinstance(node, Function) and node.at is not None:
            return changed(replace(node, argument=_then(node.argument, node.at), at=None), rule)
        if not isinstance(node, Quantity | Name) or said(node, figures) is not None:
            return None
        name = f"place {len(places)}"
        words = _told(node, figures) if node is side or not _has_letter(node) else _letter_of_force(node)
        places[name] = line("(", words, ")") if node is not side and Text(" - ") in words else words
        return Name(name, None, NOWHERE)

    told = said(changed(side, rule), figures)
    assert told is not None
    return line(*(places.get(p.name, (p,)) if isinstance(p, blocks.Name) else (p,) for p in told))


def _has_letter(node: Quantity | Name) -> bool:
    """Is it a force that a formula has by its letter?"""
    return isinstance(node, Quantity) and node.word in OF_FORCES and not node.parts and not node.things[1:]


def _letter_of_force(node: Quantity | Name) -> Line:
    """μ N_C, though alone it is the normal force at C."""
    assert isinstance(node, Quantity)
    state = f"__{node.at}" if isinstance(node.at, str) else ""
    return line(blocks.Name(f"{OF_FORCES[node.word]}_{node.things[0]}{state}", of_thing=True))


def _then(side: Side, state: str) -> Side:
    """A formula with all that changes in it at a state."""

    def rule(node: Side) -> Side | None:
        if isinstance(node, Quantity) or (isinstance(node, Name) and node.name == "t"):
            return node if node.at is not None else replace(node, at=state)
        return None

    return changed(side, rule)


def _told(node: Quantity | Name, figures: int) -> Line:
    if isinstance(node.at, str):
        return _at(node, node.at, figures)
    assert isinstance(node, Quantity)
    span = line(f" from {node.at[0]} to {node.at[1]}") if node.at is not None else ()
    return line(_of_now(replace(node, at=None), figures), span)


def _at(node: Quantity | Name, state: str, figures: int) -> Line:
    """With the state behind its letter; behind words where it has none."""
    plain = replace(node, at=None)
    short = said(plain, figures)
    if short is None:
        return line(_of_now(plain, figures), f" in state {state}") if isinstance(plain, Quantity) else ()
    place = next(i for i, p in enumerate(short) if isinstance(p, blocks.Name))
    letter = short[place]
    assert isinstance(letter, blocks.Name)
    return (*short[:place], replace(letter, name=f"{letter.name}__{state}"), *short[place + 1 :])


def _of_now(asked: Quantity, figures: int) -> Line:
    """A quantity without a short name."""
    part = asked.parts[0] if asked.parts else None
    if asked.argument is not None:
        inside = (
            _related(asked.argument, figures)
            if isinstance(asked.argument, Relation)
            else in_words(asked.argument, figures)
        )
        return line(OF_FORMULAS.get(asked.word, f"{asked.word} of "), inside)
    if asked.word == "r" and len(asked.things) == 2:
        return _reach(asked, part, figures)
    if asked.word in LETTERS and (part is None or part.kind in POLAR or len(asked.things) == 2):
        return _letter(asked, part, figures)
    if asked.word == "rho":
        return line(blocks.Name(f"rho_{asked.things[0]}", of_thing=True))
    words = {**WORDS, **MORE}.get(asked.word, f"{asked.word} of {{}}")
    things = ["all bodies" if t == WHOLE else t for t in asked.things]
    axis = f" along {part.kind}" if part is not None and part.kind in AXES else ""
    return line(*_component(part, figures), words.format(" about ".join(things)), axis)


def _letter(asked: Quantity, part: Part | None, figures: int) -> Line:
    """A letter with more behind it: v_P,θ; the velocity of A relative to B along x."""
    thing, *relative = asked.things
    letter = LETTERS[asked.word]
    if part is not None and part.kind in POLAR:
        return line(blocks.Name(f"{letter}_{thing}_{POLAR[part.kind]}", of_thing=True))
    if relative and asked.word in RELATIVE:
        axis = f" along {part.kind}" if part is not None and part.kind in AXES else ""
        return line(*_component(part, figures), f"{RELATIVE[asked.word]} of {thing} relative to {relative[0]}", axis)
    return line(blocks.Name(f"{letter}_{thing}", of_thing=True), f" relative to {relative[0]}" if relative else "")


def _reach(asked: Quantity, part: Part | None, figures: int) -> Line:
    """What leads from one point to another: the difference of a coordinate, the distance, a component."""
    end, start = asked.things
    kind = part.kind if part is not None else ""
    if kind in AXES:
        return line(blocks.Name(f"{kind}_{end}", of_thing=True), " - ", blocks.Name(f"{kind}_{start}", of_thing=True))
    if kind == "mag":
        return line(f"the distance of {end} from {start}")
    if kind == "angle":
        return line(f"the direction from {start} to {end}")
    return line(*_component(part, figures), blocks.Name(f"r_{end}/{start}", of_thing=True))


def _component(part: Part | None, figures: int) -> Iterator[Line]:
    """`the component along rod of `; nothing of the whole, of its size, or of what is along an axis."""
    if part is None or part.kind in ("mag", *AXES):
        return
    if part.kind == "angle":
        yield line("the direction of ")
    elif part.direction is not None:
        yield line(f"the component {part.kind} ", _direction(part.direction, figures), " of ")
    else:
        yield line({"t": "the tangential component of ", "n": "the normal component of "}.get(part.kind, ""))


def _direction(direction: Side | PointPair, figures: int) -> Line:
    if isinstance(direction, PointPair):
        return line(line_name(direction.origin, direction.to))
    return in_words(direction, figures)


def _related(relation: Relation, figures: int) -> Line:
    """Both sides with what stands between them."""
    return line(in_words(relation.left, figures), f" {sign_of(relation.operator)} ", in_words(relation.right, figures))


def sign_of(operator: str) -> str:
    """What stands between the sides of a relation."""
    return {"<=": "≤", ">=": "≥"}.get(operator, operator)
