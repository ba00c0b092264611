"""Numbers, angles, directions and units as words: a decimal in, text for people out."""

from __future__ import annotations

import math
from decimal import ROUND_HALF_EVEN, ROUND_HALF_UP, Context, Decimal

from planar_cli.units import pretty_unit

MINUS = "-"
# Powers of ten are written only outside this range of exponents, so that 123500 N and 0.0001 m stay readable.
_LARGEST_EXPONENT = 5
_SMALLEST_EXPONENT = -4
# A number that is short to so many digits was meant exactly: 2 m, not 2.000 m.
_EXACT_DIGITS = 15
_SUPERSCRIPTS = str.maketrans("0123456789-", "⁰¹²³⁴⁵⁶⁷⁸⁹⁻")


def superscript(text: str) -> str:
    """Digits and minus signs as Unicode superscripts."""
    return text.translate(_SUPERSCRIPTS)


def significant(number: Decimal, figures: int = 4) -> str:
    """The number to so many figures: 6.186, 490.5, 1.235×10⁶; exact short numbers stay short, zero is 0."""
    if number.is_nan():
        return "undetermined"
    if number.is_infinite():
        return "∞" if number > 0 else f"{MINUS}∞"
    if number.is_zero():
        return "0"
    shown = _rounded(number, figures)
    sign = MINUS if shown.is_signed() else ""
    magnitude = abs(shown)
    exponent = magnitude.adjusted()
    if _SMALLEST_EXPONENT <= exponent <= _LARGEST_EXPONENT:
        return sign + format(magnitude, "f")
    return f"{sign}{magnitude.scaleb(-exponent):f}×10{superscript(str(exponent))}"


def as_printed(number: Decimal, figures: int) -> Decimal:
    """The number that a reader of `significant` reads. One that ends with a 5 right behind the last figure stands as
    it is, 12.125: it could be rounded up as well as down.
    """
    nearly = _nearly(number, figures)
    half = len(nearly.as_tuple().digits) == figures + 1 and nearly.as_tuple().digits[-1] == 5
    return nearly if half else nearly.normalize(Context(prec=figures, rounding=ROUND_HALF_UP))


def _nearly(number: Decimal, figures: int) -> Decimal:
    """The number as it was meant, without the rounding of its last digits."""
    return number.normalize(Context(prec=max(_EXACT_DIGITS, figures), rounding=ROUND_HALF_EVEN))


def quantity(number: Decimal, unit: str = "", figures: int = 4) -> str:
    """A number with its unit: `490.5 N`, `-6.186 rad/s²`, `33.69°`."""
    text = significant(number, figures)
    shown = pretty_unit(unit) if unit not in ("", "1") else ""
    return text + shown if shown.startswith("°") else f"{text} {shown}".rstrip()


def angle(degrees: Decimal, figures: int = 3) -> str:
    """An angle in degrees: `33.7°`."""
    return significant(degrees, figures) + "°"


def rotation_words(sign: Decimal | int) -> str:
    """The sense of a rotation, positive counterclockwise; nothing for zero."""
    return "counterclockwise" if sign > 0 else "clockwise" if sign < 0 else ""


def vector_words(x: Decimal, y: Decimal, figures: int = 3) -> str:
    """The direction of a vector, +x to the right and +y up: "to the right", "at 33.7° above +x"; nothing for zero."""
    if x.is_zero() and y.is_zero():
        return ""
    if y.is_zero():
        return "to the right" if x > 0 else "to the left"
    if x.is_zero():
        return "upward" if y > 0 else "downward"
    axis = "+x" if x > 0 else "-x"
    side = "above" if y > 0 else "below"
    return f"at {angle(_steepness(x, y), figures)} {side} {axis}"


def _rounded(number: Decimal, figures: int) -> Decimal:
    """Rounded to the figures; without closing zeros and plain integers where the number is exact within them."""
    shown = as_printed(number, figures)
    if _nearly(number, figures) == shown:
        return shown
    # Closing zeros that are significant are shown: 6.180, not 6.18.
    return shown.quantize(Decimal(1).scaleb(shown.adjusted() - figures + 1))


def _steepness(x: Decimal, y: Decimal) -> Decimal:
    """The acute angle between a vector and the x axis, in degrees."""
    return Decimal(math.degrees(math.atan(abs(y) / abs(x))))
