"""What is said of the other solution: once on a page, under its last case."""

from __future__ import annotations

import pytest
from worked import page_of_file

from planar_cli.report.checks.checked_once import ALL, CHECKED, checked_once
from planar_cli.report.document.blocks import Answer, Check, Heading, line

FIRST, SECOND = Heading("CASE", "up"), Heading("CASE", "down")
OWN = Check(line("N = 5 N > 0"))


def test_it_stands_under_the_last_case() -> None:
    assert checked_once([OWN, CHECKED, FIRST, CHECKED, SECOND, OWN, CHECKED]) == [OWN, FIRST, SECOND, OWN, ALL]


@pytest.mark.parametrize("page", [
    [OWN, CHECKED],
    [CHECKED, FIRST, OWN],
    [CHECKED, FIRST, SECOND, CHECKED],
    [CHECKED, FIRST, Check(line("all but v checked by an independent multibody solution"))],
])  # fmt: skip
def test_where_it_is_not_true_of_all_nothing_changes(page: list[Check | Heading]) -> None:
    assert checked_once(page) == page


def test_an_answer_that_was_not_compared_is_not_among_all() -> None:
    """A moment of inertia, of which no equation of motion was solved."""
    page = [Answer("I", line("0.09 kg·m²")), FIRST, CHECKED, SECOND, CHECKED]
    assert checked_once(page) == page


def test_the_opening_is_no_case() -> None:
    title = Heading("STEP 1", "")
    assert checked_once([title, FIRST, CHECKED, SECOND, CHECKED]) == [title, FIRST, SECOND, ALL]


def test_on_a_page_with_a_case() -> None:
    page = page_of_file("ex-4-05")
    assert page.count("multibody") == 1
    assert "all answers checked by an independent multibody solution" in page
