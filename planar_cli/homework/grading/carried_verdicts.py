"""What follows rightly from wrong values of the student's own of what it rests on: its verdict and its score."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from functools import partial
from typing import Protocol

from planar_cli.homework.grading.common_mistakes import Explanation, common_mistake, is_named
from planar_cli.homework.grading.dependence import in_turn
from planar_cli.homework.grading.needed import needed
from planar_cli.homework.sets.paper import RIGHT, WRONG, Expected, Graded, Task
from planar_cli.homework.sets.rules import Rules
from planar_cli.homework.sets.tolerances import within
from planar_cli.homework.typed import typed

MOST_WAYS = 12
"""So many ways at most in which a find follows from own values."""
MOST_ALONE = 4
"""So many wrong values at most are each tried without the others."""


class Carry(Protocol):
    """What a find comes to with the student's own values of earlier finds, and which of them it rests on. Two equations
    with two unknowns tell the second in two ways where the first is wrong: `way`; None: in no further one.
    """

    def __call__(
        self, task: Task, expected: Expected, own: Mapping[str, tuple[float, ...]], way: int = 0
    ) -> tuple[tuple[float, ...], tuple[str, ...]] | None: ...


def with_carried(
    task: Task,
    pairs: Sequence[tuple[Graded, tuple[float, ...] | None]],
    rules: Rules,
    carry: Carry,
) -> list[Graded]:
    """The finds of a problem, of each its verdict and its numbers: those that follow rightly from wrong values of finds
    on which they rest are carried: of all these together or of one of them, alone or with the student's right ones.
    What a mistake gives follows from nothing that is asked behind it and found together with it: the mistake says
    more. One that explains all wrong numbers stands first.
    """
    graded = [one for one, _ in pairs]
    if sum(one.verdict == WRONG for one in graded) < 2:
        return graded
    behind, together = dict(task.behind), dict(task.together)
    wrong: dict[str, tuple[float, ...]] = {}
    right = {one.find: values for one, values in pairs if values is not None and one.verdict == RIGHT}
    common = common_mistake((e, *pair) for e, pair in zip(task.expected, pairs, strict=True))
    for place in in_turn([one.find for one in graded], behind):
        one, values = pairs[place]
        if one.verdict != WRONG or values is None:
            continue
        if common is not None and one.value == WRONG:
            graded[place] = one = replace(
                one, mistakes=tuple(dict.fromkeys((common[0], *one.mistakes))), feedback=common[1]
            )
        # What comes of the same equations and is asked later explains no less and no more: the mistake does.
        later = [e.find for e in task.expected[place:]] if is_named(one) else []
        circle = {n for n in together.get(one.find, ()) if n in later}
        own = {n: v for n, v in wrong.items() if n in behind.get(one.find, ()) and n not in circle}
        if own:
            more = {n: right[n] for n in behind[one.find] if n in right}
            for taken in _taken_together(own):
                one = carried_on(task, task.expected[place], one, values, taken, rules, carry)
                if not one.carried and more:
                    one = carried_on(task, task.expected[place], one, values, taken | more, rules, carry, tuple(taken))
                if one.carried:
                    break
            graded[place] = one if common is None or not one.carried else _explained(one, common)
        # What only follows from another stands first: it is the first to be found needless.
        wrong = {one.find: values, **wrong} if one.carried else {**wrong, one.find: values}
    return graded


def _explained(one: Graded, common: Explanation) -> Graded:
    """What follows from another wrong value by the mistake that explains all of them."""
    return replace(one, mistakes=common[:1], message=f"{common[1]}; it {one.message.removeprefix('this ')}")


def _taken_together(own: Mapping[str, tuple[float, ...]]) -> Iterator[dict[str, tuple[float, ...]]]:
    """Which wrong values are put in: all of them, then each without the others, what is nearest behind first."""
    yield dict(own)
    if len(own) > 1:
        for name in [*own][-MOST_ALONE:][::-1]:
            yield {name: own[name]}


def carried_on(
    task: Task,
    expected: Expected,
    one: Graded,
    values: tuple[float, ...],
    own: Mapping[str, tuple[float, ...]],
    rules: Rules,
    carry: Carry,
    wrong: tuple[str, ...] = (),
) -> Graded:
    """The verdict where the find follows rightly from wrong values of earlier ones, in any way. `wrong`: which of the
    own values are, where right ones are put in beside them.
    """
    for way in range(MOST_WAYS):
        found = carry(task, expected, own, way)
        if found is None:
            break
        made = _carried_to(task, expected, one, values, own, rules, partial(carry, way=way), wrong, found)
        if made.carried:
            return made
    return one


def _carried_to(
    task: Task,
    expected: Expected,
    one: Graded,
    values: tuple[float, ...],
    own: Mapping[str, tuple[float, ...]],
    rules: Rules,
    carry: Carry,
    wrong: tuple[str, ...],
    found: tuple[tuple[float, ...], tuple[str, ...]],
) -> Graded:
    due, names = found
    formula = expected.kind == "formula"
    is_right, follows = _right_and_follows(expected, due, values, rules)
    notes = [] if formula else one.message.split("; ")[1:]
    if not follows and any(typed.SAID_TWICE in note for note in notes):
        # -3 rad/s cw can mean the opposite of clockwise too: own earlier values decide.
        is_right, follows = _right_and_follows(expected, due, tuple(-v for v in values), rules)
        notes = [note for note in notes if typed.SAID_TWICE not in note]
    if is_right or not follows or (one.unit != RIGHT and not formula):
        # Where the earlier value changes nothing, nothing is carried.
        return one
    left = needed(names, due, lambda own: carry(task, expected, own), own)
    names = tuple(e.find for e in task.expected if e.find in left and e.find in (wrong or own))
    if not names:
        return one
    earlier = " and ".join(f"your {n}" for n in names)
    which = "which is not right" if len(names) == 1 else "which are not right"
    return replace(
        one,
        score=rules.carried * one.max_score,
        carried=names,
        mistakes=(),
        feedback="",
        message="; ".join((f"this follows rightly from {earlier}, {which}", *notes)),
    )


def _right_and_follows(
    expected: Expected, due: tuple[float, ...], values: tuple[float, ...], rules: Rules
) -> tuple[bool, bool]:
    """Is what is due with own earlier values the right answer all the same, and is it what was typed?"""
    if expected.kind == "formula":
        from planar_cli.homework.grading.wrong_formula import fits_at_places, same_at_places

        return fits_at_places(expected, due), same_at_places(due, values)
    return within(expected, due, rules), within(expected, values, rules, due)
