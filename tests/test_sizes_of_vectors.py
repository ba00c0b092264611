"""A speed or the size of an acceleration that is asked has its line by both components, in letters too."""

from __future__ import annotations

from unicodedata import normalize

import pytest
from conftest import ROOT
from worked import worked

from planar_cli.formats.terminal import Terminal
from planar_cli.report.page.narrate import narrate


@pytest.mark.parametrize(
    ("name", "line"),
    [
        ("textbook/ex-1-12", "v_P = √(ẋ_P² + ẏ_P²) = 15 π/4 = 11.78 m/s"),
        ("textbook/ex-1-12", "a_P = √(ẍ_P² + ÿ_P²) = 15 π²/16 = 9.253 m/s²"),
        ("motion/spiral-arm", "v_P = √(v_Pr² + v_Pθ²) = b w √(1 + θ²)"),
    ],
)
def test_size_by_components(name: str, line: str) -> None:
    """Components stand above; the size follows from them."""
    printed = Terminal(width=110).render(narrate(worked(ROOT / "problems" / f"{name}.yaml")[0]))
    assert normalize("NFC", line) in normalize("NFC", printed)
