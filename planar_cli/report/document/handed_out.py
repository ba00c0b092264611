"""What is handed out: the sheet of a variant and the key of all of them, as blocks that every format prints.

A sheet holds nothing of the key: it is written from what is asked and given alone. What was made by itself, as a worked
solution of a variant, stands between the blocks as it is in print.
"""

from __future__ import annotations

import json
import re
from collections.abc import Iterable, Iterator, Sequence
from typing import TypeAlias

from planar_cli.homework.sets.paper import Expected, Paper, Printed, Task
from planar_cli.homework.sets.printed_names import printed
from planar_cli.homework.sets.ready import Homework
from planar_cli.homework.sets.sheets import Handed
from planar_cli.homework.variants.given_letters import GRAVITY
from planar_cli.problem.nodes.show import harmless, paragraphs_of
from planar_cli.report.document.blocks import (
    Block,
    Bullet,
    Inline,
    Line,
    Name,
    Paragraph,
    Table,
    Text,
    Title,
    Typed,
    line,
)
from planar_cli.report.document.lettered import lettered
from planar_cli.report.document.prose import with_pretty_units
from planar_cli.units import pretty_unit

Piece: TypeAlias = Block | Printed
SUBSCRIPTED = re.compile(r"(?<![\w.])([A-Za-zΑ-Ωα-ω]_(?:[A-Z]/[A-Z]|[A-Za-z0-9Α-Ωα-ω]{1,8}))(?![\w])")
"""One letter with its subscript among words; longer words are names that somebody types."""
WITH_UNITS = re.compile(r"(.*) (\([^()]* in [^()]*\))")
"""A formula, and the units in which its letters are."""
DATUM = re.compile(r"([^\W\d]\w*) = (.*)")


# --- sheets ----------------------------------------------------------------------------------------------------------


def sheet(homework: Homework, one: Handed) -> Iterator[Piece]:
    """One sheet."""
    yield Title(_plain(one.title(homework)))
    yield from _paragraphs(homework.text)
    for number, task in enumerate(homework.papers[one.variant].tasks, 1):
        yield Title(f"{number}. {_plain(task.title)}", 1)
        yield from _paragraphs(task.text)
        yield task.scene
        if task.given:
            yield Paragraph(line(f"{task.lead}: ", *_listed(task.given)))
        yield from (Bullet(_asked(e)) for e in task.expected)
    yield from _how_to_hand_in(homework, one)


def _paragraphs(text: str) -> Iterator[Block]:
    return (Paragraph(_words(with_pretty_units(p))) for p in paragraphs_of(text))


def _plain(text: str) -> str:
    """Words on one line in which nothing steers a terminal."""
    return " ".join(harmless(text, kept="").split())


def _words(text: str) -> Line:
    """Words in which letters with subscripts are set as such."""
    pieces = SUBSCRIPTED.split(_plain(text))
    return tuple(Name(p) if i % 2 else Text(p) for i, p in enumerate(pieces) if p)


def _listed(data: Sequence[str]) -> Iterator[Inline]:
    """Data such as m = 2 kg, with commas between them."""
    for i, datum in enumerate(data):
        yield from (Text(", "),) if i else ()
        told = DATUM.fullmatch(_plain(datum))
        yield from (Name(told[1]), Text(f" = {told[2]}")) if told else (Text(_plain(datum)),)


def _asked(expected: Expected) -> Line:
    """A find: how it is called, what it is, its unit and its points."""
    unit = pretty_unit(expected.unit)
    two = " (two components, x and y)" if expected.kind == "vector" else ""
    # The name of the find stands before it already.
    what = "" if expected.asked in ("", printed(expected.find)) else f": {expected.asked}"
    in_unit = f", in {unit}" if unit and expected.kind != "word" else ""
    if expected.kind == "formula":
        in_unit += (
            f", as a formula in {' and '.join(map(printed, free))}" if (free := _free(expected)) else ", as a formula"
        )
    points = f" ({expected.points:g} {'point' if expected.points == 1 else 'points'})"
    return line(_named(expected), _words_after(what), f"{two}{in_unit}{points}")


def _named(expected: Expected) -> Line:
    """A find as the page and the key print it, and where that is not what is typed, also as it is typed."""
    name, typed = _find(expected), _plain(expected.find)
    if name == line(typed):
        return line(Text(typed, "strong"))
    return name if printed(typed) == typed else line(name, " (", Text(typed, "strong"), ")")


def _free(expected: Expected) -> list[str]:
    """The letters of a problem that its sheet gives no numbers for; g is known to all."""
    names = {n for n, _ in (*expected.letters, *expected.others)} - dict(expected.known).keys() - {GRAVITY[0]}
    return sorted(names)


