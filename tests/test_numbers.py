"""Numbers, angles and directions as words."""

from __future__ import annotations

from decimal import Decimal

import pytest

from planar_cli.equation.scene.arrows import vector_arrow
from planar_cli.report.notation.numbers import quantity, rotation_words, significant, vector_words


@pytest.mark.parametrize(
    ("number", "text"),
    [
        ("-6.18556701", "-6.186"),
        ("39.1752577", "39.18"),
        ("490.5", "490.5"),
        ("0.36742346", "0.3674"),
        ("8.175", "8.175"),
        ("8175", "8175"),
        ("2", "2"),
        ("2.000", "2"),
        ("0.45", "0.45"),
        ("6.18", "6.18"),
        ("6.1799999", "6.180"),
        ("7.99999", "8.000"),
        ("0.99996", "1.000"),
        ("12.00000000000000001", "12"),
        ("98100", "98100"),
        ("12345.6", "12350"),
        ("123456", "123500"),
        ("1234567", "1.235×10⁶"),
        ("1200000.4", "1.200×10⁶"),
        ("3E+8", "3×10⁸"),
        ("0.000123456", "0.0001235"),
        ("0.0000123456", "1.235×10⁻⁵"),
        ("-1E-40", "-1×10⁻⁴⁰"),
        ("0", "0"),
        ("-0", "0"),
        ("0E-30", "0"),
        ("Infinity", "∞"),
        ("-Infinity", "-∞"),
        ("NaN", "undetermined"),
    ],
)
def test_four_figures(number: str, text: str) -> None:
    assert significant(Decimal(number)) == text


@pytest.mark.parametrize(("figures", "text"), [(1, "3"), (2, "3.1"), (6, "3.14159"), (12, "3.14159265359")])
def test_other_figures(figures: int, text: str) -> None:
    assert significant(Decimal("3.14159265358979"), figures) == text


@pytest.mark.parametrize(
    ("number", "unit", "text"),
    [
        ("-6.18556701", "rad/s^2", "-6.186 rad/s²"),
        ("490.5", "N", "490.5 N"),
        ("33.69006", "deg", "33.69°"),
        ("0.5", "", "0.5"),
        ("0.5", "1", "0.5"),
    ],
)
def test_a_quantity_has_its_unit(number: str, unit: str, text: str) -> None:
    assert quantity(Decimal(number), unit) == text


@pytest.mark.parametrize(
    ("x", "y", "words", "arrow"),
    [
        ("3", "0", "to the right", "→"),
        ("-3", "0", "to the left", "←"),
        ("0", "1e-9", "upward", "↑"),
        ("0", "-2", "downward", "↓"),
        ("3", "2", "at 33.7° above +x", "↗"),
        ("-3", "2", "at 33.7° above -x", "↖"),
        ("3", "-2", "at 33.7° below +x", "↘"),
        ("-1", "-1", "at 45° below -x", "↙"),
        ("0", "0", "", ""),
    ],
)
def test_directions(x: str, y: str, words: str, arrow: str) -> None:
    assert vector_words(Decimal(x), Decimal(y)) == words
    assert vector_arrow(Decimal(x), Decimal(y)) == arrow


@pytest.mark.parametrize(("sign", "words"), [(2, "counterclockwise"), (-1, "clockwise"), (0, "")])
def test_rotations(sign: int, words: str) -> None:
    assert rotation_words(sign) == words
