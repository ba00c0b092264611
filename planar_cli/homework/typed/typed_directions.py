"""Directions in words behind what was typed: a sense of rotation, a direction, and an axis.

`6.2 rad/s cw`, `9.81 m/s^2 down`, `1.95 m/s (to the left)`, `3 m/s in the negative x direction`, `3 m/s in -x`.
"""

from __future__ import annotations

import re

SENSES = {
    **dict.fromkeys(("ccw", "counterclockwise", "counter-clockwise", "anticlockwise", "anti-clockwise", "↺"), 1),
    **dict.fromkeys(("cw", "clockwise", "↻"), -1),
}
WAYS = {
    **dict.fromkeys(("right", "rightward", "rightwards", "to the right", "→"), ("x", 1)),
    **dict.fromkeys(("left", "leftward", "leftwards", "to the left", "←"), ("x", -1)),
    **dict.fromkeys(("up", "upward", "upwards", "↑"), ("y", 1)),
    **dict.fromkeys(("down", "downward", "downwards", "↓"), ("y", -1)),
}
_ENDINGS = tuple(sorted((*SENSES, *WAYS), key=lambda words: -len(words)))
_IN_BRACKETS = re.compile(r"(.*\S)\s*\(\s*([A-Za-z][A-Za-z -]*|[↺↻→←↑↓])\s*\)")
_ALONG_AXIS = re.compile(
    r"(?P<before>.*?\S)(?:\s+|(?<=[)\]])|\s*(?=\())\(?(?:(?:in|along|towards?)\s+)?(?:the\s+)?"
    r"(?:(?P<sign>positive|negative|\+|-)\s*(?P<axis>[xy])(?:[ -]*(?:direction|axis))?"
    r"|(?P<plain>[xy])[ -]*(?:direction|axis))\)?",
    re.IGNORECASE,
)
_WORDS = "|".join(re.escape(words) for words in _ENDINGS)
_NUMBER = r"[+-]?(?:[0-9]+(?:\.[0-9]*)?|\.[0-9]+)(?:[eE][+-]?[0-9]{1,3})?"
_FIRST = re.compile(rf"(?P<words>{_WORDS})(?![\w-])[\s:,]*(?P<rest>[-+0-9.].*)", re.IGNORECASE)
_BETWEEN = re.compile(rf"(?P<number>{_NUMBER})\s+(?P<words>{_WORDS})\s+(?P<rest>[A-Za-z1(].*)", re.IGNORECASE)
_LINE = re.compile(r"(?:along|up|down|the|upwards?|downwards?|ramp|slope|incline|inclined|plane|hill|\s|[().,])+")


def with_words_behind(text: str) -> str:
    """`cw 21.2 rad/s^2` and `21.2 cw rad/s^2` with the words at the end; any other text as it is."""
    first = _FIRST.fullmatch(text)
    if first is not None:
        return f"{first['rest']} {first['words']}"
    between = _BETWEEN.fullmatch(text)
    return text if between is None else f"{between['number']} {between['rest']} {between['words']}"


def without_direction(text: str) -> tuple[str, int, str, int]:
    """The text before a sense of rotation or a direction in words; the sense, 1 counterclockwise; axis and way."""
    if text.endswith(")") and (bracket := _IN_BRACKETS.fullmatch(text)) is not None:
        words = bracket[2].lower().strip()
        if words in SENSES or words in WAYS:
            text = f"{bracket[1]} {words}"
    low = text.lower().rstrip(".")
    # Few answers end with any of them.
    if low.endswith(_ENDINGS):
        for words in _ENDINGS:
            if low.endswith(words) and _ends_before(low, words):
                axis, way = WAYS.get(words, ("", 0))
                return text[: len(low) - len(words)].rstrip(" ,"), SENSES.get(words, 0), axis, way
    if low.endswith(("x", "y", "x)", "y)", "direction", "direction)", "axis", "axis)")):
        along = _ALONG_AXIS.fullmatch(text.rstrip("."))
        if along is not None:
            axis = (along["axis"] or along["plain"]).lower()
            return along["before"].rstrip(" ,"), 0, axis, -1 if along["sign"] in ("-", "negative") else 1
    return text, 0, "", 0


def _ends_before(text: str, ending: str) -> bool:
    """Is an ending a word of its own?"""
    before = text[: len(text) - len(ending)]
    return bool(before) and not (before[-1].isalpha() and ending[0].isalpha()) and not before.endswith("-")


def along_line(words: str) -> int:
    """1 of `up the ramp`, -1 of `down the slope`, 0 of any other words."""
    low = words.lower().strip("() .,")
    if not _LINE.fullmatch(low):
        return 0
    up, down = (any(w.startswith(stem) for w in low.split()) for stem in ("up", "down"))
    return up - down
