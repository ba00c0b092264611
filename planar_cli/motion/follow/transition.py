"""What happens at one instant between two regimes: impacts of what closes, then the choice of modes that holds.

Every impact loses relative speed or sends the partners apart, so few of them follow each other at one instant; more
than that is told as such.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import field, replace

from planar_cli.motion.follow.endings import jerked
from planar_cli.motion.regime.mode import INFINITE, Chooser, Chosen, NoMode, SeveralModes, Verdict
from planar_cli.motion.trajectory.automaton import Automaton, Choice, Corner
from planar_cli.motion.trajectory.impact import (
    Contradiction,
    NoImpulse,
    Outgoing,
    Struck,
    StruckContact,
    closing,
    kinetic_energy,
    strike,
    unbalanced,
)
from planar_cli.motion.trajectory.trajectory import Outcome, Transition
from planar_cli.records import record

MOST_IMPACTS = 30
"""So many impacts may follow each other at one instant."""
UNBALANCED = 1e-7
"""In parts of a usual impulse, by how much momentum may be off after an impact."""
NAMED = 1e-4
"""Where the file says that there is an impact, partners touch that are closer than this part of the scene's length: its
places have some four digits."""
MISSED = 1e-7
"""A joint that takes hold demands other velocities where it is missed by more, in parts of lengths and speeds."""
SIMULTANEOUS = "all contacts at once, Newton's law of restitution at every one of them"


@record
class Resolved:
    """After everything that happens at one instant."""

    choice: Choice
    state: tuple[float, ...]
    transitions: tuple[Transition, ...]
    tried: int
    """Choices of modes that were looked at."""
    notes: tuple[str, ...] = ()


@record
class Moment:
    """An instant at which a regime ended, or begins."""

    automaton: Automaton
    t: float
    y: tuple[float, ...]
    choice: Choice
    words: str
    """What ended the regime."""
    tolerance: float
    """That of the motion so far."""
    inelastic: bool = False
    """Do the partners stay together, whatever their restitution: the limit of a sequence of impacts."""
    applied: Mapping[str, tuple[float, ...]] = field(default_factory=dict)
    """Impulses of loads at this instant, by their names, for each velocity."""
    forced: bool = False
    """Does everything strike that the file lets strike between two states?"""
    drawn: bool = False
    """Does nothing but impacts make it a blow, without a motion that led there?"""
    lasting: bool = True
    """Is a choice of modes sought for what follows?"""
    striking: bool = False
    """Must an impact be worked out even where nothing closes: a load strikes, a joint takes hold?"""


def grazing(joint: str, t: float, y: tuple[float, ...], choice: Choice) -> Transition:
    """A contact that is only just touched."""
    return Transition(t, "graze", f"only just touched: {joint}", (joint,), y, y, choice, choice)


def turnings(corner: Corner | None, t: float, y: tuple[float, ...], choice: Choice) -> tuple[Transition, ...]:
    """A corner that is passed over, if there is one."""
    if corner is None:
        return ()
    words = "the corner is taken as rounded: the speed is kept"
    return (Transition(t, "corner", words, corner.joints, y, corner.after, choice, choice),)


def resolve(moment: Moment) -> Resolved | Outcome:
    """Let everything happen that happens at this instant."""
    done: list[Transition] = []
    notes: list[str] = []
    y, choice = moment.y, moment.choice
    for count in range(MOST_IMPACTS):
        first = count == 0
        named = moment.forced and first
        near = NAMED if named else max(1e-9, 10 * moment.tolerance)
        struck = moment.automaton.struck(choice, moment.t, y, near, named, moment.drawn and first)
        if first and moment.applied:
            applied = tuple(sum(column) for column in zip(*moment.applied.values(), strict=True))
            struck = replace(struck, applied=applied)
        if not (first and moment.striking) and not _closes(struck, moment.tolerance):
            if not moment.lasting:
                return Resolved(choice, y, tuple(done), 0, tuple(notes))
            return _chosen(moment, y, choice, done, notes)
        hit = _impact(moment, struck, y, choice)
        if isinstance(hit, Outcome):
            return hit
        transition, note = hit
        if _does_something(transition, struck, moment.tolerance):
            if first and (joint := _takes_hold(moment)):
                return jerked(joint, moment.t)
            done.append(transition)
        notes += [note] if note else []
        y = transition.after
        # What slides after the impact slides in another direction.
        moment.automaton.note(moment.t, y)
    joint = next((t.joints[0] for t in reversed(done) if t.joints), "")
    words = f"more than {MOST_IMPACTS} impacts follow each other at t = {moment.t:.9g} s"
    return Outcome("endless", words, moment.t, joint, "PL709")


def _takes_hold(moment: Moment) -> str:
    """The joint that takes hold of what moves otherwise, where no state of the file is just after that; "" if none."""
    if moment.forced or moment.inelastic or not moment.striking:
        return ""
    missed = moment.automaton.misfits(moment.choice, moment.t, moment.y)
    worst = max(missed, key=lambda joint: missed[joint], default="")
    return worst if worst and missed[worst] > max(MISSED, 10 * moment.tolerance) else ""


def _closes(struck: Struck, tolerance: float) -> bool:
    """Does anything approach what it touches, or do joints demand other velocities?"""
    return any(closing(struck, c) < -_slow(struck, c, tolerance) for c in struck.contacts)


def _slow(struck: Struck, contact: StruckContact, tolerance: float) -> float:
    """A closing speed below this is none: rounding, and the error of what was followed so far."""
    reach = max((abs(x) * s for x, s in zip(contact.normal, struck.speeds, strict=True)), default=0.0)
    return max(1e-10, min(tolerance, 1e-6)) * reach


def _impact(moment: Moment, struck: Struck, y: tuple[float, ...], choice: Choice) -> tuple[Transition, str] | Outcome:
    if moment.inelastic:
        struck = replace(struck, contacts=tuple(replace(c, restitution=0.0) for c in struck.contacts))
    if any(c.restitution != c.restitution for c in struck.contacts):
        joint = next(c.joint for c in struck.contacts if c.restitution != c.restitution)
        words = f"what follows the impact at t = {moment.t:.9g} s is open: {joint} has no restitution"
        return Outcome("open", words, moment.t, joint, "PL706")
    try:
        found = strike(struck)
    except Contradiction as clash:
        words = f"at t = {moment.t:.9g} s the joints demand velocities that contradict each other at {clash.joint}"
        return Outcome("contradiction", words, moment.t, clash.joint, "PL708")
    except NoImpulse:
        words = f"no impulses fulfil the laws of impact and friction at t = {moment.t:.9g} s"
        return Outcome("none", words, moment.t, struck.contacts[0].joint, "PL700")
    if found.unique is False:
        return _ambiguous(moment, struck, found)
    before = kinetic_energy(struck.masses, struck.velocities)
    lost = before - kinetic_energy(struck.masses, found.velocities)
    note = ""
    driven = bool(moment.applied) or any(b.rate for b in struck.bonds) or _moved(struck)
    if not driven and lost < -1e-9 * max(before, 1e-300):
        note = f"the impact at t = {moment.t:.9g} s wins energy: Newton's restitution does not suit this friction"
    pressed = [k for k, n in enumerate(found.normals) if n > 0]
    closed = [k for k, c in enumerate(struck.contacts) if closing(struck, c) < -_slow(struck, c, moment.tolerance)]
    taking = sorted({*pressed, *closed})
    joints = tuple(dict.fromkeys(struck.contacts[k].joint for k in taking))
    after = (*y[: len(y) - len(found.velocities)], *found.velocities)
    transition = Transition(
        t=moment.t,
        kind="impact",
        words=moment.words if not closed else f"impact at {_names(struck, closed)}",
        joints=joints,
        before=tuple(y),
        after=tuple(after),
        old=choice,
        new=choice,
        impulses=_impulses(struck, found, taking),
        given={**moment.applied, **_given(struck, found)},
        lost=lost,
        law=SIMULTANEOUS if len(joints) > 1 else "",
        unbalanced=unbalanced(struck, found),
    )
    if transition.unbalanced > UNBALANCED:
        words = f"in the impact at t = {moment.t:.9g} s momentum does not add up"
        return Outcome("unbalanced", words, moment.t, joints[0] if joints else "", "PL710")
    return transition, note


def _names(struck: Struck, closed: Sequence[int]) -> str:
    """The joints of these contacts, a face with two ends once."""
    return ", ".join(dict.fromkeys(struck.contacts[k].joint for k in closed))


def _does_something(impact: Transition, struck: Struck, tolerance: float) -> bool:
    """Does anything change in it, or is anything given, beyond rounding and the error of what was followed so far? A
    joint that takes hold of what already moves as it demands does nothing.
    """
    slight = max(1e-10, min(tolerance, 1e-6))
    velocities = impact.after[len(impact.after) - len(struck.velocities) :]
    changes = zip(struck.velocities, velocities, struck.speeds, strict=True)
    if any(abs(after - before) > slight * speed for before, after, speed in changes):
        return True
    usual = [abs(mass) * speed for mass, speed in zip(struck.masses, struck.speeds, strict=True)]
    given = (zip(column, usual, strict=True) for column in impact.given.values())
    return any(abs(x) > slight * size for pairs in given for x, size in pairs)


def _moved(struck: Struck) -> bool:
    """Do surfaces move by themselves?"""
    return any(c.normal_rate or c.tangent_rate for c in struck.contacts)


def _impulses(struck: Struck, found: Outgoing, taking: list[int]) -> dict[str, tuple[float, float]]:
    """Normal and friction impulse by joint; those of a face's corners added up."""
    totals: dict[str, tuple[float, float]] = {}
    for k in taking:
        joint = struck.contacts[k].joint
        n, f = totals.get(joint, (0.0, 0.0))
        totals[joint] = (n + found.normals[k], f + found.frictions[k])
    return totals


