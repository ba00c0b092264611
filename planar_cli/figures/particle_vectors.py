"""Velocity and acceleration of a point at its place, with the components by which the file asks for them: along x and
y, along r from its pole and across it, or along the path and to its concave side; to scale, in their real senses.
"""

from __future__ import annotations

import math
import re
from collections.abc import Iterator, Mapping, Sequence
from typing import Literal

import sympy as sp

from planar_cli.figures.arms import arm, turned_arm
from planar_cli.figures.drawn import Drawn
from planar_cli.figures.motions_in_states import moving_in
from planar_cli.figures.partners import is_slot, touching
from planar_cli.figures.point_paths import way_of_point
from planar_cli.figures.rings import extent_of
from planar_cli.figures.shapes import moved
from planar_cli.problem.language.expression import Quantity
from planar_cli.problem.scene.geometry import Vec
from planar_cli.problem.scene.scene import GROUND
from planar_cli.problem.scene.scene import Line as Straight
from planar_cli.records import record
from planar_cli.report.document.blocks import Line, Name, line
from planar_cli.report.document.marks import Arrow, Figure, Mark, Panel, Polyline, Span, Spot, Style, Symbol, Tag
from planar_cli.report.notation.names import index_of
from planar_cli.solve.solution import Found
from planar_cli.solve.solved_problem import PartSolution

PLACE = "r"
STYLES: Mapping[str, Style] = {"v": "velocity", "a": "acceleration"}
WORDS = {"v": "velocity", "a": "acceleration"}
UPRIGHT = math.pi / 2
System = Literal["polar", "path", "plain"]
AXES: Mapping[System, tuple[str, str]] = {"polar": ("r", "theta"), "path": ("t", "n"), "plain": ("x", "y")}
RATES = {"v": "dot", "a": "ddot"}
LARGEST, AXIS, BEYOND, UNIT = 0.45, 0.3, 0.12, 0.55
"""In parts of the size of the scene: the largest vector, how long an axis is at least, and how far it goes beyond its
component; the arrow at its end in parts of a usual one."""
NIL = 1e-9
"""A component that is smaller than this part of the largest is zero."""
SEEN = 0.05
"""One that is smaller than this part is too short to be drawn."""
FLAT = 1e-6


@record
class Asked:
    """What is asked of a point in a state: the answers by letter and part ("": the whole vector)."""

    point: str
    pole: str
    """From which r and θ count; "": the origin."""
    state: str
    system: System
    names: Mapping[tuple[str, str], str]


@record
class Place:
    """A point in a position, with its vectors [m/s, m/s²]."""

    asked: Asked
    drawn: Drawn
    at: Spot
    pole: Spot
    vectors: Mapping[str, Spot]
    turned: float
    """The direction of the first axis; the second one is a quarter turn on, or back where `side` is -1."""
    side: int
    way: tuple[Spot, ...]


def vector_figures(part: PartSolution, letters: frozenset[str]) -> Iterator[tuple[frozenset[str], Figure]]:
    """Those of a part, each with the answers that it shows. `letters`: the names in the formulas of its page."""
    for asked in _asked(part, letters):
        place = _place(part, asked)
        if place is not None and (figure := _figure(place, letters)) is not None:
            yield frozenset(asked.names.values()), figure


# --- what is asked ---------------------------------------------------------------------------------------------------


def _asked(part: PartSolution, letters: frozenset[str]) -> Iterator[Asked]:
    """Point by point, state by state."""
    groups: dict[tuple[str, str], list[tuple[Found, Quantity]]] = {}
    for found in part.found:
        q = found.find.found.what if found.find is not None else None
        if isinstance(q, Quantity) and q.word in (*STYLES, PLACE) and q.things and not isinstance(q.at, tuple):
            groups.setdefault((q.things[0], q.at or ""), []).append((found, q))
    for (point, state), told in groups.items():
        if all(q.word == PLACE for _, q in told):
            continue
        kinds = {q.parts[0].kind if q.parts else "" for _, q in told}
        poles = {q.things[1] for _, q in told if len(q.things) > 1}
        rates = _rates(point, letters)
        system = _system(kinds, letters) or ("plain" if rates else None)
        if system is None and any(q.word == "a" for _, q in told) and _is_led_round(part, point):
            # Its size is found from the part along the curve and the one across it.
            system = "path"
        if system is not None and len(poles) <= 1:
            names = {(q.word, _part(q)): f.name for f, q in reversed(told) if _part(q) in ("", *AXES[system])}
            names |= {part: name for part, name in rates.items() if system == "plain" and part not in names}
            yield Asked(point, next(iter(poles), ""), state, system, names)


