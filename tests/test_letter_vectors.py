"""A vector in letters is read: its size, its direction, and between which points it lies."""

from __future__ import annotations

import unicodedata
from pathlib import Path

from conftest import ROOT
from worked import worked

from planar_cli.formats.terminal import Terminal
from planar_cli.homework.checking import read, solve_and_compare
from planar_cli.report.narrate import narrate

TEXTBOOK = ROOT / "problems" / "textbook"


def _page(stem: str) -> str:
    return unicodedata.normalize("NFC", Terminal(200).render(narrate(worked(TEXTBOOK / f"{stem}.yaml")[0])))


def test_an_acceleration_that_always_points_to_the_centre() -> None:
    page = _page("ex-1-05")
    assert "a_P = [r ω² sin φ, r ω² cos φ], that is r ω² along the unit vector [sin φ, cos φ], from P to G" in page
    assert page.index("constant:") < page.index("φ̇ = ω") < page.index("φ̈ = 0")
    assert "ẍ_P = r ω φ̇ sin φ = r ω² sin φ" in page


def test_a_displacement_of_a_fixed_direction() -> None:
    assert "that is √2 r at 75° below +x" in _page("ex-1-02")


def test_a_size_that_is_no_product_is_not_read() -> None:
    """2 r ω |sin(φ/2)| is not told as a root."""
    assert "v_P = [r ω (1 - cos φ), r ω sin φ]\n" in _page("ex-1-04")


def test_a_velocity_leads_to_no_point(tmp_path: Path) -> None:
    """The velocity of P seen from G is across the arm."""
    text = (TEXTBOOK / "ex-1-05.yaml").read_text(encoding="utf-8").split("answers:", maxsplit=1)[0]
    path = tmp_path / "seen.yaml"
    path.write_text(text.replace("a_P: a(P)", "v_PG: v(P/G)"), encoding="utf-8")
    page = Terminal(200).render(narrate(solve_and_compare(read(str(path)))[0]))
    assert "from P to G" not in page.split("Answer", maxsplit=1)[1]
