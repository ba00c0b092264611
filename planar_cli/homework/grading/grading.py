"""One submission against its paper: for every find a verdict on value, unit, sign and precision, and what it scores.

Nothing here needs the solver: a paper holds the numbers that are right, and those that typical mistakes give.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import replace

from planar_cli.homework.grading.answered_names import answered
from planar_cli.homework.grading.carried_verdicts import Carry, with_carried
from planar_cli.homework.grading.named_mistakes import named, named_formula
from planar_cli.homework.sets.paper import (
    MISSING,
    RIGHT,
    UNGRADABLE,
    WRONG,
    Expected,
    Graded,
    Paper,
    Result,
    Submission,
    Task,
)
from planar_cli.homework.sets.rules import Rules
from planar_cli.homework.sets.tolerances import SLACK, within
from planar_cli.homework.typed import typed
from planar_cli.homework.typed.asked_part import asked_part
from planar_cli.homework.typed.figures import too_few
from planar_cli.homework.typed.meant_units import meant, told, weights
from planar_cli.homework.typed.typed import Typed
from planar_cli.homework.typed.unreadable import Unreadable
from planar_cli.records import record
from planar_cli.units import ENERGY, PURE, Unit, parse_unit, pretty_unit

LONGEST_SHOWN = 80
YES_OR_NO = ("yes", "no")
NO_ANSWERS = frozenset({"", "n/a", "n.a.", "na", "-", "--", "–", "—", "?", "??", "???", "…", "..."})
"""What stands where somebody has no answer."""
SIGN = "the sign or sense is not right"


@record
class _Said:
    """What is told of an answer that is not right in something."""

    unit: str
    sign: str = SIGN
    figures: str = ""
    number: str = "the number is right"
    """Of the number where its unit is not right."""


class Remembered:
    """What was graded before: in a class many type the same. It holds so many answers at most."""

    def __init__(self, most: int = 20_000) -> None:
        self.most = most
        self._known: dict[tuple[int, str, str, str], tuple[Graded, tuple[float, ...] | None]] = {}

    def graded(
        self, variant: int, task: Task, expected: Expected, text: str | None, rules: Rules
    ) -> tuple[Graded, tuple[float, ...] | None]:
        """One find, and the student's numbers in the unit of the find, where there are any."""
        key = variant, task.problem, expected.find, text or ""
        found = self._known.get(key)
        if found is None:
            found = _graded(task, expected, text, rules)
            if len(self._known) < self.most and len(key[3]) <= LONGEST_SHOWN:
                self._known[key] = found
        return found


def grade(
    submission: Submission,
    papers: Mapping[int, Paper],
    rules: Rules,
    carry: Carry | None = None,
    remembered: Remembered | None = None,
) -> Result:
    """All finds of the paper that the student had, in its order. `remembered`: of the same papers and rules."""
    paper = papers.get(submission.variant)
    if paper is None:
        why = f"there is no variant {submission.variant}"
        return Result(submission.student, submission.variant, (), submission.source, (*submission.wrong, why))
    known = remembered or Remembered(0)
    answers = answered(submission.answers, paper)
    graded: list[Graded] = []
    for task in paper.tasks:
        texts = [answers.texts.get((task.problem, e.find)) for e in task.expected]
        pairs = [known.graded(paper.variant, task, e, t, rules) for e, t in zip(task.expected, texts, strict=True)]
        found = [one for one, _ in pairs] if carry is None else with_carried(task, pairs, rules, carry)
        graded += [_under(answers.names.get((task.problem, one.find), ""), one) for one in found]
    if submission.wrong and not submission.answers:
        # Nothing of it could be read, or it was given up: that is not to leave all blank.
        message = f"this cannot be graded: {submission.wrong[0]}"
        graded = [replace(one, verdict=UNGRADABLE, message=message) for one in graded]
    wrong = (*submission.wrong, *answers.unknown)
    return Result(submission.student, submission.variant, tuple(graded), submission.source, wrong)


def _under(name: str, one: Graded) -> Graded:
    """With the name under which the answer stands, where it is not that of the find."""
    if not name:
        return one
    said = f"the answer stands under '{shown(name)}'"
    return replace(one, message="; ".join(filter(None, (one.message, said))))


