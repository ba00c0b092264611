"""What stands at the head of a page: what is given, what is asked, and which principle leads there, with the reason."""

from __future__ import annotations

from collections.abc import Collection, Iterator, Sequence

import sympy as sp

from planar_cli.equation.values.ledger import Ledger
from planar_cli.problem.checks.unused import unused
from planar_cli.problem.language.expression import Name as Letter
from planar_cli.problem.scene.scene import Problem, Symbol
from planar_cli.report.document.blocks import Block, Line, Name, Note, Text, Value, line
from planar_cli.report.document.lettered import lettered
from planar_cli.report.document.mentioned import Mentioned, mentioned
from planar_cli.report.given.given import given_rows, idle_inertias, idle_masses
from planar_cli.report.page.principles import principles
from planar_cli.report.page.uses import Uses
from planar_cli.report.words.points_by_bodies import points_by_bodies
from planar_cli.report.words.sides import AS_WRITTEN, number_of, said
from planar_cli.report.words.words import Phrases

IDLE = (idle_masses, idle_inertias)
"""What may be given of bodies and not be needed."""
MOST_GIVEN = 18
"""More data are in the file, and not on the page."""
GRAVITY = "g"
MOST_PIECES = 24
"""A formula of the file of more pieces is given by its value alone."""


def opening_notes(
    problem: Problem,
    blocks: Sequence[Block],
    uses: Uses,
    phrases: Phrases | None,
    figures: int,
    drawn: Sequence[Line] = (),
) -> Iterator[Note]:
    """Given, find and principle. `blocks`: the page, whose data are told; `uses`: on what it rests; `phrases`: with the
    numbers of the first instant, where there is one; `drawn`: what is told of the drawing besides.
    """
    seen = mentioned(blocks)
    aside = frozenset() if seen.summed else uses.drawn - seen.letters
    yield from _given([*_rows(problem, seen, phrases, figures, aside), drawn])
    names = dict.fromkeys(f.name for f in problem.find)
    if names:
        yield Note("Find", _listed([line(Name(n)) for n in names]))
    if told := principles(uses, blocks):
        yield Note("Principle", line(*(p for i, t in enumerate(told) for p in (*([" "] if i else []), *lettered(t)))))


def not_used(problem: Problem, blocks: Sequence[Block], figures: int) -> Iterator[Note]:
    """What the file gives and nothing rests on: letters, surfaces, masses and inertias of which the page has none."""
    seen, parts = mentioned(blocks), (problem, *(case.problem for case in problem.cases))
    masses = dict.fromkeys(m for part in parts for of in IDLE for m in of(part, seen, figures))
    if surplus := [*(line(name) for name in unused(problem)), *masses]:
        yield Note("Not used", line(*_listed(surplus), ": not needed here"))


def changed_notes(
    problem: Problem,
    case: Problem,
    blocks: Sequence[Block],
    phrases: tuple[Phrases | None, Phrases | None],
    figures: int,
) -> Iterator[Note]:
    """What a case gives otherwise than the file, or besides. `phrases`: of the file, and of the case."""
    seen = mentioned(blocks)
    before = {datum for row in _rows(problem, seen, phrases[0], figures) for datum in row}
    names = {f"{s.name}: " for s in case.states}
    yield from _given([_changed(row, before, names) for row in _rows(case, seen, phrases[1], figures)])


def _changed(row: Sequence[Line], before: Collection[Line], names: Collection[str]) -> list[Line]:
    """What of a row is new, behind the name of its state. `names`: how the rows of states begin."""
    new = [d for d in row if d not in before]
    opens = row[0][0] if row and row[0] else None
    if new and new[0] != row[0] and isinstance(opens, Text) and opens.text in names:
        new[0] = line(opens, *new[0])
    return new


def _rows(
    problem: Problem, seen: Mentioned, phrases: Phrases | None, figures: int, aside: Collection[str] = ()
) -> list[Sequence[Line]]:
    """All that a file gives: its letters, then what has none. `aside`: letters that only place what is drawn."""
    letters = [d for s in problem.given if s.name not in aside and (d := _datum(s, phrases, figures))]
    numbers, *others = given_rows(problem, seen, figures)
    if others and any(s.name in aside for s in problem.given):
        others[:1] = [(told,) for told in points_by_bodies(problem, seen)]
    return [
        [
            *letters,
            *(line(Name(s.name)) for s in problem.symbols),
            *numbers,
            *_gravity(problem, seen, phrases, figures),
        ],
        *others,
    ]


def _gravity(problem: Problem, seen: Mentioned, phrases: Phrases | None, figures: int) -> Iterator[Line]:
    """g, where the file does not give it and its number is put into a formula, or weights are integrated."""
    if any(s.name == GRAVITY for s in (*problem.given, *problem.symbols)):
        return
    if phrases is None and seen.integrated and problem.plane == "vertical":
        ledger = Ledger(us=problem.us)
        ledger.gravity(letter=False)
        earth = Phrases(ledger, ledger.valuations(lambda _: True)[0], figures, False)
        yield line(Name(GRAVITY), " = ", earth.shown(ledger.symbols[GRAVITY]))
        return
    own = phrases.ledger.symbols.get(GRAVITY) if phrases is not None else None
    used = GRAVITY in (*seen.counted, *seen.valued) or (GRAVITY in seen.letters and seen.summed)
    numbered = phrases is not None and own is not None and _has_number(own, phrases)
    if phrases is not None and own is not None and used and numbered:
        yield line(Name(GRAVITY), " = ", phrases.shown(own))
    elif GRAVITY in seen.letters and not (seen.numeric and numbered):
        yield line(Name(GRAVITY))


def _given(rows: Sequence[Sequence[Line]]) -> Iterator[Note]:
    """The rows one after the other: numbers; places; the first state."""
    told = [_listed([*row[:MOST_GIVEN], *([line("…")] if len(row) > MOST_GIVEN else [])]) for row in rows if row]
    if told:
        yield Note("Given", line(*(piece for i, row in enumerate(told) for piece in (*(["; "] if i else []), *row))))


def _datum(symbol: Symbol, phrases: Phrases | None, figures: int) -> Line:
    """A number of the file with its unit as its author wrote it; of a formula its value."""
    number = number_of(symbol.value) if symbol.value is not None else None
    if number is not None:
        return line(Name(symbol.name), " = ", Value(*number, max(figures, AS_WRITTEN)))
    own = phrases.ledger.symbols.get(symbol.name) if phrases is not None else None
    written = said(symbol.value, figures) if symbol.value is not None else None
    # What a find of the same name found has only its number.
    alike = isinstance(symbol.value, Letter) and symbol.value.name.rpartition(".")[2] == symbol.name
    formula = (" = ", *written) if written is not None and len(written) <= MOST_PIECES and not alike else ()
    if phrases is None or own is None or not _has_number(own, phrases):
        return line(Name(symbol.name), *formula) if formula else ()
    return line(Name(symbol.name), *formula, " = ", phrases.shown(own))


def _has_number(symbol: sp.Symbol, phrases: Phrases) -> bool:
    """Do only numbers of the file make its value?"""
    value = phrases.ledger.values.get(symbol)
    return value is not None and all(_has_number(s, phrases) for s in value.free_symbols)


def _listed(parts: Sequence[Line]) -> Line:
    """With commas between."""
    return line(*(p for i, part in enumerate(parts) for p in ((", ",) if i else ()) + tuple(part)))
