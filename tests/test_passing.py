"""What is asked as a function of a coordinate: where it holds, which root it is, and that its derivative is the law."""

from __future__ import annotations

import re
import unicodedata

from conftest import ROOT
from worked import worked

from planar_cli.formats.terminal import Terminal
from planar_cli.report.page.narrate import narrate


def _page(name: str) -> str:
    page = Terminal(200).render(narrate(worked(ROOT / "problems" / f"{name}.yaml")[0]))
    return unicodedata.normalize("NFC", page)


def test_a_square_holds_while_the_sense_is_kept() -> None:
    page = _page("textbook/ex-1-08")
    assert "ω dω = α dθ from θ = 0, ω = 0 to any θ:" in page
    assert "the positive root: θ grows" in page
    assert "d(1/2 ω²)/dθ = d(g sin θ / r)/dθ = g cos θ / r = α" in page
    assert "throughout" not in page


def test_a_function_of_time_holds_throughout() -> None:
    assert "v throughout the motion:" in _page("motion/boat-coasting")


def test_a_rate_is_called_as_the_author_asks() -> None:
    page = _page("textbook/ex-1-08")
    assert "ω = θ̇, α = θ̈" in page
    assert "ω_squared = θ̇² = 2 g (cos θ - cos θ_0) / l" in _page("oscillations/simple-pendulum")


def test_a_step_that_only_restates_the_data_is_left_out() -> None:
    page = _page("motion/boat-coasting")
    assert "given:" not in page
    assert "STEP 1  Motion over time" in page
    # Another unit is worth a line.
    assert re.search(r"v_Ax = 20 km/h = 5.556 m/s +given\n", _page("motion/ships-passing"))
