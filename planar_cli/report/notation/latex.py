"""Numbers and relation signs, already printed as plain text, in LaTeX mathematics."""

from __future__ import annotations

import re

from planar_cli.report.notation.names import printable

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
    **{sign: f" {sign} " for sign in "+-="},
    **{sign: rf" {_RELATIONS[sign]} " for sign in "<≤>≥"},
    "×": r" \times ",
    "·": r" \cdot ",
    "/": "/",
    "(": "(",
    ")": ")",
    "|": "|",
    ",": r",\ ",
    "[": r"\lbrack ",
    "]": r"\rbrack ",
    "²": "^{2}",
    "³": "^{3}",
    "°": r"^{\circ}",
    "′": "'",
    "→": r"\rightarrow ",
    "←": r"\leftarrow ",
    "↑": r"\uparrow ",
    "↓": r"\downarrow ",
    "↗": r"\nearrow ",
    "↖": r"\nwarrow ",
    "↘": r"\searrow ",
    "↙": r"\swarrow ",
    "↺": r"\circlearrowleft ",
    "↻": r"\circlearrowright ",
    ":": ":",
}
_SPLIT = re.compile(rf"\s*([{re.escape(''.join(_SPOKEN))}])\s*|(\d+(?:\.\d+)?)|\s+")
_OPERATORS = re.compile(rf"[\s\d.{re.escape(''.join(_SPOKEN))}]*?(?P<unit>(?<=\]) [^\W\d].*)?")
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
    match = _OPERATORS.fullmatch(shown)
    if match is None:
        return _said(shown)
    unit = match["unit"] or ""
    signs = shown.removesuffix(unit)
    if shown == "-":
        return shown
    found = "".join(_sign(m[0]) if m[1] else m[2] or " " for m in _SPLIT.finditer(signs))
    return found + (_said(unit) if unit else "")


def _sign(text: str) -> str:
    """A sign between words; behind a colon the space stays."""
    sign = _SPOKEN[text.strip()]
    return r":\ " if sign == ":" and text[-1].isspace() else sign


def _said(text: str) -> str:
    """Words alone; what TeX would take for a command becomes a space."""
    harmless = re.sub(r"[\\{}$^~_#%&<>`\[\]]", " ", text)
    return rf"\text{{{harmless}}}" if harmless.strip() else r"\ " * (harmless != "")


def _piece(piece: str) -> str:
    if piece[0] in _SUPERSCRIPTS:
        return f"^{{{piece.translate(_FROM_SUPERSCRIPT)}}}"
    return _SIGNS.get(piece, piece)
