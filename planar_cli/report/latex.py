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
_SPOKEN = {
    " + ": " + ",
    " - ": " - ",
    " = ": " = ",
    " × ": r" \times ",
    ", ": r",\ ",
    "[": r"\lbrack ",
    "] ": r"\rbrack\ ",
    "]": r"\rbrack ",
}
_SPLIT = re.compile("( [-+=×] |, |\\[|\\] ?)")
_OPERATORS = re.compile(r"[-\s=\[+×,|]*(\](?: .*)?)?")
"""What stands between the parts of a vector equation, with the unit behind its components."""
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
    """Words in a formula, as `\\text`; signs between them as signs of mathematics."""
    shown = printable(text)
    if not _OPERATORS.fullmatch(shown):
        return _said(shown)
    return text if text == "-" else "".join(_SPOKEN.get(w) or _said(w) for w in _SPLIT.split(shown) if w)


def _said(text: str) -> str:
    """Words alone; what TeX would take for a command becomes a space."""
    harmless = re.sub(r"[\\{}$^~_#%&<>`\[\]]", " ", text)
    return rf"\text{{{harmless}}}" if harmless.strip() else r"\ " * (harmless != "")


def _piece(piece: str) -> str:
    if piece[0] in _SUPERSCRIPTS:
        return f"^{{{piece.translate(_FROM_SUPERSCRIPT)}}}"
    return _SIGNS.get(piece, piece)
