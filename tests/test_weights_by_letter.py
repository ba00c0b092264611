"""A weight that the file gives is its letter on the page."""

from __future__ import annotations

import pytest
from worked import page_of_file

from planar_cli.formats.terminal import Terminal
from planar_cli.homework.checking.checking import read, solve_and_compare
from planar_cli.report.page.narrate import narrate


def test_where_only_the_weight_enters_there_is_no_mass_and_no_g() -> None:
    told = narrate(solve_and_compare(read("problems/hard/cables-almost-in-line.yaml"))[0])
    page = " ".join(Terminal(width=110).render(told).split())
    assert "load: W ↓" in page
    assert "mass of" not in page
    assert "9.81" not in page


@pytest.mark.parametrize(
    ("name", "line"),
    [
        ("stacked-blocks-joined-over-a-pulley", "N_B - N_A - W_B = 0"),
        ("stacked-blocks-joined-over-a-pulley", "mass of block_A: m_block,A = W_A/g = 30/32.2 = 0.9317 slug"),
        ("wedge-driven-under-a-block", "N_S = W/(cos β - μ sin β) = 1000/(cos 10° - 0.2 sin 10°) = 1053 N"),
        ("wedge-driven-under-a-block", "N_F = W + w = 1000 + 20 = 1020 N"),
        ("mine-hoist-us-units", "cage: W_C ↓, T_cable ↑ = m_cage a_cage ↑"),
    ],
)
def test_beside_accelerations_the_mass_stays(name: str, line: str) -> None:
    assert line in page_of_file(name)


def test_a_mass_that_is_given_keeps_its_weight() -> None:
    assert "m_A g ↓" in page_of_file("stacked-blocks")


def test_a_weight_that_is_a_number_has_no_letter() -> None:
    page = page_of_file("package-set-down-on-a-belt")
    assert "#" not in page
    assert "N_K = m g = 0.6211 · 32.2 = 20 lbf" in page
