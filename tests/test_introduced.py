"""Every letter of an equation is introduced: by what is given, a sentence, a diagram, a formula, or convention."""

from __future__ import annotations

from page_introduced import unintroduced
from page_rules import PAGES, Page, Row, page_of


def test_letters_from_nowhere() -> None:
    """`MOST`: letters on a hundred pages; it may only fall."""
    found = [letter for path in PAGES for letter in unintroduced(page_of(path))]
    assert 100 * len(found) <= MOST * len(PAGES)


def test_what_introduces_a_letter() -> None:
    given = Row("given", "m = 2 kg; A(0, 0), AB = l at θ", 0)
    force = Row("forces", "AB: T_cord ↑ at B", 0)
    sums = Row("equation", "", 0, 1, "↺ ΣM_A:", ("T_cord l cos θ", "m k α_AB + m a_Ax"))
    made = Row("equation", "", 0, None, "", ("k", "l²"))
    assert list(unintroduced(Page("t", (given, force, sums), 3))) == ["k"]
    assert not list(unintroduced(Page("t", (given, force, made, sums), 4)))
    assert list(unintroduced(Page("t", (given, sums), 2))) == ["T_cord", "k"]


MOST = 28
