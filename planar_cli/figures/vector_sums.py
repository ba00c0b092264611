"""The vector equations of a page, taken apart: v_P = v_P′ + v_rel, a_B = a_A + α × r_B/A - ω² r_B/A."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence

import sympy as sp

from planar_cli.figures.polar_sums import polar_sums
from planar_cli.figures.vector_terms import Kind, Sum, Term
from planar_cli.report.document.blocks import Block, Equation, Inline, Line, Math, Name, Paragraph, Text

VECTOR = re.compile(r"(?P<letter>[va])_(?P<index>[^\s′²_]+)(?P<prime>′?)(?:_vec)?")
ARM = re.compile(r"r_(?P<end>[^\s/]+)/(?P<start>[^\s/]+?)(?:_vec)?")
UNIT = re.compile(r"[eun](?:_\w+)?")
SIGNS = {"+": 1, "-": -1}
SHAPES: dict[str, Kind] = {
    "V": "named",
    "VU": "named",
    "MXR": "cross",
    "MR": "square",
    "2MXV": "doubled",
    "2MXVU": "doubled",
    "2MXMU": "doubled",
    "MU": "along",
}
"""What a term is by the kinds of its pieces: V vector, U unit vector, R arm, M formula, X cross."""


def vector_sums(blocks: Sequence[Block]) -> list[Sum]:
    """The vector equations of some blocks, each once: in polar coordinates, then others; also those in sentences."""
    polar = polar_sums(blocks)
    cartesian = (s for b in blocks for s in _sums(b) if s.name not in polar)
    return list({repr(s): s for s in (*polar.values(), *cartesian)}.values())


def _sums(block: Block) -> Iterator[Sum]:
    if isinstance(block, Equation) and block.relation == "=":
        left = [p for p in _line(block.sides[0]) if not isinstance(p, Text) or p.text.strip()]
        if len(left) == 1 and isinstance(name := left[0], Name) and VECTOR.fullmatch(name.name):
            for side in block.sides[1:]:
                yield from _sum(name.name, _line(side))
    if isinstance(block, Paragraph):
        for i, piece in enumerate(block.line[:-1]):
            follows = block.line[i + 1]
            equal = isinstance(follows, Text) and follows.text.startswith(" = ")
            if equal and isinstance(piece, Name) and VECTOR.fullmatch(piece.name):
                yield from _sum(piece.name, tuple(_sentence(block.line[i + 1 :])))


def _line(side: Inline | Line) -> Line:
    return side if isinstance(side, tuple) else (side,)


def _sentence(pieces: Line) -> Iterator[Inline]:
    """The right side of an equation in a sentence, up to what ends it there."""
    for i, piece in enumerate(pieces):
        text = piece.text.removeprefix(" =") if isinstance(piece, Text) and not i else ""
        if isinstance(piece, Text):
            kept = re.split("[,;:]", text or piece.text)
            yield Text(kept[0])
            if len(kept) > 1:
                return
        else:
            yield piece


def _sum(name: str, side: Line) -> Iterator[Sum]:
    """Nothing of a side that is no sum of vectors, as one in components."""
    terms = [_term(sign, words) for sign, words in _signed(side)]
    known = [t for t in terms if t is not None]
    if not terms or len(known) < len(terms):
        return
    taken = [t for t in known if t.kind == "named" and t.sign < 0]
    if taken:
        # v_rel = v_P - v_P′ is v_P = v_P′ + v_rel.
        wholes = [t for t in known if t not in taken]
        if len(wholes) == 1 and wholes[0].kind == "named":
            parts = [Term("named", 1, t.words, t.name) for t in taken]
            yield Sum(wholes[0].name, (*parts, Term("named", 1, (Name(name),), name)))
    elif len(known) > 1 or known[0].kind != "named":
        yield Sum(name, tuple(known))


def _signed(side: Line) -> Iterator[tuple[int, Line]]:
    """The terms of a side with their signs."""
    sign, term = 1, list[Inline]()
    for piece in side:
        for part in _split(piece):
            if isinstance(part, Text) and part.text in SIGNS:
                if term:
                    yield sign, tuple(term)
                sign, term = SIGNS[part.text], []
            else:
                term.append(part)
    if term:
        yield sign, tuple(term)


def _split(piece: Inline) -> Iterator[Inline]:
    """A piece, text by its words."""
    if isinstance(piece, Text):
        yield from (Text(word, piece.style) for word in piece.text.split())
    else:
        yield piece


def _term(sign: int, words: Line) -> Term | None:
    """None: it is no vector."""
    shape = "".join(map(_kind, words))
    kind = SHAPES.get(shape) or ("other" if re.fullmatch(r"[VNMT]+U", shape) else None)
    if kind is None:
        return None
    names = [p.name for p in words if isinstance(p, Name)]
    formulas = [sp.sympify(p.expr) for p in words if isinstance(p, Math)]
    vector = next((n for n in names if VECTOR.fullmatch(n)), "")
    arm = next((m for n in names if (m := ARM.fullmatch(n)) is not None), None)
    unit = names[-1] if shape.endswith("U") else ""
    return Term(
        kind,
        sign,
        words,
        vector,
        formulas[0] if formulas and kind != "along" else sp.S.Zero,
        formulas[-1] if shape.endswith("MU") else sp.S.Zero,
        unit,
        (arm["end"], arm["start"]) if arm is not None else ("", ""),
    )


def _kind(piece: Inline) -> str:
    match piece:
        case Math(values=values):
            # Numbers in place of letters: the components of a vector.
            return "?" if values else "M"
        case Name(name=name):
            return (
                "V" if VECTOR.fullmatch(name) else "R" if ARM.fullmatch(name) else "U" if UNIT.fullmatch(name) else "N"
            )
        case Text(text=text):
            return {"×": "X", "2": "2"}.get(text, "T" if text.startswith("/") else "?")
        case _:
            return "?"
