"""text2qti: quizzes for Canvas as plain text."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from dataclasses import replace
from typing import ClassVar, final

from planar_cli.homework.exports._asked import (
    Asked,
    Interval,
    LeftOut,
    Number,
    alternatives,
    finds,
    is_numeric,
    name_of,
    numbers,
    problems,
    question_of,
    shown_unit,
    text_of,
)
from planar_cli.homework.exports._spellings import ratio, smaller
from planar_cli.homework.exports._text import clean, number, one_line, slug
from planar_cli.homework.exports.base import Exported, PaperExport
from planar_cli.homework.sets.paper import Expected, Paper

SMALLEST = 1e-4
"""Canvas takes no bound of an interval that is nearer to zero."""
FINEST = 0.0005
"""text2qti writes bounds to four decimals: of a tolerance that is smaller, rounding would be more than a tenth."""
POWERS = range(3, 25, 3)
"""Of ten, as engineers write them."""
LONGEST_TITLE = 255
_SPECIAL = re.compile(r"[\\`*{}\[\]<>&#!$|~^]|(?<!\w)_|_(?!\w)")
"""An underscore within a word, m_1, is none to the Markdown that text2qti reads."""


@final
class Text2qti(PaperExport):
    """Plain text for text2qti, which makes a quiz for Canvas of it.

    The file
        One group for each find, from which Canvas picks one variant for each student. A number is right within the
        tolerance of `planar check`. Canvas knows numbers to four decimals and none nearer to zero than 0.0001, so a
        small answer is asked in a smaller unit. The numbers of a vector or list are questions of their own. Yes or
        no becomes a choice; another word is typed.

    To import it
        `text2qti NAME.txt` (from the Python package text2qti) makes a zip; in Canvas: Settings, Import Course
        Content, "QTI .zip file".

    What is lost
        Formulas as answers; a direction told after a whole turn; worked solutions and the feedback of diagnosed
        mistakes, as Canvas gives none for one wrong number; units: students type the number in the unit of the
        question. The text is one paragraph, without a figure. Points of a group are whole numbers.
    """

    kind: ClassVar[str] = "text2qti"

    def export(self, papers: Sequence[Paper], title: str, seed: int) -> Exported:
        left_out = LeftOut()
        blocks = [f"% Variants drawn with seed {seed}.\nQuiz title: {one_line(title) or 'Homework'}"]
        for variants in problems(papers).values():
            for of_one in finds(variants).values():
                blocks += _groups(of_one, left_out)
        return Exported({f"{slug(title)}.txt": "\n\n".join([*blocks, ""]).encode()}, left_out.sentences())


def _groups(of_one: Sequence[Asked], left_out: LeftOut) -> Iterator[str]:
    """The questions of one find, each with its variants."""
    by_name: dict[str, list[str]] = {}
    for asked in of_one:
        for name, question in _questions(asked, left_out):
            by_name.setdefault(name, []).append(question)
    for questions in by_name.values():
        asked = of_one[0]
        due = asked.expected.points / len(by_name)
        points = max(1, round(due))
        if points != due:
            why = f"gets {points} of {due:g} points, as Canvas picks from groups with whole points"
            left_out.tell(f"{asked.place}: each question {why}", asked.variant)
        head = f"GROUP\npick: 1\npoints per question: {points}"
        yield "\n\n".join([head, *questions, "END_GROUP"])


def _questions(asked: Asked, left_out: LeftOut) -> Iterator[tuple[str, str]]:
    """Each question of a find with its name."""
    task, expected = asked.task, asked.expected
    if task.worked:
        left_out.tell(f"{task.problem}: Canvas shows no worked solution", asked.variant)
    if expected.mistakes:
        left_out.tell(f"{asked.place}: Canvas has no feedback for its diagnosed mistakes", asked.variant)
    if is_numeric(expected):
        for one in numbers(replace(asked, expected=replace(expected, mistakes=())), left_out):
            if one.turned:
                left_out.tell(f"{asked.place}: the same direction after a whole turn counts as wrong", asked.variant)
            sized = _sized(expected, one.right)
            if sized is None:
                left_out.tell(f"{asked.place}: Canvas cannot tell its number from zero", asked.variant)
            else:
                yield one.name, _numerical(asked, one, *sized)
    elif expected.kind == "word":
        yield expected.find, _word(asked)
    else:
        left_out.tell(f"{asked.place}: Canvas has no question for a formula", asked.variant)


def _numerical(asked: Asked, found: Number, unit: str, power: int, right: Interval) -> str:
    expected = replace(asked.expected, unit=unit)
    shown = shown_unit(expected)
    asks = [question_of(expected), f"Only the {found.label}." if found.label else ""]
    if power:
        tens = f"10^-{power}"
        whole = f"{tens} {shown}" if shown else tens
        asks.append(f"Type how many {whole} it is: 2·{whole} is typed as 2.")
    else:
        asks.append("Type the number without its unit." if shown else "")
    # An interval whose bounds are whole numbers would be written without decimals, which is as good.
    answer = f"=   {number(right.value)} +- {number(right.tolerance)}"
    return _question(asked, found.name, " ".join(filter(None, asks)), answer)


def _sized(expected: Expected, right: Interval) -> tuple[str, int, Interval] | None:
    """The unit in which Canvas can tell right from wrong, the power of ten that it takes on top, and the interval then;
    None where nothing is large enough.
    """
    for unit in (expected.unit, *smaller(expected.unit)):
        inside = _times(right, 1.0 if unit == expected.unit else ratio(expected.unit, unit))
        if _fits(inside):
            return unit, 0, inside
    for power in POWERS:
        inside = _times(right, 10.0**power)
        if _fits(inside):
            return expected.unit, power, inside
    return None


def _times(interval: Interval, factor: float) -> Interval:
    return replace(interval, value=interval.value * factor, tolerance=interval.tolerance * factor)


def _fits(interval: Interval) -> bool:
    bounds = (abs(interval.value - interval.tolerance), abs(interval.value + interval.tolerance))
    return min(bounds) >= SMALLEST and interval.tolerance >= FINEST


def _word(asked: Asked) -> str:
    word = one_line(asked.expected.text)
    choices = alternatives(word)
    if choices:
        answers = [f"{'*' if c == word.lower() else ''}{letter}) {c}" for letter, c in zip("ab", choices, strict=True)]
        answer = "\n".join(answers)
    else:
        answer = f"*   {word}"
    return _question(asked, asked.expected.find, question_of(asked.expected), answer)


def _question(asked: Asked, name: str, asks: str, answer: str) -> str:
    """One question: title, one paragraph, answer. It begins with a word of ours, which no syntax begins with."""
    task = asked.task
    given = f"{task.lead}: {'; '.join(map(one_line, task.given))}." if task.given else ""
    title = name_of(task, name, asked.variant, LONGEST_TITLE)
    text = " ".join(filter(None, [f"Variant {asked.variant}.", one_line(text_of(task)), given, asks]))
    return f"Title: {title}\n1.  {_plain(text)}\n{answer}"


def _plain(text: str) -> str:
    """Words without any meaning for Markdown, HTML or LaTeX."""
    return _SPECIAL.sub(lambda match: f"&#{ord(match[0])};", clean(text))