def _given(struck: Struck, found: Outgoing) -> dict[str, tuple[float, ...]]:
    """What each joint gives to the momenta."""
    pairs = [(b.joint, b.push or b.row, x) for b, x in zip(struck.bonds, found.bonds, strict=True)]
    for contact, normal, friction in zip(struck.contacts, found.normals, found.frictions, strict=True):
        pairs.append((contact.joint, contact.normal, normal))
        pairs += [] if contact.tangent is None else [(contact.joint, contact.tangent, friction)]
    totals: dict[str, tuple[float, ...]] = {}
    for joint, column, size in pairs:
        before = totals.get(joint, (0.0,) * len(column))
        totals[joint] = tuple(a + size * c for a, c in zip(before, column, strict=True))
    return totals


def _ambiguous(moment: Moment, struck: Struck, found: Outgoing) -> Outcome:
    number = 1 + len(found.others)
    joints = ", ".join(dict.fromkeys(c.joint for c in struck.contacts))
    words = f"the impact at t = {moment.t:.9g} s has {number} outcomes by the laws of impact and friction, at {joints}"
    return Outcome("several", words, moment.t, struck.contacts[0].joint, "PL701")


def _chosen(
    moment: Moment, y: tuple[float, ...], choice: Choice, done: list[Transition], notes: list[str]
) -> Resolved | Outcome:
    """The modes that hold now."""
    chooser = Chooser(moment.automaton, moment.t, y, moment.tolerance)
    found = chooser.choose(choice)
    if isinstance(found, Chosen):
        changed = _changed(moment.automaton, choice, found.choice)
        if changed:
            begins = _begins(moment.automaton, changed, choice, found.choice)
            new = Transition(moment.t, "mode", moment.words, changed, y, found.state, choice, found.choice, begins)
            done.append(new)
        return Resolved(found.choice, found.state, tuple(done), found.tried, tuple(notes))
    return unanswered(moment.automaton, moment.t, found)


