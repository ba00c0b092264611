"""Paths that are seen from several frames have coordinates of their own: x, y over the ground, x′, y′ in a frame that
moves with A, x″, y″ on the boom.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Sequence

from planar_cli.problem.language.expression import Quantity
from planar_cli.problem.scene.scene import GROUND
from planar_cli.report.document.blocks import Answer, Block, Equation, Heading, Paragraph, Text
from planar_cli.report.words.one_name import Renaming
from planar_cli.solve.solution import Found

PRIMES = ("′", "″")
PATH, SEEN, HODOGRAPH = "Path of ", " seen from ", "Hodograph of "
"""How the heading of a path begins, what says that a frame moves, and how that of a hodograph begins."""


def with_frames_apart(blocks: Sequence[Block], found: Iterable[Found]) -> list[Block]:
    """The blocks of a part with its answers."""
    heads = [words for b in blocks if (words := _heading(b))]
    moving = [words for words in heads if SEEN in words]
    asked = {f.name: f.find.found.what for f in found if f.find is not None}
    paths = {n: q for n, q in asked.items() if isinstance(q, Quantity) and q.word == "path"}
    others = {n: q for n, q in paths.items() if len(q.things) > 1 and q.things[1] != GROUND}
    alike = len(others) == len(moving) and all(
        words.startswith(f"{PATH}{q.things[0]}{SEEN}") for words, q in zip(moving, others.values(), strict=True)
    )
    if len(heads) < 2 or not moving or len(moving) > len(PRIMES) or not alike:
        return list(blocks)
    primes = dict(zip(others, PRIMES, strict=False))
    told: list[Block] = []
    prime, left = "", list(PRIMES)
    for block in blocks:
        if words := _heading(block):
            prime = left.pop(0) if SEEN in words else ""
            told.append(_with_axes(block, prime))
        elif isinstance(block, Answer):
            told.append(_primed(block, primes.get(block.name, "")))
        else:
            prime = "" if isinstance(block, Heading) or _begins(block, HODOGRAPH) else prime
            told.append(_primed(block, prime) if isinstance(block, Equation) else block)
    return told


def _heading(block: Block) -> str:
    """The words over the lines of a path; "" of any other block."""
    return _words(block) if _begins(block, PATH) else ""


def _begins(block: Block, words: str) -> bool:
    return isinstance(block, Paragraph) and _words(block).startswith(words)


def _words(block: Block) -> str:
    return "".join(p.text for p in block.line if isinstance(p, Text)) if isinstance(block, Paragraph) else ""


def _primed(block: Block, prime: str) -> Block:
    renamed: Block = Renaming({axis: f"{axis}{prime}" for axis in "xy"}).of(block) if prime else block
    return renamed


def _with_axes(block: Block, prime: str) -> Block:
    """The heading of a path in a moving frame with the names of its axes."""
    assert isinstance(block, Paragraph)
    if not prime:
        return block
    line = tuple(Text(_named(p.text, prime), p.style) if isinstance(p, Text) else p for p in block.line)
    return Paragraph(line)


def _named(words: str, prime: str) -> str:
    told = words.replace("x axis along", f"x{prime} axis along")
    told = re.sub(r"with (\S+) as origin", rf"in which \1 is at rest, the origin of x{prime}, y{prime}", told)
    return told.replace("axes turning", f"axes x{prime}, y{prime} turning")
