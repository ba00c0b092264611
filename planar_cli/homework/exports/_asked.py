"""What an export asks: the finds of all variants with the numbers that are taken for right, and those of mistakes.

A course system compares number by number, each with an interval. The intervals here are those of `planar check`, and
no two of one number overlap, so that it is all the same in which order a system tries them.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import replace

from planar_cli.homework.checking.verdict import FLOOR
from planar_cli.homework.exports._text import one_line
from planar_cli.homework.sets.paper import Expected, Mistaken, Paper, Task
from planar_cli.records import record
from planar_cli.units import parse_unit, pretty_unit

AXES = ("x", "y")
THINNEST = 0.2
"""An interval that is narrowed to less than this share of itself misses honest rounding: it is given up."""
NOTHING = 1e-9
"""A component below this part of its vector is what is left of zero."""
APART = 0.999
"""Neighbouring intervals stop short of each other by the rest."""
MOST_PLACES = 6
"""So many finds are named of which the same is told."""
CHOICES = dict.fromkeys(("yes", "no"), ("yes", "no"))
"""The words of which all alternatives are known."""


@record
class Interval:
    """Numbers around a value, at most `tolerance` away. `feedback`: what is told to who meets them."""

    value: float
    tolerance: float
    name: str = ""
    feedback: str = ""


@record
class Number:
    """One number that a student types."""

    name: str
    """Of the find, with the axis or place behind it where a find has several numbers."""
    label: str
    """Of several: `x component`; "" of one."""
    right: Interval
    turned: tuple[Interval, ...]
    """The same direction a whole turn away."""
    mistakes: tuple[Interval, ...]


@record
class Asked:
    """One find of one variant."""

    task: Task
    expected: Expected
    variant: int

    @property
    def place(self) -> str:
        """For sentences to the lecturer."""
        return f"{self.task.problem}, {self.expected.find}"


class LeftOut:
    """Sentences on what a system cannot take, `place: why`, each once with all places and variants."""

    def __init__(self) -> None:
        self._found: dict[str, list[int]] = {}
        self._close: dict[str, set[tuple[str, int]]] = {}

    def too_close(self, place: str, mistake: str, variant: int) -> None:
        """The number of a mistake cannot be told from another one there."""
        self._close.setdefault(one_line(place), set()).add((mistake, variant))

    def tell(self, sentence: str, variant: int) -> None:
        variants = self._found.setdefault(one_line(sentence), [])
        if variant not in variants:
            variants.append(variant)

    def sentences(self) -> tuple[str, ...]:
        alike: dict[tuple[str, str], list[str]] = {}
        for sentence, variants in self._found.items():
            place, colon, why = sentence.partition(": ")
            alike.setdefault((why if colon else place, _variants(variants)), []).extend([place] if colon else [])
        told = [f"{f'{_listed(p)}: ' if p else ''}{why} ({variants})" for (why, variants), p in alike.items()]
        if self._close:
            count, places = sum(map(len, self._close.values())), "; ".join(self._close)
            one = "1 mistake has no feedback of its" if count == 1 else f"{count} mistakes have no feedback of their"
            told.append(
                f"{one} own, being too close to another number ({places}); `planar check --set` tells such mistakes too"
            )
        return tuple(told)


def _listed(places: Sequence[str]) -> str:
    """All places, or of many the first ones."""
    more = len(places) - MOST_PLACES
    return "; ".join(places[:MOST_PLACES]) + (f"; {more} more" if more > 0 else "")


def _variants(numbers: Sequence[int]) -> str:
    if len(numbers) > 8:
        return f"{len(numbers)} variants"
    return ("variant " if len(numbers) == 1 else "variants ") + ", ".join(map(str, numbers))


def problems(papers: Sequence[Paper]) -> dict[str, list[tuple[int, Task]]]:
    """Each problem with its variants, in the order of the papers."""
    found: dict[str, list[tuple[int, Task]]] = {}
    for paper in papers:
        for task in paper.tasks:
            found.setdefault(task.problem, []).append((paper.variant, task))
    return found


def finds(variants: Sequence[tuple[int, Task]]) -> dict[str, list[Asked]]:
    """Each find of one problem with its variants."""
    found: dict[str, list[Asked]] = {}
    for variant, task in variants:
        for expected in task.expected:
            found.setdefault(expected.find, []).append(Asked(task, expected, variant))
    return found


def is_numeric(expected: Expected) -> bool:
    return expected.kind in ("number", "vector", "list")


def numbers(asked: Asked, left_out: LeftOut) -> tuple[Number, ...]:
    """The numbers of a find; none, and a sentence, where one is not finite."""
    expected = asked.expected
    due = _ordered(expected.kind, expected.values)
    if not due or not all(map(math.isfinite, due)):
        left_out.tell(f"{asked.place}: its value is no finite number", asked.variant)
        return ()
    size = math.hypot(*due) if expected.kind == "vector" else 0.0
    mistakes = [
        replace(m, values=_ordered(expected.kind, m.values))
        for m in expected.mistakes
        if len(m.values) == len(due) and all(map(math.isfinite, m.values))
    ]
    found = []
    for i, value in enumerate(due):
        name, label = _named(expected, i, len(due))
        right = Interval(value, _allowed(size or abs(value), expected))
        turned = _turned(right, expected)
        wrong = [_mistaken(m, i, expected, right) for m in mistakes if m.values[i] != value]
        found.append(Number(name, label, right, turned, _apart(asked, label, (right, *turned), wrong, left_out)))
    return tuple(found)


def _ordered(kind: str, values: Sequence[float]) -> tuple[float, ...]:
    """The values as they are asked for: those of a list from the smallest on."""
    return tuple(sorted(values)) if kind == "list" else tuple(values)


def _named(expected: Expected, place: int, count: int) -> tuple[str, str]:
    if expected.kind == "vector" and count == 2:
        return f"{expected.find}_{AXES[place]}", f"{AXES[place]} component"
    if count > 1:
        return f"{expected.find}_{place + 1}", f"value {place + 1} of {count}, from the smallest on"
    return expected.find, ""


def _allowed(size: float, expected: Expected) -> float:
    """How far off a number of that size may be; a true zero is measured by the scale of the problem."""
    return expected.tolerance * (size + float(FLOOR) * expected.scale)


def _turned(right: Interval, expected: Expected) -> tuple[Interval, ...]:
    """The right direction told from a turn before and behind."""
    turn = whole_turn(expected)
    return tuple(replace(right, value=right.value + t) for t in (-turn, turn)) if turn else ()


def whole_turn(expected: Expected) -> float:
    """A whole turn in the unit of a direction; 0 of anything else."""
    if not expected.direction:
        return 0.0
    unit = parse_unit(expected.unit)
    return 2 * math.pi / (float(unit.factor) * math.pi**unit.pi_power)


def _mistaken(mistake: Mistaken, place: int, expected: Expected, right: Interval) -> Interval:
    """The numbers of a mistake; around a zero without any scale as far as around the right one."""
    value = mistake.values[place]
    size = math.hypot(*mistake.values) if expected.kind == "vector" else abs(value)
    value = 0.0 if abs(value) < NOTHING * size else value
    return Interval(value, _allowed(size, expected) or right.tolerance, mistake.name, mistake.feedback)


def _apart(
    asked: Asked, label: str, right: Sequence[Interval], wrong: Sequence[Interval], left_out: LeftOut
) -> tuple[Interval, ...]:
    """The intervals of mistakes, narrowed until they overlap neither those of right numbers nor one another."""
    place = f"{asked.place}, {label}" if label else asked.place
    kept = []
    for one in wrong:
        room = [abs(one.value - r.value) - r.tolerance for r in right]
        # Between two mistakes each has half of the way.
        room += [abs(one.value - w.value) / 2 for w in wrong if w is not one]
        widest = min(one.tolerance, APART * min(room))
        if widest >= THINNEST * one.tolerance and min(room) > 0:
            kept.append(replace(one, tolerance=widest))
        else:
            left_out.too_close(place, one.name, asked.variant)
    return tuple(kept)


# --- what the student reads ------------------------------------------------------------------------------------------


def title_of(task: Task) -> str:
    return one_line(task.title) or task.problem


def name_of(task: Task, name: str, variant: int, longest: int) -> str:
    """What a question is called in a list: a long title is cut, never what tells questions apart."""
    tail = f": {name}, variant {variant}"
    return title_of(task)[: longest - len(tail)] + tail


def text_of(task: Task) -> str:
    """The text of a problem; its title where the file has none."""
    return task.text if task.text.strip() else title_of(task)


def question_of(expected: Expected) -> str:
    """What is asked, in which unit and by which signs, in one line."""
    what = one_line(expected.asked) or expected.find
    unit = shown_unit(expected)
    asks = f"Find: {what}{f', in {unit}' if unit else ''}"
    return " ".join([asks if asks.endswith((".", "?", "!")) else f"{asks}.", *_signs(expected)])


def shown_unit(expected: Expected) -> str:
    """As printed; "" of a pure number and of what has no unit."""
    return pretty_unit(expected.unit) if is_numeric(expected) else ""


def _signs(expected: Expected) -> Iterator[str]:
    if expected.kind == "vector":
        yield "Give the components: x is positive to the right, y upward."
    elif expected.kind == "list":
        yield "Give all values, the smallest first."
    elif expected.kind == "formula":
        letters = ", ".join(one_line(name) for name, _ in expected.letters)
        yield f"Give a formula{f' in {letters}' if letters else ''}."
    said = expected.asked.lower()
    # The lecturer's own words may tell it.
    if expected.rotation and "positive" not in said and "clockwise" not in said:
        yield "Counterclockwise is positive."
    if expected.axis and "positive" not in said:
        yield f"Positive {'to the right' if expected.axis == 'x' else 'upward'}."


def alternatives(word: str) -> tuple[str, ...]:
    """All words of which this one is the right choice; none where they are not known."""
    return CHOICES.get(word.strip().lower(), ())
