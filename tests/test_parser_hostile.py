"""Hostile expressions: every one is refused with a diagnostic, and no text raises anything else."""

from __future__ import annotations

from collections.abc import Callable
from fractions import Fraction

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from planar_cli.errors import Diagnostic, Mark
from planar_cli.problem.codes.codes import CODES
from planar_cli.problem.language.dimensions import dimension_of
from planar_cli.problem.language.expression import Number
from planar_cli.problem.language.parser import (
    ParseError,
    parse_found,
    parse_law,
    parse_side,
    parse_span,
    parse_statement,
)

HERE = Mark("f", 7, 11)

HOSTILE = [
    "__import__('os').system('true')",
    "x.subs.__globals__['__builtins__']",
    "Symbol.__new__.__globals__",
    "sin.__new__.__globals__",
    "sin('__import__(1)')",
    "eval(1)",
    "ｅｖａｌ(1)",
    "open('f').read()",
    "(lambda: 1)()",
    "f'{x}'",
    "Matrix([1])",
    "9**9**9**9",
    "9^9^9^9",
    "2^(2^(2^(2^(2^2))))",
    "((((9^12)^12)^12)^12)^12",
    "((9^12)^12)^12*((9^12)^12)^12*((9^12)^12)^12",
    "9^(9^9)",
    "factorial(factorial(100))",
    "1e1000000000",
    "1e999",
    "1e-999",
    "9" * 41,
    "9" * 4301,
    "1e10000000",
    "exp(exp(exp(exp(9))))",
    "exp(9^12)",
    "sin(" * 90 + "x" + ")" * 90,
    "(" * 250 + "1" + ")" * 250,
    "-" * 5000 + "x",
    "-(" * 300 + "x",
    "x**" * 5000 + "x",
    "x^" * 900 + "x",
    "x+" * 999 + "x",
    "x*" * 900 + "x",
    "a" * 41,
    "\x00",
    "\x1b[31m",
    "1" + ":59" * 600,
    "x if y else z",
    "x := 3",
    "3j",
    "1_000",
    "0b11",
    "[x for x in y]",
    "v(" * 100,
    "dot(" * 100 + "x" + ")" * 100,
    "v(P).along(" * 70 + "x" + ")" * 70,
    "count(" * 70 + "x = 1" + ")" * 70,
]


@pytest.mark.parametrize("text", HOSTILE, ids=range(len(HOSTILE)))
def test_hostile_text_is_refused(text: str) -> None:
    for parse in (parse_side, parse_statement, parse_law, parse_found):
        with pytest.raises(ParseError):
            parse(text, HERE)


def test_long_sums_within_the_limits_are_fine() -> None:
    assert dimension_of(parse_side("+".join(["x"] * 240), HERE), lambda _: None).dimension is None
    deep = parse_side("(" * 59 + "1" + ")" * 59, HERE)
    assert deep == Number(Fraction(1), None, 1, HERE.shifted(59))


PIECES = (
    "v(P) .x .along( ( ) + - * / ^ 2 0.5 m N*m kg cw in @ 1 -> = < a b.c sin( dot( count( at rest is largest during"
    " stick pi t r(B/A) , just after"
)


@settings(max_examples=600, deadline=None)
@given(
    st.text(max_size=60)
    | st.text(alphabet="abxvr N*m/s^()+-.,=<>@ 0123in", max_size=40)
    | st.lists(st.sampled_from(PIECES.split()), max_size=14).map(" ".join)
)
def test_any_text_is_read_or_refused(text: str) -> None:
    for parse in (parse_side, parse_statement, parse_law, parse_found, parse_span):
        diagnostic = refusal(parse, text)
        if diagnostic is not None:
            assert diagnostic.code in CODES
            assert HERE.column <= diagnostic.mark.column <= HERE.column + len(text)


def refusal(parse: Callable[[str, Mark], object], text: str) -> Diagnostic | None:
    try:
        parse(text, HERE)
    except ParseError as error:
        return error.diagnostic
    return None