def _changed(automaton: Automaton, old: Choice, new: Choice) -> tuple[str, ...]:
    return tuple(j for j, a, b in zip(automaton.choices, old, new, strict=True) if a != b)


def _begins(automaton: Automaton, changed: tuple[str, ...], old: Choice, new: Choice) -> str:
    """What the joints that changed do in their new modes."""
    told = []
    for (joint, modes), was, now in zip(automaton.choices.items(), old, new, strict=True):
        if joint in changed and modes[now].words:
            back = ", now the other way" if modes[now].words == modes[was].words else ""
            told.append(modes[now].words + back)
    return ", ".join(dict.fromkeys(told))


def unanswered(automaton: Automaton, t: float, found: NoMode | SeveralModes) -> Outcome:
    """No consistent modes, or several, told with the reasons."""
    if isinstance(found, SeveralModes):
        told = "; or ".join(_named(automaton, v) for v in found.verdicts)
        joint = _differing(automaton, found.verdicts)
        words = f"at t = {t:.9g} s more than one motion is consistent for rigid bodies with dry friction: {told}"
        return Outcome("several", words, t, joint, "PL701")
    nearest = [v for v in found.verdicts if not any(w.moving for w in v.violations)] or list(found.verdicts)
    reasons = [
        f'{_named(automaton, v)}: fails because not "{v.violations[0].words}"' for v in nearest[:4] if v.violations
    ]
    if nearest and all(w.words == INFINITE for v in nearest for w in v.violations):
        return Outcome("infinite", f"at t = {t:.9g} s {INFINITE}", t, "", "PL719")
    joint = next((w.joint for v in nearest for w in v.violations if w.joint), "")
    told = "; ".join(reasons) or f"{len(found.verdicts)} choices were tried"
    if any(_may_hold(automaton, v) for v in nearest):
        words = f"at t = {t:.9g} s it is open which modes hold: redundant constraints share their forces: {told}"
        return Outcome("shared", words, t, joint, "PL713")
    words = f"at t = {t:.9g} s no choice of modes is consistent for rigid bodies with dry friction: {told}"
    return Outcome("none", words, t, joint, "PL700")


def _may_hold(automaton: Automaton, verdict: Verdict) -> bool:
    """Does it fail by forces alone that are not unique, so that others might do?"""
    failing = {v.joint for v in verdict.violations}
    return bool(failing) and failing <= automaton.regime(verdict.choice).shared


def _named(automaton: Automaton, verdict: Verdict) -> str:
    """The modes of a choice in words."""
    modes = (automaton.choices[j][i] for j, i in zip(automaton.choices, verdict.choice, strict=True))
    return ", ".join(m.words or m.name for m in modes)


def _differing(automaton: Automaton, verdicts: Sequence[Verdict]) -> str:
    first, second = verdicts[0].choice, verdicts[1].choice
    return next((j for j, a, b in zip(automaton.choices, first, second, strict=True) if a != b), "")
