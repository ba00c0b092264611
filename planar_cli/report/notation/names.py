"""How a name of a file reads in mathematics: `omega_AB` as ω_AB, `v_D_AB` as v_D/AB; plain text and LaTeX.

A name is a stem and pieces behind underscores; behind two underscores stands the state that it belongs to. Of a
position, velocity or acceleration two pieces in capitals mean "relative to"; a component or an instant clings to the
piece before it; other pieces are set off with a comma. A name that is a phrase stays as its author wrote it. What an
earlier case found, `limit.a_max`, reads as it did there: a_max.
"""

from __future__ import annotations

import re
from functools import lru_cache

from planar_cli.greek import GREEK
from planar_cli.records import record

_WORD = re.compile(r"[a-z]{3,}")
_OF_CASE = re.compile(r"^[^\W\d]\w*\.(?=[^\W\d])")
_LATEX_OF = {letter: "\\" + word for word, letter in GREEK.items()} | {"ṙ": r"\dot{r}"}
_RELATIVE = frozenset({"r", "v", "a", "omega", "alpha"})
"""What can be relative to something; J_N_C is an impulse of N at C."""
_PREPOSITIONS = frozenset("from at to of in on by per with after before until".split())
_COMPONENTS = frozenset({"x", "y", "t", "n", "r", "theta"})
_DOTS = {
    "dot": ("\N{COMBINING DOT ABOVE}", r"\dot"),
    "ddot": ("\N{COMBINING DIAERESIS}", r"\ddot"),
    "vec": ("\N{COMBINING RIGHT ARROW ABOVE}", r"\vec"),
}
"""What stands over a letter: a rate, a second rate, a vector."""
_SPECIAL = {
    "\\": r"\backslash ",
    "{": r"\lbrace ",
    "[": r"\lbrack ",
    "]": r"\rbrack ",
    "}": r"\rbrace ",
    "~": r"\sim ",
    "^": r"\wedge ",
    "#": r"\#",
    "$": r"\$",
    "%": r"\%",
    "&": r"\&",
    "_": r"\_",
    "<": r"\lt ",
    ">": r"\gt ",
    "`": r"\prime ",
    "′": "'",
    "″": "''",
}


@record
class _Parts:
    """A name taken apart; `subscript` holds Unicode text, `dot` is "", "dot" or "ddot"."""

    prefix: str
    stem: str
    subscript: str
    dot: str
    prime: bool


def printable(text: str) -> str:
    """The text without characters that steer a terminal or turn the reading direction."""
    return "".join(c if c.isprintable() else "\N{REPLACEMENT CHARACTER}" for c in text)


def index_of(place: str) -> str:
    """A place as an index: the mass centre G_AB as G,AB, the point O_B as O,B; a stroke would be a relative motion."""
    return place.replace("_", ",")


def plain_name(name: str) -> str:
    """A name in Unicode plain text."""
    parts = _parts(name)
    mark = _DOTS[parts.dot][0] if parts.dot else ""
    subscript = f"_{parts.subscript}" if parts.subscript else ""
    stem, digits = _trailing_digits(parts.stem) if mark else (parts.stem, "")
    return f"{parts.prefix}{stem}{mark}{digits}{subscript}{'′' if parts.prime else ''}"


def latex_name(name: str) -> str:
    """A name in LaTeX mathematics; a phrase upright."""
    parts = _parts(name)
    if "_" in parts.stem:
        return rf"\mathrm{{{''.join(_SPECIAL.get(c, c) for c in parts.stem)}}}"
    stem, digits = _trailing_digits(parts.stem)
    body = _letters(stem)
    if parts.dot:
        body = f"{_DOTS[parts.dot][1]}{{{body}}}"
    subscript = ",".join(p for p in (digits, parts.subscript) if p)
    prime = "'" if parts.prime else ""
    tail = f"_{{{_letters(subscript)}}}" if subscript else ""
    return f"{_letters(parts.prefix)} {body}{tail}{prime}" if parts.prefix else f"{body}{tail}{prime}"


def stem(name: str) -> str:
    """The quantity of a name without subscripts, digits and primes: `omega` of `omega_AB`, `m` of `m1` and `m′`."""
    return _trailing_digits(name.split("_", 1)[0].rstrip("′"))[0]


@lru_cache(maxsize=4096)
def _parts(name: str) -> _Parts:
    name, _, state = _OF_CASE.sub("", printable(name)).partition("__")
    first, *pieces = name.split("_")
    words = len(pieces) > 1 and first not in GREEK and _WORD.fullmatch(first) and not {"prime", *_DOTS} & set(pieces)
    if not state and (words or _PREPOSITIONS & set(pieces[:-1])):
        # A phrase such as `rain_speed_seen` or `r_A2_from_A` stands as its author wrote it.
        return _Parts("", name, "", "", False)
    prefix = ""
    if first.startswith("Σ") and len(first) > 1:
        prefix, first = "Σ", first[1:]
    elif first == "Delta" and pieces:
        prefix, first = "Δ", pieces.pop(0)
    dot = next((p for p in pieces if p in _DOTS), "")
    prime = "prime" in pieces
    kept = [p for p in pieces if p and p != "prime" and p not in _DOTS]
    subscript = ",".join(p for p in (_subscript(kept, first in _RELATIVE), _greek(state)) if p)
    return _Parts(prefix, _greek(first), subscript, dot, prime)


def _subscript(pieces: list[str], may_be_relative: bool) -> str:
    """The pieces behind the underscores as one subscript; `may_be_relative`: two of them may be joined by a stroke."""
    places = [p for p in pieces if p not in _COMPONENTS and not p.isdigit()]
    relative = may_be_relative and len(places) == 2 and places == pieces[:2] and all(p[0].isupper() for p in places)
    text = "/".join(map(_greek, pieces[:2])) if relative else ""
    rest = pieces[2:] if relative else pieces
    before = text
    for piece in rest:
        text += ("" if not text or _clings(before, piece) else ",") + _greek(piece)
        before = piece
    return text


def _clings(before: str, piece: str) -> bool:
    """Does a component or an instant stand directly behind the piece before it?"""
    return (piece in _COMPONENTS or piece.isdigit()) and len(before) <= 2 and not before.isdigit()


def _greek(word: str) -> str:
    letters, digits = _trailing_digits(word)
    return GREEK[letters] + digits if letters in GREEK else word


def _trailing_digits(word: str) -> tuple[str, str]:
    """`theta1` as theta and 1; a word of digits only stays whole."""
    match = re.fullmatch(r"(.*?\D)(\d+)", word)
    return (match[1], match[2]) if match else (word, "")


def _letters(text: str) -> str:
    """Text for LaTeX: Greek letters by command, words upright, single letters and capitals in italics."""
    return "".join(_run(r) for r in re.findall(r"[a-z]{2,}|[A-Z]?[a-z]{3,}|.", text)).rstrip()


def _run(run: str) -> str:
    if len(run) > 1:
        return rf"\mathrm{{{run}}}"
    if run in _LATEX_OF:
        return _LATEX_OF[run] + " "
    return _SPECIAL.get(run, run)