def _is_led_round(part: PartSolution, point: str) -> bool:
    """Does a fixed curve lead a point?"""
    if part.motion is None and not part.instants:
        # A motion that was followed in numbers alone.
        return False
    problem = part.motion.problem if part.motion is not None else part.instants[0].instant.scene.problem
    curves = [s for s in problem.surfaces if s.body is None and not isinstance(s.shape, Straight)]
    return any(is_slot(s, problem.joints) and point in touching(problem, s) for s in curves)


def _rates(point: str, letters: frozenset[str]) -> dict[tuple[str, str], str]:
    """ẋ and ẍ of a point, where the page finds its vectors by them."""
    names = {(w, axis): f"{axis}_{point}_{dots}" for w, dots in RATES.items() for axis in AXES["plain"]}
    return names if letters >= set(names.values()) else {}


def _part(q: Quantity) -> str:
    """The part of a vector that is asked for, "" for all of it or its size."""
    kind = q.parts[0].kind if q.parts else ""
    return "" if kind in ("mag", "angle") else kind


def _system(kinds: set[str], letters: frozenset[str]) -> System | None:
    """In which axes components are told; None: only sizes are."""
    if kinds & {"r", "theta"}:
        return "polar"
    if kinds & {"t", "n"} or letters >= {"e_t", "e_n"}:
        return "path"
    return "plain" if kinds & {"", "angle"} or kinds >= {"x", "y"} else None


# --- where it is -----------------------------------------------------------------------------------------------------


def _place(part: PartSolution, asked: Asked) -> Place | None:
    """None: nothing tells where the point is, or how it moves; or the pole of its coordinates moves."""
    moving = moving_in(part, asked.state)
    scene = moving.drawn.scene if moving is not None else None
    if moving is None or scene is None or asked.point not in (*scene.points, *scene.bodies):
        return None
    at = moving.drawn.spot(_vec(moving.drawn, asked.point))
    pole = _pole(moving.drawn, asked.pole)
    if at is None or pole is None:
        return None
    vectors: dict[str, Spot] = {}
    for word in STYLES:
        # The path is along the velocity, which comes first.
        axes = _axes(asked.system, at, pole, vectors)
        told = moving.vector(word, asked.point) or _answered(part, moving.drawn, asked, word, axes)
        vectors |= {word: told} if told is not None else {}
    axes = _axes(asked.system, at, pole, vectors)
    if axes is None or (asked.system == "plain" and not _is_seen(part, moving.drawn, asked, vectors)):
        return None
    way = way_of_point(part, moving.drawn, asked.point, asked.state)
    return Place(asked, moving.drawn, at, pole, vectors, *axes, way)


def _vec(drawn: Drawn, name: str) -> Vec:
    return drawn.scene.bodies[name].center if name in drawn.scene.bodies else drawn.scene.points[name]


def _pole(drawn: Drawn, name: str) -> Spot | None:
    """None: it moves."""
    if not name or name == GROUND:
        return (0.0, 0.0)
    scene = drawn.scene
    place = scene.points.get(name)
    moves = {c.symbol for c in scene.displacement.coordinates} if scene.displacement is not None else set()
    if place is None or (place.x.free_symbols | place.y.free_symbols) & moves:
        return None
    return drawn.spot(place) if scene.owner(name) == GROUND or _is_pinned(drawn, name) else None


def _is_pinned(drawn: Drawn, name: str) -> bool:
    pins = (j for j in drawn.scene.problem.joints if getattr(j, "at", "") == name)
    return any(GROUND in getattr(j, "between", ()) for j in pins)


def _answered(part: PartSolution, drawn: Drawn, asked: Asked, word: str, axes: tuple[float, int] | None) -> Spot | None:
    """A vector by its answers."""
    answers = {f.name: f for f in part.found}
    whole = answers.get(asked.names.get((word, ""), ""))
    if whole is not None and whole.kind == "vector":
        x, y = (_number(drawn, whole, i) for i in range(2))
        return (x, y) if x is not None and y is not None else None
    found = [answers.get(asked.names.get((word, axis), "")) for axis in AXES[asked.system]]
    first, second = (_number(drawn, f, 0) if f is not None else None for f in found)
    if axes is None or first is None or second is None:
        return None
    return moved((0.0, 0.0), axes[0], first, axes[1] * second)


