"""Statements of a problem file as a page says them: `v(ball).x` as v_ball,x, `work(jet)` as the work of jet."""

from __future__ import annotations

import re
from collections.abc import Collection

from planar_cli.report.blocks import Inline, Line, Name, Text, line

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
}
RELATIVE = {"v": "the velocity", "a": "the acceleration"}
PARTS = {"mag": "the size of ", "angle": "the direction of "}
SHORT = 2
"""A component clings to a name of so many letters."""
_STATED = re.compile(r"([A-Za-zωα_]+)\((\w+(?:/\w+)?)\)(?:\.(x|y|mag|angle)\b)?(?: @ (\w+))?")
_POWER = str.maketrans("23", "²³")


def spoken(words: str, names: Collection[str]) -> Line:
    """Words with their quantities and the names of symbols as mathematics."""
    words = re.sub(r"(?<=\d) deg\b", "°", words)
    parts: list[str | Inline | Line] = []
    end = 0
    for match in _STATED.finditer(words):
        said = _quantity(*match.groups())
        if said is not None:
            parts += [_plain(words[end : match.start()], names), said]
            end = match.end()
    return line(*parts, _plain(words[end:], names))


def _quantity(word: str, thing: str, part: str | None, state: str | None) -> Line | None:
    """One quantity of one thing; None: it is something else."""
    behind = f" in state {state}" if state else ""
    if (word, thing) == ("work", "all"):
        return line("the work of all forces", behind)
    if word in WORDS and part is None:
        return line(WORDS[word].format(thing.replace("/", " on ")), behind)
    if word not in LETTERS:
        return None
    first, _, second = thing.partition("/")
    if second and word in RELATIVE and part not in ("x", "y"):
        return line(PARTS.get(part or "", ""), f"{RELATIVE[word]} of {first} relative to {second}", behind)
    if second:
        return None
    name = f"{LETTERS[word]}_{thing}"
    if part in ("x", "y"):
        name += part if len(thing) <= SHORT else f"_{part}"
    return line(PARTS.get(part or "", ""), Name(name), behind)


def _plain(words: str, names: Collection[str]) -> Line:
    """Words in which names are set as mathematics, products without their stars, and powers raised."""
    found: list[Inline] = []
    for piece in re.split(r"(\b[A-Za-z]\w*\b)", words):
        if piece in names and len(piece) > 1:
            found.append(Name(piece))
        elif piece:
            found.append(Text(_signs(piece)))
    return tuple(found)


def _signs(text: str) -> str:
    return re.sub(r"\s*\*\s*", " ", re.sub(r"\^([23])\b", lambda m: m[1].translate(_POWER), text))
