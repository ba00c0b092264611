"""The characteristic equation on a page is that of the law of motion above it, in the letters of the file."""

from __future__ import annotations

import re

import pytest
from conftest import ROOT
from worked import worked

from planar_cli.formats.terminal import Terminal
from planar_cli.report.page.narrate import narrate


@pytest.mark.parametrize(
    ("name", "words"),
    [
        ("textbook/ex-1-07", "simple harmonic motion with ω_0² = k/m:"),
        ("momentum/gun-on-rails", "under-damped, ζ < 1, x of G:"),
        ("oscillations/damped-block-three-ways", "critically damped, ζ = 1:"),
        ("oscillations/damped-block-three-ways", "over-damped, ζ > 1:"),
        ("oscillations/disk-rolling-in-a-trough", ""),
    ],
)
def test_the_equation_has_the_coefficients_of_the_law(name: str, words: str) -> None:
    text = Terminal(width=110).render(narrate(worked(ROOT / "problems" / f"{name}.yaml")[0]))
    page = re.sub(r"\s+", " ", text)
    assert words in page
    assert "λ² + c λ + ω²" not in page
