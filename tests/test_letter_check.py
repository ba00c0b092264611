"""A page in letters ends with an equation that it did not use, with its results put in."""

from __future__ import annotations

import pytest
from conftest import ROOT
from worked import worked

from planar_cli.formats.terminal import Terminal
from planar_cli.report.page.narrate import narrate


def _page(name: str) -> str:
    return " ".join(Terminal(width=200).render(narrate(worked(ROOT / "problems" / f"{name}.yaml")[0])).split())


@pytest.mark.parametrize(
    ("name", "check"),
    [
        ("textbook/ex-4-04", "rod: ↺ ΣM_G = √2/8 T L = 1/11 m g L, I α = 1/11 m g L"),
        ("textbook/ex-4-06", "rod: ↺ ΣM_G = 1/4 L A_y = 1/7 m g L, I α = 1/7 m g L"),
        ("rigid-bodies/cylinder-in-a-trough", "ΣM_G = F_C r = 1/3 m g r sin φ, I_G α = 1/3 m g r sin φ"),
        ("rigid-bodies/bar-when-one-of-its-cords-is-cut", "ΣM_G = 1/2 (T_right - T_left) L sin β = 0"),
    ],
)
def test_an_equation_that_is_left(name: str, check: str) -> None:
    assert check in _page(name)


def test_nothing_is_said_of_what_the_page_has_not_found() -> None:
    """The reactions of the collar's pin have no line."""
    assert "ΣM_G" not in _page("systems/bar-hanging-from-a-pushed-collar").split("Check")[1]