def _number(drawn: Drawn, found: Found, i: int) -> float | None:
    """An answer; of a formula in letters as they are drawn."""
    value = found.values[i] if found.values is not None else None
    if value is not None or found.expressions is None:
        return None if value is None else float(value)
    letters = drawn.scene.ledger.symbols
    formula = sp.sympify(found.expressions[i])
    return drawn.number(formula.xreplace({s: letters[s.name] for s in formula.free_symbols if s.name in letters}))


def _axes(system: System, at: Spot, pole: Spot, vectors: Mapping[str, Spot]) -> tuple[float, int] | None:
    """The direction of the first axis, and on which side the second one is; None: nothing tells it."""
    if system == "plain":
        return 0.0, 1
    if system == "polar":
        out = (at[0] - pole[0], at[1] - pole[1])
        return (math.atan2(out[1], out[0]), 1) if math.hypot(*out) > NIL else None
    v, a = vectors.get("v", (0.0, 0.0)), vectors.get("a", (0.0, 0.0))
    if math.hypot(*v) < NIL:
        return None
    return math.atan2(v[1], v[0]), -1 if v[0] * a[1] - v[1] * a[0] < 0 else 1


def _is_seen(part: PartSolution, drawn: Drawn, asked: Asked, vectors: Mapping[str, Spot]) -> bool:
    """Is it a particle, or a point in a later position, that does not just move along an axis?"""
    body = drawn.scene.bodies.get(asked.point if asked.point in drawn.scene.bodies else drawn.scene.owner(asked.point))
    flat = all(min(map(abs, v)) <= FLAT * max(map(abs, v)) for v in vectors.values())
    later = part.motion is not None and asked.state not in ("", part.motion.states[0])
    return body is not None and (not body.rigid or later) and not flat


# --- how it is drawn -------------------------------------------------------------------------------------------------


def _figure(place: Place, letters: frozenset[str]) -> Figure | None:
    name, state = index_of(place.asked.point), place.asked.state.replace("_", " ")
    told = [w for w in STYLES if any(word == w for word, _ in place.asked.names) or f"{w}_{name}" in letters]
    panels = []
    for word in told:
        vector = place.vectors.get(word)
        if vector is not None and math.hypot(*vector) > NIL:
            words = f"{WORDS[word]} of {name}{f' in state {state}' if state else ''}"
            panels.append(_panel(place, word, vector, words))
    kinds = " and ".join(WORDS[w] for w in told)
    at = f" in state {state}" if state else ""
    return Figure(tuple(panels), f"{kinds} of {name}{at}", name=f"vectors of {name}") if panels else None


def _panel(place: Place, word: str, vector: Spot, head: str) -> Panel:
    size = extent_of([place.at, *place.way, *([place.pole] if _has_arm(place) else [])]) or 1.0
    along, across = (_part_along(vector, angle) for angle in _directions(place))
    scale = LARGEST * size / math.hypot(*vector)
    marks: list[Mark] = [Polyline(place.way, "way")] if len(place.way) > 1 else []
    if _has_arm(place):
        marks += _arm(place)
    marks += _unit_vectors(place, (along * scale, across * scale), size)
    marks += _spans(place, word, vector, (along, across), scale)
    marks += _middle(place)
    marks += [Symbol("particle", place.at), Tag(place.at, line(Name(index_of(place.asked.point))))]
    return Panel(tuple(marks), line(head, *_zeros(place, word, vector, (along, across))))


def _directions(place: Place) -> tuple[float, float]:
    return place.turned, place.turned + place.side * UPRIGHT


def _part_along(vector: Spot, angle: float) -> float:
    return vector[0] * math.cos(angle) + vector[1] * math.sin(angle)


def _has_arm(place: Place) -> bool:
    """Is its place told from a pole?"""
    return place.asked.system == "polar" or (PLACE, "") in place.asked.names


