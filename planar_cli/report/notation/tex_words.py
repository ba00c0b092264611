"""Words in the text of a LaTeX document: nothing in them is a command, and all is plain ASCII, so that every TeX reads
it.

Letters that TeX has no command for are shown by the command \\unicodeletter, which a document defines: as they are
where TeX reads Unicode, else by their number.
"""

from __future__ import annotations

import re
import unicodedata

from planar_cli.greek import GREEK
from planar_cli.report.notation.names import printable

LETTER = "unicodeletter"
_SIGNS = {
    "\\": r"\textbackslash{}",
    "^": r"\textasciicircum{}",
    "~": r"\textasciitilde{}",
    "<": r"\textless{}",
    ">": r"\textgreater{}",
    "|": r"\textbar{}",
    '"': r"\textquotedbl{}",
    "`": r"\textasciigrave{}",
    # No ligature is made of two of them.
    "-": "{-}",
    # The sign of the font: the command of TeX draws a long line.
    "_": r"\char95{}",
    "'": "{'}",
    **{c: "\\" + c for c in "{}$&#%"},
}
_MATHS = {
    **{letter: "\\" + word for word, letter in GREEK.items()},
    **dict(zip("⁰¹²³⁴⁵⁶⁷⁸⁹⁻⁺", (f"^{{{c}}}" for c in "0123456789-+"), strict=True)),
    **dict(zip("₀₁₂₃₄₅₆₇₈₉", (f"_{{{c}}}" for c in "0123456789"), strict=True)),
    "·": r"\cdot",
    "×": r"\times",
    "−": "-",
    "±": r"\pm",
    "°": r"^{\circ}",
    "′": "'",
    "″": "''",
    "≠": r"\ne",
    "≤": r"\le",
    "≥": r"\ge",
    "≈": r"\approx",
    "→": r"\rightarrow",
    "←": r"\leftarrow",
    "↑": r"\uparrow",
    "↓": r"\downarrow",
    "↔": r"\leftrightarrow",
    "↕": r"\updownarrow",
    "↗": r"\nearrow",
    "↖": r"\nwarrow",
    "↘": r"\searrow",
    "↙": r"\swarrow",
    "↺": r"\circlearrowleft",
    "↻": r"\circlearrowright",
    "⇒": r"\Rightarrow",
    "∞": r"\infty",
    "√": r"\surd",
    "∑": r"\Sigma",
    "∫": r"\int",
    "∂": r"\partial",
    "⊥": r"\perp",
    "∥": r"\parallel",
    "½": r"\tfrac{1}{2}",
    "ϕ": r"\phi",
    "ϑ": r"\vartheta",
    "ϵ": r"\epsilon",
    "∆": r"\Delta",
    "∙": r"\cdot",
    "⋅": r"\cdot",
    "•": r"\bullet",
    "µ": r"\mu",
}
_TEXTS = {
    "–": "{--}",
    "—": "{---}",
    "…": r"\ldots{}",
    "\N{NO-BREAK SPACE}": "~",
    "\N{EM SPACE}": r"\quad{}",
    "‘": "{`}",
    "’": "{'}",
    "“": "{``}",
    "”": "{''}",
    "„": r"\quotedblbase{}",
    "§": r"\S{}",
    "ß": r"\ss{}",
    **{c: rf"\{n}{{}}" for c, n in zip("øØæÆœŒłŁı", ("o", "O", "ae", "AE", "oe", "OE", "l", "L", "i"), strict=True)},
}
_OVER = dict(
    zip("\u0300\u0301\u0302\u0303\u0304\u0306\u0307\u0308\u030a\u030b\u030c\u0327\u0328", "`'^~=u.\"rHvck", strict=True)
)
"""The commands of accents, by the combining signs."""
_VECTOR = "\u20d7"


def words(text: str) -> str:
    """Words as LaTeX text on one line."""
    shown = printable(re.sub(r"\s", lambda m: m[0] if m[0] in _TEXTS else " ", text))
    return "".join(map(_letter, _clusters(shown)))


def in_ascii(tex: str) -> str:
    """LaTeX in which other letters are left, in formulas or in words among them, all in ASCII."""
    return re.sub(r"[^\x00-\x7f]\u20d7?", lambda m: _letter(m[0]), tex)


def _clusters(text: str) -> list[str]:
    """Letters, each with the signs above or below it."""
    return re.findall(r"[^\u0300-\u036f\u20d7][\u0300-\u036f\u20d7]?|.", text)


def _letter(letter: str) -> str:
    if letter.isascii():
        return _SIGNS.get(letter, letter)
    if letter in _TEXTS:
        return _TEXTS[letter]
    if letter in _MATHS:
        return rf"\ensuremath{{{_MATHS[letter]}}}"
    parts = unicodedata.normalize("NFD", letter)
    if len(parts) == 2 and parts[1] in _OVER and parts[0].isascii() and parts[0].isalpha():
        return rf"\text{{\{_OVER[parts[1]]}{{{parts[0]}}}}}"
    if len(parts) == 2 and parts[1] in (_VECTOR, "\u0307", "\u0308") and (parts[0].isalpha() or parts[0] in _MATHS):
        over = {_VECTOR: "vec", "\u0307": "dot", "\u0308": "ddot"}[parts[1]]
        return rf"\ensuremath{{\{over}{{{in_ascii(parts[0])}}}}}"
    return "".join(rf"\text{{\{LETTER}{{{ord(c):04X}}}}}" for c in letter)
