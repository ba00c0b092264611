"""On which lines of a page its answers rest: from each answer back to the equations it came from.

An answer rests on the line that gives its letter. A line rests on the equations that it names by number, on the lines
before it that give the letters it uses, and, where it is one number divided by another, on the line above. A balance
of energies also rests on the energies and the work that it names: T_1 + U = T_2. Of v_3 = v_2 - g t, solved for t
behind it, v_3 is no result: it came before.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from decimal import Decimal
from itertools import takewhile

from planar_cli.records import record
from planar_cli.report.document.blocks import Answer, Block, Equation, Inline, Line, Math, Name, Result, Text, Value
from planar_cli.report.document.mentioned import names_in, pieces_of
from planar_cli.report.notation.names import plain_name

WORK = "U"
ENERGIES = re.compile(r"(T|E_k)(__\w+)?|U")
NUMBERED = re.compile(r"\((\d+)\)")
PLACEHOLDER = "#"
"""So begins what stands for a number in a formula."""
END = r"(?=[xytnr]?(?:[^A-Za-z0-9]|$))"
"""What may stand behind the name of a body in that of a letter: its component, its state."""
SECOND_RATE = "ddot"
OTHERWISE = ", that is "
"""Behind it an answer is told once more, in another form."""
SAME = Decimal("1e-12")


@record
class Row:
    """One equation of a page. `at`: its place among the blocks; `gives`: the letters that it tells; `uses`: all others
    in it; `refers`: the numbers of the equations that it comes from; `energies`: what a balance names; `leads_on`: a
    product of vectors, or an integral, which the next numbered equation takes up; `law`: an equation of motion.
    """

    at: int
    block: Equation
    gives: frozenset[str]
    uses: frozenset[str]
    refers: frozenset[int]
    energies: frozenset[str]
    leads_on: bool
    integral: bool
    law: bool


def rests_on(blocks: Sequence[Block], places: Mapping[str, str] | None = None) -> frozenset[int] | None:
    """The places of the equations and results on which the answers of a part rest; None: of an answer there is no line
    here that gives it. `places`: the point that each particle is: what a line says of B is true of the collar.
    """
    rows = [_row(i, b) for i, b in enumerate(blocks) if isinstance(b, Equation)]
    rows = _solved_for(_of_points(rows, places or {}))
    needed: list[tuple[Row, int]] = []
    kept: set[int] = set()
    found = True
    for answer in (b for b in blocks if isinstance(b, Answer)):
        if _is_word(answer):
            kept.update(i for i, b in enumerate(blocks) if isinstance(b, Result))
            own = _of_word(blocks, rows)
        else:
            own = _lines_of(answer, rows)
            found &= bool(own)
        needed += [(r, r.at) for r in own]
    while needed:
        row, seen = needed.pop()
        if row.at not in kept:
            kept.add(row.at)
            # What a numbered equation uses may be solved for behind it.
            since = seen if row.block.number is not None else row.at
            needed += [(r, since) for r in _before(row, [r for r in rows if r.at < since and r is not row])]
    return frozenset(kept) if found else None


def _of_points(rows: Sequence[Row], places: Mapping[str, str]) -> list[Row]:
    """The same, where a line that has a letter of a particle which none gives uses that of its point: v_B, v_collar."""
    given = frozenset[str]().union(*(r.gives for r in rows))
    forms = [(re.compile(f"_{re.escape(body)}{END}"), f"_{point}") for body, point in places.items()]
    names = {x: {form.sub(own, x) for form, own in forms} & given for r in rows for x in r.uses - given}
    return [replace(r, uses=r.uses.union(*(names[x] for x in r.uses - given))) for r in rows]


def _solved_for(rows: Sequence[Row]) -> list[Row]:
    """The same, where an equation that is solved for another letter behind it gives none that stood before."""
    known: set[str] = set()
    found: list[Row] = []
    for i, row in enumerate(rows):
        number = row.block.number
        solved = [r.gives for r in rows[i + 1 :] if number is not None and r.refers == {number}]
        told = row.gives & known if solved and solved[0].isdisjoint(row.gives) else frozenset()
        found.append(replace(row, gives=row.gives - told, uses=row.uses | told))
        known |= row.gives
    return found


def _before(row: Row, earlier: Sequence[Row]) -> list[Row]:
    """What one line rests on, of those before it."""
    found: list[Row] = []
    for name in sorted(row.uses):
        found += [r for r in earlier if name in r.gives][-1:]
    for number in sorted(row.refers):
        found += [r for r in earlier if r.block.number == number][-1:]
    own = [r for r in earlier if r.at < row.at]
    if row.energies:
        found += _energies(row, own)
    if row.block.number is not None:
        last = max((r.at for r in own if r.block.number is not None), default=-1)
        found += [r for r in own if r.leads_on and r.at > last]
    # What is integrated, and that of which the frequency is read off.
    laws = [r for r in own if r.law] or [r for r in own if _is_sum(r.block)]
    found += laws[-1:] if row.integral else [r for r in own[-1:] if r.law]
    if not found:
        # A formula that is told once more; one number divided by another; ω_1, a root of an equation for ω.
        stems = {_stem(g) for g in row.gives} | row.gives
        found += ([r for r in own if _ends_alike(r, row)] or [r for r in own if (r.uses | r.gives) & stems])[-1:]
    return found


def _is_sum(block: Equation) -> bool:
    """Is it a sum of forces or moments?"""
    return block.number is not None and any(isinstance(p, Name) and p.name.startswith("Σ") for p in block.lead)


def _ends_alike(one: Row, other: Row) -> bool:
    """Do two lines end in the same formula?"""
    last, own = one.block.sides[-1], other.block.sides[-1]
    return isinstance(last, Math) and isinstance(own, Math) and last.expr == own.expr and not own.expr.is_number


def _energies(row: Row, own: Sequence[Row]) -> Iterator[Row]:
    """The energies that a balance names, and the work since the one before it; none that is zero."""
    since = max((r.at for r in own if r.energies), default=-1)
    told = [r for r in own if not _is_nothing(r.block)]
    yield from (r for r in told if WORK in r.gives & row.energies and r.at > since)
    for name in sorted(row.energies - {WORK}):
        yield from [r for r in told if name in r.gives][-1:]


def _row(at: int, block: Equation) -> Row:
    left, *others = block.sides
    letter = _letter(left)
    second = _letter(others[0]) if len(others) > 1 else ""
    names = frozenset(n for side in (others if letter else block.sides) for n in _names(side))
    sized = bool(letter) and "|" in _words(left)
    integral = any(_is_integral(s) for s in block.sides)
    lead = _words(block.lead)
    heads = {p.name for p in block.lead if isinstance(p, Name)}
    return Row(
        at=at,
        block=block,
        gives=frozenset({letter, second} - {""}),
        uses=names | ({letter} if sized else set()),
        refers=frozenset(int(n) for n in NUMBERED.findall(lead)),
        energies=frozenset(plain_name(h) for h in heads if block.number is not None and ENERGIES.fullmatch(h)),
        leads_on=not letter and (" · " in _words(left) or integral),
        integral=integral,
        law=any(SECOND_RATE in n for n in (names_in(left) if letter else names_in(block.sides))),
    )


def _is_integral(side: Inline | Line) -> bool:
    return any(isinstance(p, Math) and p.expr.func.__name__ == "Integral" for p in pieces_of(side))


def _letter(side: Inline | Line) -> str:
    """The letter that a side is, with words before or behind it; empty: it is more than one letter."""
    pieces = [p for p in (side if isinstance(side, tuple) else (side,)) if not isinstance(p, Text)]
    words = _words(side)
    if len(pieces) != 1 or re.search(r"[-+·×/]\s*$|^\s*[-+·×/]|\d", words):
        return ""
    piece = pieces[0]
    if isinstance(piece, Name):
        return plain_name(piece.name)
    return plain_name(piece.expr.name) if isinstance(piece, Math) and piece.expr.is_Symbol else ""


def _names(side: Inline | Line) -> Iterator[str]:
    for piece in pieces_of(side):
        if isinstance(piece, Name):
            yield plain_name(piece.name)
        elif isinstance(piece, Math):
            # What numbers stand for was told on the side before.
            yield from (plain_name(s.name) for s in piece.expr.free_symbols if not s.name.startswith(PLACEHOLDER))


def _words(side: Inline | Line) -> str:
    return "".join(p.text for p in pieces_of(side) if isinstance(p, Text))


def _is_nothing(block: Equation) -> bool:
    """Does it only say that something is zero?"""
    last = block.sides[-1]
    return len(block.sides) == 2 and isinstance(last, Math) and last.expr == 0


# --- answers ---------------------------------------------------------------------------------------------------------


def _is_word(answer: Answer) -> bool:
    """Is the answer a word: yes, slips?"""
    return answer.relation == ":" and all(isinstance(p, Text) for p in answer.line)


def _of_word(blocks: Sequence[Block], rows: Sequence[Row]) -> list[Row]:
    """What an answer in words was read from: the equation before each result that the page tells."""
    results = [i for i, b in enumerate(blocks) if isinstance(b, Result)]
    return [r for i in results for r in [r for r in rows if r.at < i][-1:]]


def _lines_of(answer: Answer, rows: Sequence[Row]) -> list[Row]:
    """The lines that give an answer: by its letter, that of the solution, or its numbers; of a vector and of several
    modes a line for each number.
    """
    names = set(_names(answer.line))
    letters = {plain_name(answer.name), *(names if len(names) == 1 else ())}
    own = [r for r in rows if letters & r.gives]
    if parts := [r for r in own if ", " in _words(r.block.sides[0])]:
        return parts
    told = [p for p in takewhile(lambda p: p != Text(OTHERWISE), answer.line) if isinstance(p, Math | Value)]
    stems = [r for r in rows if any(_stem(g) in letters for g in r.gives)]
    for lines in (own, stems, [r for r in rows if r.gives], rows):
        if found := [r for p in told for r in [r for r in lines if _tells(r, p)][-1:]]:
            return found
    return own[-1:]


def _stem(name: str) -> str:
    """A printed name without its subscript."""
    return re.split("[_,]", name)[0]


def _tells(row: Row, piece: Math | Value) -> bool:
    """Does a line end in a number or formula of an answer?"""
    ends = [p for side in row.block.sides[1:] for p in pieces_of(side)]
    if isinstance(piece, Math):
        return any(p.expr == piece.expr for p in ends if isinstance(p, Math))
    size = abs(piece.number)
    return any(abs(abs(p.number) - size) <= SAME * size for p in ends if isinstance(p, Value))
