"""Do the digits of a printed page give the result behind them? Sides of numbers alone are read back and worked out.

`6 · 9.81 / (2 sin 60°) = 33.98 N` holds where a pocket calculator, given the digits on the left, shows 33.98.
"""

from __future__ import annotations

import math
import re
from collections.abc import Callable, Iterator
from dataclasses import dataclass

from page_rules import FUNCTIONS, Page, symbols, value_of

NUMBERS = r"\d+(?:\.\d+)?(?:×10[⁻⁰¹²³⁴⁵⁶⁷⁸⁹]+)?"
TOKEN = re.compile(rf"{NUMBERS}|[a-z]+\d?|π|√|∛|[⁻⁰¹²³⁴⁵⁶⁷⁸⁹]+|[-+·/^()|°,]")
SUPER = str.maketrans("⁻⁰¹²³⁴⁵⁶⁷⁸⁹", "-0123456789")
KNOWN: dict[str, Callable[..., float]] = {
    "sin": math.sin,
    "cos": math.cos,
    "tan": math.tan,
    "cot": lambda x: 1 / math.tan(x),
    "arcsin": math.asin,
    "arccos": math.acos,
    "arctan": math.atan,
    "atan2": math.atan2,
    "ln": math.log,
    "exp": math.exp,
    "sinh": math.sinh,
    "cosh": math.cosh,
    "tanh": math.tanh,
}
STEPS = "+ -", "· /"
FIGURES = 4
ANOTHER_UNIT = 0.02
"""A result that is farther off, in parts of itself, is told in another unit than its numbers."""


class Unreadable(Exception):
    """It is not a formula of numbers alone."""


@dataclass
class _Reader:
    """Works out one formula of numbers, token by token."""

    tokens: list[str]
    at: int = 0

    @property
    def token(self) -> str:
        return self.tokens[self.at] if self.at < len(self.tokens) else ""

    def take(self) -> str:
        self.at += 1
        return self.tokens[self.at - 1]

    def total(self) -> float:
        sign = -1.0 if self.token == "-" else 1.0
        if self.token in ("-", "+"):
            self.take()
        found = sign * self.product()
        while self.token in ("+", "-"):
            found += self.product() if self.take() == "+" else -self.product()
        return found

    def product(self) -> float:
        found = self.power()
        while self.token and self.token not in ("+", "-", ")", "|", ","):
            operator = self.take() if self.token in ("·", "/") else "·"
            sign = 1.0
            if self.token == "-":
                self.take()
                sign = -1.0
            other = sign * self.power()
            found = found * other if operator == "·" else found / other
        return found

    def power(self) -> float:
        found = self.atom()
        while self.token and (self.token[0] in "⁻⁰¹²³⁴⁵⁶⁷⁸⁹°^"):
            mark = self.take()
            if mark == "°":
                found = math.radians(found)
            elif mark == "^":
                found **= self.atom()
            else:
                found **= int(mark.translate(SUPER))
        return found

    def atom(self) -> float:
        token = self.take() if self.token else ""
        if token == "(":
            return self.closed(")")
        if token == "|":
            return abs(self.closed("|"))
        if token == "√":
            return math.sqrt(self.atom())
        if token == "π":
            return math.pi
        if token == "e":
            return math.e
        if token in KNOWN:
            return self.function(token)
        if not token or not token[0].isdigit():
            raise Unreadable(token)
        digits, _, exponent = token.partition("×10")
        return float(digits) * 10.0 ** int(exponent.translate(SUPER) or 0)

    def closed(self, end: str) -> float:
        found = self.total()
        if self.token != end:
            raise Unreadable(self.token)
        self.take()
        return found

    def function(self, name: str) -> float:
        exponent = int(self.take().translate(SUPER)) if self.token and self.token[0] in "²³⁴" else 1
        arguments = []
        if self.token == "(":
            self.take()
            arguments.append(self.total())
            while self.token == ",":
                self.take()
                arguments.append(self.total())
            if self.token != ")":
                raise Unreadable(self.token)
            self.take()
            if self.token == "°":
                raise Unreadable("°")
        else:
            arguments.append(self.power())
        return KNOWN[name](*arguments) ** exponent


def worked_out(text: str) -> float | None:
    """The value of a formula of numbers; None: it is something else."""
    text = text.replace(" rad)", ")")
    tokens = TOKEN.findall(text)
    if "".join(tokens) != text.replace(" ", ""):
        return None
    reader = _Reader(tokens)
    try:
        found = reader.total()
    except (Unreadable, ArithmeticError, ValueError, TypeError, OverflowError):
        return None
    return found if reader.at == len(tokens) else None


def last_place(number: str) -> float:
    """One in the last figure of a printed number."""
    digits, _, exponent = number.partition("×10")
    places = len(digits.partition(".")[2])
    if digits.isdigit() and digits.endswith("0"):
        # 19160 has four figures, 1200 may have two.
        places = min(0, FIGURES - len(digits))
    return 10.0 ** (int(exponent.translate(SUPER) or 0) - places)


def unequal_digits(page: Page) -> Iterator[str]:
    """Lines `numbers = result` of which the digits give another result than the printed one."""
    for row in page.of("equation"):
        for before, after in zip(row.sides[1:], row.sides[2:], strict=False):
            if told := differs(before, after):
                yield f"{row.left} = {before} = {after}   gives {told}"
    yield from _in_checks(page)


def differs(before: str, after: str) -> str:
    """What the digits give, where it is not the value behind them."""
    value, found = value_of(after), None
    if value is not None and value_of(before) is None and not [s for s in symbols(before) if s not in FUNCTIONS]:
        found = worked_out(before)
    if value is None or found is None:
        return ""
    number, unit = value
    if unit == "°" and re.search("arc|atan", before):
        found = math.degrees(found)
    match = re.match(rf"-?({NUMBERS})", after)
    assert match is not None
    place = last_place(match[1])
    rounded_off = abs(found - number) <= 0.5001 * place
    if rounded_off or not number or abs(found - number) > ANOTHER_UNIT * abs(number):
        return ""
    return f"{found:.7g}"


def _in_checks(page: Page) -> Iterator[str]:
    """The same in the check of a page, whose lines are joined."""
    text = " ".join(r.text for r in page.of("check", "check on"))
    for match in re.finditer(rf"= ([-\d][^=;,:]*?[-+·/][^=;,:]*?) = (-?{NUMBERS}[^\s,;]*)", text):
        if told := differs(match[1], match[2]):
            yield f"Check: {match[1]} = {match[2]}   gives {told}"
