"""How a motion comes to an end that is not what was asked for, in words."""

from __future__ import annotations

from collections.abc import Sequence

from planar_cli.integrators.base import StepTooSmall, TooManySteps
from planar_cli.motion.regime.guards import AGAIN
from planar_cli.motion.terms.source import Singular
from planar_cli.motion.trajectory.automaton import Guard
from planar_cli.motion.trajectory.segment import Segment
from planar_cli.motion.trajectory.trajectory import Outcome

CHANGED = 1e-6
"""A length that is taken for granted has changed when it is off by more than this part of the scale."""


def stuck_at(stuck: StepTooSmall | Singular, t: float) -> Outcome:
    """What a motion comes to that does not go on from a time t."""
    if isinstance(stuck, Singular):
        return Outcome("singular", f"at t = {t:.9g} s the accelerations are not determined", t, "", "PL702")
    if isinstance(stuck, TooManySteps):
        return Outcome("long", f"{stuck}", stuck.t, "", "PL703")
    words = f"near t = {stuck.t:.9g} s a place is singular, or something grows beyond all bounds: {stuck}"
    return Outcome("small", words, stuck.t, "", "PL703")


def undetermined_at(loose: Sequence[str], t: float) -> Outcome:
    """Bodies that forces leave open."""
    words = f"nothing tells how {', '.join(loose)} will move: without mass forces do not"
    return Outcome("singular", words, t, loose[0], "PL702")


def unbalanced(segment: Segment, allowed: float) -> Outcome | None:
    """Momentum or energy that is off by more than an allowed part of its scale over a segment; None: it adds up."""
    balance = segment.balance
    if balance is None or balance.off <= allowed:
        return None
    words = f"between t = {segment.t0:.9g} s and t = {segment.t1:.9g} s {balance.told}"
    return Outcome("unbalanced", words, segment.t1, "", "PL710")


def not_as_presumed(segment: Segment) -> Outcome | None:
    """What a joint takes for granted of places, and does not stay so over a segment; None: everything does."""
    begun = segment.regime.presumed(segment.t0, segment.start)
    for t, y in (*((s.t1, s.y1) for s in segment.steps[:-1]), (segment.t1, segment.end)) if begun else ():
        for (joint, words, before), (*_, now) in zip(begun, segment.regime.presumed(t, y), strict=True):
            if abs(now - before) > CHANGED:
                said = f"{joint}: {words}, from t = {segment.t0:.9g} s on"
                return Outcome("aside", said, segment.t0, joint, "PL539")
    return None


def as_presumed(segments: Sequence[Segment], outcome: Outcome) -> tuple[Segment, ...]:
    """Those that go as they were followed: not the last, where a joint took something else for granted in it."""
    return tuple(s for s in segments if outcome.kind != "aside" or s.t1 <= outcome.t)


def jerked(joint: str, t: float) -> Outcome:
    """A joint takes hold of what moves otherwise, and the file does not say that this is a blow."""
    return Outcome("jerk", f"at t = {t:.9g} s {joint} takes hold of what moves otherwise", t, joint, "PL717")


def endless(words: str, joint: str, t: float) -> Outcome:
    """Changes of mode that follow each other at one instant."""
    return Outcome("endless", f"at t = {t:.9g} s the modes change without end: {words}", t, joint, "PL709")


def begun_apart(found: tuple[str, str] | None, t: float) -> Outcome | None:
    """A joint whose partners do not touch when it begins: the joint, and words; None: there is none."""
    return None if found is None else Outcome("apart", f"at t = {t:.9g} s {found[1]}", t, found[0], "PL718")


def spent(guard: Guard, t: float) -> Outcome:
    """A guard has fallen behind which nothing goes on."""
    if guard.kind == AGAIN:
        who = guard.words.removesuffix(" are apart")
        words = f"at t = {t:.9g} s {who} meet again, and their impact acts between two earlier states only"
        return Outcome("again", words, t, guard.joint, "PL715")
    # It ends a little before nothing is left: the last digits of the time tell nothing.
    words = f"at about t = {t:.2g} s a free part of {guard.joint} has run out: draw it longer, or end before"
    return Outcome("spent", words, t, guard.joint, "PL712")


def open_after(found: tuple[str, str], t: float) -> Outcome:
    """What the file leaves open of how partners of an impact go on: the impact, and words."""
    joint, words = found
    return Outcome("open", f"at t = {t:.9g} s {words}", t, joint, "PL714")


def repeats_every(period: float, t: float) -> Outcome:
    """A motion that has come back to where it was by a time t."""
    return Outcome("repeats", f"the motion repeats itself every {period:.6g} s", t)
