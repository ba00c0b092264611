"""The forces of a diagram stand closer where that spares a row."""

from __future__ import annotations

import pytest

from planar_cli.formats.terminal import Terminal
from planar_cli.report.document.blocks import Document, Forces, line


@pytest.mark.parametrize(("width", "told"), [
    (60, "  box:  W ↓ at G,  P → at A,  N ↑ at C   =   m a → at G"),
    (54, "  box:  W ↓ at G, P → at A, N ↑ at C   =   m a → at G"),
    (40, "  box:  W ↓ at G,  P → at A,  N ↑ at C\n      = m a → at G"),
])  # fmt: skip
def test_room_between_forces(width: int, told: str) -> None:
    left = line("W ↓ at G", ",  ", "P → at A", ",  ", "N ↑ at C")
    page = Terminal(width=width).render(Document("Box", (Forces("box", left, line("m a → at G")),)))
    assert told in page
