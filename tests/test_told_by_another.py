"""A force that is another one, S_1 = S_2, takes its number, and does not repeat the formula that stands above."""

from __future__ import annotations

from pathlib import Path

from conftest import ROOT
from worked import page_of_text


def test_the_formula_of_an_equal_force_stands_once(tmp_path: Path) -> None:
    path = ROOT / "problems" / "hard" / "cables-almost-in-line.yaml"
    page = page_of_text(tmp_path, path.read_text(encoding="utf-8"))
    assert "S_right = S_left = 5×10⁹ N" in page
    assert page.count("W/(2 sin δ)") == 1
