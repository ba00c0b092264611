"""Forces and moments that the solution did not add up check it: of several bodies together, and about another point."""

from __future__ import annotations

import re
from decimal import Decimal

import pytest
from worked import page_of_file

from planar_cli.report.kinematics.component_sums import sum_of_products
from planar_cli.report.notation.notation import plain


def _sides(found: re.Match[str] | None) -> list[tuple[float, float]]:
    """Of both sides what the terms come to, and what the page says that they come to."""
    assert found is not None
    sides = []
    for text in found.groups():
        terms, _, result = text.partition(" = ")
        total = sum(float(t) for t in re.sub(r" ([+-]) ", r" \1", terms).split())
        sides.append((total, float(result or terms)))
    return sides


@pytest.mark.parametrize(
    ("stem", "pattern"),
    [
        ("roller-with-a-drag-bar", r"roller, bar together: → ΣF_x = (.*?) N, Σ m a_x = (.*?) N"),
        ("spool-rolls-or-slips", r"spool: [↺↻] ΣM_C = (.*?) N·m; I α and the moment of m a_G: (.*?) N·m"),
        ("crate-on-cart", r"crate: ↺ ΣM_B = (.*?) N·m; the moment of m a_G: (.*?) N·m"),
    ],
)
def test_both_sides_agree(stem: str, pattern: str) -> None:
    sides = _sides(re.search(pattern, page_of_file(stem)))
    results = [result for _, result in sides]
    assert results == pytest.approx([results[0]] * 2, rel=1e-9)
    assert [total for total, _ in sides] == pytest.approx(results, rel=2e-3)


def test_equal_numbers_of_a_product_stay_apart() -> None:
    """2 ṙ ω with ṙ = 2 is 2 · 2 · 3, no 2² · 3."""
    two, three = Decimal(2), Decimal(3)
    told = sum_of_products([(1, ((two, 1), (two, 1), (three, 1))), (-1, ((two, 1), (three, 2)))], 4)
    assert plain(told.expr, told.values) == "2 · 2 · 3 - 2 · 3²"
