"""What a case says as an earlier one did is told once: of a run of lines that stood there word for word, with the same
numbers of equations, only that it is as before, of named quantities by the same formulas the new values. A diagram from
which forces are gone is drawn again, and so is one about another point of which moments are taken.
"""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import replace
from itertools import takewhile

from planar_cli.equation.algebra.plain import longer
from planar_cli.report.document.as_printed import as_text, diagram, read_alike
from planar_cli.report.document.blocks import (
    Block,
    Equation,
    Forces,
    Heading,
    Line,
    Math,
    Name,
    Note,
    Paragraph,
    Result,
    Table,
    Text,
    Value,
    line,
)
from planar_cli.report.equations.results import told_by_others, value_told
from planar_cli.report.equations.steps import SOLVING
from planar_cli.report.oscillation.small_motion import LINEAR
from planar_cli.report.repeats.before_in_heads import with_before_in_heads
from planar_cli.report.repeats.turned_diagrams import is_turned, steps_turned, with_first_equations, without_arrows
from planar_cli.report.words.pointing import told_centres

LONG = 7
"""A formula of more operations is not printed a second time with other numbers."""
LEAST = 3
"""Fewer lines are printed again, unless they are all of a step."""
TOLD = (Paragraph, Equation, Forces, Result, Table)
NUMBERED, RUN = re.compile(r"\(\d+\)"), re.compile(r"\((\d+)\) to \((\d+)\)")
CASE = "CASE"
DEFINED = ("moment of inertia of", "terminal speed", "half disk, from", "sector, from")
"""Begins the line of a moment of inertia, of what a drag makes, and of the mass centre of a sector."""


def told_once(blocks: Sequence[Block], before: Sequence[Block]) -> list[Block]:
    """The blocks of a case. `before`: those of earlier cases."""
    printed = _Printed(before)
    if not printed.said:
        return list(blocks)
    drawn = _known_first([printed.reduced(b) for b in blocks], printed)
    printed.redrawn = printed.beside_equations(drawn)
    known = [printed.knows(b) or printed.renews(b) for b in drawn]
    known = [
        k and not (isinstance(b, Forces) and _is_about_another(b, drawn[i:], before))
        for i, (k, b) in enumerate(zip(known, drawn, strict=True))
    ]
    turned = list(steps_turned(drawn, known, printed.knows_turned))
    known = [k and _with_all_it_leads_to(drawn, known, i) for i, k in enumerate(known)]
    known = [k and not _is_led_anew(drawn, known, i) for i, k in enumerate(known)]
    known = [a or b for a, b in zip(known, turned, strict=True)]
    found: list[Block] = []
    start = 0
    while start < len(drawn):
        stop = start
        while stop < len(drawn) and known[stop]:
            stop += 1
        heading = found[-1] if found and start > 0 and drawn[start - 1] is found[-1] and _ends(drawn, stop) else None
        # A sentence that leads to what is new stays, and so does a line that goes on with what is new: cos β above β.
        while stop > start and stop < len(drawn) and _leads(drawn[stop - 1]) and not isinstance(drawn[stop], Heading):
            stop -= 1
        while stop > start and stop < len(drawn) and _goes_on(drawn[stop]) and _cites(drawn[stop - 1]):
            stop -= 1
        run = drawn[start:stop]
        told = _as_before(run, printed, _cited(drawn[stop:])) if run else ()
        if run and isinstance(heading, Heading) and heading in before:
            found[-1] = _headed(heading, run, told, _link(run, printed))
            start = stop
        elif told and ((len(run) >= LEAST and _alike(run, printed)) or _all_define(run, printed)):
            found.append(Paragraph(line("As before", _link(run, printed), told, ".")))
            start = stop
        else:
            found += drawn[start : max(stop, start + 1)]
            start = max(stop, start + 1)
    return with_before_in_heads(found)


def _known_first(blocks: Sequence[Block], printed: _Printed) -> list[Block]:
    """Blocks in which the results of a step that solves equations begin with those that an earlier case had: they rest
    on nothing new.
    """
    found: list[Block] = []
    start = 0
    while start < len(blocks):
        heading = blocks[start]
        stop = next((k for k in range(start + 1, len(blocks)) if isinstance(blocks[k], Heading)), len(blocks))
        own = list(blocks[start + 1 : stop])
        if isinstance(heading, Heading) and heading.text == SOLVING:
            known = [b for b in own if _is_result(b) and printed.knows(b)]
            led = [i for i, b in enumerate(own) if i and b not in known and own[i - 1] in known and not _is_result(b)]
            if len(known) >= LEAST and not led:
                own = [*known, *(b for b in own if b not in known)]
        found += [heading, *own]
        start = stop
    return found


