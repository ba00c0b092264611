"""What P′ is: said before the first formula that has it."""

from __future__ import annotations

from collections.abc import Iterator

from planar_cli.problem.scene.scene import with_article
from planar_cli.report.document.blocks import Block, Paragraph, line

PRIME = "′"


def coincident(place: str, body: str, told: set[str]) -> Iterator[Block]:
    """P′: the point fixed to AB that coincides with P; nothing of a place without a prime. `told`: what was said."""
    words = f"{place}: the point fixed to {with_article(body)} that coincides with {place.rstrip(PRIME)}"
    if place.endswith(PRIME) and words not in told:
        told.add(words)
        yield Paragraph(line(words))
