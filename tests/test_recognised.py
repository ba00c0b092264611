"""Long coefficients that are something simple."""

from __future__ import annotations

import pytest
import sympy as sp

from planar_cli.equation.values.exact import Valuation
from planar_cli.equation.values.ledger import Ledger
from planar_cli.solve.instant.recognised import recognised
from planar_cli.units import parse_unit

R, BETA, H = sp.Symbol("R", positive=True), sp.Symbol("beta", real=True), sp.Symbol("h", positive=True)


@pytest.fixture
def ledger() -> Ledger:
    made = Ledger(())
    for symbol, unit, value in ((R, "m", sp.Rational(3, 10)), (BETA, "rad", sp.Rational(7, 20)), (H, "m", R)):
        made.units[symbol] = parse_unit(unit)
        made.values[symbol] = sp.Rational(3, 10) if symbol is H else value
    return made


@pytest.mark.parametrize(
    ("long", "simple"),
    [
        (sp.sqrt((2 * sp.cos(BETA)) ** 2 + (2 * sp.sin(BETA)) ** 2) / 2, sp.S.One),
        (-R * sp.cos(BETA) ** 2 / 2 - R * sp.sin(BETA) ** 2 / 2, -R / 2),
        (R * sp.cos(BETA) / sp.sqrt(sp.cos(BETA) ** 2 + sp.sin(BETA) ** 2), R * sp.cos(BETA)),
    ],
)
def test_what_holds_for_all_numbers(long: sp.Expr, simple: sp.Expr, ledger: Ledger) -> None:
    assert recognised(long, ledger, Valuation({}, ledger.values)) == simple


def test_equal_numbers_of_two_letters_are_no_identity(ledger: Ledger) -> None:
    assert recognised(2 * R - H, ledger, Valuation({}, ledger.values)) is None
