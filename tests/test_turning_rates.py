"""Where a page says θ̈ = α, the rates of the angle are called ω and α throughout."""

from __future__ import annotations

from decimal import Decimal

import sympy as sp

from planar_cli.report.document.blocks import Block, Check, Equation, Math, Paragraph, Value, line
from planar_cli.report.page.turning_rates import with_turning_rates

ALPHA, RATE, SECOND = (sp.Symbol(x, real=True) for x in ("alpha", "theta_dot", "theta_ddot"))
NUMBER = Value(Decimal("0.1667"), "rad/s^2")
TOLD: tuple[Block, ...] = (
    Equation((Math(ALPHA), NUMBER)),
    Paragraph(line("For the angle of the wheel:")),
    Equation((Math(SECOND), Math(ALPHA), NUMBER)),
    Equation((Math(RATE), Math(SECOND * sp.Symbol("t", real=True)))),
    Check(line(Math(SECOND), " = ", Math(ALPHA), " is constant")),
)


def test_one_name() -> None:
    first, rate, check = with_turning_rates(TOLD, ())
    assert first == TOLD[0]
    assert isinstance(rate, Equation)
    assert [str(s.expr) for s in rate.sides if isinstance(s, Math)] == ["omega", "alpha*t"]
    assert check == Check(line(Math(ALPHA), " is constant"))


def test_not_the_coordinate_of_the_file() -> None:
    assert with_turning_rates(TOLD, ("theta",)) == list(TOLD)


START = Paragraph(line("From 1 to 2, constant angular acceleration, angle of wheel:"))
OWN = sp.Symbol("alpha__1", real=True)


def test_what_it_is_in_one_motion_stands_where_it_is_used() -> None:
    law = (Paragraph(line("For the angle of the wheel:")), Equation((Math(SECOND), Math(OWN), NUMBER)))
    told = with_turning_rates([TOLD[0], *law, START], ())
    assert told == [TOLD[0], START, Equation((Math(OWN), NUMBER))]


def test_another_motion_has_another_value() -> None:
    """The page said α = 0 last: in this motion it is something else."""
    rest = Equation((Math(ALPHA), Math(sp.S.Zero)))
    told = with_turning_rates([TOLD[0], rest, *TOLD[1:3], START], ())
    assert told[2:] == [START, Equation((Math(ALPHA), NUMBER))]