def _arm(place: Place) -> Iterator[Mark]:
    """The pole, r from there, and θ from its zero."""
    name = place.asked.pole
    yield Symbol("point", place.pole)
    yield Tag(place.pole, line(Name(index_of(name)) if name else "O"))
    if place.asked.system == "polar":
        yield from turned_arm(place.pole, place.at)
    else:
        letter = _called(place, PLACE, "", f"{PLACE}_{index_of(place.asked.point)}")
        yield from arm(place.pole, place.at, line(Name(letter)))


def _middle(place: Place) -> Iterator[Mark]:
    """What is at rest at the middle of a closed path: a point with a name, or the origin."""
    scene, way = place.drawn.scene, place.way
    if len(way) > 1 and math.dist(way[0], way[-1]) < FLAT * extent_of(way) and not _has_arm(place):
        middle = tuple(sum(s[i] for s in way[1:]) / (len(way) - 1) for i in (0, 1))
        for point in scene.problem.points:
            spot = place.drawn.named(point.name)
            if not point.unnamed and spot is not None and math.dist(spot, middle) < FLAT * extent_of(way):
                yield from (Symbol("point", spot), Tag(spot, line(Name(index_of(point.name)))))
                return
        if math.hypot(*middle) < FLAT * extent_of(way) and all(p.name != "O" for p in scene.problem.points):
            yield from (Symbol("origin", (0.0, 0.0)), Tag((0.0, 0.0), line(Name("O"))))


def _unit_vectors(place: Place, parts: tuple[float, float], size: float) -> Iterator[Mark]:
    """The axes through the point, with e_r and e_θ beyond the components."""
    if place.asked.system == "plain":
        return
    for axis, angle, part in zip(AXES[place.asked.system], _directions(place), parts, strict=True):
        end = moved(place.at, angle, max(AXIS * size, part + BEYOND * size))
        yield Polyline((place.at, end), "thin")
        yield Arrow(end, angle, "axis", line(Name(f"e_{axis}")), UNIT)


def _spans(place: Place, word: str, vector: Spot, parts: tuple[float, float], scale: float) -> Iterator[Mark]:
    """The vector, and its components that are not all of it."""
    at, style = place.at, STYLES[word]
    tip = (at[0] + vector[0] * scale, at[1] + vector[1] * scale)
    shown = [
        (axis, angle, part)
        for axis, angle, part in zip(AXES[place.asked.system], _directions(place), parts, strict=True)
        if abs(part) > SEEN * math.hypot(*vector)
    ]
    if len(shown) == 1:
        # That a velocity is along the path needs no words.
        also = (" = ", *_letter(place, word, shown[0][0], shown[0][2])) if not _is_along(place, word) else ()
        yield Span(at, tip, style, line(*_whole(place, word), *also))
        return
    for axis, angle, part in shown:
        end = moved(at, angle, part * scale)
        yield Polyline((end, tip), "way")
        yield Span(at, end, style, _letter(place, word, axis, part))
    yield Span(at, tip, style, _whole(place, word))


def _is_along(place: Place, word: str) -> bool:
    """Is it a velocity in axes of its path?"""
    return place.asked.system == "path" and word == "v"


def _whole(place: Place, word: str) -> Line:
    return line(Name(_called(place, word, "", f"{word}_{index_of(place.asked.point)}")))


def _letter(place: Place, word: str, axis: str, part: float) -> Line:
    """A component: of one against its axis the size, for its arrow has the real sense."""
    name = Name(_called(place, word, axis, f"{word}_{axis}"))
    return line("|", name, "|") if part < 0 else line(name)


def _called(place: Place, word: str, axis: str, usual: str) -> str:
    """The name of the answer, where it is the letter with an index."""
    name = place.asked.names.get((word, axis), "")
    return name if re.fullmatch(rf"{word}(_[^\W_]+)?|{axis}_\w+_d?dot", name) else usual


def _zeros(place: Place, word: str, vector: Spot, parts: Sequence[float]) -> Iterator[str | Name]:
    """What is not drawn, as it is zero or too short."""
    for axis, part in zip(AXES[place.asked.system], parts, strict=True) if not _is_along(place, word) else ():
        if abs(part) <= SEEN * math.hypot(*vector):
            name = Name(_called(place, word, axis, f"{word}_{axis}"))
            yield from (", ", name, " = 0" if abs(part) <= NIL * math.hypot(*vector) else " too short to be seen")
