"""The ledger of effects: what a scene calls for, in which line of its file, and what is not there.

Nothing is listed by hand: every entry comes from a body, joint or load of the scene, or from a member of a shelf that
it does not use. What `--without` leaves out is left out of the problem itself, so that the model never sees it.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import fields, is_dataclass, replace
from fractions import Fraction
from typing import Any

from planar_cli.joints.base import Joint
from planar_cli.problem.language.expression import Number, Side
from planar_cli.problem.scene.facts import Effect
from planar_cli.problem.scene.scene import Problem
from planar_cli.records import record
from planar_cli.registry import members

FRICTION = "friction"
COEFFICIENTS = ("mu", "mu_s", "mu_k", "friction", "friction_torque")
"""The keys of a joint that are its friction."""


@record
class Entry:
    """One effect of the scene."""

    words: str
    """friction, spring, weight ..."""
    line: int
    """The line of the file that calls for it."""
    name: str
    """The joint, load or body."""


def ledger(problem: Problem) -> tuple[tuple[Entry, ...], tuple[str, ...]]:
    """What is in the scene, and the effects that are not."""
    entries = tuple(_entries(problem))
    present = {e.words for e in entries}
    absent = [effect_of(kind).words for kind in members("loads")] + [FRICTION, "impact"]
    return entries, tuple(dict.fromkeys(a for a in absent if a not in present))


def _entries(problem: Problem) -> Iterator[Entry]:
    heavy = [b for b in problem.bodies if b.mass is not None or b.weight is not None or b.any_mass]
    if problem.plane == "vertical":
        yield from (Entry(effect_of("weight").words, b.mark.line, b.name) for b in heavy)
    for body in problem.bodies:
        if body in heavy and type(body.shape).__name__ != "Particle":
            yield Entry("rotational inertia", body.mark.line, body.name)
    for joint in problem.joints:
        yield Entry(joint.kind, joint.mark.line, joint.name)
        if frictions(joint):
            yield Entry(FRICTION, joint.mark.line, joint.name)
    for load in problem.loads:
        yield Entry(effect_of(load.kind).words, load.mark.line, load.name)
    for law in problem.motion:
        yield Entry("prescribed motion", law.statement.mark.line, law.statement.text)


def effect_of(kind: str) -> Effect:
    """How a kind of load is called among the effects."""
    member: Any = members("loads")[kind]
    return member.effect or Effect(kind)


def frictions(joint: Joint) -> tuple[str, ...]:
    """The keys of a joint that give it friction; a coefficient that is plainly zero does not count."""
    names = _keys(joint)
    return tuple(k for k in COEFFICIENTS if k in names and not _nothing(getattr(joint, k)))


def _nothing(side: Side | None) -> bool:
    return side is None or (isinstance(side, Number) and side.value == 0)


def known_effects(problem: Problem) -> tuple[str, ...]:
    """The words that `without` takes for this scene: friction, kinds of loads, names of joints and loads."""
    words = [FRICTION] if any(frictions(j) for j in problem.joints) else []
    words += ["weight"] if problem.plane == "vertical" else []
    words += [load.kind for load in problem.loads] + [effect_of(load.kind).words for load in problem.loads]
    words += [j.name for j in problem.joints] + [x.name for x in problem.loads]
    words += [j.kind for j in problem.joints if j.strikes]
    return tuple(dict.fromkeys(words))


def without(problem: Problem, words: Sequence[str]) -> Problem:
    """The problem without some effects."""
    left = set(words)
    plane = "horizontal" if "weight" in left and problem.plane == "vertical" else problem.plane
    joints = tuple(
        _smooth(j) if FRICTION in left else j for j in problem.joints if j.name not in left and j.kind not in left
    )
    loads = tuple(x for x in problem.loads if not left & {x.kind, x.name, effect_of(x.kind).words})
    return replace(problem, plane=plane, joints=joints, loads=loads)


def _smooth(joint: Joint) -> Joint:
    """The joint with no friction."""
    keys = frictions(joint)
    if not keys:
        return joint
    left: dict[str, Any] = dict.fromkeys(keys)
    if "mu" in _keys(joint):
        left["mu"] = Number(Fraction(0), None, 1, joint.mark)
    return replace(joint, **left)


def _keys(joint: Joint) -> set[str]:
    assert is_dataclass(joint)
    return {f.name for f in fields(joint)}
