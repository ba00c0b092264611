"""Words that tell where a vector acts and which way, " ↓ at G", with the same for who draws it."""

from __future__ import annotations

from planar_cli.problem.geometry import Vec
from planar_cli.report.blocks import Text, Way
from planar_cli.report.words import Phrases


def pointing(phrases: Phrases, told: str, place: Vec, direction: Vec | None = None) -> Text:
    """`told`: the words. `direction`: of a force, its own or the opposite one, whichever the words tell; None: of a
    couple.
    """
    return Text(told, way=Way(place, direction, phrases.drawn or phrases.value))
