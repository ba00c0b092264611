"""Forces and moments that the solution did not add up check it: of several bodies together, and about another point."""

from __future__ import annotations

import re
from decimal import Decimal

import pytest
from worked import page_of_file

from planar_cli.report.component_sums import sum_of_products
from planar_cli.report.notation import plain


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
        ("ex-4-16", r"block, bar together: ↑ ΣF_y = (.*?) N, Σ m a_y = (.*?) N"),
        ("ex-4-05", r"spool: ↻ ΣM_C = (75) N·m; I α and the moment of m a_G: (.*?) N·m"),
        ("crate-on-cart", r"crate: ↺ ΣM_B = (.*?) N·m; the moment of m a_G: (.*?) N·m"),
    ],
)
def test_both_sides_agree(stem: str, pattern: str) -> None:
    sides = _sides(re.search(pattern, page_of_file(stem)))
    results = [result for _, result in sides]
    assert results == pytest.approx([results[0]] * 2, rel=1e-9)
    assert [total for total, _ in sides] == pytest.approx(results, rel=2e-3)


@pytest.mark.parametrize(
    ("stem", "factors"),
    [("ex-4-10", [10, 1.704, 0.1333, 8.521]), ("arm-lifted-by-a-jet", [6, 3.287, 0.72, 5.479])],
)
def test_speeds_put_into_the_kinetic_energy(stem: str, factors: list[float]) -> None:
    """Of the mass centre and of turning apart, where the solution put both into one square."""
    found = re.search(
        r"= 1/2 m v² \+ 1/2 I ω² = 0\.5 · (\S+) · (\S+)² \+ 0\.5 · (\S+) · (\S+)² = (\S+) J; \S+ \+ U = (.*?) J",
        page_of_file(stem),
    )
    assert found is not None
    m, v, inertia, w, energy = (float(x) for x in found.groups()[:5])
    assert [m, v, inertia, w] == factors
    assert (m * v**2 + inertia * w**2) / 2 == pytest.approx(energy, rel=1e-3)
    assert float(found.group(6).rpartition(" = ")[2]) == energy


def test_equal_numbers_of_a_product_stay_apart() -> None:
    """2 ṙ ω with ṙ = 2 is 2 · 2 · 3, no 2² · 3."""
    two, three = Decimal(2), Decimal(3)
    told = sum_of_products([(1, ((two, 1), (two, 1), (three, 1))), (-1, ((two, 1), (three, 2)))], 4)
    assert plain(told.expr, told.values) == "2 · 2 · 3 - 2 · 3²"


def test_many_energies_are_told_by_their_values() -> None:
    """Of three bodies five products would not fit two lines."""
    found = re.search(r"T_2 = Σ \(1/2 m v² \+ 1/2 I ω²\) = (.*?) J; T_1 \+ U = (.*?) J", page_of_file("ex-4-17"))
    sides = _sides(found)
    assert [total for total, _ in sides] == pytest.approx([result for _, result in sides], rel=2e-3)
    assert sides[0][1] == sides[1][1]
