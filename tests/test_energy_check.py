"""A motion that was found without energies is checked by them, with numbers that fulfil the balance."""

from __future__ import annotations

import re

import pytest
from worked import page_of_file


def _checks(stem: str) -> list[str]:
    sides = r"(?:(?:T_|E_k,)\w+ \+ )?U = .*?; (?:T_|E_k,)\w+ = .*?"
    return re.findall(rf"work and energy: {sides}(?= ·| CASE |$)", page_of_file(stem))


@pytest.mark.parametrize("stem", ["ball-with-backspin", "body-atwood-with-heavy-pulley", "exercise-3-30"])
def test_both_sides_agree(stem: str) -> None:
    found = _checks(stem)
    assert found
    for text in found:
        left, right = text.split("; ")
        *_, terms, total = left.split(" = ")
        numbers = [float(t) for t in re.sub(r" ([+-]) ", r" \1", terms).split()]
        result = float(total.split()[0])
        assert sum(numbers) == pytest.approx(result, abs=2e-3 * max(map(abs, numbers)))
        assert float(re.findall(r" = ([\d.]+) J", right)[-1]) == result


@pytest.mark.parametrize(
    ("stem", "words"),
    [
        (
            "sledge-down-a-slope-and-out-over-level-snow",
            "U = m g L sin β - μ m g (L cos β + x_3) = 6039 - 6039 = 0 J",
        ),
        (
            "load-wound-up-against-axle-friction",
            "E_k,1 + U = 1/2 (M k_O² + m r²) ω_1² - m g (y_L,2 - y_L,1) - M_f θ_2 = 69.66",
        ),
        ("body-atwood-with-heavy-pulley", "U = 88.29 - 58.86 = 29.43 J (weight of A, weight of B); E_k,2 = "),
        ("exercise-3-30", "U = F x_A,2 - 30 μ x_A,2 - 15 μ x_A,2 = 72 - 24 - 12 = 36 J; E_k,2 = 24 + 12 = 36 J"),
    ],
)
def test_works_and_energies_are_named(stem: str, words: str) -> None:
    assert f"work and energy: {words}" in page_of_file(stem)


def test_none_where_it_is_the_square_of_the_only_speed_again() -> None:
    """v² = v_0² + 2 a s was solved for it, of the only body: m/2 times that tests nothing."""
    assert "v_start² + 2 a x_stops" in page_of_file("crate-that-stops")
    assert not _checks("crate-that-stops")


def test_a_way_found_by_its_time_is_tested_by_the_work_done_along_it() -> None:
    """Of the only body too: v = a t and x = 1/2 a t² were solved, not v² = 2 a s."""
    page = page_of_file("parcel-on-a-belt")
    assert "x_carried = 1/2 a t_carried²" in page
    assert "v_carried² = 2 a" not in page
    assert _checks("parcel-on-a-belt") == [
        "work and energy: U = μ m g x_carried = 8 J; T_carried = 1/2 m v_carried² = 8 J"
    ]


def test_none_where_energies_were_used() -> None:
    assert not _checks("ex-4-10")
