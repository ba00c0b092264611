"""Long runs of equations of one form: the first ones are told, and of the others by which numbers they go."""

from __future__ import annotations

import re

import pytest
from worked import page_of_file

from planar_cli.report.blocks import Paragraph, line
from planar_cli.report.results import told_by_others

CHAIN_5 = "Likewise with BC as well, about B; then AB about A; then OA about O: (13) to (15)"


@pytest.mark.parametrize(
    ("stem", "others", "components"),
    [
        (
            "chain-5",
            "with BC as well, about B; then AB about A; then OA about O: (13) to (15), collected",
            "(5) to (10)",
        ),
        ("chain-5-symbols", "with BC as well, about B; then AB about A; then OA about O: (13) to (15).", "(5) to (10)"),
        ("chain-10", "then bar_1 about P0: (22) to (29), collected", "(5) to (18)"),
    ],
)
def test_moments_of_groups_that_grow(stem: str, others: str, components: str) -> None:
    page = page_of_file(stem)
    assert others in page
    assert re.search(rf"Likewise the components of [^:]*: {re.escape(components)}\.", page)


@pytest.mark.parametrize("stem", ["chain-5", "chain-5-symbols"])
def test_what_is_told_so_stood_in_an_earlier_case(stem: str) -> None:
    inner = page_of_file(stem).partition("CASE inner")[2]
    assert "as before: (1) to (10)" in inner
    assert "As before: the diagram, (11) to (15)." in inner
    assert "Likewise the components" not in inner


def test_every_row_is_solved() -> None:
    page = page_of_file("chain-10")
    assert all(f"({n}):" in page or f"({n}) " in page for n in range(20, 30))


def test_from_the_free_end_no_reaction_enters() -> None:
    """The last bar is vertical and the first horizontal: about the last pin the first has no part."""
    page = page_of_file("chain-10")
    assert "bar_10, moments about P9:" in page
    assert "bar_9, bar_10, moments about P8:" in page


@pytest.mark.parametrize(
    ("said", "numbers"),
    [
        ("Likewise the components of a_C: (5) to (8).", [5, 6, 7, 8]),
        ("Likewise B: (3), (4), collected further down.", [3, 4]),
        ("From (3), (4):", []),
    ],
)
def test_numbers_of_a_sentence(said: str, numbers: list[int]) -> None:
    assert told_by_others(Paragraph(line(said))) == numbers
