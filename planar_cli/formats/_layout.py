"""Rows of styled text and how lines are wrapped into them; shared by formats of fixed-width text.

A line may break at a space of its words; inside a formula only if it has to: before an operator, else between two
factors, and inside brackets last, the innermost at the very last.
"""

from __future__ import annotations

import re
import unicodedata
from collections.abc import Iterable, Sequence
from dataclasses import replace

from planar_cli.plain_letters import letters
from planar_cli.records import record
from planar_cli.report.document.blocks import Inline, Line, Math, Name, Relation, Text, Value
from planar_cli.report.notation.names import plain_name, printable
from planar_cli.report.notation.numbers import quantity

# Spaces inside formulas while lines are being filled. `printable` lets neither through from a file.
FIRM = "\N{NO-BREAK SPACE}"
BEFORE_OPERATOR, BETWEEN_FACTORS, IN_BRACKETS, DEEPER = "\ue000", "\ue001", "\ue002", "\ue003"
"""Outside brackets before + - =, and between two factors or before a stroke; inside brackets before an operator, and
inside brackets within these.
"""
LITTLE = 1 / 3
VECTOR = (Text("["), Text(", "), Text("]"))
"""What stands around the components of a vector."""
_INNER_SPACES = str.maketrans(dict.fromkeys((FIRM, BEFORE_OPERATOR, BETWEEN_FACTORS, IN_BRACKETS, DEEPER), " "))


@record
class Span:
    """Text in one style: a `TextStyle`, or "title", "heading", "label", "math", "answer"."""

    text: str
    style: str = "plain"


Row = tuple[Span, ...]


def cells(text: str) -> int:
    """How many columns of a terminal a text takes."""
    if text.isascii():
        return len(text)
    return sum(0 if unicodedata.combining(c) else 2 if unicodedata.east_asian_width(c) in "WF" else 1 for c in text)


def row_cells(row: Iterable[Span]) -> int:
    return sum(cells(s.text) for s in row)


def words(text: str) -> str:
    """Text of a file made harmless: white space is a space, steering characters are replaced."""
    return letters(_harmless(text))


def _harmless(text: str) -> str:
    return printable(re.sub(r"\s", " ", text))


def spans(line: Line) -> list[Span]:
    """A line as styled text; spaces inside formulas, and inside a vector of two numbers, are marked as firm."""
    return [replace(s, text=letters(s.text)) for s in _marked(line)]


def _marked(line: Line) -> list[Span]:
    firm = _in_vectors(line)
    made = [
        (
            isinstance(part, Text),
            Span(_harmless(part.text).replace(" ", FIRM), part.style) if i in firm and isinstance(part, Text) else span,
        )
        for i, part in enumerate(line)
        for span in _spans(part)
    ]
    plain = [False, *(not is_text or _IN_FORMULA.fullmatch(span.text) is not None for is_text, span in made), False]
    inside = [one and other for one, other in zip(plain, plain[2:], strict=False)]
    made = [(t, _factors(span) if t and held else span) for (t, span), held in zip(made, inside, strict=True)]
    whole = "".join(span.text for _, span in made).translate(_INNER_SPACES)
    if not re.search(r"[-+=/·] |[\w′√][(\[]|\[", whole):
        return [span for _, span in made]
    kept, begin, found = _brackets(whole), 0, list[Span]()
    for is_text, span in made:
        text = _held(span.text, whole, begin, kept) if is_text else _component(span.text, kept[begin : begin + 1])
        found.append(Span(text, span.style))
        begin += len(span.text)
    return found


_IN_FORMULA = re.compile(r"[ π²³⁴/\d]+")


def _factors(between: Span) -> Span:
    """Text that only stands between factors, as a space or π, gives way as a formula does."""
    if not _IN_FORMULA.fullmatch(between.text):
        return between
    return Span(between.text.replace(" ", BETWEEN_FACTORS), between.style)


