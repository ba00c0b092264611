"""Sentences with formulas of the course, cut into words and letters: v_P = v_P′ + v_rel, T = 1/2 m v_G²."""

from __future__ import annotations

import re

from planar_cli.report.document.blocks import Inline, Line, Name, Text

_ONE = "[A-Za-zα-ωΑ-Ωṙ]"
_LETTER = re.compile(
    rf"(?<![\w.'])(?<![a-z]{{2}}/)(?P<letter>{_ONE})(?P<dots>[\u0307\u0308])?(?P<subscript>_[A-Za-zα-ω0-9]+(?:/\w+)?)?(?![A-Za-zα-ω0-9_'])"
    rf"|(?P<d>(?<![\w.'])d(?={_ONE}(?!\w)))|(?<=\bd)(?P<of>{_ONE})(?!\w)"
)
"""One letter with its subscript; ds and dθ are two."""
_DOTS = {"\u0307": "_dot", "\u0308": "_ddot", None: ""}
_PLACE = re.compile(r"\b(?:about|along|at|from|of|to) $")
"""Behind it stands the name of a point."""
_ARTICLES = ("a", "A", "I")


def lettered(sentence: str) -> Line:
    """A sentence whose letters are names; one that ends in a formula behind a colon has them there alone."""
    words, colon, formula = sentence.partition(": ")
    if not colon:
        words, formula = "", sentence
    parts: list[Inline] = [Text(words + colon)] if words else []
    end = 0
    for match in _LETTER.finditer(formula):
        word = match[0] in _ARTICLES and not _in_formula(formula, match.start(), match.end())
        if word or _PLACE.search(formula[: match.start()]):
            continue
        name = f"{match['letter']}{_DOTS[match['dots']]}{match['subscript'] or ''}" if match["letter"] else match[0]
        parts += [Text(formula[end : match.start()]), Name(name)]
        end = match.end()
    parts.append(Text(formula[end:]))
    return tuple(p for p in parts if p != Text(""))


def _in_formula(text: str, start: int, end: int) -> bool:
    """Does a letter stand beside a sign, so that it is none of the words?"""
    return text[:start].endswith("= ") or re.match(r" ?[=·×²/]|$", text[end:]) is not None
