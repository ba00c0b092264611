"""How a contact acts, as the answer says it: it stays at rest; it slides to the right."""

from __future__ import annotations

import sympy as sp

from planar_cli.equation.system.system import System
from planar_cli.equation.values.exact import ZERO
from planar_cli.problem.language.expression import Quantity
from planar_cli.problem.scene.facts import Mode
from planar_cli.problem.scene.scene import GROUND, with_article
from planar_cli.report.notation.numbers import vector_words
from planar_cli.solve.solution import Found, InstantSolution
from planar_cli.solve.solved_problem import PartSolution


def mode_words(found: Found, part: PartSolution) -> str:
    """What a contact does whose mode is asked of one instant; "": nothing of this kind is asked, or more is known by
    its plain word.
    """
    what = found.find.found.what if found.find is not None else None
    if part.motion is not None or found.word not in ("stick", "slip") or not isinstance(what, Quantity):
        return ""
    for instant in part.instants:
        system = instant.trial.system
        for joint in system.modes:
            if {joint, system.aliases.get(joint)} & set(what.things):
                return _sticks(instant, joint) if found.word == "stick" else _slides(instant, joint)
    return ""


def words_of(mode: Mode, system: System) -> str:
    """What is assumed of a contact. Where a body lies on another that moves, and neither turns, what slides on what: B
    slides on the floor, A does not slide on B; else at which point: crate at C slips.
    """
    pairs = {n: pair for n, m in system.modes.items() if (pair := _sliding(m)) is not None}
    own = next((pair for n, pair in pairs.items() if system.modes[n] is mode), None)
    stacked = any(base != GROUND for _, base in pairs.values())
    turning = {e.body for e in system.tree.edges if e.spin is not None}
    if own is None or not stacked or turning & set(own) or sum(mover == own[0] for mover, _ in pairs.values()) != 1:
        return mode.words
    base = own[1] if own[1] != GROUND else _surface(mode, system, own[0])
    return f"{own[0]} {'slides' if mode.name == 'slip' else 'does not slide'} on {base}" if base else mode.words


def _sliding(mode: Mode) -> tuple[str, str] | None:
    """What slides, or might, and on what; None: it rolls, or there is no friction."""
    friction = next((p for p in mode.facts.pushes if p.kind == "friction"), None)
    if friction is None or len(friction.actions) != 2 or not mode.words.endswith((" slips", " does not slip")):
        return None
    return friction.actions[0].body, friction.actions[1].body


def _surface(mode: Mode, system: System, mover: str) -> str:
    """What a body lies on that does not move, by its name in the file."""
    joint = mode.facts.pushes[0].joint
    (pair, *_) = (getattr(j, "between", ()) for j in system.scene.problem.joints if j.name == joint)
    return next((with_article(other) for other in pair if other != mover), "")


def _sticks(instant: InstantSolution, joint: str) -> str:
    """Whether all that touches there is at rest, or only does not slip."""
    system = instant.trial.system
    bodies = {a.body for push in system.modes[joint].facts.pushes for a in push.actions} - {GROUND}
    still = all(system.balanced(body) for body in bodies) and system.is_held()
    return "it stays at rest (it does not slip)" if still else "it does not slip"


def _slides(instant: InstantSolution, joint: str) -> str:
    """What slides on what, and the way in which it does, against the friction on it; of a body that turns at which
    point; on a belt only that it slips.
    """
    trial = instant.trial
    friction = next((p for p in trial.system.modes[joint].facts.pushes if p.kind == "friction"), None)
    motion = trial.system.motion
    if friction is None or motion is None or not trial.outcomes:
        return ""
    (own, *others) = friction.actions
    size, value = trial.outcomes[0].push(friction.name), instant.value
    turns = not value.vanishes(motion.accelerations[own.body].angular)
    if size is None or own.force is None or len(others) != 1:
        return "it slips"
    x, y = (-size * (value.known(sp.sympify(c)) or ZERO) for c in (own.force.x, own.force.y))
    way = vector_words(x, y)
    (other,) = others
    if other.body != GROUND:
        return f"{own.body} slides on {other.body}, {way} relative to it" if way else "it slips"
    belt = trial.system.modes[joint].sliding
    if belt is not None and belt.rate != 0:
        return "it slips"
    return f"it slides {way}".rstrip() if not turns else f"it slips, at {friction.place} {way}".rstrip()
