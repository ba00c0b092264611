"""A force that its author gave no name is called by the letter of its magnitude: U of F for U of the force block."""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Sequence
from dataclasses import replace

from planar_cli.problem.expression import Name as Letter
from planar_cli.problem.scene import Problem
from planar_cli.report.blocks import Block, Equation, Inline, Line, Name, Text


def with_loads_by_letter(blocks: Sequence[Block], problem: Problem) -> list[Block]:
    """The blocks of a page with `of F` at the end of the first side of a line of such a force."""
    letters = _letters(problem)
    if not letters:
        return list(blocks)
    return [
        replace(b, sides=(_called(b.sides[0], letters), *b.sides[1:])) if isinstance(b, Equation) else b for b in blocks
    ]


def _letters(problem: Problem) -> dict[str, str]:
    """The letter by what a page says of a load: ` of the force block`."""
    loads = [load for part in (problem, *(c.problem for c in problem.cases)) for load in part.loads]
    made = {(load.called, m.name) for load in loads if isinstance(m := getattr(load, "magnitude", None), Letter)}
    once = Counter(letter for _, letter in made)
    called = Counter(words for words, _ in made)
    nameless = {load.called for load in loads if re.fullmatch(rf"{re.escape(_body(load))}_?\d*", load.name)}
    return {
        f" of {words}": letter
        for words, letter in sorted(made)
        if words in nameless and once[letter] == 1 and called[words] == 1
    }


def _body(load: object) -> str:
    return str(getattr(load, "body", None) or "")


def _called(side: Inline | Line, letters: dict[str, str]) -> Inline | Line:
    match side:
        case (*before, Text(text)) if text in letters:
            return (*before, Text(" of "), Name(letters[text]))
    return side
