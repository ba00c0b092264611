"""Statements of a problem file as a page says them: `v(ball).x` as v_ball,x, `work(jet)` as the work of jet."""

from __future__ import annotations

import re
from collections.abc import Collection

from planar_cli.report.document.blocks import Inline, Line, Name, Text, line

LETTERS = {"v": "v", "a": "a", "omega": "omega", "ω": "omega", "alpha": "alpha", "α": "alpha", "theta": "theta"}
LETTERS |= {"x": "x", "y": "y", "r": "r", "s": "s"}
WORDS = {
    "work": "the work of {}",
    "heat": "the heat at {}",
    "impulse": "the impulse of {}",
    "tension": "the tension in {}",
    "friction": "the friction at {}",
    "normal": "the normal force at {}",
    "N": "the normal force at {}",
    "reaction": "the reaction at {}",
    "path_length": "the way of {}",
    "momentum": "the momentum of {}",
    "energy": "the energy of {}",
    "period": "the period about {}",
    "frequency": "the frequency about {}",
    "decrement": "the logarithmic decrement about {}",
    "damping_ratio": "the damping ratio about {}",
}
RELATIVE = {"v": "the velocity", "a": "the acceleration"}
PARTS = {"mag": "the size of ", "angle": "the direction of "}
AXES = ("x", "y", "t", "n")
SHORT = 2
"""A component clings to a name of so many letters."""
TOWARDS = {"0": "to the right", "90": "upward", "180": "to the left", "270": "downward", "-90": "downward"}
"""Directions by their angle in degrees."""
SIGNS = {"sqrt": "√", "pi": "π"}
_WAY = r"(?:along|across)\([^()]*\)"
_STATED = re.compile(rf"([A-Za-zωα_]+)\((\w+(?:/\w+)?)\)(?:\.({_WAY}|(?:x|y|t|n|mag|angle)\b))?(?: @ (\w+))?")
_POWER = str.maketrans("23", "²³")


def spoken(words: str, names: Collection[str]) -> Line:
    """Words with their quantities and the names of symbols as mathematics."""
    words = re.sub(r"(?<=\d) deg\b", "°", words)
    parts: list[str | Inline | Line] = []
    end = 0
    for match in _STATED.finditer(words):
        word, thing, part, state = match.groups()
        said = _quantity(word, thing, part, state, names)
        if said is not None:
            parts += [_plain(words[end : match.start()], names), said]
            end = match.end()
    return line(*parts, _plain(words[end:], names))


def _quantity(word: str, thing: str, part: str | None, state: str | None, names: Collection[str]) -> Line | None:
    """One quantity of one thing; None: it is something else."""
    behind = f" in state {state}" if state else ""
    if (word, thing) == ("work", "all"):
        return line("the work of all forces", behind)
    if word in WORDS and part not in ("t", "n"):
        before = PARTS.get(part or "", f"the {part} component of " if part in ("x", "y") else "")
        return line(
            *([before] if before else ()), *_way(part, names), WORDS[word].format(thing.replace("/", " on ")), behind
        )
    if word not in LETTERS:
        return None
    first, _, second = thing.partition("/")
    if second and word == "r":
        return line(*_reach(first, second, part, names), behind)
    if second and word in RELATIVE:
        beside = f" along {part}" if part in ("x", "y") else ""
        said = f"{RELATIVE[word]} of {first} relative to {second}{beside}"
        return line(PARTS.get(part or "", ""), *_way(part, names), said, behind)
    if second:
        return None
    name = f"{LETTERS[word]}_{thing}"
    if part in AXES:
        name += part if len(thing) <= SHORT and part in ("x", "y") else f"_{part}"
    letter = Name(f"{name}__{state}" if state else name, of_thing=True)
    if part == "mag":
        return line("|", letter, "|")
    return line(PARTS.get(part or "", ""), *_way(part, names), letter, _towards(part))


def _towards(part: str | None) -> str:
    """` to the left` of the component along 180°."""
    angle = (part or "").removeprefix("along(").removesuffix(")").removesuffix(" deg").removesuffix("°")
    return f" {TOWARDS[angle]}" if angle in TOWARDS else ""


def _reach(end: str, start: str, part: str | None, names: Collection[str]) -> Line:
    """What leads from one point to another: the difference of a coordinate, the distance, a component."""
    if part in ("x", "y"):
        return line(Name(f"{part}_{end}", of_thing=True), " - ", Name(f"{part}_{start}", of_thing=True))
    if part in ("mag", "angle"):
        return line(f"the distance of {end} from {start}" if part == "mag" else f"the direction from {start} to {end}")
    return line(*_way(part, names), Name(f"r_{end}/{start}", of_thing=True))


def _way(part: str | None, names: Collection[str]) -> Line:
    """The component along or across a body, or the direction of an angle."""
    if part is None or "(" not in part:
        return ()
    side, where = part[:-1].split("(")
    if side == "along" and where.removesuffix(" deg").removesuffix("°") in TOWARDS:
        return ()
    angle = where in names or not re.fullmatch(r"[^\W\d]\w*(?:/\w+)?", where)
    return line("the component ", f"{side} the direction " if angle else f"{side} ", *_plain(where, names), " of ")


def _plain(words: str, names: Collection[str]) -> Line:
    """Words in which names are set as mathematics, products without their stars, and powers raised."""
    found: list[Inline] = []
    for piece in re.split(r"(\b[A-Za-z]\w*\b)", words):
        if piece in SIGNS:
            found.append(Text(SIGNS[piece]))
        elif piece in names and len(piece) > 1:
            found.append(Name(piece))
        elif piece:
            found.append(Text(_signs(piece)))
    return tuple(found)


def _signs(text: str) -> str:
    text = text.replace("<=", "≤").replace(">=", "≥")
    return re.sub(r"\s*\*\s*", " ", re.sub(r"\^([23])\b", lambda m: m[1].translate(_POWER), text))


def begun(words: str) -> str:
    """Words at the beginning of a line; a quantity, `v(P).y is largest` or `w_1 is least`, keeps its small letter."""
    first = words.split(" ", 1)[0]
    letter = "(" in first or "_" in first or (len(first) == 1 and first != "a")
    return words if letter else f"{words[:1].upper()}{words[1:]}"


def lead_of(lead: str) -> Line:
    """What is equated, before an equation; every other piece between backquotes is a name."""
    pieces = lead.split("`")
    return line(*(Name(p) if i % 2 else p for i, p in enumerate(pieces) if p), ":") if lead else ()