def _words_after(text: str) -> Line:
    """Words behind others, from which the space that they begin with parts them."""
    return line(": ", _words(text.removeprefix(": "))) if text else ()


def _how_to_hand_in(homework: Homework, one: Handed) -> Iterator[Block]:
    """A form with a line for each answer, beside it an example of its kind with made-up numbers."""
    asked = [(task.problem, e) for task in homework.papers[one.variant].tasks for e in task.expected]
    axes = "x counts to the right, y upward. " if any(e.axis or e.kind == "vector" for _, e in asked) else ""
    yield Title("How to hand in", 1)
    yield Paragraph(
        line(
            "A YAML file with one line for each answer: copy the lines below and write your answers behind the colons, "
            f"a number with its unit and, of a rotation, its sense (cw or ccw). {axes}Give {homework.rules.figures} "
            "significant figures. The examples behind # show how an answer is written; what they say is made up."
        )
    )
    yield Typed(tuple(_form(homework, one, asked)))


def _form(homework: Homework, one: Handed, asked: Sequence[tuple[str, Expected]]) -> Iterator[str]:
    yield f"student: {_quoted(one.student) or 'your name or number'}"
    yield from (f"variant: {one.variant}",) if one.variant else ()
    yield "answers:"
    width = max((len(f"{problem}.{e.find}") for problem, e in asked), default=0) + 1
    for problem, e in asked:
        example = _example(e, homework.rules.comma)
        yield f"  {f'{problem}.{e.find}:':<{width}} {f' # {example}' if example else ''}".rstrip()


def _quoted(name: str) -> str:
    """A name as YAML reads it as one word."""
    name = harmless(name, kept="")
    return name if re.fullmatch(r"[\w.][\w .-]*|", name) else json.dumps(name, ensure_ascii=False)


def _example(expected: Expected, comma: bool) -> str:
    """How an answer of that kind is typed; "" where an example would be one of few answers."""
    unit = f" {expected.unit}" if expected.unit != "1" else ""
    first, second = ("12,3", "4,56") if comma else ("12.3", "4.56")
    if expected.kind == "vector":
        # In quotes: a bracket begins a list in YAML.
        return f'"[{first}; -{second}]{unit}"' if comma else f'"[{first}, -{second}]{unit}"'
    if expected.kind == "formula":
        return _made_up(_free(expected) or [n for n, _ in (*expected.letters, *expected.others)])
    if expected.kind != "number":
        return ""
    return f"{first}{unit}{' cw' if expected.rotation else ''}"


def _made_up(letters: Sequence[str]) -> str:
    """A formula in the first letters of a problem, which is no answer."""
    one, *more = sorted(letters)
    return f"2/7*{one}*sqrt({more[-1]})" if more else f"2/7*{one}"


# --- keys ------------------------------------------------------------------------------------------------------------


def key(homework: Homework, variants: Iterable[int], worked: bool, short: bool = True) -> Iterator[Piece]:
    """The key of some variants: the answers, the worked solutions, or both."""
    yield Title(f"{_plain(homework.title)}: key")
    for variant in variants:
        paper = homework.papers[variant]
        if len(homework.papers) > 1:
            students = "".join(f", {_plain(name)}" for name, own in homework.students if own == variant)
            yield Title(f"{'The files as they are' if not variant else f'Variant {variant}'}{students}", 1)
        yield from _short(paper) if short else ()
        yield from (task.worked for task in paper.tasks) if worked else ()


def _short(paper: Paper) -> Iterator[Block]:
    header = tuple(line(h) for h in ("Problem", "Find", "Answer", "Points"))
    rows = tuple(
        (line(_plain(t.problem)), _find(e), _answer(e), line(f"{e.points:g}")) for t in paper.tasks for e in t.expected
    )
    yield Table(header, rows)
    yield from (Bullet(_varied(t)) for t in paper.tasks if t.drawn)


def _find(expected: Expected) -> Line:
    """The name of a find, where it is a letter as it is printed."""
    name = printed(expected.find)
    return line(Name(expected.find) if len(name) == 1 or SUBSCRIPTED.fullmatch(name) else _plain(expected.find))


def _answer(expected: Expected) -> Line:
    text = _plain(expected.text)
    if expected.kind not in ("formula", "equation"):
        return line(text)
    told = WITH_UNITS.fullmatch(text)
    return line(lettered(told[1]), " ", _words(told[2])) if told else lettered(text)


def _varied(task: Task) -> Line:
    return line(f"{_plain(task.problem)}: ", *_listed(task.drawn))
