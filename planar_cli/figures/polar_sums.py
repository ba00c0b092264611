"""Velocities and accelerations in polar coordinates, as the vector sums that a page writes: along r and across it.

v_P = ṙ e_r + r ω e_θ,  a_P = r̈ e_r - r ω² e_r + r α e_θ + 2 ṙ ω e_θ, where the page tells a_r and a_θ by these parts.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping, Sequence
from typing import Any

import sympy as sp

from planar_cli.figures.vector_terms import Sum, Term
from planar_cli.records import record
from planar_cli.report.document.blocks import Block, Equation, Inline, Line, Math, Name, Paragraph, Text, line

POLES = (
    re.compile(r"^(?P<place>\S+) in polar coordinates about (?P<pole>[^\s,]+),"),
    re.compile(r"^.*\be_r from (?P<pole>\S+) to (?P<place>[^\s,]+),"),
    re.compile(r"^Polar coordinates of (?P<place>\S+) about (?P<pole>[^\s,:]+)"),
    re.compile(r"^Distance of (?P<place>\S+) from (?P<pole>[^\s,:]+):"),
)
"""The sentences in which a page says about which point it counts r, and of which."""
VECTOR = re.compile(r"(?P<letter>[va])_(?P<index>[^\s′²_]+)(?:_vec)?")
PARTS = ("r", "theta")
"""v_r and v_θ, a_r and a_θ."""
OUTWARD = re.compile(r"^r(_\w+)?_ddot$")
RADIAL = re.compile(r"^(r(_\w+)?_dot|v_r)$")
SPEEDING = re.compile(r"_ddot$|^alpha")


@record
class _Part:
    """Something along e_r, or across it. `sign`, `words`: as the page has it; `letters`: the names in it."""

    radial: bool
    sign: int
    words: Line
    letters: frozenset[str]

    def kind(self, letter: str) -> str:
        """What it is of the motion."""
        if self.letters & {f"{letter}_{p}" for p in PARTS} and len(self.letters) == 1:
            return "radial" if self.radial else "across"
        if letter == "v":
            return "radial" if self.radial else "across"
        if self.radial:
            return "outward" if any(map(OUTWARD.match, self.letters)) else "inward"
        speeding = any(map(SPEEDING.search, self.letters))
        return "coriolis" if any(map(RADIAL.match, self.letters)) and not speeding else "speeding"


def polar_sums(blocks: Sequence[Block]) -> dict[str, Sum]:
    """The sums of some blocks in polar coordinates, by the names of their vectors."""
    told = [b for b in blocks if isinstance(b, Equation) and b.relation == "="]
    components = _components(told)
    found: dict[str, Sum] = {}
    poles = dict(_poles(blocks))
    for block in told:
        name = _name(block.sides[0])
        vector = VECTOR.fullmatch(name)
        place = vector["index"] if vector is not None else ""
        for side in block.sides[1:] if place in poles else ():
            parts = list(_parts(side if isinstance(side, tuple) else (side,)))
            if parts:
                found.setdefault(name, _sum(name, parts, (place, poles[place]), components))
    if not found and len(poles) == 1:
        # The page tells the components alone: of what these are made, no other figure shows.
        ((place, pole),) = poles.items()
        if {f"a_{p}" for p in PARTS} <= components.keys():
            parts = [_whole("a", p) for p in PARTS]
            found[f"a_{place}"] = _sum(f"a_{place}", parts, (place, pole), components)
    return found


def _whole(letter: str, part: str) -> _Part:
    name = f"{letter}_{part}"
    return _Part(part == "r", 1, line(Name(name)), frozenset({name}))


def _sum(name: str, parts: Sequence[_Part], arm: tuple[str, str], components: Mapping[str, sp.Expr]) -> Sum:
    opened = [one for part in parts for one in _opened(part, name[0], components)]
    return Sum(name, tuple(Term("polar", 1, p.words, p.kind(name[0]), arm=arm, letter=name[0]) for p in opened))


def _opened(part: _Part, letter: str, components: Mapping[str, sp.Expr]) -> Iterator[_Part]:
    """a_r as r̈ - r ω², where the page writes that."""
    own = next((components[n] for n in part.letters if n in components and len(part.letters) == 1), None)
    terms = sp.Add.make_args(own) if own is not None else ()
    made = [_term(part.radial, part.sign, t) for t in terms]
    kinds = [p.kind(letter) for p in made]
    # Of a_r = -a_θ/tan θ the parts are not told.
    mixed = any(n.startswith(f"{letter}_") for p in made for n in p.letters)
    yield from made if made and letter == "a" and len(set(kinds)) == len(kinds) and not mixed else [part]


def _term(radial: bool, sign: int, expr: sp.Expr) -> _Part:
    back = expr.could_extract_minus_sign()
    size = -expr if back else expr
    return _Part(radial, -sign if back else sign, line(Math(size)), frozenset(str(s.name) for s in size.free_symbols))


def _components(told: Sequence[Equation]) -> dict[str, sp.Expr]:
    """a_r = r̈ - r ω² and its like, by the name."""
    found: dict[str, sp.Expr] = {}
    for block in told:
        name, first = _name(block.sides[0]), block.sides[-1] if len(block.sides) < 2 else block.sides[1]
        letter, _, part = name.partition("_")
        if letter in ("v", "a") and part in PARTS and isinstance(first, Math) and not first.values:
            found.setdefault(name, sp.sympify(first.expr))
    return found


def _name(side: Any) -> str:
    """What stands alone on a side."""
    pieces = [p for p in (side if isinstance(side, tuple) else (side,)) if not isinstance(p, Text) or p.text.strip()]
    if len(pieces) != 1:
        return ""
    (one,) = pieces
    if isinstance(one, Math):
        return str(one.expr.name) if one.expr.is_Symbol else ""
    return one.name if isinstance(one, Name) else ""


def _parts(side: Line) -> Iterator[_Part]:
    """What a side has along e_r and across it; nothing where it is no such sum in letters."""
    sign, before = 1, list[Inline]()
    for piece in side:
        match piece:
            case Text(text=text):
                signs = [c for c in text if c in "+-"]
                sign = (-1 if signs[-1] == "-" else 1) if signs else sign
                if re.sub(r"[\s()+-]", "", text):
                    return
            case Name(name=name) if name.startswith("e_"):
                yield from _of_unit(name == "e_r", sign, before)
                sign, before = 1, []
            case Name() | Math(values=None):
                before.append(piece)
            case _:
                return


def _of_unit(radial: bool, sign: int, before: Sequence[Inline]) -> Iterator[_Part]:
    if len(before) == 1 and isinstance(one := before[0], Math):
        yield from (_term(radial, sign, t) for t in sp.Add.make_args(sp.sympify(one.expr)))
        return
    letters = {p.name for p in before if isinstance(p, Name)}
    letters |= {str(s.name) for p in before if isinstance(p, Math) for s in p.expr.free_symbols}
    yield _Part(radial, sign, line(*(x for p in before for x in (" ", p)))[1:], frozenset(letters))


def _poles(blocks: Sequence[Block]) -> Iterator[tuple[str, str]]:
    """The points in polar coordinates, by their letters, with the points about which."""
    for block in blocks:
        if isinstance(block, Paragraph):
            told = "".join(p.text if isinstance(p, Text) else p.name if isinstance(p, Name) else "" for p in block.line)
            for sentence in POLES:
                if (found := sentence.match(told)) is not None:
                    yield found["place"], found["pole"]