def _component(formula: str, depth: list[int]) -> str:
    """A formula; one that is a component of a vector breaks less readily than the vector at its comma."""
    return formula.replace(BETWEEN_FACTORS, FIRM).replace(BEFORE_OPERATOR, IN_BRACKETS) if depth == [3] else formula


def _brackets(whole: str) -> list[int]:
    """By place: 0 outside brackets, 1 in those about words, 2 in those of a formula, f(x) or T(0, R + r), 3 in those of
    a vector, [1, 2].
    """
    depth, opened = [], list[int]()
    for place, character in enumerate(whole):
        if character in "([":
            formula = character == "[" or re.match(r"[\w′√]", whole[place - 1 : place]) is not None
            opened.append(3 if character == "[" else 2 if formula or max(opened, default=0) > 1 else 1)
        elif character in ")]" and opened:
            opened.pop()
        depth.append(max(opened, default=0))
    return depth


def _held(text: str, whole: str, begin: int, depth: list[int]) -> str:
    """The spaces of words between formulas: firm behind an operator and in the brackets of a formula."""
    return "".join(_between(whole, n, depth[n]) if c == " " else c for n, c in enumerate(text, begin))


def _between(whole: str, place: int, depth: int) -> str:
    """A space of words, by what stands around it."""
    if depth == 3 and whole.startswith(",", place - 1):
        return BEFORE_OPERATOR
    if depth > 1 or (depth and re.match(r"[-+/·] ", whole[place + 1 : place + 3])):
        return IN_BRACKETS
    if re.match(r" [-+=/·]$", whole[place - 2 : place]):
        return FIRM
    begins = whole.startswith("= ", place + 1) and _begins_datum(whole[:place])
    return BEFORE_OPERATOR if begins else " "


def _begins_datum(before: str) -> bool:
    """Is what stands before a sign of equality one letter with which a datum begins?"""
    return re.search(r"(?:^|[,;:] )\S+$", before) is not None


def _in_vectors(line: Line) -> set[int]:
    """Where the comma of [x, y] in numbers stands, and the unit behind it."""
    found = set[int]()
    for i in range(len(line) - 4):
        opened, x, comma, y, closed = line[i : i + 5]
        if (opened, comma, closed) == VECTOR and isinstance(x, Value) and isinstance(y, Value):
            behind = line[i + 5] if len(line) > i + 5 else None
            united = isinstance(behind, Text) and re.fullmatch(r" \S+", behind.text)
            found |= {i + 2, i + 5} if united else {i + 2}
    return found


def side_spans(side: Inline | Line) -> list[Span]:
    """One side of an equation as styled text."""
    return spans(side if isinstance(side, tuple) else (side,))


def _spans(part: Inline) -> list[Span]:
    match part:
        case Text(text, style):
            return [Span(_harmless(text), style)]
        case Name(name):
            return [Span(plain_name(_harmless(name)).replace(" ", FIRM), "math")]
        case Value(number, unit, figures):
            return [Span(quantity(number, unit, figures).replace(" ", FIRM), "math")]
        case Relation(left, relation, right):
            return [*_spans(left), Span(f"{FIRM}{_harmless(relation)}{FIRM}", "math"), *_spans(right)]
        case Math(expr, values):
            from planar_cli.report.notation.notation import plain  # SymPy is loaded only where there is a formula

            return [Span(_firm(plain(expr, values)), "math")]


def _firm(formula: str) -> str:
    """The spaces of a formula made firm, each with what tells how soon it gives way."""
    depth, text = 0, ""
    for place, character in enumerate(formula):
        depth += (character in "([") - (character in ")]")
        text += _space(formula, place, depth) if character == " " else character
    return text


