"""Numbers put into formulas: what somebody with a pocket calculator gets from them is what is printed behind them."""

from __future__ import annotations

import math
from decimal import Decimal
from itertools import pairwise
from pathlib import Path

import pytest
import sympy as sp
from conftest import PROBLEMS, ROOT
from printed import equations, read_number
from worked import name_of, worked

from planar_cli.report.blocks import Equation, Math, Value
from planar_cli.report.enough_figures import MOST, enough_figures
from planar_cli.report.narrate import narrate
from planar_cli.report.words import rounded
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
ROUNDED = 2.01
"""In units of the last figure: one between both as they are printed, and half of one for the rounding of each."""
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


@pytest.mark.parametrize(
    ("expr", "numbers", "figures"),
    [
        (A * B**2, ("1.23456789", "9.87654321"), 4),
        (8 * A**2, ("2.8125",), 5),
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
