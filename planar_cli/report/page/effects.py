"""The effects that a scene calls for, and those that it does not."""

from __future__ import annotations

from typing import Any

from planar_cli.problem.language.expression import JustAfter
from planar_cli.problem.scene.facts import Effect
from planar_cli.registry import members
from planar_cli.report.document.blocks import Note, line
from planar_cli.solve.solution import InstantSolution


def effect_notes(instant: InstantSolution) -> tuple[Note, ...]:
    """Two lines: what acts in this scene, and what does not."""
    present, absent = effects(instant)
    notes = [Note("Effects", line(" · ".join(present)))] if present else []
    if absent and present:
        notes.append(Note("Effects", line("not in this scene: " + ", ".join(absent))))
    return tuple(notes)


def effects(instant: InstantSolution) -> tuple[list[str], list[str]]:
    """Effects present and absent, in the words of the course."""
    system, scene = instant.trial.system, instant.instant.scene
    kinds = {w.kind for w in system.wrenches}
    present: list[str] = []
    has_mass = any(b.mass != 0 for b in scene.bodies.values())
    shelf = sorted(((_effect(kind), kind) for kind in members("loads")), key=lambda pair: pair[0].rank)
    present += [effect.words for effect, kind in shelf if kind in kinds]
    if any(b.varies for b in scene.bodies.values()):
        present.append("mass that varies")
    if has_mass:
        present += _contacts(instant)
    driven = [p.place for p in system.pushes if p.kind == "drive"]
    present += [f"what keeps {place}" for place in driven]
    turning = [n for n, b in scene.bodies.items() if b.rigid and b.inertia != 0]
    if turning and has_mass:
        present.append("rotational inertia of " + ", ".join(turning))
    coriolis = _coriolis(instant)
    if coriolis:
        present.append("Coriolis acceleration")
    absent = [effect.absent for effect, kind in shelf if effect.absent and kind not in kinds]
    absent += [] if coriolis else ["Coriolis"]
    blows = any(isinstance(s, JustAfter) for state in scene.problem.states for s in state.relations)
    if scene.problem.strikers or blows:
        return [*present, "impact"], absent
    return present, [*absent, "impact"]


def _effect(kind: str) -> Effect:
    """How a kind of load is listed."""
    member: Any = members("loads")[kind]
    return member.effect or Effect(kind)


def _contacts(instant: InstantSolution) -> list[str]:
    system = instant.trial.system
    found: dict[str, list[str]] = {}
    for push in system.pushes:
        if push.kind == "drive":
            continue
        words = {
            "normal": "normal force",
            "friction": "friction",
            "component": "pin force",
            "tension": "tension",
            "couple": "couple",
        }["component" if push.member else push.kind]
        place = system.aliases.get(push.joint, push.joint)
        if words not in found.setdefault(place, []):
            found[place].append(words)
    lines = []
    for place, listed in found.items():
        joint = next(m for j, m in system.modes.items() if system.aliases[j] == place)
        rolling = not joint.name and any(j.rolling is not None for j in joint.facts.joinings)
        lines.append(" and ".join(listed) + f" at {place}" + (" (rolling, no slip)" if rolling else ""))
    return lines


def _coriolis(instant: InstantSolution) -> bool:
    """Does any point slide along a turning body?"""
    system, value = instant.trial.system, instant.value
    motion = system.motion
    if motion is None:
        return False
    for mode in system.modes.values():
        for j in mode.facts.joinings:
            if j.path is None or motion.velocities[j.base].angular == 0 or motion.slide_speed(j) == 0:
                continue
            if not value.is_zero(motion.slide_speed(j)):
                return True
    return False
