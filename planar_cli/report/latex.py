"""Numbers and relation signs, already printed as plain text, in LaTeX mathematics."""

from __future__ import annotations

import re

from planar_cli.report.names import printable

_RELATIONS = {"≠": r"\ne", "<": r"\lt", "≤": r"\le", ">": r"\gt", "≥": r"\ge", "≈": r"\approx", "→": r"\to"}
_SIGNS = {
    "×": r" \times ",
    "·": r" \cdot ",
    "π": r"\pi ",
    "∞": r"\infty ",
    "°": r"^{\circ}",
    "−": "-",
    "√": r"\surd ",
    "\\": r"\backslash ",
    "{": r"\lbrace ",
    "[": r"\lbrack ",
    "]": r"\rbrack ",
    "}": r"\rbrace ",
    "~": r"\sim ",
    "^": r"\wedge ",
    **{c: "\\" + c for c in "%_&#$"},
}
_SUPERSCRIPTS = "⁰¹²³⁴⁵⁶⁷⁸⁹⁻"
_FROM_SUPERSCRIPT = str.maketrans(_SUPERSCRIPTS, "0123456789-")


def relation(sign: str) -> str:
    """A relation sign; an unknown one counts as `=`."""
    return _RELATIONS.get(sign, "=")


def numeral(text: str) -> str:
    """A printed number or unit: powers of ten, degrees and superscripts; nothing passes that TeX would obey."""
    pieces = re.findall(f"[{_SUPERSCRIPTS}]+|.", printable(text))
    return "".join(_piece(p) for p in pieces).rstrip()


def words(text: str) -> str:
    """Words in a formula, as `\\text`; what TeX would take for a command becomes a space."""
    harmless = re.sub(r"[\\{}$^~_#%&<>`\[\]]", " ", printable(text))
    return rf"\text{{{harmless}}}"


def _piece(piece: str) -> str:
    if piece[0] in _SUPERSCRIPTS:
        return f"^{{{piece.translate(_FROM_SUPERSCRIPT)}}}"
    return _SIGNS.get(piece, piece)
