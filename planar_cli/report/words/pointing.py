"""Words that tell where a vector acts and which way, " ↓ at G", with the same for who draws it."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from itertools import pairwise

from planar_cli.problem.scene.geometry import Vec
from planar_cli.report.document.blocks import Block, Name, Paragraph, Text, Way
from planar_cli.report.words.words import Phrases


def pointing(
    phrases: Phrases, told: str, place: Vec, direction: Vec | None = None, before: bool = False, kind: str = ""
) -> Text:
    """`told`: the words. `direction`: of a force, its own or the opposite one, whichever the words tell; None: of a
    couple. `before`: it is a momentum before a blow. `kind`: of a force.
    """
    return Text(told, way=Way(place, direction, phrases.drawn or phrases.value, before=before, kind=kind))


def about(phrases: Phrases, told: str, place: Vec | None, bodies: Sequence[str]) -> Text:
    """`told`: the words before the name of a point about which moments of some bodies are taken; None: it has no place
    of its own.
    """
    return Text(told, way=None if place is None else Way(place, None, phrases.drawn or phrases.value, tuple(bodies)))


def told_centres(blocks: Iterable[Block]) -> Iterator[tuple[str, Way]]:
    """The points about which moments are taken, by their names."""
    for block in blocks:
        for piece, behind in pairwise(block.line) if isinstance(block, Paragraph) else ():
            if isinstance(piece, Text) and piece.way is not None and piece.way.bodies and isinstance(behind, Name):
                yield behind.name, piece.way
