"""What is asked as a function of a coordinate: where it holds, which root it is, and that its derivative is the law."""

from __future__ import annotations

import unicodedata

from conftest import ROOT
from worked import worked

from planar_cli.formats.terminal import Terminal
from planar_cli.report.narrate import narrate


def _page(name: str) -> str:
    page = Terminal(200).render(narrate(worked(ROOT / "problems" / f"{name}.yaml")[0]))
    return unicodedata.normalize("NFC", page)


def test_a_square_holds_while_the_sense_is_kept() -> None:
    page = _page("textbook/ex-1-08")
    assert "ω from let_go to lowest, as a function of θ:" in page
    assert "the positive root, as θ grows there" in page
    assert "d(1/2 θ̇²)/dθ = d(g sin θ / r)/dθ = g cos θ / r = θ̈" in page
    assert "throughout" not in page


def test_a_function_of_time_holds_throughout() -> None:
    assert "v throughout the motion:" in _page("motion/boat-coasting")