def _space(formula: str, place: int, depth: int) -> str:
    """A space of a formula, by what stands around it."""
    if re.match(r"[-+=] ", formula[place + 1 : place + 3]):
        return (BEFORE_OPERATOR, IN_BRACKETS, DEEPER)[min(depth, 2)]
    if re.match(r"[/·] ", formula[place + 1 : place + 3]):
        return FIRM if depth else BETWEEN_FACTORS
    behind_a_sign = re.search(r"(^|[-+=/·,≤≥<>→]|sin[²³]?|cos[²³]?|tan[²³]?)$", formula[:place])
    return FIRM if depth or behind_a_sign else BETWEEN_FACTORS


def settled(row: Iterable[Span]) -> Row:
    """A finished row: inner spaces are spaces again."""
    return tuple(Span(s.text.translate(_INNER_SPACES), s.style) for s in row if s.text)


def indent(columns: int) -> list[Span]:
    return [Span(" " * columns)] if columns > 0 else []


@record
class _Chunk:
    """What must stay together, and how many spaces stand before it. `begins`: it is the first part of what is wider
    than a row and breaks at no outer operator; it begins a row unless little stands on the last one.
    """

    gap: int
    spans: tuple[Span, ...]
    begins: bool = False


def fill(head: Sequence[Span], content: Sequence[Span], hang: int, width: int) -> list[Row]:
    """Rows that begin with `head` and go on at column `hang`, none wider than `width` where that can be avoided."""
    rows: list[list[Span]] = [list(head)]
    used = row_cells(head)
    start = used
    if used + row_cells(content) <= width:
        return [settled([*head, *content])]
    room = max(width - hang, 8)
    for chunk in _fitting(_chunks(content, " "), room):
        size = row_cells(chunk.spans)
        gap = chunk.gap if used > start else 0
        if used > start and (used + gap + size > width or (chunk.begins and used - start > LITTLE * room)):
            rows.append(indent(hang))
            used = start = hang
            gap = 0
        rows[-1] += [*indent(gap), *chunk.spans]
        used += gap + size
    return [settled(r) for r in rows]


def _chunks(content: Iterable[Span], space: str) -> list[_Chunk]:
    """Content cut at one kind of space."""
    chunks: list[_Chunk] = []
    current: list[Span] = []
    gap = 0
    for span in content:
        for piece in re.findall(f"{space}+|[^{space}]+", span.text):
            if piece[0] != space:
                current.append(Span(piece, span.style))
                continue
            if current:
                chunks.append(_Chunk(gap, tuple(current)))
                current, gap = [], 0
            gap += len(piece)
    return [*chunks, _Chunk(gap, tuple(current))] if current else chunks


def _fitting(chunks: list[_Chunk], room: int) -> list[_Chunk]:
    """Chunks that are wider than the room, cut where they give way first, at last anywhere."""
    for space in (BEFORE_OPERATOR, BETWEEN_FACTORS, IN_BRACKETS, DEEPER, FIRM):
        chunks = [part for c in chunks for part in (_cut(c, space) if row_cells(c.spans) > room else [c])]
        chunks = chunks if space != BEFORE_OPERATOR else [replace(c, begins=row_cells(c.spans) > room) for c in chunks]
    return [part for c in chunks for part in _sliced(c, room)]


def _cut(chunk: _Chunk, space: str) -> list[_Chunk]:
    parts = _chunks(chunk.spans, space)
    return [
        _Chunk(chunk.gap + p.gap, p.spans, chunk.begins) if i == 0 else _Chunk(p.gap, p.spans)
        for i, p in enumerate(parts)
    ]


def _sliced(chunk: _Chunk, room: int) -> list[_Chunk]:
    """A chunk without any space, in slices of the room."""
    if row_cells(chunk.spans) <= room:
        return [chunk]
    slices: list[list[Span]] = [[]]
    used = 0
    for span in chunk.spans:
        for character in span.text:
            size = cells(character)
            if used + size > room:
                slices.append([])
                used = 0
            slices[-1].append(Span(character, span.style))
            used += size
    return [_Chunk(chunk.gap, tuple(s), chunk.begins) if i == 0 else _Chunk(0, tuple(s)) for i, s in enumerate(slices)]