def _is_result(block: Block) -> bool:
    """Is it a line that ends with the value of a letter?"""
    return isinstance(block, Equation) and block.number is None and isinstance(block.sides[-1], Value)


def _all_define(run: Sequence[Block], printed: _Printed) -> bool:
    """Is it nothing but moments of inertia that have kept their values?"""
    return all(_defines(b) and not printed.renews(b) for b in run)


def _link(run: Sequence[Block], printed: _Printed) -> str:
    """What stands between `as before` and what is named."""
    return ", now with " if any(map(printed.renews, run)) else ": "


def _alike(run: Sequence[Block], printed: _Printed) -> bool:
    """Have its equations the same numbers there? Else a reader would have to look each of them up; of a whole step it
    is worth that.
    """
    return all(here == there for b in run for here, there in printed.numbers(b))


class _Printed:
    """What earlier cases printed: word for word, and the last diagram of each body and the last equation of each
    number, since only those are meant by `before`.
    """

    def __init__(self, before: Sequence[Block]) -> None:
        # A letter that is sought in one case and given in another is the same in print.
        self.said = {_told(b) for b in before if isinstance(b, TOLD)} if before else frozenset[str]()
        self.numbered = {b.number: _told(b) for b in before if isinstance(b, Equation) and b.number is not None}
        self._numbers = {said: number for number, said in self.numbered.items()}
        self._likewise = {_told(b): own for b in before if (own := told_by_others(b))}
        self._turned = {without_arrows(said): number for said, number in self._numbers.items()}
        self.places, self.last = _places(before)
        self.diagrams = {b.body: b for b in before if isinstance(b, Forces)}
        self._beside = {(diagram(d), _told(e), e.number) for d, e in with_first_equations(before)}
        self.redrawn: frozenset[str] = frozenset()
        """Diagrams that are not the last of their body, but stand beside the same equations with the same numbers."""
        self.formulas = {_formula(b) for b in before if isinstance(b, Equation) and _is_long(b)}
        self.named = {_formula(b) for b in before if isinstance(b, Equation) and _is_named(b)}

    def knows(self, block: Block) -> bool:
        """Does it stand there word for word, and would `before` mean it?"""
        if isinstance(block, Forces):
            last = self.diagrams.get(block.body)
            return (last is not None and diagram(last) == diagram(block)) or diagram(block) in self.redrawn
        if isinstance(block, Equation) and block.number is not None:
            return _told(block) in self._numbers
        return isinstance(block, TOLD) and _told(block) in self.said

    def beside_equations(self, blocks: Sequence[Block]) -> frozenset[str]:
        """The diagrams of a case that stood beside the same equation, which tells where they are to be found."""
        pairs = [(diagram(d), _told(e), e.number) for d, e in with_first_equations(blocks)]
        return frozenset(d for d, e, n in pairs if (d, e, n) in self._beside and self.numbered.get(n or 0) == e)

    def renews(self, block: Block) -> bool:
        """Is it the line of a named quantity by the same formula, with other numbers?"""
        named = (
            isinstance(block, Equation) and _is_named(block) and read_alike((block.lead, block.sides[:2])) in self.named
        )
        return named and not self.knows(block)

    def knows_turned(self, block: Block) -> bool:
        """Would it stand there word for word, but for directions that are turned?"""
        if isinstance(block, Forces):
            last = self.diagrams.get(block.body)
            return last is not None and is_turned(diagram(last), diagram(block))
        return isinstance(block, Equation) and block.number is not None and self.number(block) is not None

    def number(self, equation: Equation) -> int | None:
        """The number of an equation there; None: it did not stand there, or another had its number later."""
        said = _told(equation)
        same = equation.number is not None and self.numbered.get(equation.number) == said
        other = self._numbers.get(said)
        return equation.number if same else self._turned.get(without_arrows(said)) if other is None else other

    def numbers(self, block: Block) -> list[tuple[int, int | None]]:
        """The numbers of the equations that a block tells, here and there."""
        if isinstance(block, Equation):
            return [] if block.number is None else [(block.number, self.number(block))]
        own = told_by_others(block)
        return list(zip(own, self._likewise.get(_told(block), own), strict=False))

    def reduced(self, block: Block) -> Block:
        """A long formula of a named quantity with its other numbers alone. Itself, where it is another."""
        if (
            isinstance(block, Equation)
            and _is_long(block)
            and read_alike((block.lead, block.sides[:2])) in self.formulas
        ):
            return block if _told(block) in self.said else replace(block, sides=(block.sides[0], *block.sides[2:]))
        return block


