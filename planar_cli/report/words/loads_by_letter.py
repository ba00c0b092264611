"""How a page calls a force whose work it tells: by the letter of its magnitude where its author gave it no name, U of F
for U of the force block; by its name alone where that is a noun, U of the pull for U of the force pull.
"""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Iterator, Sequence
from dataclasses import replace

from planar_cli.joints.base import Joint
from planar_cli.loads.base import Load
from planar_cli.problem.language.expression import Name as Letter
from planar_cli.problem.scene.scene import Body, Point, Problem
from planar_cli.report.document.blocks import Block, Equation, Inline, Line, Name, Text, line

KINDS = ("force", "torque")
NOUN = re.compile(r"[a-z]{3,}")
LETTER = re.compile(r"[A-Z](_\w+)?")
UNCOUNTED = frozenset({"gravity", "friction", "traction", "thrust", "drag", "lift"})
"""Nouns without an article."""


def with_loads_by_letter(blocks: Sequence[Block], problem: Problem) -> list[Block]:
    """The blocks of a page with such names where a line of it speaks `of` such a force."""
    called: dict[str, Line] = {words: line(Name(letter)) for words, letter in _letters(problem).items()}
    called = dict(_names(problem)) | called
    if not called:
        return list(blocks)
    return [_renamed(b, called) if isinstance(b, Equation) else b for b in blocks]


def _loads(problem: Problem) -> list[Load]:
    return [load for part in (problem, *(c.problem for c in problem.cases)) for load in part.loads]


def _letters(problem: Problem) -> dict[str, str]:
    """The letter by what a page says of a load: `the force block`."""
    loads = _loads(problem)
    made = {(load.called, m.name) for load in loads if isinstance(m := getattr(load, "magnitude", None), Letter)}
    once = Counter(letter for _, letter in made)
    called = Counter(words for words, _ in made)
    nameless = {load.called for load in loads if _is_nameless(load)}
    return {
        words: letter
        for words, letter in sorted(made)
        if words in nameless and once[letter] == 1 and called[words] == 1
    }


def _names(problem: Problem) -> Iterator[tuple[str, Line]]:
    """The name alone by what a page says of a load, where nothing else has it; of one without a name, its body."""
    parts = (problem, *(c.problem for c in problem.cases))
    others = {name for p in parts for name in (*_named(p.bodies), *_named(p.points), *_named(p.joints))}
    kinds: dict[str, set[str]] = {}
    for load in _loads(problem):
        kinds.setdefault(load.name, set()).add(load.kind)
    for load in _loads(problem):
        if load.kind not in KINDS or len(kinds[load.name]) > 1:
            continue
        if load.name in others:
            if load.name == _body(load) and all(_is_alone(load, p) for p in parts):
                yield load.called, line(f"the {load.kind} on {load.name}")
        elif NOUN.fullmatch(load.name) and not _is_nameless(load):
            yield load.called, line(load.name if load.name in UNCOUNTED else f"the {load.name}")
        elif LETTER.fullmatch(load.name):
            yield load.called, line(Name(load.name))


def _is_nameless(load: Load) -> bool:
    """Has it only the name of its body, perhaps with a number?"""
    return re.fullmatch(rf"{re.escape(_body(load))}_?\d*", load.name) is not None


def _named(members: Sequence[Body | Point | Joint]) -> list[str]:
    return [m.name for m in members]


def _is_alone(load: Load, problem: Problem) -> bool:
    return sum(_body(x) == _body(load) and x.kind == load.kind for x in problem.loads) <= 1


def _body(load: Load) -> str:
    return str(getattr(load, "body", None) or "")


def _renamed(equation: Equation, called: dict[str, Line]) -> Equation:
    sides = tuple(_side(side, called) for side in equation.sides)
    return equation if sides == equation.sides else replace(equation, sides=sides)


def _side(side: Inline | Line, called: dict[str, Line]) -> Inline | Line:
    if not isinstance(side, tuple):
        return side
    found: list[Inline] = []
    for piece in side:
        words = next((w for w in called if isinstance(piece, Text) and _speaks_of(piece.text, w)), None)
        if words is None or not isinstance(piece, Text):
            found.append(piece)
            continue
        before, _, after = piece.text.partition(words)
        found += line(before, *called[words], after) if after else line(before, *called[words])
    return tuple(found)


def _speaks_of(text: str, words: str) -> bool:
    return re.search(rf" of {re.escape(words)}(?!\w)", text) is not None
