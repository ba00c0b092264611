"""What stands at the head of a page: what is given, what is asked, and which principle leads there, with the reason."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from decimal import Decimal

import sympy as sp

from planar_cli.problem.expression import Number
from planar_cli.problem.scene import Problem, Symbol
from planar_cli.records import record
from planar_cli.report.blocks import Block, Equation, Heading, Line, Math, Name, Note, Paragraph, Text, Value, line
from planar_cli.report.given import Mentioned, given_rows, mentioned
from planar_cli.report.sides import AS_WRITTEN, said
from planar_cli.report.words import Phrases

MOST_GIVEN = 18
"""More data are in the file, and not on the page."""
MOST_PIECES = 24
"""A formula of the file of more pieces is given by its value alone."""


def opening_notes(problem: Problem, blocks: Sequence[Block], phrases: Phrases | None, figures: int) -> Iterator[Note]:
    """Given, find and principle. `blocks`: the page, which tells the principles that it uses; `phrases`: with the
    numbers of the first instant, where there is one.
    """
    yield from _given(_rows(problem, mentioned(blocks), phrases, figures))
    names = dict.fromkeys(f.name for f in problem.find)
    if names:
        yield Note("Find", _listed([line(Name(n)) for n in names]))
    principles = [p.words for p in PRINCIPLES if p.applies(_seen(blocks))]
    if principles:
        yield Note("Principle", line(" ".join(principles)))


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
    yield from _given([[d for d in row if d not in before] for row in _rows(case, seen, phrases[1], figures)])


def _rows(problem: Problem, seen: Mentioned, phrases: Phrases | None, figures: int) -> list[Sequence[Line]]:
    """All that a file gives: its letters, then what has none."""
    letters = [d for s in problem.given if (d := _datum(s, phrases, figures))]
    numbers, *others = given_rows(problem, seen, figures)
    return [[*letters, *(line(Name(s.name)) for s in problem.symbols), *numbers], *others]


def _given(rows: Sequence[Sequence[Line]]) -> Iterator[Note]:
    """The rows one after the other: numbers; places; the first state."""
    told = [_listed([*row[:MOST_GIVEN], *([line("…")] if len(row) > MOST_GIVEN else [])]) for row in rows if row]
    if told:
        yield Note("Given", line(*(piece for i, row in enumerate(told) for piece in (*(["; "] if i else []), *row))))


def _datum(symbol: Symbol, phrases: Phrases | None, figures: int) -> Line:
    """A number of the file with its unit as its author wrote it; of a formula its value."""
    if isinstance(symbol.value, Number):
        number = symbol.value
        value = Decimal(number.value.numerator) / Decimal(number.value.denominator) * number.sense
        return line(Name(symbol.name), " = ", Value(value, number.unit or "1", max(figures, AS_WRITTEN)))
    own = phrases.ledger.symbols.get(symbol.name) if phrases is not None else None
    written = said(symbol.value, figures) if symbol.value is not None else None
    formula = (" = ", *written) if written is not None and len(written) <= MOST_PIECES else ()
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


@record
class _Seen:
    """What a page has: the names before its equations, its sentences, its headings, whether it integrates."""

    leads: frozenset[str]
    names: frozenset[str]
    words: str
    headings: frozenset[str]
    integrates: bool
    inertial: bool
    """Are inertial forces drawn among the forces?"""

    def led(self, start: str) -> bool:
        """Does an equation begin with such a name?"""
        return any(n.startswith(start) for n in self.leads)


def _seen(blocks: Sequence[Block]) -> _Seen:
    leads: set[str] = set()
    names: set[str] = set()
    words: list[str] = []
    integrates = False
    for block in blocks:
        if isinstance(block, Equation):
            leads |= {p.name for p in block.lead if isinstance(p, Name)}
            for side in block.sides:
                parts = side if isinstance(side, tuple) else (side,)
                names |= {p.name for p in parts if isinstance(p, Name)}
                integrates |= any(isinstance(p, Math) and p.expr.has(sp.Integral) for p in parts)
        elif isinstance(block, Paragraph):
            words += [p.text for p in block.line if isinstance(p, Text)]
    headings = frozenset(b.text for b in blocks if isinstance(b, Heading))
    inertial = any(isinstance(b, Heading) and "inertial" in str(b.aside) for b in blocks)
    return _Seen(frozenset(leads), frozenset(names), " ".join(words), headings, integrates, inertial)


@record
class _Principle:
    """One principle in a sentence with its reason. `applies`: is it used?"""

    applies: Callable[[_Seen], bool]
    words: str


def _newton(page: _Seen) -> bool:
    return "Kinetic analysis" in page.headings and (page.led("ΣF") or page.led("ΣM"))


def _kinetic(page: _Seen) -> bool:
    return _newton(page) or "virtual power" in page.words


def _energetic(page: _Seen) -> bool:
    return page.led("T_") or page.led("T'_")


PRINCIPLES = (
    _Principle(lambda p: "a_cor" in p.names, "Motion relative to a turning body, with the Coriolis acceleration."),
    _Principle(lambda p: "v_rel" in p.names and "a_cor" not in p.names, "Motion relative to a moving body."),
    _Principle(
        lambda p: (
            "Kinematic analysis" in p.headings and not _kinetic(p) and not _energetic(p) and "v_rel" not in p.names
        ),
        "Kinematics: places, velocities and accelerations.",
    ),
    _Principle(lambda p: _newton(p) and not p.inertial, "Newton's second law."),
    _Principle(lambda p: p.inertial, "d'Alembert's principle: with the inertial forces each body is in equilibrium."),
    _Principle(lambda p: "virtual power" in p.words, "Virtual power, in which no reaction takes part."),
    _Principle(lambda p: "momentum before" in p.words, "Impulse and momentum across the blow."),
    _Principle(lambda p: p.led("T_"), "Work and energy between the states."),
    _Principle(lambda p: p.led("T'_"), "Work and energy in a frame that moves."),
    _Principle(lambda p: "impulse and momentum" in p.words, "Impulse and momentum over a time."),
    _Principle(lambda p: "conservation of" in p.words, "Conservation of momentum."),
    _Principle(lambda p: p.integrates or "The law" in p.words, "Integration over time."),
)
"""In the order in which they are told."""