def _graded(task: Task, expected: Expected, text: str | None, rules: Rules) -> tuple[Graded, tuple[float, ...] | None]:
    """One find, and the student's numbers in the unit of the find, where there are any."""
    blank = Graded(
        task.problem,
        expected.find,
        shown(text or ""),
        MISSING,
        0.0,
        expected.points,
        expected=expected.text,
        due_unit=expected.unit,
        tolerance=expected.tolerance if rules.tolerance is None else rules.tolerance,
    )
    if text is None or text.strip().lower() in NO_ANSWERS:
        return replace(blank, message="there is no answer"), None
    try:
        answer = typed.read(text, expected.kind, rules.comma)
        if expected.kind == "word":
            return _of_word(blank, _is_so(answer.word, expected), rules), None
        if expected.kind in ("formula", "equation"):
            return _of_formula(blank, expected, answer.formula, rules)
        return _of_numbers(blank, expected, answer, rules)
    except Unreadable as why:
        return replace(blank, verdict=UNGRADABLE, message=f"this cannot be graded: {_fitting(why, expected)}"), None


def _fitting(why: Unreadable, expected: Expected) -> str:
    """A reason with its examples in the unit that is asked."""
    unit = "" if expected.unit == "1" else f" {expected.unit}"
    said = str(why).replace("`12.5 N`", f"`12.5{unit}`")
    return said.replace("`[3, -4] m/s`", f"`[3, -4]{unit}`").replace("`5 m/s at", f"`5{unit} at")


def shown(text: str) -> str:
    """What was typed, fit for print."""
    plain = text.strip()
    if not plain.isprintable():
        plain = "".join(c if c.isprintable() else "\ufffd" for c in plain)
    return plain if len(plain) <= LONGEST_SHOWN else plain[: LONGEST_SHOWN - 1] + "…"


def _of_formula(blank: Graded, expected: Expected, text: str, rules: Rules) -> tuple[Graded, tuple[float, ...] | None]:
    """A formula or the equation of a curve, and what the formula comes to at places where it is wrong."""
    from planar_cli.homework.grading.grading_formulas import equation_is_right, formula_verdict
    from planar_cli.homework.grading.wrong_formula import NOT_RIGHT, values_of

    if expected.kind == "equation":
        one = _of_word(blank, equation_is_right(text, expected), rules)
        return (named_formula(one, expected, text) if one.verdict == WRONG else one), None
    found = formula_verdict(text, expected, rules)
    precision = WRONG if found.coarse else RIGHT
    one = replace(blank, value=found.value, unit=found.unit, sign=found.sign, precision=precision)
    one = _scored(one, rules, _Said(found.why, figures=found.coarse))
    if one.value == WRONG:
        one = named_formula(replace(one, precision="", message=found.why), expected, found.text)
        if one.feedback and found.why.startswith(NOT_RIGHT):
            # What the mistake is says more than what can be seen of it.
            one = replace(one, message=NOT_RIGHT)
    one = replace(one, message="; ".join(filter(None, (one.message, *found.notes))))
    return one, values_of(expected, found.text) if one.value == WRONG else None


def _is_so(word: str, expected: Expected) -> bool:
    """Of a mode that is asked by yes or no, its own name will do as well: slips is no to whether it sticks."""
    if expected.mode and word not in YES_OR_NO:
        word = YES_OR_NO[word != expected.mode]
    return word == expected.text


def _of_word(blank: Graded, right: bool, rules: Rules) -> Graded:
    verdict = RIGHT if right else WRONG
    score = blank.max_score if right else 0.0
    return replace(blank, verdict=verdict, value=verdict, score=score, message="" if right else "this is not so")


# --- numbers ---------------------------------------------------------------------------------------------------------


