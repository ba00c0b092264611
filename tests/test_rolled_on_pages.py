"""A wheel that the file places by the arc on which it has rolled: the page says so before its places."""

from __future__ import annotations

import unicodedata
from pathlib import Path

import pytest
from conftest import ROOT
from worked import worked

from planar_cli.formats.terminal import Terminal
from planar_cli.homework.checking import read, solve_and_compare
from planar_cli.report.narrate import narrate

ROLLS = "The disk rolls on the floor without slipping: G advances from x = 0 by the arc that has come into contact with"
TEXTBOOK = ROOT / "problems" / "textbook"


def _page(path: Path) -> str:
    return Terminal(200).render(narrate(worked(path)[0]))


@pytest.mark.parametrize("stem", ["ex-1-03", "ex-1-04", "ex-1-05"])
def test_a_wheel_placed_by_an_arc_rolls(stem: str) -> None:
    page = _page(TEXTBOOK / f"{stem}.yaml")
    assert page.index(ROLLS) < page.index("x_G = r φ")
    assert "x_P = x_G + r cos(270° - φ) = r φ - r sin φ = r (φ - sin φ)" in page
    assert "y_P = y_G + r sin(270° - φ) = r - r cos φ = r (1 - cos φ)" in page
    assert "Not used" not in page
    # Where G is follows from that; it is no datum.
    assert "G(r φ, r)" not in page


def test_a_wheel_that_slips_does_not_roll(tmp_path: Path) -> None:
    """Placed by another arc than its own, it touches the floor with a point that moves."""
    text = (TEXTBOOK / "ex-1-03.yaml").read_text(encoding="utf-8").split("answers:", maxsplit=1)[0]
    path = tmp_path / "slips.yaml"
    path.write_text(text.replace("[r*phi, r]", "[2*r*phi, r]"), encoding="utf-8")
    page = Terminal(200).render(narrate(solve_and_compare(read(str(path)))[0]))
    assert "x_G = 2 r φ" in page
    assert "rolls" not in page


def test_derivatives_by_the_chain_rule() -> None:
    page = unicodedata.normalize("NFC", _page(TEXTBOOK / "ex-1-05.yaml"))
    assert "ẏ_P = r φ̇ sin φ = r ω sin φ" in page
    assert "ẏ_G = 0" in page
    assert "ÿ_G = 0" in page
    assert "a_G = 0\n" in page
