"""A later step of a motion by what changes in it, and letters that have one value in one line."""

from __future__ import annotations

from decimal import Decimal

import sympy as sp

from planar_cli.report.document.blocks import Answer, Block, Equation, Forces, Line, Math, Paragraph, Text, Value, line
from planar_cli.report.energy.alike import with_equals_together
from planar_cli.report.repeats.as_there import as_there

BODIES = ("frame", "rear", "front")
LONG = sp.Add(*sp.symbols("m:40"))


def _drawn(body: str, couple: str = "") -> Forces:
    acting = line(Math(sp.Symbol("W")), " ↓ at G", *((",  ", Math(sp.Symbol(couple)), " ↺") if couple else ()))
    return Forces(body, acting, line(Math(sp.Symbol("ma")), " → at G"))


def _rows(bodies: dict[str, str]) -> list[Block]:
    return [_drawn(body, bodies.get(body, "")) for body in (*BODIES, "fork", "chain")]


def _sum(number: int, total: sp.Expr) -> list[Block]:
    return [Paragraph(line("frame, moments about A:")), Equation((Math(total), Math(sp.S.Zero)), number)]


def _text(told: Line) -> str:
    return "".join(p.text if isinstance(p, Text) else str(p.expr) for p in told if isinstance(p, Text | Math))


def test_diagrams_by_the_loads_that_change() -> None:
    before, now = _rows({"frame": "M_c", "rear": "M_c"}), _rows({"frame": "M_b", "front": "M_b"})
    (told,) = as_there(now, before, "from 1 to 2")
    assert isinstance(told, Paragraph)
    assert _text(told.line) == (
        "Diagrams as from 1 to 2, but on frame M_b ↺ in place of M_c ↺; on rear no M_c ↺; on front also M_b ↺."
    )


def test_of_two_equal_forces_one_may_be_missing() -> None:
    before, now = _rows({"frame": "S", "rear": "M_c"}), _rows({"frame": "S", "rear": "M_b"})
    frame = before[0]
    assert isinstance(frame, Forces)
    before[0] = Forces("frame", (*frame.left, Text(",  "), *_drawn("frame", "S").left[3:]), frame.right)
    (told,) = as_there(now, before, "from 1 to 2")
    assert isinstance(told, Paragraph)
    assert _text(told.line) == "Diagrams as from 1 to 2, but on frame no S ↺; on rear M_b ↺ in place of M_c ↺."


def test_a_few_diagrams_are_drawn_again() -> None:
    before, now = [_drawn("frame", "M_c"), _drawn("rear")], [_drawn("frame", "M_b"), _drawn("rear")]
    assert list(as_there(now, before, "from 1 to 2")) == now


def test_equations_that_stay_are_named() -> None:
    x = sp.Symbol("x")
    before = [*_sum(5, x), *_sum(7, LONG), *_sum(8, LONG + 1)]
    told = as_there([*_sum(14, -x), *_sum(16, LONG), *_sum(17, LONG + 1)], before, "from 1 to 2")
    assert list(told[:2]) == _sum(14, -x)
    assert isinstance(told[-1], Paragraph)
    assert _text(told[-1].line) == "Equations as from 1 to 2: (16), (17), there (7), (8)."
    # One short equation is as soon read as looked up.
    assert list(as_there(_sum(14, x), before, "from 1 to 2")) == _sum(14, x)


def _acceleration(name: str) -> Equation:
    r, alpha = sp.symbols("R alpha")
    texts = {r: "0.35", alpha: "1.043"}
    return Equation((Math(sp.Symbol(name)), Math(r * alpha), Math(r * alpha, texts), Value(Decimal("0.3651"), "m/s^2")))


def test_accelerations_of_one_value_stand_in_one_line() -> None:
    told = [_acceleration(name) for name in ("a_A", "a_B", "a_G")]
    (one,) = with_equals_together(told)
    assert isinstance(one, Equation)
    assert [str(side.expr) for side in one.sides if isinstance(side, Math)][:3] == ["a_A", "a_B", "a_G"]
    # What an answer looks for keeps its line.
    assert with_equals_together([*told[:2], Answer("a_B", line("0.3651"))])[:2] == told[:2]