def _of_numbers(
    blank: Graded, expected: Expected, answer: Typed, rules: Rules
) -> tuple[Graded, tuple[float, ...] | None]:
    """Value, unit, sign and precision apart."""
    answer = _as_meant(expected, asked_part(expected, answer))
    unit, why = _unit_verdict(expected, answer.unit)
    values = in_unit_of_find(expected, answer)
    sign, ignored = _sense_verdict(expected, answer)
    fits, turned = _fits_or_turned(expected, values, rules)
    number = "the number is right"
    if unit != RIGHT and not fits and not turned:
        otherwise = _in_base_unit(expected, values, rules) if unit == MISSING else _weighed(expected, answer, rules)
        if otherwise is not None:
            values = otherwise
            fits, turned = _fits_or_turned(expected, values, rules)
            if unit == WRONG:
                why, number = f"{why}: times g it is the right force", ""
    elif unit == RIGHT and not fits and not turned and answer.unit is not None:
        bare = in_unit_of_find(expected, replace(answer, unit=parse_unit(expected.unit)))
        if answer.unit.text != expected.unit and any(_fits_or_turned(expected, bare, rules)):
            unit, why = WRONG, f"the unit is not right: it is not {pretty_unit(answer.unit.text)}"
            fits, turned = _fits_or_turned(expected, values := bare, rules)
    value = RIGHT if fits or turned else WRONG
    if turned or (fits and sign == WRONG):
        sign = WRONG
    elif fits:
        sign = RIGHT
    else:
        sign = ""
    notes = "; ".join((*answer.notes, *ignored))
    coarse = too_few(values, answer, expected, rules.figures) if value == RIGHT else ""
    precision = "" if value == WRONG else WRONG if coarse else RIGHT
    if value == unit == sign == precision == RIGHT:
        # Most answers: nothing is to be said of them.
        score = blank.max_score
        return replace(
            blank, verdict=RIGHT, score=score, value=value, unit=unit, sign=sign, precision=precision, message=notes
        ), values
    one = replace(blank, value=value, unit=unit, sign=sign, precision=precision)
    one = _scored(one, rules, _Said(why, _what_is_with_the_sign(expected, answer), coarse, number))
    if one.verdict == WRONG and value == WRONG:
        one = named(one, expected, values, answer, rules.figures)
        if unit == RIGHT and not one.mistakes and _is_rounded_too_far(values, answer, expected, rules):
            one = replace(one, message=f"this is rounded too far: give {rules.figures} significant figures")
    if notes:
        one = replace(one, message="; ".join(filter(None, (one.message, notes))))
    return one, values


def _fits_or_turned(expected: Expected, values: tuple[float, ...], rules: Rules) -> tuple[bool, bool]:
    """Is it right, and if not, would it be with the other sign?"""
    if within(expected, values, rules):
        return True, False
    if expected.kind == "vector" and len(values) == 2:
        x, y = values
        return False, any(within(expected, other, rules) for other in ((-x, y), (x, -y), (-x, -y)))
    return False, expected.kind == "number" and within(expected, tuple(-v for v in values), rules)


def _in_base_unit(expected: Expected, values: tuple[float, ...], rules: Rules) -> tuple[float, ...] | None:
    """Numbers without a unit that are right if they were meant in the SI unit, where the key has another; else None."""
    due = parse_unit(expected.unit)
    factor = float(due.factor) * math.pi**due.pi_power
    meant = tuple(v / factor for v in values)
    return meant if factor != 1 and any(_fits_or_turned(expected, meant, rules)) else None


def _as_meant(expected: Expected, answer: Typed) -> Typed:
    """The answer with its unit as it is meant where this quantity is due."""
    if answer.unit is None or answer.unit.text == expected.unit:
        return answer
    unit = meant(answer.unit, parse_unit(expected.unit).dimension, expected.gravity)
    return answer if unit is answer.unit else replace(answer, unit=unit)


def _weighed(expected: Expected, answer: Typed, rules: Rules) -> tuple[float, ...] | None:
    """The weights, where masses were typed for forces, and these are right; else None."""
    due = parse_unit(expected.unit)
    for weight in weights(answer.unit, due.dimension, expected.gravity) if answer.unit is not None else ():
        values = tuple(v * weight / float(due.factor) for v in in_unit_of_find(expected, answer))
        if any(_fits_or_turned(expected, values, rules)):
            return values
    return None


def _unit_verdict(expected: Expected, unit: Unit | None) -> tuple[str, str]:
    """right, wrong or missing, and what to say of it."""
    due = parse_unit(expected.unit)
    if unit is None:
        # Radians are a pure number; degrees are not.
        return (RIGHT, "") if due.dimension == PURE and not due.pi_power else (MISSING, "the unit is missing")
    if unit.dimension != due.dimension:
        return WRONG, f"the unit is that of {told(unit)}"
    return RIGHT, ""


