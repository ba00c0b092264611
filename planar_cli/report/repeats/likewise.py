"""What is the same of several bodies but for their names is told of the first; of the others, whom it is told of.

crank_1, moments about O1:
  (6)  ↺ ΣM_O1:   -1/2 m g l cos β - l B1_t = I_O1 α_crank,1
Likewise crank_2 (O2, B2), crank_3 (O3, B3), crank_4 (O4, B4): (7) to (9).
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from dataclasses import replace
from itertools import chain

from planar_cli.problem.scene.scene import Problem
from planar_cli.records import record
from planar_cli.report.answers.sizes_listed import with_sizes_listed
from planar_cli.report.document.blocks import (
    Answer,
    Block,
    Equation,
    Forces,
    Line,
    Math,
    Name,
    Paragraph,
    Text,
    Value,
    line,
)
from planar_cli.report.document.mentioned import pieces_of
from planar_cli.report.document.said import letter_of
from planar_cli.report.equations.results import numbered
from planar_cli.report.notation.names import plain_name
from planar_cli.report.notation.numbers import significant
from planar_cli.report.repeats.components_listed import with_components_listed
from planar_cli.report.repeats.same_body import with_axes_alone

LEAST, LONGEST, SAVED, OF_POINTS = 3, 4, 3, 1
"""Fewer units are told one by one; a unit has no more blocks; more rows of a page are saved, of points with their arms
and of moments of inertia one at least.
"""
ROW = 95
"""About how many characters fill a row."""
NUMBER, COMMA = re.compile(r"\((\d+)\)"), re.compile(r"(?<=\w),(?=\w)")
ARM = "r_"
"""Begins the name of an arm, which stands beside the equation of a point."""


def told_likewise(blocks: Sequence[Block], problem: Problem) -> list[Block]:
    """The blocks of a page; bodies that are alike only of a problem with three at least."""
    blocks = with_axes_alone(with_sizes_listed(blocks))
    if len(problem.bodies) < LEAST:
        return blocks
    names = _Names.of(problem)
    asked = [b for b in blocks if isinstance(b, Answer)]
    answers = frozenset(n for a in asked for n in (plain_name(a.name), letter_of(a.line[:1])) if n)
    found: list[Block] = []
    blocks = with_components_listed(blocks, answers)
    start = 0
    while start < len(blocks):
        size, units = _units(blocks, start, names)
        few = bool(units) and (_are_points(units[0]) or _is_inertia(blocks[start]))
        least = OF_POINTS if few else SAVED
        told = _told(units, names, answers) if sum(map(_rows, units[1:])) > least else None
        if told is None:
            found.append(blocks[start])
            start += 1
        else:
            found += [*blocks[start : start + size], Paragraph(told)]
            start += size * len(units)
    return found


@record
class _Names:
    """The names of a file: bodies, points, and what it gives, in the order in which they are told of."""

    order: tuple[str, ...]
    things: frozenset[str]
    pattern: re.Pattern[str]
    texts: dict[int, str]
    """What blocks of the page say, by their identity: each is looked at with its neighbours several times."""

    def text(self, block: Block) -> str:
        """What a block says, but for its numbers."""
        if id(block) not in self.texts:
            self.texts[id(block)] = _text(block)
        return self.texts[id(block)]

    @classmethod
    def of(cls, problem: Problem) -> _Names:
        things = [*(b.name for b in problem.bodies), *(p.name for p in problem.points)]
        order = tuple(dict.fromkeys([*things, *(s.name for s in (*problem.given, *problem.symbols))]))
        longest = sorted(order, key=len, reverse=True)
        pattern = re.compile(rf"(?<![A-Za-z0-9])(?:{'|'.join(map(re.escape, longest))})(?![A-Za-z0-9])")
        return cls(order, frozenset(things), pattern, {})


@record
class _Unit:
    """Blocks that are told of one body: what they say without its names, and its names."""

    blocks: tuple[Block, ...]
    form: str
    names: tuple[str, ...]

    @classmethod
    def of(cls, blocks: Sequence[Block], names: _Names) -> _Unit:
        text = "\n".join(map(names.text, blocks))
        own = tuple(dict.fromkeys(names.pattern.findall(text)))
        form = names.pattern.sub(lambda m: f"‹{own.index(m[0])}›", text)
        return cls(tuple(blocks), NUMBER.sub("(#)", form), own)


def _is_inertia(block: Block) -> bool:
    """Is it the line of a moment of inertia?"""
    lead = block.lead[:1] if isinstance(block, Equation) and block.number is None else ()
    return bool(lead) and isinstance(lead[0], Text) and lead[0].text.startswith("moment of inertia of ")


def _units(blocks: Sequence[Block], start: int, names: _Names) -> tuple[int, list[_Unit]]:
    """The units from there on that are alike, and how many blocks one has: as many blocks in all as can be."""
    best: tuple[int, list[_Unit]] = (1, [])
    for size in range(1, LONGEST + 1):
        first = blocks[start : start + size]
        if len(first) < size or not _is_unit(first):
            continue
        units = [_Unit.of(first, names)]
        while _is_like(units[0], other := blocks[(at := start + size * len(units)) : at + size], names):
            units.append(_Unit.of(other, names))
        if len(units) >= LEAST and size * len(units) > best[0] * len(best[1]):
            best = (size, units)
    return best


def _rows(unit: _Unit) -> int:
    """About how many rows of a page it fills."""
    return sum(1 + len(_text(b, whole=True)) // ROW for b in unit.blocks)


def _is_unit(blocks: Sequence[Block]) -> bool:
    """Do they say something, to the end?"""
    return all(isinstance(b, Equation | Forces | Paragraph) for b in blocks) and not isinstance(blocks[-1], Paragraph)


def _is_like(first: _Unit, blocks: Sequence[Block], names: _Names) -> bool:
    """Do blocks say the same of another body?"""
    if [type(b) for b in blocks] != [type(b) for b in first.blocks]:
        return False
    unit = _Unit.of(blocks, names)
    other = any(a != b and a in names.things for a, b in zip(first.names, unit.names, strict=False))
    return unit.form == first.form and other


def _text(block: Block, whole: bool = False) -> str:
    """What a block says, but for its numbers; of an arm that stands beside it only the name, unless `whole`."""
    match block:
        case Equation(sides, number, lead, note):
            arm = note[:1] if _arm(note) and not whole else note
            head = "" if whole else f"{number is None} "
            return f"{head}{' = '.join(_said(side) for side in sides)} {_said(lead)} {_said(arm)}"
        case Forces(body, left, right):
            return f"{body}: {_said(left)} = {_said(right)}"
    return _said(getattr(block, "line", ()))


def _said(parts: object) -> str:
    return "".join(_piece(p) for p in pieces_of(parts))


def _piece(piece: object) -> str:
    match piece:
        case Text(text):
            return COMMA.sub("_", text)
        case Name(name):
            return COMMA.sub("_", name)
        case Math(expr):
            return COMMA.sub("_", str(expr))
        case Value(_, unit):
            # No letter of a unit is a name: m of kg·m² is no mass.
            return f"# {'.'.join(str(ord(c)) for c in unit)}"
    return repr(piece)


def _arm(note: Line) -> bool:
    return bool(note) and isinstance(note[0], Name) and note[0].name.startswith(ARM)


# --- what is told of the others --------------------------------------------------------------------------------------


def _told(units: Sequence[_Unit], names: _Names, answers: frozenset[str]) -> Line | None:
    """The sentence that stands for all units but the first; None: they are told one by one."""
    first, *others = units
    lefts = [b for u in others for b in u.blocks if isinstance(b, Equation)]
    if _are_points(first):
        return _of_points([b for u in units for b in u.blocks if isinstance(b, Equation)], len(first.blocks))
    if any(letter_of(b.sides[0]) in answers for b in lefts):
        return None
    numbers = [b.number for b in lefts if b.number is not None]
    valued = [b for b in lefts if isinstance(b.sides[-1], Value)]
    if lefts and not numbers and all(isinstance(b, Equation) for b in first.blocks):
        return _of_results(lefts, [b for b in first.blocks if isinstance(b, Equation)])
    if valued or (lefts and not numbers):
        return None
    whom = [line(_whom(first, u, names)) for u in others]
    return line("Likewise ", *_listed(whom), f": {numbered(numbers)}." if numbers else ".")


def _of_results(told: Sequence[Equation], first: Sequence[Equation]) -> Line | None:
    """`B3_t = B4_t = -0.5839 N from (8) and (9)`; their letters alone, where they have no value."""
    leads = [_cited(b) for b in told]
    if any(len(cited) > 1 for cited in leads):
        return None
    cited = f" from {numbered([n for c in leads for n in c])}" if any(leads) else ""
    if not isinstance(told[0].sides[-1], Value):
        return line("Likewise ", *_listed([line(b.sides[0]) for b in told]), f"{cited}.") if cited else None
    if len({_read(line(b.sides[-1])) for b in (*first, *told)}) == 1:
        letters = line(*(p for b in told for p in (" = ", *line(b.sides[0]))))
        return line("Likewise ", *letters[1:], " = ", told[-1].sides[-1], f"{cited}.")
    return line("Likewise ", *_listed([line(b.sides[0], " = ", b.sides[-1]) for b in told]), f"{cited}.")


def _of_points(told: Sequence[Equation], first: int) -> Line:
    """`a_C with r_C/B = [0.2819, -0.1026] m` for each point but the `first` ones, with its value where it has one."""
    arms = [_bare(b.note[max((i for i, p in enumerate(b.note) if _opens(p)), default=1) :]) for b in told]
    others = told[first:]
    if len({_read(arm) for arm in arms}) == 1 and all(len(b.sides) == 2 for b in others):
        same = ", with arms of the same components." if arms[0] else "."
        return line("Likewise ", *_listed([line(b.sides[0]) for b in others]), same)
    entries = []
    for b, arm in zip(others, arms[first:], strict=True):
        value = (" = ", b.sides[-1]) if len(b.sides) > 2 else ()
        entries.append(line(b.sides[0], *value, *((" with ", b.note[0], " = ", *arm) if arm else ())))
    return line("Likewise ", *_listed(entries), ".")


def _are_points(unit: _Unit) -> bool:
    """Are they vector equations of points?"""
    return all(isinstance(b, Equation) and b.number is None and not b.lead and _vector(b) for b in unit.blocks)


def _vector(block: Equation) -> bool:
    """Is it the vector equation of a point?"""
    left = block.sides[0]
    named = isinstance(left, tuple) and isinstance(left[0], Name) and not block.note
    return named or _arm(block.note)


def _bare(arm: Line) -> Line:
    """Without the equals sign before it."""
    first = arm[0] if arm else None
    return (replace(first, text=first.text.removeprefix(" = ")), *arm[1:]) if isinstance(first, Text) else arm


def _opens(piece: object) -> bool:
    return isinstance(piece, Text) and piece.text.startswith("[")


def _read(parts: Line) -> str:
    """What tells vectors that read alike."""
    return "".join(significant(p.number, p.figures) if isinstance(p, Value) else _piece(p) for p in parts)


def _whom(first: _Unit, other: _Unit, names: _Names) -> str:
    """The names that stand in place of those of the first: crank_2 (O2, B2)."""
    changed = {b for a, b in zip(first.names, other.names, strict=True) if a != b}
    head, *more = [n for n in names.order if n in changed]
    return f"{head} ({', '.join(more)})" if more else head


def _cited(block: Equation) -> list[int]:
    """The numbers of the equations from which a line follows."""
    return [int(n) for n in NUMBER.findall(_said(block.lead))]


def _listed(entries: Sequence[Line]) -> Iterator[Line]:
    return chain.from_iterable((line(", "), e) if i else (e,) for i, e in enumerate(entries))
