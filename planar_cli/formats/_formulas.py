"""A line of words and formulas cut into stretches that are one formula each: m = 12 kg, |v| ≤ 3 m/s, (0, -h).

A line comes in pieces: names, numbers, formulas, and between them words, among which are signs, brackets and functions.
Neighbours that belong to one formula are put together, so that `$m = 12~\\mathrm{kg}$` is one and not `$m$ = $12$ kg`.
A comma is part of a formula only inside brackets; a bracket that is not closed again is a word.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator, Sequence
from typing import Literal, get_args

from planar_cli.records import record
from planar_cli.report.document.blocks import Inline, Line, Name, Text
from planar_cli.report.notation.latex import numeral
from planar_cli.report.notation.names import latex_name

Kind = Literal[
    "term",
    "number",
    "sign",
    "tail",
    "comma",
    "open",
    "close",
    "bar",
    "root",
    "function",
    "label",
    "letter",
    "unit",
    "space",
    "named",
    "word",
]

KINDS: tuple[Kind, ...] = get_args(Kind)[1:]
"""All but terms: what words are cut into."""
SIGNS = {
    "=": "=",
    "≠": r"\ne",
    "<": r"\lt",
    "≤": r"\le",
    ">": r"\gt",
    "≥": r"\ge",
    "≈": r"\approx",
    "→": r"\to",
    "·": r"\cdot",
    "×": r"\times",
}
ENDS = ("term", "number", "tail", "close", "bar", "letter", "unit")
TAILS = {"²": "^{2}", "³": "^{3}", "⁴": "^{4}", "′": "'"}
OPENING, CLOSING = {"(": "(", "[": r"\lbrack "}, {")": ")", "]": r"\rbrack "}
FUNCTIONS = ("sin", "cos", "tan", "cot", "arctan", "arcsin", "arccos", "exp", "ln")
TOKENS = re.compile(
    r"(?P<named>(?<!\w)[A-Za-zΑ-Ωα-ω]_(?:[A-Z]/[A-Z]|[A-Za-z0-9Α-Ωα-ω]{1,8})(?![\w*/^]))"
    r"|(?P<sign> ?[=≠<≤>≥≈→·×](?= |$)|[-+](?= ?)|/)|(?P<tail>[²³⁴′])|(?P<comma>,(?= ))|(?P<open>[(\[])"
    r"|(?P<unit>(?<=[)\]]) (?:[kmcM]?[mNgJWs]|rad|ft|in\.|lbf?)(?:[·/](?:[kmc]?[msgN]|rad|ft|in\.)[²³⁴]?)*(?![\w·/²]))"
    r"|(?P<close>[)\]])|(?P<bar>\|)|(?P<root>√)"
    rf"|(?P<function>(?:{'|'.join(FUNCTIONS)})(?![\w.]))|(?P<number>\d+(?:\.\d+)?(?![\w:.°%])|\d+(?:\.\d+)?°)"
    r"|(?P<label>[A-Z]\w{0,2}′?(?=\()|d(?=\(|$))|(?P<letter>[α-ωΑ-Ω](?!\w))|(?P<space>\s+)"
    r"|(?P<word>.[^\s,()\[\]|√²³′]*)"
)


@record
class Atom:
    """A piece of a line. `tex`: in a formula; `text`: the same among words."""

    kind: Kind
    tex: str
    text: str


Formula = Callable[[Inline], str]


def joined(line: Line, formula: Formula, escaped: Callable[[str], str], marked: Callable[[Text], str]) -> str:
    """A line as Markdown. `formula`: a piece in LaTeX; `escaped`: words; `marked`: words in a style of their own."""
    atoms = [a for piece in _merged(line) for a in _atoms(piece, formula, escaped, marked)]
    return "".join(_stretches(atoms))


def _merged(line: Line) -> Iterator[Inline]:
    """Plain words side by side as one piece."""
    words = ""
    for piece in line:
        if isinstance(piece, Text) and piece.style == "plain":
            words += piece.text
            continue
        yield from [Text(words)] if words else []
        words = ""
        yield piece
    yield from [Text(words)] if words else []


def _atoms(
    piece: Inline, formula: Formula, escaped: Callable[[str], str], marked: Callable[[Text], str]
) -> Iterator[Atom]:
    if not isinstance(piece, Text):
        tex = formula(piece)
        if isinstance(piece, Name) and r"\_" in tex:
            # A phrase, low_is_stable, is a word: GitHub takes its strokes for subscripts.
            yield Atom("word", "", escaped(piece.name))
        else:
            yield Atom("term", tex, f"${tex}$")
        return
    if piece.style != "plain":
        yield Atom("word", "", marked(piece))
        return
    for match in TOKENS.finditer(piece.text):
        kind = next(k for k in KINDS if match[k] is not None)
        if kind == "named":
            # One letter with its subscript, among words of the file: v_0, G_AB.
            yield from _atoms(Name(match[0]), formula, escaped, marked)
            continue
        yield Atom(kind, _tex(kind, match[0].strip()), escaped(match[0]))


def _tex(kind: Kind, text: str) -> str:
    match kind:
        case "sign":
            return f" {SIGNS[text]} " if text in SIGNS else text
        case "tail":
            return TAILS[text]
        case "open":
            return OPENING[text]
        case "close":
            return CLOSING[text]
        case "comma":
            return r",\ "
        case "bar":
            return "|"
        case "function":
            return rf"\{text} "
        case "number":
            return text.replace("°", r"^{\circ}")
        case "label":
            return text.replace("′", "'")
        case "letter":
            return latex_name(text) + " "
        case "unit":
            return rf"~\mathrm{{{numeral(text)}}}"
    return ""


def _stretches(atoms: Sequence[Atom]) -> Iterator[str]:
    start = 0
    while start < len(atoms):
        stop = _end(atoms, start)
        if stop > start:
            yield f"${_formula(atoms[start:stop])}$"
            start = stop
        else:
            yield atoms[start].text
            start += 1


def _end(atoms: Sequence[Atom], start: int) -> int:
    """Where the longest formula that begins here ends; `start`: none does."""
    before = atoms[start - 1].kind if start else "space"
    begins = atoms[start].kind in ("term", "open", "bar", "root", "function", "label", "number", "letter")
    within = atoms[start].kind in ("number", "open") and before not in ("space", "open", "comma")
    if not (begins or _is_minus(atoms, start)) or within:
        return start
    depth, best, bars, terms = 0, start, 0, 0
    for i in range(start, len(atoms)):
        kind = atoms[i].kind
        if kind == "word" or (kind == "comma" and depth == 0):
            break
        depth += (kind == "open") - (kind == "close")
        bars += kind == "bar"
        terms += kind == "term"
        if depth < 0:
            break
        if depth == 0 and bars % 2 == 0 and terms and kind in ENDS:
            best = i + 1
    return best


def _is_minus(atoms: Sequence[Atom], start: int) -> bool:
    """Is it the sign of what follows directly?"""
    if start and atoms[start - 1].kind not in ("space", "open", "comma"):
        return False
    following = atoms[start + 1].kind if start + 1 < len(atoms) else "word"
    own = atoms[start].tex.strip() == "-" and atoms[start].text == atoms[start].text.strip()
    return own and following in ("term", "open", "root", "function")


def _formula(atoms: Sequence[Atom]) -> str:
    found, i = "", 0
    while i < len(atoms):
        atom = atoms[i]
        if atom.kind == "root":
            inside = _argument(atoms, i + 1)
            own = atoms[i + 1 : inside]
            bracketed = own and own[0].kind == "open"
            found += rf"\sqrt{{{_formula(own[1:-1] if bracketed else own)}}}"
            i = inside
            continue
        found += " " if atom.kind == "space" else atom.tex
        i += 1
    return re.sub(r" +", " ", found).strip()


def _argument(atoms: Sequence[Atom], start: int) -> int:
    """Where the argument of a root ends: a bracket, or one term."""
    depth = 0
    for i in range(start, len(atoms)):
        depth += (atoms[i].kind == "open") - (atoms[i].kind == "close")
        if depth == 0 and atoms[i].kind != "space":
            return i + 1
    return len(atoms)
