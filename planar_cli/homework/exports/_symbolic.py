"""A formula of the key as PrairieLearn's symbolic input takes it: SymPy's syntax, whole numbers, functions it knows."""

from __future__ import annotations

import re
from fractions import Fraction

from planar_cli.homework.sets.paper import Expected

# What PrairieLearn reads as a function or a constant, so that no letter may have that name.
FUNCTIONS = frozenset(
    "exp log ln sqrt factorial abs sgn max min sign Abs Max Min cos sin tan sec cot csc cosh sinh tanh arccos arcsin "
    "arctan acos asin atan arctan2 atan2 atanh acosh asinh".split()
)
CONSTANTS = frozenset(("pi", "e", "infty"))
_LETTER = re.compile(r"[A-Za-z][A-Za-z0-9_]*")
_NAME = re.compile(r"[A-Za-z_][A-Za-z0-9_]*")
_NUMBER = re.compile(r"(?<![A-Za-z0-9_.])(\d+\.?\d*|\.\d+)([eE][+-]?\d+)?(?![A-Za-z0-9_.])")
_SIGNS = re.compile(r"[-+*/^(),\s]*")


class NoFormula(Exception):
    """PrairieLearn cannot take it; says why."""


def symbolic(expected: Expected) -> tuple[str, tuple[str, ...]]:
    """The formula and its letters. Raises NoFormula."""
    formula, letters = expected.formula, tuple(name for name, _ in expected.letters)
    if not formula:
        raise NoFormula("the formula is known only as it is printed, so PrairieLearn cannot compare it")
    for letter in letters:
        if not _LETTER.fullmatch(letter) or letter in FUNCTIONS | CONSTANTS:
            raise NoFormula(f"PrairieLearn takes no letter '{letter}'")
    unknown = [n for n in _NAME.findall(_NUMBER.sub("", formula)) if n not in {*letters, *FUNCTIONS, "pi"}]
    if unknown:
        raise NoFormula(f"PrairieLearn does not know '{unknown[0]}' in a formula")
    if not _SIGNS.fullmatch(_NAME.sub("", _NUMBER.sub("", formula))):
        raise NoFormula("PrairieLearn cannot read its formula")
    return _NUMBER.sub(_exact, formula), letters


def _exact(match: re.Match[str]) -> str:
    """A decimal number as a fraction: PrairieLearn refuses decimals."""
    value = Fraction(match[0])
    return str(value.numerator) if value.denominator == 1 else f"({value})"