def _is_about_another(row: Forces, step: Sequence[Block], before: Sequence[Block]) -> bool:
    """Does a step take moments of a body about a point that the diagram of earlier cases does not have?"""
    told = " ".join(as_text(side) for side in (row.left, row.right))
    then = {(name, repr(way.place)) for name, way in told_centres(before)}
    now = told_centres(takewhile(lambda b: not isinstance(b, Heading), step))
    own = [(name, repr(way.place)) for name, way in now if set(row.body.split(", ")) <= set(way.bodies)]
    return any(c not in then and not re.search(rf" at {re.escape(c[0])}\b", told) for c in own)


def _formula(equation: Equation) -> str:
    """Its letter and formula, with what stands before them."""
    return read_alike((equation.lead, equation.sides[:2]))


def _is_named(equation: Equation) -> bool:
    """Has a line letter = formula = numbers = value, without a number of its own, a title?"""
    formula = equation.sides[1] if len(equation.sides) > 3 and equation.number is None and equation.lead else None
    if not isinstance(formula, Math) or formula.values:
        return False
    title = equation.lead[0]
    return isinstance(title, Text) and NUMBERED.match(title.text) is None


def _is_long(equation: Equation) -> bool:
    """Has a line letter = formula = numbers = value, without a number of its own, a long formula?"""
    formula = equation.sides[1] if len(equation.sides) > 3 and equation.number is None and equation.lead else None
    return isinstance(formula, Math) and not formula.values and longer(formula.expr, LONG)


def _ends(blocks: Sequence[Block], stop: int) -> bool:
    """Does a step of the solution end there, by the next heading or by what is assumed of the next stretch?"""
    return stop < len(blocks) and isinstance(blocks[stop], Heading | Note)


def _told(block: Block) -> str:
    """What a block says, whatever the numbers of equations."""
    if isinstance(block, Equation):
        block = replace(block, number=None)
    return NUMBERED.sub("(#)", read_alike(block))


def _with_all_it_leads_to(blocks: Sequence[Block], known: Sequence[bool], i: int) -> bool:
    """Of `From 1 to 2, work and kinetic energy:` whether all that stands under it is known too. What numbered equations
    give is not led to by the words above these.
    """
    if not _announces(blocks[i]):
        return True
    stop = next((k for k in range(i + 1, len(blocks)) if isinstance(blocks[k], Paragraph | Heading)), len(blocks))
    after = (k for k in range(i + 1, stop) if _is_numbered(blocks[k - 1]))
    result = next((k for k in after if _cites(blocks[k]) or _is_of_a_point(blocks[k])), stop)
    if all(map(_is_numbered, blocks[i + 1 : result])):
        stop = result
    return all(known[i + 1 : stop])


def _is_numbered(block: Block) -> bool:
    return isinstance(block, Equation) and block.number is not None


def _goes_on(block: Block) -> bool:
    """Is it a line without a number that begins with no other's, which goes on with the one above?"""
    return isinstance(block, Equation) and block.number is None and not block.lead


def _cites(block: Block) -> bool:
    """Is it a line without a number that begins with those of others?"""
    return isinstance(block, Equation) and block.number is None and bool(NUMBERED.search(read_alike(block.lead)))


def _is_of_a_point(block: Block) -> bool:
    """Is it the vector equation of a point, which goes on with nothing above?"""
    left = block.sides[0] if isinstance(block, Equation) and _goes_on(block) else ()
    return isinstance(left, tuple) and len(left) == 1 and isinstance(left[0], Name)


def _is_led_anew(blocks: Sequence[Block], known: Sequence[bool], i: int) -> bool:
    """Does it stand under words that are new?"""
    return isinstance(blocks[i], Equation) and i > 0 and _announces(blocks[i - 1]) and not known[i - 1]


def _announces(block: Block) -> bool:
    """Is it a sentence that ends with a colon?"""
    return isinstance(block, Paragraph) and isinstance(last := block.line[-1], Text) and last.text.endswith(":")


