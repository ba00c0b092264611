"""Friction of what slides over a turning table along its circle: of one sense as long as it slides."""

from __future__ import annotations

import pytest
from answered import first, solve
from conftest import ROOT
from worked import page_of_file

FILE = ROOT / "problems" / "friction" / "block-lowered-on-a-turning-table.yaml"


def test_the_sense_of_sliding_is_told_and_not_a_quotient() -> None:
    page = page_of_file("block-lowered-on-a-turning-table")
    assert "(1) ↖ ΣF: μ m g = m R α_string" in page
    assert "It stops sliding at t_2 = 3.058 s (state 2): w - ω_string = 0." in page
    assert "t_2 = w/α_string = 18/5.886 = 3.058 s" in page


@pytest.mark.parametrize(("start", "time"), [(12, 6 * 0.5 / 2.943), (3, 12 * 0.5 / 2.943), (-3, 24 * 0.5 / 2.943)])
def test_it_slides_either_way(start: float, time: float) -> None:
    """Also where it first goes against the table and turns round meanwhile."""
    text = FILE.read_text(encoding="utf-8").partition("note:")[0]
    found = solve(text.replace("block at rest", f"v(block).y = {start} m/s"))
    assert first(found["t_2"]) == pytest.approx(time)
    assert first(found["v_2"]) == pytest.approx(9)
