"""A line that is too long breaks between its data or before an outer operator, never inside brackets or a term."""

from __future__ import annotations

from decimal import Decimal

import pytest
import sympy as sp

from planar_cli.formats._layout import fill, spans
from planar_cli.formats.terminal import Terminal
from planar_cli.report.document.blocks import Document, Equation, Inline, Line, Math, Name, Value, line

R, H, M, N = sp.symbols("R r m n", positive=True)


def rows(told: Line | tuple[Inline, ...], width: int) -> list[str]:
    return ["".join(s.text for s in row) for row in fill((), spans(told), 0, width)]


@pytest.mark.parametrize(("width", "shown"), [
    (20, ["C(0, 0), G(0, R),", "T(0, R + r); at rest"]),
    (33, ["C(0, 0), G(0, R), T(0, R + r); at", "rest"]),
])  # fmt: skip
def test_a_place_stays_together(width: int, shown: list[str]) -> None:
    place = line("C(0, 0), G(0, ", Math(R), "), T(0, ", Math(R), " + ", Math(H), "); at rest")
    assert rows(place, width) == shown


def test_words_break_before_an_operator_and_a_datum_not_at_all() -> None:
    speed = line("at rest, ", Name("omega_AB"), " = ", Value(Decimal(4), "rad/s"))
    assert rows(speed, 16) == ["at rest,", "ω_AB = 4 rad/s"]
    assert rows(line("U = 100 + 200 + 300 J"), 13) == ["U = 100 + 200", "+ 300 J"]


def test_words_in_brackets_are_words() -> None:
    assert rows(line("no work (normal to the motion)"), 16) == ["no work (normal", "to the motion)"]


def test_a_product_goes_to_the_next_row_with_its_sign() -> None:
    total = sp.Add(sp.Mul(2, M, N), sp.Mul(3, R, H, evaluate=False), evaluate=False)
    shown = rows((Math(total, {M: "1.25", N: "0.5", R: "4.75", H: "0.5"}),), 24)
    assert len(shown) == 2
    assert shown[1].startswith(("+ ", "- "))


def test_a_root_that_is_wider_than_the_rest_of_its_row_begins_one() -> None:
    terms = sp.Add(*(sp.Mul(x, y, evaluate=False) for x, y in ((M, N), (R, H))), evaluate=False)
    texts = dict.fromkeys((M, N, R, H), "123.4567")
    told = line("a long name of it = ", Math(sp.sqrt(terms), texts))
    assert [row[:3] for row in rows(told, 40)][1] == "= √"


def test_what_fits_a_row_stands_in_one() -> None:
    """A product wider than the room behind a far sign breaks nothing while the row has room for it."""
    told = (Math(sp.Mul(M, N, sp.sin(R * H), evaluate=False)),)
    shown = "".join(s.text for s in spans(told))
    assert len(fill((), spans(told), len(shown) - 3, len(shown))) == 1


def test_a_long_left_side_goes_on_at_the_margin() -> None:
    """Behind its sign there is no room: what is left of it does not stand in a column at the right."""
    terms = sp.Add(*(sp.Mul(x, y, sp.sin(x + y), evaluate=False) for x, y in ((M, N), (R, H), (M, H))), evaluate=False)
    told = Document("", (Equation((Math(terms), Math(sp.S.Zero)), None, line("(2) in numbers:"), line("in J")),))
    for width in range(40, 100):
        rows_of_page = Terminal(width).render(told).splitlines()
        assert all(len(row) - len(row.lstrip()) <= width - 12 for row in rows_of_page), width


def test_factors_of_a_datum_stay_together() -> None:
    datum = line("h = 20 mm, ", Name("m_2"), " = -", Name("rho"), " π ", Name("d"), "²/4 ", Name("s"))
    assert rows(datum, 24) == ["h = 20 mm,", "m_2 = -ρ π d²/4 s"]


@pytest.mark.parametrize(("lead", "times", "columns"), [
    ("mass:", 1, [19, 19]),
    ("mass:", 6, [6, 19]),
    ("T_1 + U = T_2:", 1, [6, 28]),
])  # fmt: skip
def test_lines_before_a_numbered_one_stand_apart_from_a_wide_lead_and_where_they_would_break(
    lead: str, times: int, columns: list[int]
) -> None:
    told = Equation((line("U"), *(Math(M * N) for _ in range(times)), Math(R * H)))
    numbered = Equation((Math(M), Math(R)), 1, line(lead))
    page = Terminal(56).render(Document("", (told, numbered)))
    assert [row.index("=", row.find(":") + 1) for row in page.splitlines() if row.strip()] == columns


def test_the_innermost_brackets_break_last() -> None:
    """Before a term of the numerator, and not inside R (R - M)."""
    above = sp.Add(sp.Mul(4, H, M), sp.Mul(3, N, sp.Add(R, M)), evaluate=False)
    told = (Math(sp.Mul(above, sp.Pow(H, -1, evaluate=False), evaluate=False), {M: "123.45", N: "678.9", R: "23.456"}),)
    whole = "".join(s.text for s in spans(told))
    for width in range(len(whole) - 12, len(whole)):
        first, *_ = rows(told, width)
        assert first.count("(") - first.count(")") == 1


@pytest.mark.parametrize(("size", "columns"), [(16, [10, 10]), (20, [10, 5])])
def test_lines_behind_a_number_stand_apart_where_beside_it_they_would_break(size: int, columns: list[int]) -> None:
    numbered = Equation((line("a"), Math(R)), 1)
    told = Equation((line("b"), line("c" * 24)), None, (), line("d" * size))
    page = Terminal(56).render(Document("", (numbered, told)))
    assert [row.index("=") - 1 for row in page.splitlines() if row.strip()] == columns