def _defines(block: Block) -> bool:
    """Is it the line of a moment of inertia, of a mass centre, or of a terminal speed?"""
    if not isinstance(block, Equation) or block.number is not None or not block.lead:
        return False
    return isinstance(block.lead[0], Text) and block.lead[0].text.startswith(DEFINED)


def _leads(block: Block) -> bool:
    """Does a sentence announce what follows?"""
    return isinstance(block, Paragraph) and not told_by_others(block)


def _cited(blocks: Sequence[Block]) -> frozenset[str]:
    """The numbers of equations in what is told."""
    said = " ".join(map(read_alike, blocks))
    inside = ((int(low), int(high)) for low, high in RUN.findall(said))
    within = {f"({n})" for low, high in inside for n in range(low, high + 1)}
    return frozenset(NUMBERED.findall(said)) | within


def _as_before(run: Sequence[Block], printed: _Printed, cited: frozenset[str]) -> Line:
    """What stands in place of a run of lines: the diagram, the numbers of equations, quantities with their values; ():
    there is nothing to name. `cited`: the numbers that the lines after it name.
    """
    if new := [one for b in run if printed.renews(b) and (one := value_told(b))]:
        return line(*(p for i, t in enumerate(new) for p in (", ", t)[i == 0 :]))
    equations = [(here, there or 0) for b in run for here, there in printed.numbers(b)]
    drawn = [b for b in run if isinstance(b, Forces)]
    as_it_is = "the diagram" if all(map(printed.knows, drawn)) else "the diagram (turned)"
    told: list[Line] = [line(as_it_is)] if drawn else []
    if equations:
        shifted = _shifted(equations, printed)
        told.append(line("; ".join(_ranges(run, printed, cited) for run in shifted)))
    else:
        linear = any(isinstance(b, Paragraph) and Text(LINEAR) in b.line for b in run)
        told += [line("the linear equation")] if linear else []
        told += [one for b in run if (one := value_told(b))]
    last = " and " if len(equations) == 1 else ", "
    return line(*(p for i, t in enumerate(told) for p in (last if i == len(told) - 1 else ", ", t)[i == 0 :]))


def _shifted(equations: Sequence[tuple[int, int]], printed: _Printed) -> list[list[tuple[int, int]]]:
    """The numbers of equations, here and there, in runs in which both grow alike."""
    runs: list[list[tuple[int, int]]] = []
    for here, there in equations:
        if runs and runs[-1][-1] == (here - 1, there - 1) and printed.places[there] == printed.places[there - 1]:
            runs[-1].append((here, there))
        else:
            runs.append([(here, there)])
    return runs


def _ranges(run: Sequence[tuple[int, int]], printed: _Printed, cited: frozenset[str]) -> str:
    """(1) to (3), of the case before; (1) of case root, which stands further up; of equations that had other numbers
    there, (6) to (8), that is (5) to (7) of case root, by the old ones alone where none of the new is `cited`.
    """
    (first, old), (last, older) = run[0], run[-1]
    own, place = _range(first, last), printed.places[old]
    if first != old and not cited & {f"({n})" for n, _ in run}:
        return f"{_range(old, older)} {place}"
    if first != old:
        return f"{own}, that is {_range(old, older)} {place}"
    return own if place == printed.last else f"{own} {place}"


def _places(before: Sequence[Block]) -> tuple[dict[int, str], str]:
    """In which case the last equation of each number stands, and the last equation of all."""
    found: dict[int, str] = {}
    place = last = "of the first part"
    for block in before:
        if isinstance(block, Heading) and block.label == CASE:
            place = f"of case {block.text}"
        else:
            own = [block.number] if isinstance(block, Equation) and block.number is not None else told_by_others(block)
            found |= dict.fromkeys(own, place)
            last = place if own else last
    return found, last


def _headed(heading: Heading, run: Sequence[Block], told: Line, link: str) -> Heading:
    """The heading of a step of which all lines stood there before; the legend of diagrams that are not drawn goes."""
    aside = (heading.aside,) if isinstance(heading.aside, str) else heading.aside
    legend = any(isinstance(b, Forces) for b in run)
    kept = line(*aside, "; ") if heading.aside and not legend else ()
    return replace(heading, aside=line(kept, "as before", link if told else "", told))


def _range(first: int, last: int) -> str:
    if first == last:
        return f"({first})"
    return f"({first}) {'and' if last == first + 1 else 'to'} ({last})"
