"""Numbers put into formulas: what somebody with a pocket calculator gets from them is what is printed behind them."""

from __future__ import annotations

import math
from decimal import Decimal
from itertools import pairwise
from pathlib import Path

import pytest
import sympy as sp
from conftest import PROBLEMS, ROOT
from page_digits import differs, unequal_digits, worked_out
from page_rules import PAGES, page_of
from printed import equations, read_number
from worked import name_of, page_of_file, worked

from planar_cli.formats.terminal import Terminal
from planar_cli.report.document.blocks import Equation, Math, Value
from planar_cli.report.in_numbers.sums import sum_of
from planar_cli.report.notation.enough_figures import MOST, enough_figures, figures_each, figures_of
from planar_cli.report.notation.numbers import significant
from planar_cli.report.notation.rounding import rounded
from planar_cli.report.page.narrate import narrate
from planar_cli.units import parse_unit

SAMPLE = (
    "flywheel-of-a-punch-press",
    "puck-hits-a-free-rod",
    "spool-turned-round-by-its-cord",
    "wheel-over-a-kerb",
    "ex-2-09",
    "mine-hoist-us-units",
)
FILES = [*(p for p in PROBLEMS if p.stem in SAMPLE), ROOT / "problems/hard/ball-that-grazes-the-ceiling.yaml"]
ROUNDED = 1.01
"""In units of the last figure: as they are printed both are the same, half of one for the rounding of each."""
UNEQUAL = 110
"""Lines on a hundred pages of which the printed digits give another last figure."""
A, B = sp.symbols("a b", positive=True)


def _unequal(block: Equation) -> list[str]:
    """Sides in numbers alone, put in for names, that do not give the value that follows them."""
    found = []
    for side, after in pairwise(block.sides):
        if not (isinstance(side, Math) and side.values and isinstance(after, Value)):
            continue
        if side.expr.free_symbols - set(side.values) or side.expr.has(sp.Integral, sp.Piecewise):
            continue
        put = {s: sp.Float(read_number(text), 30) for s, text in side.values.items()}
        got = complex(sp.N(side.expr.xreplace(put)))
        turn = float(sp.pi) ** parse_unit(after.unit).pi_power / 180 if after.unit == "deg" else 1.0
        value = float(after.number) * turn
        last = 10.0 ** (math.floor(math.log10(abs(value))) + 1 - after.figures) if value else 0.0
        if value and abs(got - value) > ROUNDED * last:
            found.append(f"{side.expr} with {side.values} = {got}, not {value}")
    return found


def test_the_sample_is_there() -> None:
    assert {p.stem for p in FILES} > set(SAMPLE)


@pytest.mark.parametrize("path", FILES, ids=name_of)
def test_printed_numbers_give_the_printed_result(path: Path) -> None:
    document = narrate(worked(path)[0])
    assert not [text for block in equations(document.blocks) for text in _unequal(block)]


def test_a_result_that_is_a_tenth_but_for_rounding() -> None:
    """0.6 · 0.1667 = 0.1, of which sixty digits may be 0.0999…"""
    sixth = Decimal(1) / 6 - Decimal("1e-40")
    assert figures_of([Decimal("0.6"), sixth], lambda v: v[0] * v[1], 4) == 4


@pytest.mark.parametrize(
    ("expr", "numbers", "figures"),
    [
        (A * B**2, ("1.23456789", "9.87654321"), 5),
        (8 * A**2, ("2.8125",), 4),
        (A * sp.sin(B), ("9.9944", "0.5"), 5),
        (A + B, ("1.23456789", "9.87654321"), 4),
        (A - B, ("5.00123456", "5"), 7),
        (sp.sqrt(100 - A), ("99.9967891",), 7),
        (A - B, ("1.00000000000001234", "1"), None),
    ],
    ids=str,
)
def test_as_many_figures_as_the_result_needs(expr: sp.Expr, numbers: tuple[str, ...], figures: int | None) -> None:
    """A product may need one more than is shown, a difference more; where `MOST` are too few, nothing is put in."""
    value = dict(zip((A, B), map(Decimal, numbers), strict=False))
    assert enough_figures(expr, rounded, value, (), 4) == figures
    assert figures is None or figures <= MOST


@pytest.mark.parametrize(
    ("expr", "numbers", "figures"),
    [
        (1000 * A + B, ("1.23456789", "9.87654321"), (5, 4)),
        (A * B, ("9.4349312", "5.0743412"), (4, 5)),
        (A - B / 1000, ("5.00123456", "5.1234567"), (4, 4)),
        (A - B, ("5.00123456", "5.00012345"), (8, 8)),
        (A * (B - 1), ("3.1415926", "1.0012345"), (5, 7)),
        (A + 2 * B, ("1.2345678", "1.2345678"), (5, 5)),
    ],
    ids=str,
)
def test_more_figures_only_of_what_needs_them(
    expr: sp.Expr, numbers: tuple[str, ...], figures: tuple[int, int]
) -> None:
    """What stands alone beside a small difference keeps its four; equal numbers are told alike."""
    value = dict(zip((A, B), map(Decimal, numbers), strict=True))
    found = figures_each(expr, rounded, value, (), 4)
    assert found is not None
    assert (found.each[A], found.each[B]) == figures


@pytest.mark.parametrize(("number", "text"), [("12.125", "12.125"), ("2.4525", "2.4525"), ("12.1251", "12.13")])
def test_halves_stand_as_they_are(number: str, text: str) -> None:
    """Nobody has to ask whether they are rounded up or down."""
    assert significant(Decimal(number)) == text


def test_figures_of_a_sum() -> None:
    """A difference of numbers that stand in a line needs more of them than it has itself."""
    assert figures_of([Decimal("679.84"), Decimal("-362.56")], sum_of, 4) == 5


def test_pages_are_worked_out() -> None:
    """The reader of printed lines finds a wrong last figure, and none where all are right."""
    assert worked_out("2 · 9.81 (-0.5) / (2 sin² 30°)") == pytest.approx(-19.62)
    assert worked_out("√(3² + 4²) + |-1|") == pytest.approx(6)
    assert worked_out("m g") is None
    assert differs("1.233²", "1.519 m")
    assert not differs("1.2326²", "1.519 m")


@pytest.mark.parametrize("path", FILES, ids=name_of)
def test_digits_of_a_page_give_its_results(path: Path, tmp_path: Path) -> None:
    """Formulas, vectors, energies and checks, as they stand on the page."""
    printed = tmp_path / f"{path.stem}.solution.txt"
    printed.write_text(Terminal(width=110).render(narrate(worked(path)[0])), encoding="utf-8")
    assert not list(unequal_digits(page_of(printed)))


def test_digits_of_all_pages() -> None:
    """Places on a hundred pages; it may only fall."""
    found = [text for path in PAGES for text in unequal_digits(page_of(path))]
    assert 100 * len(found) <= UNEQUAL * len(PAGES), found


def test_a_sum_of_numbers_is_what_its_printed_numbers_give() -> None:
    assert "56.667 - 13.333 = 43.33 = 0.3106 v_P,2²" in page_of_file("weight-dropped-on-nested-springs")


def test_both_components_of_a_vector_have_the_same_figures() -> None:
    """[0.81915 · 0.6 - 0.57358 · 2, 0.57358 · 0.6 + 0.81915 · 2]: the second needs them."""
    page = page_of_file("collar-on-rotating-rod")
    assert "[0.81915 · 0.6 - 0.57358 · 2, 0.57358 · 0.6 + 0.81915 · 2]" in page
    assert page.index("e_r = [cos 35°") < page.index("e_r + r ω e_θ")