def in_unit_of_find(expected: Expected, answer: Typed) -> tuple[float, ...]:
    """The typed numbers in the unit of the find; with the key's unit where none, or a wrong one, was typed."""
    due = parse_unit(expected.unit)
    factor = 1.0
    if answer.unit is not None and answer.unit is not due and answer.unit.dimension == due.dimension:
        powers = answer.unit.pi_power - due.pi_power
        factor = float(answer.unit.factor / due.factor) * math.pi**powers
    if answer.polar:
        size, angle = answer.values
        x, y = size * factor * math.cos(angle), size * factor * math.sin(angle)
        if expected.kind == "vector":
            return x, y
        return (x,) if expected.axis == "x" else (y,)
    values = tuple(v * factor for v in answer.values)
    if answer.sense and expected.rotation:
        return tuple(answer.sense * v for v in values)
    if answer.way and expected.kind == "number" and answer.axis == expected.axis:
        return tuple(answer.way * v for v in values)
    return values


def _sense_verdict(expected: Expected, answer: Typed) -> tuple[str, tuple[str, ...]]:
    """Of a sense or direction in words, and what is said of one that was not looked at: a magnitude, such as a normal
    force, has no direction to be wrong. Unreadable: a sense of rotation stands where nothing turns.
    """
    if expected.kind != "number":
        return "", ()
    if answer.sense and not expected.rotation:
        if parse_unit(expected.unit).dimension == ENERGY:
            return "", ("the sense is not graded here",)
        raise Unreadable("a sense of rotation stands behind what does not turn")
    if answer.way and expected.axis and answer.axis != expected.axis:
        return WRONG, ()
    if answer.way and not expected.axis:
        return "", ("the direction in words is not graded here",)
    return "", ()


def _is_rounded_too_far(values: Sequence[float], answer: Typed, expected: Expected, rules: Rules) -> bool:
    """Is it the right value, with fewer figures than are asked for?"""
    if expected.kind != "number" or not answer.figures or not values[0] or answer.figures[0] >= rules.figures:
        return False
    last = 10.0 ** (math.floor(math.log10(abs(values[0]))) - answer.figures[0] + 1)
    return abs(values[0] - expected.values[0]) <= SLACK * last


def _what_is_with_the_sign(expected: Expected, answer: Typed) -> str:
    """What is said of a right number with the wrong sign: a sense that is missing is not a wrong one."""
    if expected.kind == "vector":
        return "the size is right, the direction is not"
    if answer.sense or answer.way or answer.polar or (expected.values and expected.values[0] > 0) or not answer.values:
        return SIGN
    if expected.rotation:
        return "the sense is missing: without one a number counts counterclockwise, which is not so"
    if expected.axis and answer.values[0] > 0:
        ahead = "to the right" if expected.axis == "x" else "upward"
        return f"the direction is missing: without one a number counts {ahead}, which is not so"
    return SIGN


def _scored(one: Graded, rules: Rules, said_of: _Said) -> Graded:
    """The verdict and the score, from the four verdicts."""
    if one.value == WRONG:
        missing = "; the unit is missing" if one.unit == MISSING else ""
        message = said_of.unit if one.unit == WRONG else f"the value is not right{missing}"
        return replace(one, verdict=WRONG, message=message)
    if one.unit == MISSING and rules.no_unit is None:
        return replace(one, verdict=UNGRADABLE, value="", sign="", message="this cannot be graded: the unit is missing")
    credit, said = 1.0, []
    for verdict, part, sentence in (
        (one.unit, rules.unit if one.unit == WRONG else rules.no_unit or 0.0, said_of.unit or "the unit is not right"),
        (one.sign, rules.sign, said_of.sign),
        (one.precision, rules.precision, said_of.figures),
    ):
        if verdict in (WRONG, MISSING):
            credit = min(credit, part)
            said.append(sentence)
    fine = one.unit == RIGHT and one.sign == RIGHT and (one.precision == RIGHT or rules.precision == 1)
    message = "; ".join(said)
    if said and said_of.number and one.unit != RIGHT and one.sign == RIGHT:
        message = f"{said_of.number}; {message}"
    return replace(one, verdict=RIGHT if fine else WRONG, score=credit * one.max_score, message=message)
