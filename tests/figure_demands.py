"""What is demanded of a figure: words within the picture with all that they cover, no two of them over each other, none
on a stroke; every force and moment of a diagram with its letters.
"""

from __future__ import annotations

import math
import re
from collections import Counter
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from itertools import pairwise
from xml.etree import ElementTree as ET

from sympy import Integer

from planar_cli.figures.diagrams import diagram
from planar_cli.formats._paper import SIZE, Box, Run, Spot, runs_of
from planar_cli.formats._svg import svg
from planar_cli.report.document.blocks import Document, Forces, Line, Math, Text, line
from planar_cli.report.document.marks import Arrow, Figure, Turn
from planar_cli.report.kinetics.entries import entries
from planar_cli.solve.solved_problem import Solution

SPACE = "{http://www.w3.org/2000/svg}"
ABOVE, BELOW = 0.87, 0.38
"""How far letters go over and under the line on which they stand, in parts of their size."""
ROUND = 90
"""So many straight pieces stand for a circle."""
NOTHING = (line("0"), line(Math(Integer(0))))
"""Stands on a side of a diagram on which there is nothing."""
ROUNDED = 0.02
"""Numbers of a picture are rounded to the second decimal."""


@dataclass(frozen=True)
class Placed:
    """Words of a picture with all that they cover."""

    text: str
    box: Box


def demand_figure(figure: Figure) -> list[Placed]:
    """The words of a figure, all inside it as everything else is, beside each other, and in a look of their own."""
    root = ET.fromstring(svg(figure))
    words = demand_inside(root)
    on = [(w.text, kind) for kind, start, end in _strokes(root) for w in words if w.box.is_cut(start, end)]
    assert not on
    return words


def demand_inside(root: ET.Element) -> list[Placed]:
    """The words of a picture."""
    left, top, width, height = map(float, root.attrib["viewBox"].split())
    assert all(left <= x <= left + width and top <= y <= top + height for x, y in _spots(root))
    words = list(_words(root, 0.0, 0.0))
    for one in words:
        box = one.box
        assert left <= box.left < box.right <= left + width, one
        assert top <= box.top < box.bottom <= top + height, one
    over = [(a.text, b.text) for i, a in enumerate(words) for b in words[i + 1 :] if a.box.overlaps(b.box)]
    assert not over
    assert all("words" in e.attrib["class"].split() for e in root.iter(f"{SPACE}text"))
    return words


def _spots(root: ET.Element) -> Iterator[tuple[float, float]]:
    """The places between which strokes and circles lie."""
    for group in root.iter(f"{SPACE}g"):
        dx, dy = _moved(group)
        for element in group.iter():
            if element.tag == f"{SPACE}path":
                for x, y in re.findall(r"(-?[\d.]+) (-?[\d.]+)", element.attrib["d"]):
                    yield float(x) + dx, float(y) + dy
            if element.tag == f"{SPACE}circle":
                x, y, r = (float(element.attrib[a]) for a in ("cx", "cy", "r"))
                yield from ((x + dx - r, y + dy - r), (x + dx + r, y + dy + r))


def _strokes(root: ET.Element) -> Iterator[tuple[str, Spot, Spot]]:
    """The straight pieces of all strokes, and of outlines; on the lines of a grid words may stand."""
    for group in root.iter(f"{SPACE}g"):
        dx, dy = _moved(group)
        for element in group.iter():
            kind = element.get("class", "")
            if element.tag == f"{SPACE}path" and "grid" not in kind.split():
                way = element.attrib["d"]
                spots = [(float(x) + dx, float(y) + dy) for x, y in re.findall(r"(-?[\d.]+) (-?[\d.]+)", way)]
                yield from ((kind, *ends) for ends in pairwise(spots + spots[:1] * way.endswith("Z")))
            if element.tag == f"{SPACE}circle":
                x, y, r = (float(element.attrib[a]) for a in ("cx", "cy", "r"))
                turns = [2 * math.pi * i / ROUND for i in range(ROUND + 1)]
                rim = [(x + dx + r * math.cos(a), y + dy + r * math.sin(a)) for a in turns]
                yield from ((kind, *ends) for ends in pairwise(rim))


def _words(element: ET.Element, dx: float, dy: float) -> Iterator[Placed]:
    if "transform" in element.attrib:
        more = _moved(element)
        dx, dy = dx + more[0], dy + more[1]
    if element.tag == f"{SPACE}text":
        yield _placed(element, dx, dy)
    for child in element:
        yield from _words(child, dx, dy)


def _moved(element: ET.Element) -> tuple[float, float]:
    dx, dy = map(float, re.findall(r"-?[\d.]+", element.attrib["transform"]))
    return dx, dy


def _placed(text: ET.Element, dx: float, dy: float) -> Placed:
    size = float(text.attrib["font-size"])
    pieces = [(text.text or "", size), *((t.text or "", float(t.get("font-size", size))) for t in text)]
    width = sum(Run(letters).width * own / SIZE for letters, own in pieces)
    start = float(text.attrib["x"]) + dx - (width / 2 if text.get("text-anchor") == "middle" else 0.0)
    foot = float(text.attrib["y"]) + dy
    box = Box(start, foot - ABOVE * size, start + width, foot + BELOW * size)
    return Placed("".join(t for t, _ in pieces), box.grown(-ROUNDED))


def demand_forces(page: Document, solution: Solution, words: Mapping[str, Sequence[Placed]]) -> None:
    """Every list of forces of a page has its diagrams, in which each force and couple has an arrow of its own with the
    same letters; it tells of each where it is drawn. `words`: what is written in each figure of the page.
    """
    for place, row in enumerate(page.blocks):
        if not isinstance(row, Forces):
            continue
        every = [e for side in (row.left, row.right) for e in entries(side) if e not in NOTHING]
        assert all(map(_is_placed, every)), row
        told = Counter(map(_letters, every))
        made = diagram(row, page.blocks[place + 1 :], solution)
        if made is None:
            assert not any(e not in NOTHING for e in entries(row.left)), row
            continue
        drawn = Counter(_letters(m.words) for p in made.panels for m in p.marks if isinstance(m, Arrow | Turn))
        # What is given against its letter is drawn the way it is.
        assert _without_signs(drawn) == _without_signs(told), row
        assert not drawn - Counter(w.text for w in words[repr(made)]), row


def _without_signs(told: Counter[str]) -> Counter[str]:
    return Counter(words.removeprefix("-") for words in told.elements())


def _is_placed(entry: Line) -> bool:
    return any(isinstance(p, Text) and p.way is not None for p in entry)


def _letters(words: Line) -> str:
    """What stands before the direction, as it is drawn."""
    end = next((i for i, p in enumerate(words) if isinstance(p, Text) and p.way is not None), len(words))
    return "".join(r.text for r in runs_of(words[:end]))
