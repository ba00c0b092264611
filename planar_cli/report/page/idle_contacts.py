"""That a body stays on a floor is no assumption to be told where no line speaks of the normal force but the diagram."""

from __future__ import annotations

import re
from collections.abc import Sequence

from planar_cli.report.document.blocks import Block, Forces, Note, Text
from planar_cli.report.document.mentioned import names_in

STAYS = re.compile(r"\w+ at (\w+) stays in contact")


def without_idle_contacts(blocks: Sequence[Block]) -> list[Block]:
    """The blocks of a part."""
    drawn = {name for b in blocks if isinstance(b, Forces) for name in names_in(b)}
    spoken = {name for b in blocks if not isinstance(b, Forces) for name in names_in(b)}
    idle = drawn - spoken
    return [b for b in blocks if not ((point := _stays(b)) and idle & {f"N_{point}", "N"})]


def _stays(block: Block) -> str:
    """The point at which a body is assumed to stay in contact, and nothing else is assumed; "" of another block."""
    match block:
        case Note("Assume", (Text(text),)) if (found := STAYS.fullmatch(text)) is not None:
            return found[1]
    return ""
