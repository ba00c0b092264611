"""Forces on a page: what the diagrams hold, and where the normal forces of the checks come from."""

from __future__ import annotations

import pytest
from conftest import ROOT
from worked import worked

from planar_cli.formats.terminal import Terminal
from planar_cli.report.narrate import narrate


def _page(name: str) -> str:
    return Terminal(width=110).render(narrate(worked(ROOT / "problems" / f"{name}.yaml")[0]))


@pytest.mark.parametrize(
    ("name", "row"),
    [
        ("friction/heaviest-weight-before-a-box-slips", "load:  m_load g ↓,  T_cord ↑   =   m_load a_Hy ↑\n"),
        ("particles/unknown-counterweight", "weight:  m_B g ↓,  T_cord ↑   =   m_B a_By ↑\n"),
        ("textbook/ex-1-11", "P:  m g ↓   =   m a_Py ↑\n"),
    ],
)
def test_an_acceleration_that_is_zero_is_not_drawn(name: str, row: str) -> None:
    """What hangs or flies has no acceleration along which nothing acts."""
    assert row in _page(name)


def test_a_normal_force_of_a_check_has_its_sum_of_forces() -> None:
    page = _page("friction/heaviest-weight-before-a-box-slips")
    assert "N_A = m_cart g + N_B = 42 lbf > 0" in page
    assert " · N_B = 12 lbf > 0" in page
    assert "N_C = m g = 490.5 N > 0" in _page("textbook/ex-4-05")


def test_a_limit_speaks_of_the_extreme_that_is_asked() -> None:
    page = _page("friction/heaviest-weight-before-a-box-slips")
    assert "At the largest W: friction at B reaches its limit, it is about to slip:" in page
