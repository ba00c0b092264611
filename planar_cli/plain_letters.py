"""Letters for terminals that can do no better: ASCII for everything that a page can print.

α is alpha, x² is x^2, √(2 g h) is sqrt(2 g h), ↺ is ccw. What is longer so is made so before lines are laid out:
whoever lays out asks `letters`, which changes nothing unless `in_plain(True)` holds.
"""

from __future__ import annotations

import os
import re
import unicodedata
from collections.abc import Iterator
from contextlib import contextmanager
from contextvars import ContextVar
from typing import TextIO

from planar_cli.greek import GREEK

POOR = re.compile(r"^(dumb|linux|ansi|cons\d*|vt\d+.*)$")
"""Terminals, by TERM, that have few letters."""
SAMPLE = "α√²→⇒─⠿"
"""An encoding that has these has them all."""
C_LOCALE = ("C", "POSIX")
SUPERSCRIPTS = dict(zip("⁰¹²³⁴⁵⁶⁷⁸⁹⁺⁻⁽⁾ᐟ⁼ⁿⁱ", "0123456789+-()/=ni", strict=True))
TABLE = """
ϑ theta  ϕ phi  ε epsilon  ϵ epsilon  ς sigma  µ mu  ± +/-  ∓ -/+  × x  · *  ⋅ *  ∙ *  ÷ /  − -  ½ 1/2  ¼ 1/4
← <-  → ->  ↔ <->  ↑ up  ↓ down  ↖ up-left  ↗ up-right  ↘ down-right  ↙ down-left  ↺ ccw  ↻ cw  ⇒ =>  ⇐ <=
⇔ <=>  ↦ ->  ∞ infinity  ∫ int  ∂ d  ∑ Sum  ∈ in  ∥ ||  ⊥ perp  ⟂ perp  ∠ angle  ≈ ~  ≠ !=  ≤ <=  ≥ >=  ≡ =
∝ ~  ≪ <<  ≫ >>  √ sqrt  – -  — --  ‐ -  ‑ -  • *  … ...  ′ '  ″ ''  ‴ '''  ° deg  “ "  ” "  „ "  ‘ '  ’ '  ‚ ,
« "  » "  ⊕ +  ⊗ x  ✓ ok  ✗ x  ∅ none  ─ -  ━ -  │ |  ┃ |  ┌ +  ┐ +  └ +  ┘ +  ├ +  ┤ +  ┬ +  ┴ +  ┼ +  ╵ |  ╷ |  █ #
▓ #  ▒ #  ░ .  ● o  ○ o  ◦ o  ℓ l  ß ss  æ ae  Æ AE  ø o  Ø O  œ oe  ł l  Ł L  đ d  ı i
"""
WORDS = {letter: name for name, letter in GREEK.items()}
WORDS |= {pair.split(" ")[0]: pair.split(" ")[1] for pair in re.split(r"  |\n", TABLE.strip())}
"""What stands for one letter."""
UMLAUTS, TREMAS = re.compile("(?<=[aouAOU])\u0308"), re.compile("(?<=[eiEI])\u0308")
DOTS = {"\u0307": "_dot", "\u0308": "_ddot"}
"""Over a letter: a rate."""
KEPT = re.compile("[\u00a0\ue000-\ue003]")
"""Spaces of a layout, which become plain ones when it is done."""
BRAILLE = 0x2800
_RAISED = re.compile(f"[{''.join(SUPERSCRIPTS)}]+")
_ROOT = re.compile(r"√(\w[\w.]*)")
_DELTA = re.compile(r"Δ(?=\w)")
_SUM = re.compile(r"Σ(?= ?\w)")
_SIGN = re.compile(r"(?<=[∫∑∠√])(?=\w)")
_DEGREES = re.compile(r"(?<=\d)°")
_BESIDE = re.compile(rf"(?<=\d)(?=[{''.join(GREEK.values())}])")
_PLAIN: ContextVar[bool] = ContextVar("plain", default=False)


def is_poor(stream: TextIO) -> bool:
    """Can a stream show no more than ASCII: by its encoding, by a locale `C` that was asked for, or by its terminal?"""
    try:
        SAMPLE.encode(stream.encoding or "utf-8")
    except (LookupError, UnicodeEncodeError):
        return True
    told = os.environ.get("PYTHONIOENCODING") or os.environ.get("PYTHONUTF8")
    if os.environ.get("LC_ALL") in C_LOCALE and not told:
        return True
    return stream.isatty() and POOR.match(os.environ.get("TERM", "")) is not None


@contextmanager
def in_plain(plain: bool) -> Iterator[None]:
    """Inside of it, `letters` gives ASCII, or not."""
    token = _PLAIN.set(plain)
    try:
        yield
    finally:
        _PLAIN.reset(token)


def letters(text: str) -> str:
    """The text as it is to be laid out."""
    return ascii_of(text) if _PLAIN.get() and not text.isascii() else text


def ascii_of(text: str) -> str:
    """A text in ASCII, but for the spaces of a layout; what has no letters there is a question mark."""
    text = _DEGREES.sub(" deg", text)
    text = _ROOT.sub(r"sqrt(\1)", text).replace("√(", "sqrt(")
    text = _RAISED.sub(lambda run: _power(run.group()), text)
    text = _SIGN.sub(" ", _SUM.sub("∑", _DELTA.sub("Delta_", _BESIDE.sub(" ", text))))
    text = TREMAS.sub("", UMLAUTS.sub("e", unicodedata.normalize("NFD", text)))
    return "".join(map(_letter, text))


def _power(run: str) -> str:
    """² is ^2, ⁻¹ is ^-1, ¹ᐟ² is ^(1/2)."""
    plain = "".join(SUPERSCRIPTS[c] for c in run)
    return f"^({plain})" if "/" in plain else f"^{plain}"


def _letter(letter: str) -> str:
    if letter.isascii() or KEPT.match(letter):
        return letter
    found = WORDS.get(letter) or DOTS.get(letter)
    if found is not None:
        return found
    if unicodedata.combining(letter):
        return ""
    if 0 <= ord(letter) - BRAILLE < 256:
        return of_dots(ord(letter) - BRAILLE)
    plain = unicodedata.normalize("NFKD", letter)
    return plain if plain.isascii() else " " if letter.isspace() else "?"


LEFT, RIGHT = (0, 1, 2, 6), (3, 4, 5, 7)
"""The bits of the dots of a Braille cell, downward."""


def of_dots(bits: int) -> str:
    """The letter that looks most like the strokes in a Braille cell."""
    left, right = ([row for row, bit in enumerate(side) if bits >> bit & 1] for side in (LEFT, RIGHT))
    if not left and not right:
        return " "
    both = [*left, *right]
    if left and right:
        low, high = sum(left) / len(left), sum(right) / len(right)
        if abs(low - high) >= 1:
            return "/" if low > high else "\\"
        if max(both) - min(both) >= 2:
            return "#" if len(both) > 5 else "|"
        middle = sum(both) / len(both)
    else:
        if len(both) > 2:
            return "|"
        middle = sum(both) / len(both)
    return "'" if middle < 0.75 else "-" if middle < 2.25 else "."
