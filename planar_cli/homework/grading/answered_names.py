"""Which find an answer is meant for: its very name, else the only one that differs from it by capitals, `_` and spaces.

`Winch.T1` is the answer to `winch.T_1`, unless that is answered too, or another find could be meant.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from planar_cli.homework.sets.paper import Paper
from planar_cli.near import nearest
from planar_cli.records import record

Place = tuple[str, str]
"""A problem and a find."""


@record
class Answered:
    """What was typed for each find; under which other name, where it was another; and what is no answer to any."""

    texts: Mapping[Place, str]
    names: Mapping[Place, str]
    unknown: tuple[str, ...] = ()


def answered(answers: Sequence[tuple[str, str, str]], paper: Paper) -> Answered:
    """The answers of a submission by the finds of its paper."""
    typed = {(problem, find): text for problem, find, text in answers}
    finds = [(task.problem, e.find) for task in paper.tasks for e in task.expected]
    known = dict.fromkeys(finds)
    others = [place for place in typed if place not in known]
    if not others:
        return Answered(typed, {})
    texts = {place: text for place, text in typed.items() if place in known}
    names: dict[Place, str] = {}
    unknown = []
    like = _alike(finds)
    claimed = _alike(others)
    for place in others:
        meant = like.get(_plain(place), [])
        if len(meant) == 1 and meant[0] not in texts and len(claimed[_plain(place)]) == 1:
            texts[meant[0]], names[meant[0]] = typed[place], ".".join(place)
        else:
            unknown.append(_told(place, finds))
    return Answered(texts, names, tuple(unknown))


def _alike(places: Sequence[Place]) -> dict[Place, list[Place]]:
    found: dict[Place, list[Place]] = {}
    for place in places:
        found.setdefault(_plain(place), []).append(place)
    return found


def _plain(place: Place) -> Place:
    problem, find = ("".join(c for c in name.lower() if c.isalnum()) for name in place)
    return problem, find


def _told(place: Place, finds: Sequence[Place]) -> str:
    """What was answered and not asked, and what may be meant."""
    problem, find = place
    of_it = [f for p, f in finds if p == problem]
    what, known = (f"find '{find}' in {problem}", of_it) if of_it else (f"problem '{problem}'", [p for p, _ in finds])
    near = nearest(find if of_it else problem, dict.fromkeys(known))
    return f"there is no {what}{f'; did you mean {near}?' if near else ''}"
